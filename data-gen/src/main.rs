//! The sweep: parameters → simulation → measured attributes → rows in `training/`.

fn main() {}
