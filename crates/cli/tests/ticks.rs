//! Definitions in time: `--ticks`.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::path::PathBuf;

use common::{katydid, said, text};
use serde_json::Value;

/// Runs a definition that is written down here.
struct Run {
    _folder: tempfile::TempDir,
    file: PathBuf,
}

impl Run {
    fn of(definition: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("definition.kd");
        std::fs::write(&file, format!("katydid 1\n{definition}")).unwrap();
        Self { _folder: folder, file }
    }

    fn output(&self, words: &[&str]) -> std::process::Output {
        katydid(&[&["run", text(&self.file), "--json"], words].concat())
    }

    /// What an object gives after so many ticks, branch by branch, and what was said.
    fn items(&self, name: &str, words: &[&str]) -> (Vec<Vec<String>>, String) {
        let output = self.output(words);
        let report: Value =
            serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{}", said(&output)));
        let objects = report["objects"].as_array().unwrap();
        let object = objects.iter().find(|o| o["nickname"] == name).unwrap();
        let branches = object["outputs"][0]["branches"].as_array().unwrap();
        let item = |item: &Value| item.as_str().unwrap().to_owned();
        let items = |branch: &Value| branch["items"].as_array().unwrap().iter().map(item).collect();
        (branches.iter().map(items).collect(), said(&output))
    }

    fn item(&self, name: &str, words: &[&str]) -> String {
        let (items, said) = self.items(name, words);
        assert_eq!(items.iter().flatten().count(), 1, "{items:?} {said}");
        items[0][0].clone()
    }
}

#[test]
fn a_recorder_counts_what_a_timer_does() {
    let run = Run::of(
        "n = Number Slider(4, 0..10)\n\
         clock = Trigger(n, interval = 500)\n\
         rec = Data Recorder(n)\n\
         count = List Length(rec)\n",
    );
    assert_eq!(run.item("count", &[]), "1");
    assert_eq!(run.item("count", &["--ticks", "0"]), "1");
    let (items, said) = run.items("count", &["--ticks", "9"]);
    assert_eq!(items, [["10"]]);
    assert!(said.contains("9 of 9 ticks, 4.5 s in the definition's time"), "{said}");
    assert_eq!(run.items("rec", &["--ticks", "2", "--set", "n=7"]).0, [["7", "7", "7"]]);
}

#[test]
fn only_what_hangs_on_the_target_is_recorded_again() {
    let run = Run::of(
        "a = Number Slider(1, 0..10)\n\
         b = Number Slider(2, 0..10)\n\
         sum = Addition(a, b)\n\
         clock = Trigger(sum)\n\
         of a = Data Recorder(a)\n\
         of sum = Data Recorder(sum) -> sum |graft\n\
         off = Data Recorder(sum, record = false)\n",
    );
    assert_eq!(run.items("of a", &["--ticks", "3"]).0, [["1"]]);
    assert_eq!(run.items("of sum", &["--ticks", "3"]).0, [["3"], ["3"], ["3"], ["3"]]);
    assert_eq!(run.items("off", &["--ticks", "3"]).0, [["3"]]);
}

#[test]
fn a_tracker_draws_the_values_of_all_ticks() {
    let run = Run::of(
        "n = Number Slider(4, 0..10)\n\
         clock = Trigger(n, interval = 500)\n\
         rec = Data Recorder(n)\n\
         count = List Length(rec)\n\
         tracker = Value Tracker(count)\n",
    );
    // It hands on what comes.
    assert_eq!(run.item("tracker", &["--ticks", "5"]), run.item("count", &["--ticks", "5"]));
    let picture = run.file.with_extension("svg");
    // How many values its line joins.
    let values = |words: &[&str]| {
        let output = katydid(&[&["view", text(&run.file), "--canvas", "-o", text(&picture)], words].concat());
        assert!(output.status.success(), "{}", said(&output));
        let drawing = std::fs::read_to_string(&picture).unwrap();
        let line = drawing.split("<path ").find(|path| path.contains("stroke-width=\"1.4\"")).unwrap();
        let path = line.split('"').nth(1).unwrap();
        path.split(['M', 'L', ' ']).filter(|number| !number.is_empty()).count() / 2
    };
    // One value is a level line.
    assert_eq!(values(&[]), 2);
    assert_eq!(values(&["--ticks", "5"]), 6);
}

#[test]
fn a_recorder_keeps_the_newest_of_each_branch() {
    // The recorder numbers its own loop: each tick adds one to the last of what is there.
    let run = Run::of(
        "start = Number(0)\n\
         all = Merge(start, rec)\n\
         last = List Item(all, -1)\n\
         next = Addition(last, 1)\n\
         rec = Data Recorder(next, limit = 3)\n",
    );
    assert_eq!(run.items("rec", &["--ticks", "2"]).0, [["1", "2"]]);
    assert_eq!(run.items("rec", &["--ticks", "10"]).0, [["8", "9", "10"]]);
    assert_eq!(run.item("next", &["--ticks", "10"]), "11");
}

