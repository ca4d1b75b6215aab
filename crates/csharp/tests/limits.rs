//! Programs that would never end are stopped, with the line and the reason; texts that are no programs are refused.

#![allow(clippy::unwrap_used, reason = "a test that meets no error fails")]

use katydid_csharp::{Engine, Failure, Host, Limits, Printing, Source, Stop};

fn small() -> Limits {
    Limits { steps: 2_000_000, bytes: 32 << 20, depth: 2_000, output: 1 << 20 }
}

fn run_with(body: &str, members: &str, host: Box<dyn Host>) -> Failure {
    let source = format!(
        "using System;\nusing System.Collections.Generic;\nclass P {{\n{members}\nstatic void Main() {{\n{body}\n}} }}"
    );
    let mut engine =
        Engine::new(&Source::File(&source), host, small()).map_err(|e| e[0].to_string()).unwrap();
    engine.run_main().unwrap_err()
}

fn run(body: &str, members: &str) -> Failure {
    run_with(body, members, Box::new(Printing::default()))
}

#[test]
fn an_endless_loop_ends() {
    let failure = run("while (true) { }", "");
    assert_eq!(failure.stop, Some(Stop::Steps(2_000_000)));
    assert_eq!(failure.at.unwrap().line, 6);
}

/// Also where condition and step of a loop are one operation, and where a call is none.
#[test]
fn short_loops_are_counted() {
    for body in [
        "for (int i = 0; i < 2000000000; i++) { }",
        "int n = 5; for (int i = 0; i < n; i++) i--;",
        "for (int i = 0; i < 10; i++) for (int j = 0; j < 3; j++) if (j == 2) { i = 0; j = -1; }",
        "double x = 0; while (x < 1.0) x = Half(x);",
        "for (long i = 0; i < 4000000000L; i += 1L) { }",
    ] {
        let failure = run(body, "static double Half(double x) { return x * 0.5; }");
        assert_eq!(failure.stop, Some(Stop::Steps(2_000_000)), "{body}");
        assert_eq!(failure.at.unwrap().line, 6, "{body}");
    }
}

/// Of 32 MiB an array takes what its elements need, not more.
#[test]
fn arrays_count_by_what_they_hold() {
    for (fits, length, element) in [
        (true, 30_000_000, "bool"),
        (true, 30_000_000, "byte"),
        (true, 15_000_000, "char"),
        (false, 18_000_000, "char"),
        (true, 7_000_000, "int"),
        (false, 9_000_000, "float"),
        (true, 4_000_000, "double"),
        (false, 5_000_000, "long"),
        (true, 1_900_000, "object"),
        (false, 2_200_000, "string"),
    ] {
        let body = format!("var a = new {element}[{length}]; throw new Exception(\"made\");");
        let failure = run(&body, "");
        let expected = if fits { None } else { Some(Stop::Bytes(32 << 20)) };
        assert_eq!(failure.stop, expected, "{body}: {failure}");
    }
}

#[test]
fn unbounded_recursion_ends() {
    let failure = run("F(1);", "static int F(int n) { return F(n + 1) + 1; }");
    assert_eq!(failure.stop, Some(Stop::Depth(2_000)));
    assert_eq!(failure.at.unwrap().line, 4);
}

#[test]
fn growth_without_end_ends() {
    for body in [
        "var l = new List<double>(); while (true) l.Add(1);",
        "string s = \"x\"; while (true) s += s;",
        "var l = new List<int[]>(); while (true) l.Add(new int[1000]);",
        "var a = new int[2000000000];",
        "var b = new System.Text.StringBuilder(\"ab\"); while (true) b.Append(b.ToString());",
        "new string('x', 2000000000);",
        "var a = new double[60000, 60000];",
    ] {
        let failure = run(body, "");
        let stopped = matches!(failure.stop, Some(Stop::Bytes(_) | Stop::Steps(_)));
        assert!(stopped, "{body}: {failure}");
        assert_eq!(failure.at.unwrap().line, 6, "{body}");
    }
}

#[test]
fn a_stop_is_not_caught() {
    let failure = run("try { while (true) { } } catch (Exception) { } finally { while (true) { } }", "");
    assert!(matches!(failure.stop, Some(Stop::Steps(_))));
}

#[test]
fn types_that_grow_without_end_are_refused() {
    let failure = run("F<int>(1);", "static void F<T>(int n) { F<List<T>>(n + 1); }");
    assert!(failure.message.contains("too deeply"), "{failure}");
}

#[test]
fn printing_ends() {
    let failure = run("while (true) Console.Write(\"0123456789\");", "");
    assert!(matches!(failure.stop, Some(Stop::Output(_) | Stop::Steps(_))));
}

struct Impatient(u32);

impl Host for Impatient {
    fn cancelled(&mut self) -> bool {
        self.0 += 1;
        self.0 > 3
    }
}

#[test]
fn the_host_ends_a_run() {
    let failure = run_with("while (true) { }", "", Box::new(Impatient(0)));
    assert_eq!(failure.stop, Some(Stop::Cancelled));
}

/// Memory that nobody reaches any more is used again.
#[test]
fn garbage_is_collected() {
    let source = "class P { class N { public N Next; public int[] A = new int[100]; } static void Main() { N n = null; for (int i = 0; i < 100000; i++) { n = new N(); n.Next = n; } System.Console.WriteLine(n.A.Length); } }";
    let mut engine = Engine::new(&Source::File(source), Box::new(Printing::default()), small())
        .map_err(|e| e[0].to_string())
        .unwrap();
    engine.run_main().map_err(|e| e.to_string()).unwrap();
}

fn refused(source: &str) -> String {
    match Engine::new(&Source::File(source), Box::new(Printing::default()), small()) {
        Ok(_) => String::new(),
        Err(errors) => errors[0].to_string(),
    }
}

#[test]
fn deep_nesting_is_refused() {
    for (open, close) in
        [("(", ")"), ("{", "}"), ("-", ""), ("new int[]{", "}"), ("!", ""), ("x => ", ""), ("if (true) ", "")]
    {
        let source = format!(
            "class P {{ static void Main() {{ int x = {}1{}; }} }}",
            open.repeat(30_000),
            close.repeat(30_000)
        );
        assert!(!refused(&source).is_empty(), "{open}");
    }
    let sum = format!("class P {{ static void Main() {{ int x = 1{}; }} }}", " + 1".repeat(30_000));
    assert!(refused(&sum).contains("too long or complex"));
    let types = format!("class P {{ {} int {} x; }}", "System.Nullable<".repeat(5_000), ">".repeat(5_000));
    assert!(!refused(&types).is_empty());
}

#[test]
fn errors_have_their_places() {
    assert_eq!(
        refused("class P {\n  static void Main() {\n    int x = 1\n  }\n}"),
        "script(3,14): error CS1002: ; expected"
    );
    assert_eq!(
        refused("class P {\n  static void Main() {\n    nope();\n  }\n}"),
        "script(3,5): error CS0103: The name 'nope' does not exist in the current context"
    );
    assert!(refused("class P { static async void Main() { } }").contains("async is not supported"));
}
