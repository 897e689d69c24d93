use super::*;

fn names_in(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

fn write_new(stream: &mut Unfinished) -> Result<(), Stopped> {
    Ok(stream.write_all(b"new")?)
}

#[test]
fn a_file_is_created_and_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.png");
    save(&path, |stream| Ok(stream.write_all(b"old and longer")?)).unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"old and longer");
    save(&path, write_new).unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"new");
    assert_eq!(names_in(folder.path()), ["a.png"]);
}

#[test]
fn a_write_that_fails_or_is_cancelled_changes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.png");
    fs::write(&path, "old").unwrap();
    let fail = |why: fn() -> Stopped| {
        save(&path, |stream| {
            stream.write_all(&[0; 3 << 20])?;
            Err(why())
        })
        .unwrap_err()
        .to_string()
    };
    assert!(fail(|| Stopped::Cancelled).ends_with("a.png' was not written: cancelled"));
    assert!(
        fail(|| io::Error::from(io::ErrorKind::StorageFull).into())
            .contains("a.png': the disk is full; free some space")
    );
    assert!(
        fail(|| io::Error::from(io::ErrorKind::PermissionDenied).into())
            .contains("is not permitted; choose another")
    );
    assert!(fail(|| io::Error::other("out of paper").into()).ends_with("a.png': out of paper"));
    assert_eq!(fs::read(&path).unwrap(), b"old");
    assert_eq!(names_in(folder.path()), ["a.png"]);
}

#[test]
fn paths_that_cannot_be_written_give_an_error_with_the_remedy() {
    let folder = tempfile::tempdir().unwrap();
    let message = |name: &str| {
        let path = folder.path().join(name);
        let early = check_content(&path, Content::Colours).unwrap_err().to_string();
        let late = save(&path, write_new).map_err(|error| error.to_string());
        (early, late)
    };
    let same = |name: &str| {
        let (early, late) = message(name);
        assert_eq!(late, Err(early.clone()));
        early
    };
    assert!(same("no/a.png").ends_with("no' does not exist; create it first, or choose another"));
    fs::create_dir(folder.path().join("sub.png")).unwrap();
    assert!(same("sub.png").contains("sub.png': it is a folder; name a file in it, such as"));
    fs::write(folder.path().join("file"), "").unwrap();
    assert!(same("file/a.png").contains("does not exist; create it first"));
    assert!(same("..").contains("it is a folder"));
    let locked = folder.path().join("locked.png");
    fs::write(&locked, "old").unwrap();
    let mut permissions = fs::metadata(&locked).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&locked, permissions).unwrap();
    assert!(same("locked.png").contains("the file exists and is read-only; make it writable"));
    assert_eq!(fs::read(&locked).unwrap(), b"old");
    assert_eq!(names_in(folder.path()), ["file", "locked.png", "sub.png"]);
}

#[test]
fn only_known_endings_are_allowed() {
    let message = |path: &str| {
        check_content(Path::new(path), Content::Colours).map(drop).map_err(|error| error.to_string())
    };
    assert_eq!(message("a.png"), Ok(()));
    assert_eq!(message("A.PNG"), Ok(()));
    assert_eq!(["a.tif", "a.TIFF", "a.exr", "a.jpg", "a.jpeg", "a.WebP"].map(message), [const { Ok(()) }; 6]);
    let gif = "cannot write 'a.gif': its name ends in .gif, which is not a format that dapple writes here; allowed: .png, .tif, .tiff, .exr, .jpg, .jpeg, .webp";
    assert_eq!(message("a.gif"), Err(gif.to_owned()));
    let lossy = check_content(Path::new("a.jpg"), Content::Labels).unwrap_err().to_string();
    assert!(lossy.contains("JPEG") && lossy.ends_with("allowed: .png, .tif, .tiff"), "{lossy}");
    let none = "cannot write 'png': its name has no ending that names the format; allowed: .png, .tif, .tiff, .exr, .jpg, .jpeg, .webp";
    assert_eq!(message("png"), Err(none.to_owned()));
    assert!(message("").is_err());
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::fs::Permissions;
    use std::os::unix::fs::{PermissionsExt, symlink};

    fn mode(path: &Path) -> u32 {
        fs::metadata(path).unwrap().permissions().mode() & 0o777
    }

    #[test]
    fn a_new_file_has_the_permissions_of_any_new_file() {
        let folder = tempfile::tempdir().unwrap();
        let [ours, plain] = ["a.png", "b.png"].map(|name| folder.path().join(name));
        save(&ours, write_new).unwrap();
        fs::write(&plain, "").unwrap();
        assert_eq!(mode(&ours), mode(&plain));
    }

    #[test]
    fn a_replaced_file_keeps_its_permissions() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        fs::write(&path, "old").unwrap();
        fs::set_permissions(&path, Permissions::from_mode(0o604)).unwrap();
        save(&path, write_new).unwrap();
        assert_eq!((mode(&path), fs::read(&path).unwrap()), (0o604, b"new".to_vec()));
    }

    #[test]
    fn a_link_stays_a_link() {
        let folder = tempfile::tempdir().unwrap();
        let [real, link] = ["real.png", "link.png"].map(|name| folder.path().join(name));
        fs::write(&real, "old").unwrap();
        symlink("real.png", &link).unwrap();
        save(&link, write_new).unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&real).unwrap(), b"new");
    }
}
