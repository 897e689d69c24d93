//! Paths as text on one line: `%`, control characters and bytes that are not UTF-8 are written `%25`, `%0A` and so on.

use std::path::{Path, PathBuf};

/// The text of a path.
#[must_use]
pub fn encode(path: &Path) -> String {
    let mut line = String::new();
    for chunk in bytes(path).utf8_chunks() {
        for letter in chunk.valid().chars() {
            match letter {
                '%' => line.push_str("%25"),
                letter if letter.is_control() => {
                    let mut buffer = [0; 4];
                    for byte in letter.encode_utf8(&mut buffer).bytes() {
                        line.push_str(&format!("%{byte:02X}"));
                    }
                }
                letter => line.push(letter),
            }
        }
        for byte in chunk.invalid() {
            line.push_str(&format!("%{byte:02X}"));
        }
    }
    line
}

/// The path of a text that [`encode`] wrote; a `%` without two hexadecimal digits stands for itself.
#[must_use]
pub fn decode(line: &str) -> PathBuf {
    let (mut bytes, mut rest) = (Vec::with_capacity(line.len()), line.as_bytes());
    while let [first, after @ ..] = rest {
        let code = after.get(..2).and_then(|code| std::str::from_utf8(code).ok());
        match code.and_then(|code| u8::from_str_radix(code, 16).ok()) {
            Some(byte) if *first == b'%' => {
                bytes.push(byte);
                rest = &after[2..];
            }
            _ => {
                bytes.push(*first);
                rest = after;
            }
        }
    }
    path(bytes)
}

#[cfg(unix)]
fn bytes(path: &Path) -> std::borrow::Cow<'_, [u8]> {
    use std::os::unix::ffi::OsStrExt;
    path.as_os_str().as_bytes().into()
}

#[cfg(not(unix))]
fn bytes(path: &Path) -> std::borrow::Cow<'_, [u8]> {
    path.to_string_lossy().into_owned().into_bytes().into()
}

#[cfg(unix)]
fn path(bytes: Vec<u8>) -> PathBuf {
    use std::os::unix::ffi::OsStringExt;
    std::ffi::OsString::from_vec(bytes).into()
}

#[cfg(not(unix))]
fn path(bytes: Vec<u8>) -> PathBuf {
    String::from_utf8_lossy(&bytes).into_owned().into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_path_with_a_line_break_is_one_line() {
        assert_eq!(encode(Path::new("/a b/50 %\n.dapple")), "/a b/50 %25%0A.dapple");
        assert_eq!(decode("/ä/100%"), Path::new("/ä/100%"));
    }

    proptest! {
        #[cfg(unix)]
        #[test]
        fn any_path_is_read_back(bytes: Vec<u8>) {
            let path = path(bytes);
            let line = encode(&path);
            prop_assert!(!line.contains(char::is_control));
            prop_assert_eq!(decode(&line), path);
        }
    }
}
