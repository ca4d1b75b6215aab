//! Scripts run when they are allowed, and say what to do when they are not.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use common::{katydid, said, text};

/// A definition of one script, which doubles 21.
fn definition(folder: &Path, code: &str) -> PathBuf {
    let path = folder.join("script.kd");
    let body = format!(
        "katydid 1\ns = Number Slider(21, 0..100)\ntwice = `GhPython Script` \
         @410755b1-224a-4c1e-a407-bf32fb45ea7e(x = s) variable -> out, a {{\n    CodeInput = \"\"\"\n        {code}\n        \
         \"\"\"\n    HideInput = true\n}}\nafter = Addition(s, 1)\n"
    );
    fs::write(&path, body).unwrap();
    path
}

fn with_settings(folder: &Path, words: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_katydid")).args(words).env("XDG_CONFIG_HOME", folder).output().unwrap()
}

#[test]
fn a_script_that_is_not_allowed_says_so_and_the_rest_runs() {
    let folder = tempfile::tempdir().unwrap();
    let file = definition(folder.path(), "a = x * 2");
    let output = with_settings(folder.path(), &["run", text(&file), "--json"]);
    let words = said(&output);
    assert!(
        words.contains("twice is a IronPython 2 script and was not run") || words.contains("was not run"),
        "{words}"
    );
    assert!(words.contains("--allow-scripts") && words.contains("katydid trust"), "{words}");
    let printed = String::from_utf8_lossy(&output.stdout);
    assert!(printed.contains("\"22\"") && !printed.contains("\"42\""), "{printed}");
}

#[test]
fn a_script_runs_with_the_flag_and_in_a_trusted_file_until_it_changes() {
    let folder = tempfile::tempdir().unwrap();
    let file = definition(folder.path(), "a = x * 2");
    let run = |more: &[&str]| {
        let words: Vec<&str> =
            ["run", text(&file), "--json"].into_iter().chain(more.iter().copied()).collect();
        let output = with_settings(folder.path(), &words);
        (String::from_utf8_lossy(&output.stdout).into_owned(), said(&output))
    };
    let (printed, words) = run(&["--allow-scripts"]);
    assert!(printed.contains("\"42\""), "{printed} {words}");
    assert!(run(&[]).1.contains("was not run"));
    let trusted = with_settings(folder.path(), &["trust", text(&file)]);
    assert!(trusted.status.success(), "{}", said(&trusted));
    assert!(run(&[]).0.contains("\"42\""));
    definition(folder.path(), "a = x * 3");
    assert!(run(&[]).1.contains("was not run"));
}

#[test]
fn without_a_python_a_message_says_what_to_install() {
    let folder = tempfile::tempdir().unwrap();
    let file = definition(folder.path(), "a = x * 2");
    let output = Command::new(env!("CARGO_BIN_EXE_katydid"))
        .args(["run", text(&file), "--allow-scripts"])
        .env("PATH", folder.path())
        .output()
        .unwrap();
    let words = said(&output);
    assert!(words.contains("There is no Python to run scripts with: install Python"), "{words}");
}

#[test]
fn check_names_what_a_script_needs() {
    let folder = tempfile::tempdir().unwrap();
    let code = "import no_such_package\n        import Rhino.Geometry as rg\n        \
                a = rg.Brep.CreateShell([], [], 0.1, 0.01)";
    let file = definition(folder.path(), code);
    let output = katydid(&["check", text(&file)]);
    let printed = String::from_utf8_lossy(&output.stdout);
    assert!(printed.contains("no_such_package, a module of Python"), "{printed}");
    assert!(printed.contains("Brep.CreateShell"), "{printed}");
    let good = definition(folder.path(), "import math, Rhino\n        a = math.sqrt(x)");
    let output = katydid(&["check", text(&good)]);
    let printed = String::from_utf8_lossy(&output.stdout);
    assert!(printed.contains("runs"), "{printed}");
}

