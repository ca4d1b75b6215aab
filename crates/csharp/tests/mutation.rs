//! Programs with something deleted, doubled, exchanged or replaced: whatever comes of them, nothing panics and nothing
//! goes on beyond its limits. `KATYDID_MUTATIONS` says how many are tried.

#![allow(clippy::unwrap_used, reason = "a test that cannot read its files fails")]

use katydid_csharp::{Engine, Limits, Printing, Source};

/// Knuth's generator: the same mutations in every run.
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % n.max(1)
    }
}

fn pieces(source: &str) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    for c in source.chars() {
        match all.last_mut() {
            Some(last) if c.is_alphanumeric() && last.chars().all(char::is_alphanumeric) => last.push(c),
            _ => all.push(c.to_string()),
        }
    }
    all
}

const SPICE: &[&str] = &[
    "(",
    ")",
    "{",
    "}",
    "[",
    "]",
    "<",
    ">",
    ";",
    ",",
    "=>",
    "null",
    "1.5m",
    "decimal ",
    "ref readonly ",
    "goto ",
    " where T : class ",
    "this",
    "base",
    "default",
    "int",
    "var",
    "dynamic",
    "ref ",
    "out ",
    "yield return ",
    "2147483647",
    "-1",
    "\"",
    "'",
    "$\"{",
    "new ",
    "static ",
    "?",
    "??",
    "?.",
    "<T>",
    "()",
    "goto ",
    "switch",
    "is ",
    "as ",
    "throw ",
    "0",
    "1e308",
    "T",
    "typeof(int)",
    ".ToString()",
    "[0]",
    "++",
    "<<",
    "checked(",
];

#[test]
fn mutated_programs_do_not_panic() {
    let count: usize = std::env::var("KATYDID_MUTATIONS").ok().and_then(|n| n.parse().ok()).unwrap_or(120);
    let folder = std::path::PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/programs");
    let mut paths: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.extension().is_some_and(|e| e == "cs"))
        .collect();
    paths.sort();
    let sources: Vec<_> = paths.iter().map(|p| pieces(&std::fs::read_to_string(p).unwrap())).collect();
    let limits = Limits { steps: 200_000, bytes: 16 << 20, depth: 300, output: 1 << 16 };
    let seed = std::env::var("KATYDID_SEED").ok().and_then(|n| n.parse().ok()).unwrap_or(7);
    let mut dice = Dice(seed);
    for _ in 0..count {
        let mut text = sources[dice.below(sources.len())].clone();
        for _ in 0..=dice.below(4) {
            let at = dice.below(text.len());
            match dice.below(5) {
                0 => {
                    text.remove(at);
                }
                1 => text.insert(at, text[dice.below(text.len())].clone()),
                2 => {
                    let other = dice.below(text.len());
                    text.swap(at, other);
                }
                3 => text[at] = SPICE[dice.below(SPICE.len())].to_owned(),
                _ => text.insert(at, SPICE[dice.below(SPICE.len())].to_owned()),
            }
            if text.is_empty() {
                text.push(String::new());
            }
        }
        let source = text.concat();
        let ran = std::panic::catch_unwind(|| {
            if let Ok(mut engine) =
                Engine::new(&Source::File(&source), Box::new(Printing::default()), limits.clone())
            {
                let _ = engine.run_main();
            }
        });
        if ran.is_err() {
            let kept = std::env::temp_dir().join("katydid-csharp-panic.cs");
            let _ = std::fs::write(&kept, &source);
            panic!("it panicked on {}", kept.display());
        }
    }
}