#[test]
fn a_loop_through_a_recorder_makes_fibonacci_numbers() {
    let run = Run::of(
        "seeds = Number([0, 1])\n\
         all = Merge(seeds, rec)\n\
         two = List Item(all, [-1, -2])\n\
         next = Mass Addition(two)\n\
         rec = Data Recorder(next)\n",
    );
    // F(2) after no tick, F(12) after ten.
    assert_eq!(run.item("next", &["--ticks", "0"]), "1");
    assert_eq!(run.item("next", &["--ticks", "10"]), "144");
    assert_eq!(run.items("rec", &["--ticks", "5"]).0, [["1", "2", "3", "5", "8"]]);
    // In a single solution it stays what it is: a loop.
    let output = run.output(&[]);
    assert_eq!(output.status.code(), Some(1));
    assert!(said(&output).contains("read each other in a loop"), "{}", said(&output));
}

#[test]
fn a_loop_through_a_dam_takes_the_time_of_its_delay() {
    let looped = |dam: &str| {
        Run::of(&format!(
            "start = Number(0)\n\
             all = Merge(start, dam)\n\
             last = List Item(all, -1)\n\
             next = Addition(last, 1)\n\
             dam = {dam}\n"
        ))
    };
    for (dam, time) in [("Data Dam(next, delay = 0.25)", "2 s"), ("Data Dam(next)", "0 s")] {
        let (items, said) = looped(dam).items("next", &["--ticks", "8"]);
        assert_eq!(items, [["9"]]);
        assert!(said.contains(&format!("8 of 8 ticks, {time} in")), "{said}");
    }
}

#[test]
fn a_dam_lets_the_newest_data_through_after_its_delay() {
    let run = Run::of(
        "n = Number Slider(4, 0..10)\n\
         clock = Trigger(n, interval = 100)\n\
         dam = Data Dam(n, delay = 0.25)\n\
         passed = Data Recorder(dam)\n\
         count = List Length(passed)\n",
    );
    // The timer fires at 0.1, 0.2 … 1.0 s; the dam opens at 0.35, 0.65 and 0.95 s.
    let (items, said) = run.items("count", &["--ticks", "13"]);
    assert_eq!(items, [["4"]]);
    assert!(said.contains("13 of 13 ticks, 1 s in"), "{said}");
    assert_eq!(run.item("count", &["--ticks", "3"]), "1");
    assert_eq!(run.item("count", &["--ticks", "4"]), "2");
}

#[test]
fn without_anything_that_happens_the_run_ends() {
    for definition in [
        "n = Number Slider(4, 0..10)\nclock = Trigger(n) disabled\n",
        "n = Number Slider(4, 0..10)\nclock = Trigger(@00000000-0000-0000-0000-000000000007)\n",
        "n = Number Slider(4, 0..10)\n",
    ] {
        let (items, said) = Run::of(definition).items("n", &["--ticks", "1000000000"]);
        assert_eq!(items, [["4"]]);
        assert!(said.contains("nothing happens any more: no Trigger is on"), "{said}");
    }
    // A dam holds back what came, once.
    let run = Run::of("n = Number Slider(4, 0..10)\ndam = Data Dam(n, delay = 1)\n");
    assert!(run.items("dam", &["--ticks", "5"]).1.contains("0 of 5 ticks"));
}

#[test]
fn limits_hold_over_all_ticks() {
    let run = Run::of("n = Number Slider(4, 0..10)\nclock = Trigger(n)\nrec = Data Recorder(n)\n");
    let output = run.output(&["--ticks", "1000000000", "--limit-seconds", "0.2"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        said(&output).contains("ended early: the time limit of 0.2 seconds is over"),
        "{}",
        said(&output)
    );
    let (items, said) = run.items("rec", &["--ticks", "20", "--limit-items", "5"]);
    assert_eq!(items, [["4"; 5]]);
    assert!(said.contains("The recorder is full: it holds 5 items"), "{said}");
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_tells_where_it_was() {
    use std::io::Read;
    use std::process::{Command, Stdio};
    let run = Run::of("n = Number Slider(4, 0..10)\nclock = Trigger(n, interval = 1000)\n");
    let mut child = Command::new(env!("CARGO_BIN_EXE_katydid"))
        .args(["run", text(&run.file), "--ticks", "1000000000000"])
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(700));
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    let mut said = String::new();
    child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(1), "{said}");
    assert!(said.contains("ended early: interrupted") && said.contains("of 1000000000000 ticks"), "{said}");
}

#[test]
fn the_settings_of_time_survive_the_way_through_an_archive() {
    let definition = "katydid 1\n\n\
        n = Number Slider(4, 0..10)\n\
        clock = Trigger(n, rec, interval = 500)\n\
        slow = Trigger(n)\n\
        rec = Data Recorder(limit = 3, record = false, n)\n\
        dam = Data Dam(delay = 0.25, n)\n";
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name);
    std::fs::write(file("a.kd"), definition).unwrap();
    for [from, to] in [["a.kd", "b.gh"], ["b.gh", "c.kd"], ["c.kd", "d.gh"]] {
        let output = katydid(&["convert", text(&file(from)), text(&file(to))]);
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    }
    let written = std::fs::read_to_string(file("c.kd")).unwrap();
    for line in definition.lines().skip(2) {
        assert!(written.contains(line), "{line}\n{written}");
    }
    assert!(!written.contains("details"), "{written}");
    let output = katydid(&["diff", text(&file("b.gh")), text(&file("d.gh"))]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
}