/// `["call", "Curve.GetLength", a circle of radius 1]`, byte by byte.
#[test]
fn members_answer_over_the_standard_pipes() {
    let mut message = vec![b'l', 3, 0, 0, 0];
    for word in ["call", "Curve.GetLength"] {
        message.push(b's');
        message.extend(u32::try_from(word.len()).unwrap().to_le_bytes());
        message.extend(word.as_bytes());
    }
    message.push(b'c');
    let plane = [0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.];
    plane.iter().chain(&[1.0]).for_each(|x: &f64| message.extend(x.to_le_bytes()));
    let mut child = Command::new(env!("CARGO_BIN_EXE_katydid"))
        .args(["members", "--stdio"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut pipe = child.stdin.take().unwrap();
    pipe.write_all(&u32::try_from(message.len()).unwrap().to_le_bytes()).unwrap();
    pipe.write_all(&message).unwrap();
    drop(pipe);
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success());
    // A list of the text "ok" and a number: 4 bytes of length, 5 of the list, 7 of the text, the tag and the number.
    let number = f64::from_le_bytes(output.stdout[17..25].try_into().unwrap());
    assert!((number - std::f64::consts::TAU).abs() < 1e-12, "{:?}", output.stdout);
}

/// A weather file of two hours: eight lines of heading, then hours with the dry bulb temperature in the seventh field.
fn weather(folder: &Path) -> PathBuf {
    let mut lines = vec!["LOCATION,Test,-,-,-,0,48.0,11.0,1.0,500.0".to_owned()];
    lines.extend((0..7).map(|k| format!("HEADING {k}")));
    lines.extend([20.5, 22.5].map(|t| format!("2026,6,21,12,60,source,{t},10.0")));
    let path = folder.join("deep").join("test.epw");
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(&path, lines.join("\n")).unwrap();
    path
}

/// A folder that the command names is read, with what is below it; nothing is written in it, and nothing beside it is read.
#[test]
fn a_folder_that_is_named_is_read_and_not_written() {
    let (folder, open) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let path = weather(open.path());
    let mean = format!(
        "a = sum(float(line.split(',')[6]) for line in open({:?}).read().splitlines()[8:]) / 2.0",
        path.display().to_string()
    );
    let run = |code: &str, read: &[&str]| {
        let file = definition(folder.path(), code);
        let words: Vec<&str> = ["run", text(&file), "--json", "--allow-scripts"]
            .into_iter()
            .chain(read.iter().copied())
            .collect();
        let output = with_settings(folder.path(), &words);
        (String::from_utf8_lossy(&output.stdout).into_owned(), said(&output))
    };
    let (printed, words) = run(&mean, &["--script-read", text(open.path())]);
    assert!(printed.contains("\"21.5\""), "{printed} {words}");
    // Without the permission, and with one for another folder.
    let other = tempfile::tempdir().unwrap();
    let refused: [&[&str]; 2] = [&[], &["--script-read", text(other.path())]];
    for read in refused {
        let (printed, words) = run(&mean, read);
        assert!((printed + &words).contains("may not read the file"), "{words}");
    }
    let named = ["--script-read", text(open.path())];
    let beside = folder.path().join("secret.txt");
    fs::write(&beside, "secret").unwrap();
    let cases = [
        (format!("open({:?}, 'a').write('x')", path.display().to_string()), "may not write the file"),
        (format!("import os\n        os.remove({:?})", path.display().to_string()), "may not"),
        (format!("a = open({:?}).read()", beside.display().to_string()), "may not read the file"),
        (
            format!(
                "a = open({:?} + '/../' + {:?}).read()",
                open.path().display().to_string(),
                beside.display().to_string()
            ),
            "may not read the file",
        ),
    ];
    for (code, word) in &cases {
        let (printed, words) = run(code, &named);
        let all = printed + &words;
        assert!(all.contains(word) && !all.contains("\"secret\""), "{code}: {all}");
    }
    assert_eq!(fs::read_to_string(&path).unwrap().lines().count(), 10);
    #[cfg(unix)]
    {
        let link = open.path().join("link.txt");
        std::os::unix::fs::symlink(&beside, &link).unwrap();
        let (printed, words) = run(&format!("a = open({:?}).read()", link.display().to_string()), &named);
        assert!((printed + &words).contains("may not read the file"), "a link leads out of the folder");
    }
    let file = definition(folder.path(), "a = 1");
    let gone = folder.path().join("gone");
    let output =
        with_settings(folder.path(), &["run", text(&file), "--allow-scripts", "--script-read", text(&gone)]);
    assert!(!output.status.success() && said(&output).contains("--script-read"), "{}", said(&output));
}
