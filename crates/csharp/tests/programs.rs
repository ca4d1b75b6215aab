//! Small programs, one a feature or corner, with what Mono makes of them (`tests/mono.py`): the same is printed, and
//! what Mono refuses is refused, with the same number where the two compilers of C# agree on it.

#![allow(clippy::unwrap_used, reason = "a test that cannot read its files fails")]

use std::path::PathBuf;

use katydid_csharp::{Engine, Limits, Printing, Source};

/// Where csc, whose words are followed here, numbers an error otherwise than Mono.
const NUMBERED_AS_CSC: &[(&str, u16)] = &[
    ("bad_call", 149),
    ("bad_condition", 29),
    ("bad_constraint", 411),
    ("bad_infer", 411),
    ("bad_new_args", 7036),
    ("bad_semicolon", 1002),
];

/// What a program prints, or its first error.
fn outcome(source: &str) -> Result<String, (u16, String)> {
    let host = Printing::default();
    let printed = host.text.clone();
    let mut engine = Engine::new(&Source::File(source), Box::new(host), Limits::default())
        .map_err(|errors| (errors[0].code, errors[0].to_string()))?;
    let ended = engine.run_main();
    let mut text = printed.lock().unwrap().clone();
    if let Err(failure) = ended {
        text.push_str(&format!("\n{failure}"));
    }
    Ok(text)
}

fn programs() -> Vec<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/programs");
    let mut all: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "cs"))
        .collect();
    all.sort();
    all
}

#[test]
fn programs_print_what_mono_prints() {
    let mut wrong = Vec::new();
    let mut count = 0;
    for path in programs() {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let source = std::fs::read_to_string(&path).unwrap();
        let result = outcome(&source);
        count += 1;
        if let Ok(expected) = std::fs::read_to_string(path.with_extension("out")) {
            match result {
                Ok(text) if text == expected => {}
                Ok(text) => {
                    let line = text.lines().zip(expected.lines()).find(|(a, b)| a != b);
                    wrong.push(format!("{name}: {line:?}"));
                }
                Err((_, message)) => wrong.push(format!("{name}: {message}")),
            }
            continue;
        }
        let expected = std::fs::read_to_string(path.with_extension("err")).unwrap();
        match result {
            Ok(_) => wrong.push(format!("{name}: was not refused")),
            Err((code, message)) => {
                let same = expected.split_whitespace().any(|c| c == format!("CS{code:04}"));
                if !same && !NUMBERED_AS_CSC.contains(&(name.as_str(), code)) {
                    wrong.push(format!("{name}: {message}, but Mono says {expected}"));
                }
            }
        }
    }
    assert!(count > 280, "{count} programs");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
