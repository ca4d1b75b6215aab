//! How long a warm script takes beside the script itself. The bounds are wide, since tests run beside others; `--nocapture`
//! prints the numbers.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

mod common;

use std::time::{Duration, Instant};

use common::{gh_python, messages, numbers, session};

/// Thirteen lines, as the scripts of real files have in the middle.
const THIRTEEN: &str = "import math\nr = x\nn = 12\nt = 0.0\nfor i in range(n):\n    u = 2.0 * math.pi * i / n\n    \
                        c = math.cos(u) * r\n    s = math.sin(u) * r\n    t += c * c + s * s\nif t < 0:\n    \
                        raise ValueError('no')\nt = t / n\na = t";

fn median(mut times: Vec<Duration>) -> Duration {
    times.sort_unstable();
    times.get(times.len() / 2).copied().unwrap_or_default()
}

#[test]
fn a_warm_call_is_short() {
    let script = gh_python("warm", "x = s", "out, a", THIRTEEN, "");
    let mut session = session(&format!("s = Number Slider(1.00, 0..100)\n{script}"));
    session.solve();
    let times = (1..200u32).map(|k| {
        session.set("s", &format!("{}", f64::from(k) * 0.25)).unwrap();
        let begin = Instant::now();
        session.solve();
        begin.elapsed()
    });
    let times = times.collect();
    let found: Vec<f64> = numbers(&session, "warm", 1).into_iter().flat_map(|(_, x)| x).collect();
    assert!((found[0] - 49.75 * 49.75).abs() < 1e-6, "{found:?} {:?}", messages(&session, "warm"));
    let median = median(times);
    println!("a warm call of 13 lines, with its solve: {median:?}");
    assert!(median < Duration::from_millis(20), "{median:?}");
}

#[test]
fn ten_thousand_points_go_in_and_out() {
    let access = "    ParameterData/InputParam[0]/ScriptParamAccess = 1\n";
    let script = gh_python("through", "x = p", "out, a", "a = x", access);
    let lines = "s = Number Slider(1.00, 0..100)\nr = Series(s, 1, 10000)\np = Construct Point(r, 0, 0)";
    let mut session = session(&format!("{lines}\n{script}\nback = Deconstruct(through.a)"));
    session.solve();
    let times = (1..12u32).map(|k| {
        session.set("s", &format!("{k}")).unwrap();
        let begin = Instant::now();
        session.solve();
        begin.elapsed()
    });
    let median = median(times.collect());
    let found: Vec<f64> = numbers(&session, "back", 0).into_iter().flat_map(|(_, x)| x).collect();
    assert_eq!(
        (found.len(), found[0], found[9999]),
        (10_000, 11.0, 10_010.0),
        "{:?}",
        messages(&session, "through")
    );
    println!("10,000 points through a script, with their solve: {median:?}");
    assert!(median < Duration::from_millis(500), "{median:?}");
}
