//! Field → picture: pattern values to colours.
