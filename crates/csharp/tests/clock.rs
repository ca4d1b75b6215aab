//! Programs see the host's clock, and none where the host has none; a host's own types come before the library's.

use katydid_csharp::{Engine, Host, Limits, Printing, Source, Stop};

/// A clock that goes on by 1.5 ms each time it is looked at, from 2024-02-29 12:00.
struct Clock(Printing, i64);

const NOON: i64 = 638_448_048_000_000_000;

impl Host for Clock {
    fn declarations(&self) -> &str {
        "namespace System { public struct Guid { public int Own; } }"
    }

    fn write(&mut self, text: &str) {
        self.0.write(text);
    }

    fn now(&mut self) -> Option<i64> {
        self.1 += 15_000;
        Some(self.1)
    }
}

fn printed(body: &str) -> Result<String, String> {
    let host = Clock(Printing::default(), NOON - 15_000);
    let text = host.0.text.clone();
    let source =
        format!("using System; using System.Diagnostics; class P {{ static void Main() {{ {body} }} }}");
    let mut engine = Engine::new(&Source::File(&source), Box::new(host), Limits::default())
        .map_err(|errors| errors[0].to_string())?;
    engine.run_main().map_err(|e| e.to_string())?;
    text.lock().map(|t| t.clone()).map_err(|e| e.to_string())
}

#[test]
fn a_stopwatch_goes_by_the_hosts_clock() {
    let text = printed(
        "var w = Stopwatch.StartNew(); Console.WriteLine(w.ElapsedTicks); w.Stop(); Console.WriteLine(w.ElapsedMilliseconds);
         w.Start(); w.Stop(); Console.WriteLine(w.Elapsed); w.Restart(); Console.WriteLine(w.ElapsedTicks);",
    );
    assert_eq!(text.as_deref(), Ok("15000\n3\n00:00:00.0045000\n15000\n"));
}

#[test]
fn the_date_is_the_hosts() {
    let text =
        printed("Console.WriteLine(DateTime.Now); Console.WriteLine(DateTime.UtcNow.ToString(\"o\"));");
    assert_eq!(text.as_deref(), Ok("02/29/2024 12:00:00\n2024-02-29T12:00:00.0015000Z\n"));
}

#[test]
fn a_hosts_type_comes_before_the_librarys() {
    let text = printed("var g = new Guid(); g.Own = 3; Console.WriteLine(g.Own);");
    assert_eq!(text.as_deref(), Ok("3\n"));
}

#[test]
fn without_a_clock_the_run_ends_by_name() {
    let source = "class P { static void Main() { var d = System.DateTime.Now; } }";
    let mut engine = Engine::new(&Source::File(source), Box::new(Printing::default()), Limits::default())
        .unwrap_or_else(|e| panic!("{e:?}"));
    let failure = engine.run_main().expect_err("there is no clock");
    assert!(matches!(failure.stop, Some(Stop::NotSupported(ref what)) if what == "The clock"), "{failure}");
}
