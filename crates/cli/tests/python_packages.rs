//! `katydid python add`: packages beside a definition, found by its scripts. The packages are made here: no network.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use common::{said, text};

/// A wheel of one module, in a folder that stands for the index.
fn wheel(index: &Path, name: &str, version: &str, code: &str, needs: &str) {
    let make = String::from(
        "import sys, zipfile\nname, version, code, needs, folder = sys.argv[1:]\nz = zipfile.ZipFile('%s/%s-%s-py3-none-any.whl' \
         % (folder, name, version), 'w')\ninfo = '%s-%s.dist-info/' % (name, version)\nz.writestr(name + '.py', \
         code)\nmeta = 'Metadata-Version: 2.1\\nName: %s\\nVersion: %s\\n' % (name, version)\nif needs: meta += \
         'Requires-Dist: ' + needs + '\\n'\nz.writestr(info + 'METADATA', meta)\nz.writestr(info + 'WHEEL', \
         'Wheel-Version: 1.0\\nGenerator: t\\nRoot-Is-Purelib: true\\nTag: py3-none-any\\n')\nz.writestr(info + 'RECORD', \
         '')\nz.close()\n",
    );
    let made = Command::new("python3").args(["-c", &make, name, version, code, needs, text(index)]).status();
    assert!(made.unwrap().success());
}

fn definition(folder: &Path, code: &str) -> PathBuf {
    let path = folder.join("facade.kd");
    let code: String = code.lines().map(|line| format!("        {line}\n")).collect();
    let body = format!(
        "katydid 1\ns = Number Slider(21, 0..100)\ntwice = `GhPython Script` \
         @410755b1-224a-4c1e-a407-bf32fb45ea7e(x = s) variable -> out, a {{\n    CodeInput = \"\"\"\n{code}        \"\"\"\n    \
         HideInput = true\n}}\n"
    );
    fs::write(&path, body).unwrap();
    path
}

/// The command, with the folder as the only index that pip may ask.
fn katydid(index: &Path, words: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_katydid"));
    command
        .args(words)
        .env("PIP_NO_INDEX", "1")
        .env("PIP_FIND_LINKS", index)
        .env("PIP_CONFIG_FILE", "/dev/null");
    command.env_remove("KATYDID_PYTHON").output().unwrap()
}

fn printed(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
fn a_package_is_installed_beside_the_definition_locked_and_found() {
    let folder = tempfile::tempdir().unwrap();
    let index = tempfile::tempdir().unwrap();
    wheel(index.path(), "katydid_trial_part", "1.5", "size = 2", "");
    wheel(index.path(), "katydid_trial", "0.9", "factor = 0", "");
    wheel(
        index.path(),
        "katydid_trial",
        "1.0",
        "import katydid_trial_part\nfactor = katydid_trial_part.size",
        "katydid_trial_part>=1",
    );
    let file = definition(
        folder.path(),
        "# r: katydid_trial==1.0\nimport katydid_trial\na = x * katydid_trial.factor",
    );
    let run = || katydid(index.path(), &["run", text(&file), "--json", "--allow-scripts"]);

    // Without it the error names the command, and so does `check`.
    let before = run();
    let words = printed(&before) + &said(&before);
    assert!(words.contains("katydid python add") && words.contains("katydid_trial==1.0"), "{words}");
    let checked = printed(&katydid(index.path(), &["check", text(&file)]));
    assert!(checked.contains("katydid_trial==1.0, a package of Python"), "{checked}");

    // Without a name: what the `# r:` line asks for.
    let added = katydid(index.path(), &["python", "add", "--file", text(&file)]);
    assert!(added.status.success(), "{}", said(&added));
    let words = printed(&added);
    assert!(words.contains("katydid_trial==1.0") && words.contains("katydid_trial_part==1.5"), "{words}");
    let lock = fs::read_to_string(folder.path().join("python-packages.lock")).unwrap();
    let lines: Vec<&str> = lock.lines().filter(|line| line.contains("--hash=sha256:")).collect();
    assert_eq!(lines.len(), 2, "{lock}");
    assert!(lock.contains("# asked: katydid_trial==1.0"), "{lock}");

    let after = run();
    assert!(printed(&after).contains("\"42\""), "{} {}", printed(&after), said(&after));
    // A path from the working folder finds the environment too.
    let mut here = Command::new(env!("CARGO_BIN_EXE_katydid"));
    here.current_dir(folder.path())
        .args(["run", "facade.kd", "--json", "--allow-scripts"])
        .env_remove("KATYDID_PYTHON");
    let near = here.output().unwrap();
    assert!(printed(&near).contains("\"42\""), "{} {}", printed(&near), said(&near));
    let checked = printed(&katydid(index.path(), &["check", text(&file)]));
    assert!(checked.contains("runs"), "{checked}");

    // The environment is made again from the lock alone; an archive that was changed is refused.
    fs::remove_dir_all(folder.path().join(".venv")).unwrap();
    let synced = katydid(index.path(), &["python", "sync", "--file", text(&file)]);
    assert!(synced.status.success(), "{}", said(&synced));
    assert!(printed(&run()).contains("\"42\""));
    fs::remove_dir_all(folder.path().join(".venv")).unwrap();
    wheel(index.path(), "katydid_trial_part", "1.5", "size = 666", "");
    let forged = katydid(index.path(), &["python", "sync", "--file", text(&file)]);
    assert!(!forged.status.success());
    assert!(said(&forged).contains("HASHES"), "{}", said(&forged));
}

#[test]
fn what_cannot_be_installed_changes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let index = tempfile::tempdir().unwrap();
    let file = definition(folder.path(), "a = x");
    let missing = katydid(index.path(), &["python", "add", "katydid-trial-nowhere", "--file", text(&file)]);
    assert_eq!(missing.status.code(), Some(2));
    assert!(said(&missing).contains("katydid-trial-nowhere"), "{}", said(&missing));
    assert!(!folder.path().join("python-packages.lock").exists());
    // An option of pip is no package.
    let option = katydid(
        index.path(),
        &["python", "add", "--file", text(&file), "--", "--index-url=http://localhost"],
    );
    assert_eq!(option.status.code(), Some(2));
    assert!(said(&option).contains("is no package"), "{}", said(&option));
}
