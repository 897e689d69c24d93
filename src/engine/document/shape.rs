//! The shape of documents: the keys of each object, and the values that they may have. Each table is beside the code that reads its
//! object. The reader takes the names of keys from it, and [`crate::document::schema()`] prints all of it.

use crate::document::limits::Range;

/// An object of a document.
pub(super) struct Object {
    /// Its name; `docs/format.md` has a heading of this name.
    pub name: &'static str,
    /// Its keys, in the order of messages and docs.
    pub keys: &'static [Key],
}

/// A key of an object.
#[derive(Clone, Copy)]
pub(super) struct Key {
    /// The key.
    pub name: &'static str,
    /// The values that are allowed.
    pub shape: Shape,
    /// Its default as JSON, or [`Self::REQUIRED`], or [`Self::NONE`].
    pub default: &'static str,
    /// Its meaning and its unit.
    pub meaning: &'static str,
}

impl Key {
    /// In place of a default: the key must be given.
    pub(super) const REQUIRED: &'static str = "required";
    /// In place of a default: no value has the meaning of a missing key.
    pub(super) const NONE: &'static str = "none";

    pub(super) const fn new(
        name: &'static str,
        shape: Shape,
        default: &'static str,
        meaning: &'static str,
    ) -> Self {
        Self { name, shape, default, meaning }
    }
}

/// The values that a key may have, as far as they do not depend on other values.
#[derive(Clone, Copy)]
pub(super) enum Shape {
    /// One of these texts.
    Choice(fn() -> Vec<&'static str>),
    /// A text of so many characters, from the first number to the second.
    Text([usize; 2]),
    /// A prefix and hexadecimal digits, whose number is one of these.
    Hexadecimal(&'static str, &'static [usize]),
    /// A gray PNG in base64.
    Png,
    /// True or false.
    Flag,
    /// A number.
    Number(Range),
    /// A whole number, from the first to the second.
    Whole([u64; 2]),
    /// A list of one number in each of these ranges.
    Numbers(&'static [Range]),
    /// A list of one whole number in each of these ranges.
    Wholes(&'static [[u64; 2]]),
    /// A list of values of one shape, from the first number of them to the second.
    List(&'static Shape, [usize; 2]),
    /// An object.
    Object(&'static Object),
    /// What one of these shapes allows.
    AnyOf(&'static [Shape]),
}

/// A list or text of any length.
pub(super) const ANY: usize = usize::MAX;
