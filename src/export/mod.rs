//! Pictures → bytes.
