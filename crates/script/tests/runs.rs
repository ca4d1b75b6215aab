//! Scripts run, and give what was worked out by hand.

#![allow(clippy::unwrap_used, clippy::panic, clippy::float_cmp, reason = "a test may fail")]

mod common;

use common::{gh_python, messages, numbers, session, session_of, session_of_every_language, values};
use katydid_data::Value;

#[test]
fn items_come_one_by_one_and_results_stay_together() {
    let script = gh_python("double", "x = s", "out, a", "a = x * 2", "");
    let mut session = session(&format!("s = Series(1, 1, 3)\n{script}"));
    session.solve();
    assert_eq!(messages(&session, "double"), Vec::<String>::new());
    assert_eq!(numbers(&session, "double", 1), [("{0;0}".to_owned(), vec![2.0, 4.0, 6.0])]);
}

#[test]
fn a_list_result_of_an_item_has_a_branch_of_its_own() {
    let script = gh_python("spread", "x = s", "out, a", "a = [x, x + 10]", "");
    let mut session = session(&format!("s = Series(1, 1, 2)\n{script}"));
    session.solve();
    let expected = [("{0;0;0}".to_owned(), vec![1.0, 11.0]), ("{0;0;1}".to_owned(), vec![2.0, 12.0])];
    assert_eq!(numbers(&session, "spread", 1), expected);
}

#[test]
fn a_list_input_comes_whole() {
    let access = "    ParameterData/InputParam[0]/ScriptParamAccess = 1\n";
    let script = gh_python("total", "x = s", "out, a, n", "a = sum(x)\nn = x.Count", access);
    let mut session = session(&format!("s = Series(1, 1, 100)\n{script}"));
    session.solve();
    assert_eq!(messages(&session, "total"), Vec::<String>::new());
    assert_eq!(numbers(&session, "total", 1), [("{0;0}".to_owned(), vec![5050.0])]);
    assert_eq!(numbers(&session, "total", 2), [("{0;0}".to_owned(), vec![100.0])]);
}

#[test]
fn old_python_prints_and_divides_as_it_did() {
    let script = gh_python("old", "x = s", "out, a", "print \"seven\"\na = 7 / 2", "");
    let mut session = session(&format!("s = Series(1, 1, 1)\n{script}"));
    session.solve();
    assert_eq!(messages(&session, "old"), Vec::<String>::new());
    assert_eq!(values(&session, "old", 0), [Some(Value::Text("seven".into()))]);
    assert_eq!(numbers(&session, "old", 1), [("{0;0}".to_owned(), vec![3.0])]);
}

#[test]
fn geometry_goes_through_the_kernel_and_back() {
    let code = "import Rhino.Geometry as rg\n\
                line = rg.LineCurve(rg.Point3d(0, 0, 0), rg.Point3d(3, 4, 0))\n\
                line.Reverse()\n\
                a = line.GetLength()\nb = line\nc = line.PointAtStart";
    let script = gh_python("measure", "x = s", "out, a, b, c", code, "");
    let mut session = session(&format!("s = Series(1, 1, 1)\n{script}\nlength = Length(measure.b)"));
    session.solve();
    assert_eq!(messages(&session, "measure"), Vec::<String>::new());
    assert_eq!(numbers(&session, "measure", 1), [("{0;0}".to_owned(), vec![5.0])]);
    assert_eq!(numbers(&session, "length", 0), [("{0;0}".to_owned(), vec![5.0])]);
    let Some(Some(Value::Point(start))) = values(&session, "measure", 3).into_iter().next() else { panic!() };
    assert_eq!((start.x, start.y, start.z), (3.0, 4.0, 0.0));
}

#[test]
fn an_error_names_its_line_and_the_rest_goes_on() {
    let script = gh_python("broken", "x = s", "out, a", "b = 1\na = 1 / (x - 2.0)", "");
    let mut session = session(&format!("s = Series(1, 1, 3)\n{script}\nafter = Addition(s, 1)"));
    session.solve();
    let said = messages(&session, "broken");
    assert!(
        said.len() == 1 && said[0].contains("division by zero") && said[0].contains("line 2"),
        "{said:?}"
    );
    assert_eq!(numbers(&session, "after", 0), [("{0;0}".to_owned(), vec![2.0, 3.0, 4.0])]);
    let all = values(&session, "broken", 1);
    assert_eq!(all, [Some(Value::Number(-1.0)), None, Some(Value::Number(1.0))]);
}

/// What stands in `out`, a line an item.
fn printed(session: &katydid_session::Session, name: &str) -> Vec<String> {
    let line = |item: Option<Value>| match item {
        Some(Value::Text(line)) => line.to_string(),
        other => panic!("{other:?} is no line"),
    };
    values(session, name, 0).into_iter().map(line).collect()
}

