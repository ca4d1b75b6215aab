//! Small scripts, with what they must give by hand.

#![allow(clippy::panic, reason = "a test may fail")]

use super::*;
use katydid_definition::document::ScriptLanguage;
use katydid_geometry::Point3;

pub(super) fn program(body: &str, additional: &str, parameters: &str) -> Result<Program, Vec<Message>> {
    let script = Script {
        language: ScriptLanguage::CSharp,
        text: body.into(),
        additional: additional.into(),
        using: String::new(),
        from_wire: false,
    };
    Program::new(&script, parameters)
}

pub(super) fn row(body: &str, parameters: &str, inputs: &[Value]) -> Vec<Value> {
    let mut program = program(body, "", parameters).unwrap_or_else(|faults| panic!("{faults:?}"));
    let called = program.call(inputs);
    assert!(called.messages.is_empty(), "{:?}", called.messages);
    called.row
}

#[test]
fn whole_numbers_divide_to_whole_numbers() {
    let given = row("A = x / 2; B = x / 2.0;", "int x, ref object A, ref object B", &[Value::Int(7)]);
    assert_eq!(given, [Value::Int(3), Value::Number(3.5)]);
}

#[test]
fn points_and_vectors_follow_their_formulas() {
    let body = "Vector3d v = p - Point3d.Origin; A = v.Length; v.Unitize(); B = Vector3d.CrossProduct(v, Vector3d.ZAxis);";
    let inputs = [Value::Point(Point3::new(3.0, 4.0, 0.0))];
    let given = row(body, "Point3d p, ref object A, ref object B", &inputs);
    // |(3, 4, 0)| = 5, and (0.6, 0.8, 0) x (0, 0, 1) = (0.8, -0.6, 0).
    assert_eq!(given, [Value::Number(5.0), Value::Vector(katydid_geometry::Vector3::new(0.8, -0.6, 0.0))]);
}

#[test]
fn a_line_that_names_the_language_is_no_directive() {
    let given = row("#! csharp\nA = x * 2;", "int x, ref object A", &[Value::Int(7)]);
    assert_eq!(given, [Value::Int(14)]);
    let whole = "\u{feff}\n#! csharp\nusing System;\npublic class Script_Instance : GH_ScriptInstance {
        private void RunScript(int x, ref object A) { A = x + 1; } }";
    assert_eq!(row(whole, "int x, ref object A", &[Value::Int(7)]), [Value::Int(8)]);
    // Lines keep their numbers.
    let faults = program("#! csharp\nA = nothing;", "", "ref object A").err().unwrap_or_default();
    assert!(faults.iter().any(|fault| fault.text.contains("(2,5)")), "{faults:?}");
}

#[test]
fn a_list_in_a_list_is_one_object_that_shows_its_name() {
    let body = "A = new object[] { 1, new List<int> { 2 }, new double[] { 3.0 }, \"t\" };";
    let given = row(body, "ref object A", &[]);
    let [Value::List(items)] = given.as_slice() else { panic!("{given:?}") };
    let shown: Vec<_> =
        items.iter().map(|item| if let Value::Error(_, text) = item { text } else { "" }).collect();
    assert_eq!(shown, ["", "System.Collections.Generic.List`1[System.Int32]", "System.Double[]", ""]);
    assert_eq!((&items[0], &items[3]), (&Value::Int(1), &Value::from("t")));
}

#[test]
fn curves_are_those_of_the_member_table() {
    let body = "Curve c = new LineCurve(new Line(new Point3d(0, 0, 0), new Point3d(8, 6, 0)));
        double t; bool found = c.ClosestPoint(new Point3d(4, 3, 5), out t);
        A = c.GetLength(); B = found ? c.PointAt(t) : Point3d.Unset; c.Domain = new Interval(0, 2); C = c.Domain.T1;";
    let given = row(body, "ref object A, ref object B, ref object C", &[]);
    let [Value::Number(length), Value::Point(at), Value::Number(end)] = given.as_slice() else {
        panic!("{given:?}");
    };
    assert!((length - 10.0).abs() < 1e-9 && (end - 2.0).abs() < 1e-12);
    assert!((at.x - 4.0).abs() < 1e-6 && (at.y - 3.0).abs() < 1e-6);
}

#[test]
fn trees_go_in_and_out() {
    let body = "DataTree<double> t = new DataTree<double>();
        for (int i = 0; i < x.BranchCount; i++) t.Add(x.Branch(i).Count * 10.0, x.Path(i)); A = t;";
    let numbers = |list: &[f64]| list.iter().map(|x| Value::Number(*x)).collect::<Vec<_>>();
    let tree = Value::Tree(vec![(vec![0, 1], numbers(&[1.0, 2.0])), (vec![3], numbers(&[5.0]))]);
    let given = row(body, "DataTree<double> x, ref object A", &[tree]);
    let expected = Value::Tree(vec![(vec![0, 1], numbers(&[20.0])), (vec![3], numbers(&[10.0]))]);
    assert_eq!(given, [expected]);
}

#[test]
fn fields_stay_between_runs_and_the_component_speaks() {
    let body = "n += x.Count; Print(\"{0} so far\", n);
        Component.AddRuntimeMessage(GH_RuntimeMessageLevel.Warning, \"careful\"); A = n;";
    let mut program =
        program(body, "int n = 0;", "List<double> x, ref object A").unwrap_or_else(|f| panic!("{f:?}"));
    let list = [Value::Numbers(vec![1.0, 2.0, 3.0])];
    for expected in [3, 6] {
        let called = program.call(&list);
        assert_eq!(called.row, [Value::Int(expected)]);
        assert_eq!(called.printed.trim_end(), format!("{expected} so far"));
        assert_eq!(called.messages, [Message::warning("careful")]);
    }
}

#[test]
fn faults_have_the_line_of_the_script() {
    let faults = program("int a = 1;\nint b = \"x\";", "", "ref object A").err().unwrap_or_default();
    assert!(faults.iter().any(|fault| fault.text.starts_with("script(2,9): error CS0029")), "{faults:?}");
    let mut program = program("int[] a = new int[2];\nA = a[x];", "", "int x, ref object A")
        .unwrap_or_else(|f| panic!("{f:?}"));
    let called = program.call(&[Value::Int(5)]);
    assert!(called.messages.iter().any(|said| said.text.contains("script(2,")), "{:?}", called.messages);
}

#[test]
fn a_cancelled_solve_ends_an_endless_loop() {
    let mut program = program("while (true) { }", "", "ref object A").unwrap_or_else(|f| panic!("{f:?}"));
    program.turn.lock().unwrap_or_else(PoisonError::into_inner).end = Some(std::time::Instant::now());
    assert!(program.call(&[]).ended);
}

/// Panels show what `ToString` gives, for an object and for those in a list.
#[test]
fn objects_of_own_classes_are_shown_by_their_text() {
    let own = "class Part { int n; public Part(int n) { this.n = n; } public override string ToString() { return \"part \" + n; } }";
    let body = "A = new Part(7); B = new List<object> { new Part(1), 2.5 };";
    let mut program =
        program(body, own, "ref object A, ref object B").unwrap_or_else(|faults| panic!("{faults:?}"));
    let called = program.call(&[]);
    assert!(called.messages.is_empty(), "{:?}", called.messages);
    let shown = |text: &str| Value::Error(SHOWN.to_owned(), text.to_owned());
    assert_eq!(called.row, [shown("part 7"), Value::List(vec![shown("part 1"), Value::Number(2.5)])]);
}
