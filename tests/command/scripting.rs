//! The commands of `docs/scripting.md` run as they stand there.

use std::fs;
use std::path::Path;
use std::process::Command;

#[test]
#[cfg(unix)]
fn the_commands_of_the_page_on_scripts_run_one_after_the_other() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/scripting.md");
    let page = fs::read_to_string(page).expect("the page");
    let blocks: Vec<&str> =
        page.split("```bash\n").skip(1).filter_map(|rest| rest.split("\n```").next()).collect();
    assert!(blocks.len() >= 7, "{}", blocks.len());
    let folder = tempfile::tempdir().unwrap();
    let program = assert_cmd::cargo::cargo_bin!("dapple").parent().expect("a folder").to_owned();
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap_or_default());
    for block in blocks {
        let mut run = Command::new("bash");
        run.args(["-euo", "pipefail", "-c", block]).env("PATH", &path).current_dir(&folder);
        let output = run.output().expect("bash");
        assert!(output.status.success(), "{block}\n{}", String::from_utf8_lossy(&output.stderr));
    }
    for made in
        ["large.png", "wide.png", "report.json", "measured.json", "dapple.schema.json", "variations", "set"]
    {
        assert!(folder.path().join(made).exists(), "{made}");
    }
}