#[test]
fn prints_and_then_the_error_stand_in_out() {
    let code = "print('begun')\ndef half(n):\n    return n / 'two'\na = half(x)";
    let script = gh_python("broken", "x = s", "out, a", code, "");
    let mut session = session(&format!("s = Series(1, 1, 1)\n{script}"));
    session.solve();
    let lines = printed(&session, "broken");
    assert_eq!(lines[0], "begun");
    assert!(lines[1].starts_with("Runtime error (TypeError): unsupported operand"), "{lines:?}");
    assert_eq!(lines[2..], ["", "Traceback:", "  line 4, in script", "  line 3, in half"]);
}

#[test]
fn a_script_that_does_not_compile_says_so_in_out() {
    let script = gh_python("broken", "x = s", "out, a", "a = 1\nb = = 2", "");
    let mut session = session(&format!("s = Series(1, 1, 1)\n{script}"));
    session.solve();
    let lines = printed(&session, "broken");
    assert!(
        lines.len() == 1 && lines[0].contains("Syntax error") && lines[0].contains("line 2"),
        "{lines:?}"
    );
}

#[test]
fn a_script_knows_where_its_definition_lies() {
    let script = gh_python("where", "x = s", "out, a, b", "a = ghdoc.Path\nb = ghdoc.Name", "");
    let path = std::path::PathBuf::from("/some/folder/facade.gh");
    let mut session = session_of(&format!("s = Series(1, 1, 1)\n{script}"), path);
    session.solve();
    assert_eq!(values(&session, "where", 1), [Some(Value::Text("/some/folder/facade.gh".into()))]);
    assert_eq!(values(&session, "where", 2), [Some(Value::Text("facade".into()))]);
}

#[test]
fn what_one_script_keeps_another_finds() {
    let first = gh_python(
        "first",
        "x = s",
        "out, a",
        "import scriptcontext\nscriptcontext.sticky['k'] = x\na = x",
        "",
    );
    let code = "import scriptcontext\na = scriptcontext.sticky['k'] + x";
    let second = gh_python("second", "x = first.a", "out, a", code, "");
    let mut session = session(&format!("s = Series(5, 1, 1)\n{first}\n{second}"));
    session.solve();
    assert_eq!(messages(&session, "second"), Vec::<String>::new());
    assert_eq!(numbers(&session, "second", 1), [("{0;0}".to_owned(), vec![10.0])]);
}

#[test]
fn objects_of_python_travel_as_themselves() {
    let code = "class Part(object):\n    def __init__(self, n):\n        self.n = n\na = Part(x)";
    let first = gh_python("maker", "x = s", "out, a", code, "");
    let second = gh_python("user", "p = maker.a", "out, a", "a = p.n * 3", "");
    let mut session = session(&format!("s = Series(4, 1, 2)\n{first}\n{second}"));
    session.solve();
    assert_eq!(messages(&session, "user"), Vec::<String>::new());
    assert_eq!(numbers(&session, "user", 1), [("{0;0}".to_owned(), vec![12.0, 15.0])]);
}

#[test]
fn messages_of_a_script_are_the_components() {
    let code = "from Grasshopper.Kernel import GH_RuntimeMessageLevel as L\n\
                ghenv.Component.AddRuntimeMessage(L.Warning, 'look here')\na = 1";
    let script = gh_python("talker", "x = s", "out, a", code, "");
    let mut session = session(&format!("s = Series(1, 1, 1)\n{script}"));
    session.solve();
    assert_eq!(messages(&session, "talker"), ["warning: look here"]);
}

