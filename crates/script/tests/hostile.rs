//! Scripts that would harm: each is ended or refused with a message, and the next one runs.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

mod common;

use std::time::{Duration, Instant};

use common::{gh_python, messages, numbers, session, session_with, within};
use katydid_component::Cancel;
use katydid_script::Bounds;
use katydid_session::Session;

/// A definition of one script, with a good one behind it.
fn lines(code: &str) -> String {
    let bad = gh_python("bad", "x = s", "out, a", code, "");
    let good = gh_python("good", "x = bad.a", "out, b", "b = 42", "");
    format!("s = Series(1, 1, 1)\n{bad}\n{good}")
}

fn refused(code: &str, word: &str) {
    let mut session = session(&lines(code));
    session.solve();
    let said = messages(&session, "bad").join("\n");
    assert!(said.contains(word), "{said}");
    goes_on(&session);
}

fn goes_on(session: &Session) {
    let found: Vec<f64> = numbers(session, "good", 1).into_iter().flat_map(|(_, numbers)| numbers).collect();
    assert_eq!(found, [42.0], "{:?}", messages(session, "good"));
}

#[test]
fn files_of_the_machine_are_not_read() {
    refused("a = open('/etc/passwd').read()", "may not read the file /etc/passwd");
    refused("import os\na = os.listdir('/')", "may not read the folder /");
}

#[test]
fn files_of_the_machine_are_not_written() {
    let path = std::env::temp_dir().join(format!("katydid-script-{}", std::process::id()));
    refused(
        &format!("open({:?}, 'w').write('x')\na = 1", path.display().to_string()),
        "may not write the file",
    );
    assert!(!path.exists());
    refused("import os\nos.remove('/etc/hostname')\na = 1", "may not");
}

#[test]
fn there_is_no_network_and_no_other_program() {
    refused(
        "import socket\ns = socket.socket()\ns.connect(('127.0.0.1', 9))\na = 1",
        "may not use the network",
    );
    refused("import os\na = os.system('true')", "may not start or end other programs");
    refused("import os\nwhile True:\n    os.fork()", "may not start or end other programs");
    refused("import subprocess\na = subprocess.check_output(['id'])", "may not start or end other programs");
}

#[test]
fn a_file_of_its_own_is_written_and_read() {
    let code = "f = open('own.txt', 'w')\nf.write('12')\nf.close()\na = int(open('own.txt').read())";
    let script = gh_python("own", "x = s", "out, a", code, "");
    let mut session = session(&format!("s = Series(1, 1, 1)\n{script}"));
    session.solve();
    assert_eq!(
        numbers(&session, "own", 1),
        [("{0;0}".to_owned(), vec![12.0])],
        "{:?}",
        messages(&session, "own")
    );
}

#[test]
fn too_much_memory_is_an_error() {
    let bounds = Bounds { memory: 512 << 20, ..Bounds::default() };
    let mut session = session_with(
        &lines("a = len(bytearray(10 * 1024 * 1024 * 1024))"),
        bounds,
        within(60),
        Cancel::default(),
    );
    session.solve();
    let said = messages(&session, "bad").join("\n");
    assert!(said.contains("MemoryError") || said.contains("memory"), "{said}");
    goes_on(&session);
}

#[test]
fn an_endless_loop_ends_with_the_time() {
    let begin = Instant::now();
    let mut session =
        session_with(&lines("while True: pass"), Bounds::default(), within(3), Cancel::default());
    session.solve();
    let said = messages(&session, "bad").join("\n");
    assert!(said.contains("time limit"), "{said}");
    assert!(begin.elapsed() < Duration::from_secs(30), "{:?}", begin.elapsed());
}

#[test]
fn a_loop_that_will_not_be_interrupted_is_ended() {
    let code = "while True:\n    try:\n        while True: pass\n    except BaseException:\n        pass";
    let begin = Instant::now();
    let mut session = session_with(&lines(code), Bounds::default(), within(3), Cancel::default());
    session.solve();
    let said = messages(&session, "bad").join("\n");
    assert!(said.contains("time limit"), "{said}");
    assert!(begin.elapsed() < Duration::from_secs(30), "{:?}", begin.elapsed());
}

#[test]
fn a_cancelled_solve_ends_its_script() {
    let cancel = Cancel::default();
    let stop = cancel.clone();
    let waiter = std::thread::spawn(move || {
        std::thread::sleep(Duration::from_secs(2));
        stop.cancel();
    });
    let begin = Instant::now();
    let mut session = session_with(
        &lines("import time\ntime.sleep(100)"),
        Bounds::default(),
        katydid_component::Limits::default(),
        cancel,
    );
    session.solve();
    waiter.join().unwrap();
    assert!(begin.elapsed() < Duration::from_secs(30), "{:?}", begin.elapsed());
}

#[test]
fn a_process_that_dies_is_started_again() {
    // The script ends its own process past Python's exits, as a crash would.
    let mut session = session(&lines("import os\nos._exit(9)"));
    session.solve();
    let said = messages(&session, "bad").join("\n");
    assert!(said.contains("The Python process ended"), "{said}");
    goes_on(&session);
}

#[test]
fn what_was_lost_with_a_process_is_made_again() {
    let code = "class Part(object):\n    def __init__(self, n):\n        self.n = n\na = Part(7)";
    let maker = gh_python("maker", "x = one", "out, a", code, "");
    let code = "import os\nif x > 50:\n    os._exit(9)\na = p.n * x";
    let user = gh_python("user", "p = maker.a, x = s", "out, a", code, "");
    let mut session =
        session(&format!("one = Series(1, 1, 1)\ns = Number Slider(2.0, 0..100)\n{maker}\n{user}"));
    session.solve();
    let found = |session: &Session| -> Vec<f64> {
        let all = numbers(session, "user", 1).into_iter().flat_map(|(_, numbers)| numbers);
        all.collect()
    };
    assert_eq!(found(&session), [14.0], "{:?}", messages(&session, "user"));
    session.set("s", "60").unwrap();
    session.solve();
    let said = messages(&session, "user").join("\n");
    assert!(said.contains("The Python process ended"), "{said}");
    session.set("s", "3").unwrap();
    let begin = Instant::now();
    session.solve();
    // The part was made by a process that is gone: it is made anew, though nothing that it hangs on has changed.
    assert_eq!(found(&session), [21.0], "{:?}", messages(&session, "user"));
    println!("back after a process that died: {:?}", begin.elapsed());
}
