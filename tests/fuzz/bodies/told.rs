//! What every refusal owes whoever reads it.

/// Longest message, bytes: what a terminal shows at once. A value that is quoted in it is cut.
const LONGEST: usize = 2_000;

/// Asserts that `message` names `file`, says more than that, and does nothing to a terminal.
pub fn told(message: &str, file: &str) {
    assert!(message.starts_with(file), "the file is not named first: {message:?}");
    assert!(message.len() > file.len() + 10, "says nothing: {message:?}");
    assert!(message.len() < LONGEST, "{} bytes long: {message:.200}…", message.len());
    assert!(!message.contains(char::is_control), "acts on a terminal: {message:?}");
}
