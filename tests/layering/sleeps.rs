//! Checks that no test waits for a fixed time, which is too long on a fast machine and too short on a slow one. Tests
//! wait for a message, the end of a program, or a condition, with a time limit.

use crate::scan::{Named, scan};
use crate::sources::{files_in, is_test, module, sources};

fn is_sleep(named: &Named) -> bool {
    named.path.ends_with(&["thread".to_owned(), "sleep".to_owned()])
}

#[test]
fn no_test_sleeps() {
    let beside = files_in(&["tests", "data-gen/tests"]).into_iter().map(|file| (file, true));
    let within = sources().into_iter().map(|file| {
        let is_test = is_test(&module(&file.0));
        (file, is_test)
    });
    let mut complaints = Vec::new();
    for ((file, source), is_test) in beside.chain(within) {
        let paths = scan(&source, &module(&file)).paths;
        let sleeps = paths.iter().filter(|named| (is_test || named.in_tests) && is_sleep(named));
        complaints.extend(sleeps.map(|named| format!("{file}:{}", named.line)));
    }
    assert!(complaints.is_empty(), "wait for what is to happen instead:\n{}", complaints.join("\n"));
}

#[test]
fn a_sleep_is_found_by_any_of_its_names() {
    for source in [
        "std::thread::sleep(time);",
        "use std::thread; fn f() { thread::sleep(time); }",
        "use std::thread::sleep;",
    ] {
        assert!(scan(source, &[]).paths.iter().any(is_sleep), "{source}");
    }
    assert!(!scan("worker.sleep_until(time); std::thread::yield_now();", &[]).paths.iter().any(is_sleep));
}
