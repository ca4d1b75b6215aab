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
    // Python's own error has no text: it names the limit and the option.
    assert!(said.contains("MemoryError") && said.contains("512 MB together (--script-memory)"), "{said}");
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

/// Whether this machine's kernel has Landlock for the Python that tests run with.
#[cfg(target_os = "linux")]
fn has_landlock() -> bool {
    let code = "import ctypes; c = ctypes.CDLL(None).syscall; c.restype = ctypes.c_long; \
                raise SystemExit(c(ctypes.c_long(444), None, ctypes.c_size_t(0), ctypes.c_uint32(1)) < 1)";
    let python = katydid_script::find(None, None).unwrap().0;
    std::process::Command::new(python).args(["-c", code]).status().unwrap().success()
}

#[test]
#[cfg(target_os = "linux")]
fn what_goes_past_python_is_refused_by_the_kernel() {
    if !has_landlock() {
        println!("this machine has no Landlock: not tested");
        return;
    }
    // O_WRONLY | O_CREAT is 65, O_RDONLY 0; 13 is EACCES. The script's own folder can be written this way too.
    let path = std::env::temp_dir().join(format!("katydid-past-{}", std::process::id()));
    let code = format!(
        "import ctypes\nc = ctypes.CDLL('libc.so.6', use_errno=True)\ndef tried(path, flags):\n    found = \
         c.open(path, flags, 0o600)\n    return ctypes.get_errno() if found < 0 else 0\na = [tried(b'/etc/passwd', 0), \
         tried({:?}.encode(), 65), tried(b'own', 65), c.execv(b'/bin/true', None) * ctypes.get_errno()]",
        path.display().to_string()
    );
    let script = gh_python("past", "x = s", "out, a", &code, "");
    let mut session = session(&format!("s = Series(1, 1, 1)\n{script}"));
    session.solve();
    let found: Vec<f64> = numbers(&session, "past", 1).into_iter().flat_map(|(_, numbers)| numbers).collect();
    assert_eq!(found, [13.0, 13.0, 0.0, -13.0], "{:?}", messages(&session, "past"));
    assert!(!path.exists());
}

/// The Python process whose command names a folder, by its number on this machine.
#[cfg(target_os = "linux")]
fn python_in(folder: &str) -> Option<String> {
    std::fs::read_dir("/proc").unwrap().find_map(|entry| {
        let entry = entry.ok()?;
        let words = std::fs::read(entry.path().join("cmdline")).ok()?;
        let words = String::from_utf8_lossy(&words).into_owned();
        let program = words.split('\0').next()?;
        (program.contains("python") && words.contains(folder))
            .then(|| entry.file_name().into_string().ok())?
    })
}

#[test]
#[cfg(target_os = "linux")]
fn a_process_that_is_killed_while_it_runs_is_back_within_a_second() {
    // What comes before is solved once: it says where its process works, and how often it ran.
    let code = "import os\ncount = globals().get('count', 0) + 1\na = os.getcwd()\nb = count";
    let before = gh_python("before", "x = one", "out, a, b", code, "");
    let code = "import time\nif x > 50:\n    time.sleep(100)\na = x + b";
    let user = gh_python("user", "b = before.b, x = s", "out, a", code, "");
    let mut session =
        session(&format!("one = Series(1, 1, 1)\ns = Number Slider(2.0, 0..100)\n{before}\n{user}"));
    session.solve();
    let found = |session: &Session, name: &str, output: usize| -> Vec<f64> {
        let all = numbers(session, name, output).into_iter().flat_map(|(_, numbers)| numbers);
        all.collect()
    };
    assert_eq!(found(&session, "user", 1), [3.0], "{:?}", messages(&session, "user"));
    let Some(Some(katydid_data::Value::Text(folder))) = common::values(&session, "before", 1).pop() else {
        panic!()
    };
    let folder = folder.trim_end_matches("/work").to_owned();
    let killer = std::thread::spawn(move || {
        std::thread::sleep(Duration::from_millis(700));
        let process = python_in(&folder).unwrap();
        assert!(std::process::Command::new("kill").args(["-9", &process]).status().unwrap().success());
        Instant::now()
    });
    session.set("s", "60").unwrap();
    session.solve();
    let told = killer.join().unwrap().elapsed();
    let said = messages(&session, "user").join("\n");
    assert!(said.contains("The Python process ended"), "{said}");
    // Its numbers are kept, and it is not run again.
    assert_eq!(found(&session, "before", 2), [1.0]);
    session.set("s", "3").unwrap();
    let begin = Instant::now();
    session.solve();
    let back = begin.elapsed();
    assert_eq!(found(&session, "user", 1), [4.0], "{:?}", messages(&session, "user"));
    println!("told {told:?} after the kill, back {back:?} after the next change");
    assert!(back < Duration::from_secs(1), "{back:?}");
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
