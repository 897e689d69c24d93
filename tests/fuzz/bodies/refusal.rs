//! Checks the message of every refusal.

/// The longest message, bytes, that a terminal shows at once. Longer quoted values are shortened.
const LONGEST: usize = 2_000;

/// Asserts that `message` names `file`, says more than that, and has no control characters.
pub fn assert_readable(message: &str, file: &str) {
    assert!(message.starts_with(file), "the file is not named first: {message:?}");
    assert!(message.len() > file.len() + 10, "says nothing: {message:?}");
    assert!(message.len() < LONGEST, "{} bytes long: {message:.200}…", message.len());
    assert!(!message.contains(char::is_control), "has control characters: {message:?}");
}
