//! Parameters → field: reaction and diffusion.