/// Texts on geometry go through parameters and transforms, from script to script, and into the file of the model.
#[test]
fn texts_on_geometry_travel_with_it() {
    let code = "import Rhino.Geometry as rg\n\
                m = rg.Mesh.CreateFromPlane(rg.Plane.WorldXY, rg.Interval(0, 2), rg.Interval(0, 2), 1, 1)\n\
                m.SetUserString('key', 'text')\na = m\n\
                p = rg.Point(rg.Point3d(1, 2, 3))\np.SetUserString('of', 'point')\nb = p\nc = m.Duplicate().UserStringCount";
    let made = gh_python("made", "x = s", "out, a, b, c", code, "");
    let asked = gh_python(
        "asked",
        "x = moved.geometry, y = mesh",
        "out, a, b, c",
        "a = x.GetUserString('key')\nb = y.GetUserStrings()['key']\nc = x.UserStringCount + y.UserStringCount",
        "",
    );
    let mut session = session(&format!(
        "s = Series(1, 1, 1)\n{made}\nmesh = Mesh(made.a)\nmoved = Move(made.a, \"0,0,5\")\narea = Area(made.a)\n\
         {asked}\nshown = Panel(made.a)"
    ));
    session.solve();
    for name in ["made", "asked"] {
        assert_eq!(messages(&session, name), Vec::<String>::new(), "{name}");
    }
    let text = |name: &str, output: usize| values(&session, name, output).into_iter().next().flatten();
    assert_eq!(text("asked", 1), Some(Value::Text("text".into())));
    assert_eq!(text("asked", 2), Some(Value::Text("text".into())));
    assert_eq!(numbers(&session, "asked", 3)[0].1, [2.0]);
    assert_eq!(numbers(&session, "made", 3)[0].1, [1.0]);
    let Some(point) = text("made", 2) else { panic!("no point") };
    assert_eq!(point.carried_texts(), [("of".into(), "point".into())]);
    assert!(text("mesh", 0).is_some_and(|mesh| mesh.carried_texts().len() == 1));
    // In the model, read again: beside each mesh, and not among its attributes.
    let baked = katydid_session::bake(session.engine(), katydid_session::BakeOptions::default());
    let bytes = baked.model.write(80).unwrap();
    let model = katydid_3dm::Model::read(&bytes, &katydid_3dm::Limits::default()).unwrap();
    let texts = |object: &katydid_3dm::ModelObject| {
        object.user_data.iter().find_map(|data| data.strings().unwrap()).unwrap_or_default()
    };
    let found =
        model.objects.iter().filter(|object| texts(object) == [("key".to_owned(), "text".to_owned())]);
    assert!(found.count() >= 2);
}

/// A panel shows what `str` gives for an object of a script's own class.
#[test]
fn panels_show_objects_by_their_text() {
    let code = "class Part(object):\n    def __init__(self, n): self.n = n\n    def __str__(self): return 'part %d' % self.n\n\
                class Bad(object):\n    def __str__(self): raise ValueError()\n\
                class Net(object):\n    def ToString(self): return 'as .NET'\n\
                a = [Part(1), Part(2)]\nb = [[1, 'two', None]]\nc = Bad()\nd = Net()";
    let script = gh_python("made", "x = s", "out, a, b, c, d", code, "");
    let mut session = session(&format!(
        "s = Series(1, 1, 1)\n{script}\npa = Panel(made.a)\npb = Panel(made.b)\npc = Panel(made.c)\npd = Panel(made.d)"
    ));
    session.solve();
    assert_eq!(messages(&session, "made"), Vec::<String>::new());
    let shown = |name: &str| -> Vec<String> {
        let style = katydid_data::text::Style::default();
        values(&session, name, 0).iter().flatten().map(|v| katydid_data::text::value(v, &style)).collect()
    };
    assert_eq!(shown("pa"), ["part 1", "part 2"]);
    assert_eq!(shown("pb"), ["[1, 'two', None]"]);
    assert_eq!(shown("pc"), ["Bad"]);
    assert_eq!(shown("pd"), ["as .NET"]);
}

#[test]
fn the_language_of_the_generic_component_comes_with_the_text() {
    let component = |name: &str, text: &str| {
        let text = text.replace('\n', "\\n");
        format!(
            "{name}code = Panel(\"{text}\")\n{name} = Script @c9b2d725-6f87-4b07-af90-bd9aefef68eb(script = {name}code, x = s) \
             variable -> out, a {{\n    UsingScriptInputParam = true\n}}"
        )
    };
    let scripts = [
        component("python", "#! python 3\na = x * 2 + 1"),
        component("sharp", "// #! csharp\na = (int)x * 2 + 2;"),
        component(
            "whole",
            "#! csharp\nusing System;\npublic class Script_Instance : GH_ScriptInstance {\n  \
             private void RunScript(object x, ref object a) { a = Convert.ToInt32(x) + 4; } }",
        ),
        component("unnamed", "a = x"),
    ];
    let mut session = session_of_every_language(&format!("s = Series(20, 1, 1)\n{}", scripts.join("\n")));
    session.solve();
    for (name, expected) in [("python", 41.0), ("sharp", 42.0), ("whole", 24.0)] {
        assert_eq!(messages(&session, name), Vec::<String>::new(), "{name}");
        assert_eq!(numbers(&session, name, 1), [("{0;0}".to_owned(), vec![expected])], "{name}");
    }
    let said = messages(&session, "unnamed");
    assert!(said.len() == 1 && said[0].contains("#! python 3"), "{said:?}");
}
