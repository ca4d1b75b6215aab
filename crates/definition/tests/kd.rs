//! The text form: what it means, how it is written, what is wrong with it.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod kd_catalogue;

use katydid_definition::archive::Limits;
use katydid_definition::document::special::Rounding;
use katydid_definition::document::{
    ClusterContent, Document, Mapping, Object, Persistent, Special, Stored, ids,
};
use katydid_definition::kd::{self, Problems};
use katydid_geometry::{Interval, Units};
use kd_catalogue::Few;

fn read(text: &str) -> Document {
    match kd::read(text, &Few) {
        Ok(read) => read.document,
        Err(problems) => panic!("{problems}"),
    }
}

fn wrong(text: &str) -> Problems {
    kd::read(text, &Few).expect_err("it should not be read")
}

/// The text that a document read from this one is written as.
fn again(text: &str) -> String {
    let written = kd::write(&read(text), &Few).unwrap();
    assert!(written.left_out.is_empty(), "{:?}", written.left_out);
    written.text
}

fn named<'a>(document: &'a Document, nickname: &str) -> &'a Object {
    document.objects.iter().find(|object| object.nickname == nickname).expect("there is such an object")
}

const SKETCH: &str = "\
katydid 1

A = Construct Point(1, 2, 3)
V = Vector XYZ(2, 2, 2)
tip = Move(A, V.Vector)
r = Number Slider(5.18, 0..10)
grid = Square(_, r, 10, 10)
pts = List Item(grid.Points |flatten, [0, 4, 9])
group anchor and tip: A, V, tip
";

#[test]
fn the_sketch_reads_and_comes_back() {
    let document = read(SKETCH);
    let names: Vec<&str> = document.objects.iter().map(|object| object.nickname.as_str()).collect();
    assert_eq!(names, ["A", "V", "tip", "r", "grid", "pts", "anchor and tip"]);
    let (a, v, tip) = (&document.objects[0], &document.objects[1], &document.objects[2]);
    assert_eq!(tip.inputs[0].sources, [a.outputs[0].id]);
    assert_eq!(tip.inputs[1].sources, [v.outputs[0].id]);
    assert_eq!(a.persistent(&a.inputs[2]), Some(Persistent::item(Stored::Number(3.0))));
    let Some(Special::Slider(slider)) = named(&document, "r").special() else { panic!("no slider") };
    assert_eq!((slider.value, slider.min, slider.max, slider.digits), (5.18, 0.0, 10.0, 2));
    let grid = named(&document, "grid");
    assert!(grid.persistent(&grid.inputs[0]).is_some(), "the plane that it begins with is kept in it");
    let pts = named(&document, "pts");
    assert_eq!(pts.inputs[0].modifiers.mapping, Mapping::Flatten);
    assert_eq!(pts.persistent(&pts.inputs[1]).map(|values| values.count()), Some(3));
    assert!(document.problems().is_empty(), "{:?}", document.problems());
    // What is left out at the front is said by name.
    assert_eq!(
        again(SKETCH),
        SKETCH.replace("Square(_, r, 10, 10)", "Square(Size = r, Extent X = 10, Extent Y = 10)")
    );
}

#[test]
fn what_is_written_by_hand_comes_back_as_it_is() {
    for body in [
        "_panel = Panel(\"a text\")\n_panel'2 = Panel(\"b\", lines = true, colour = rgb(255, 0, 0))\n",
        "on = Boolean Toggle(true) disabled\nshown = Panel(on)\n",
        "n = Number Slider(4, 0..10, rounding = even)\nx = Number Slider(0.250, -1..1)\n",
        "x = Number Slider(7, 0..10, rounding = real, expression = \"x/2\")\n",
        "size = Value List(\"small\": 1, * \"large\": \"\\\"L\\\"\", mode = cycle)\n",
        "c = Colour Swatch(rgb(10, 20, 30, 40))\n",
        "p = Point([(0, 0, 0), (1, 0.5, -2)])\nq = Point(p |{x+1} |graft |reverse) hidden\n",
        "d = Data([{0;0}: 1, 2.5, \"t\"; {0;1}: null, true, 0..1; {3}:])\n",
        "a = Construct Point(1)\nb = Move([a, a], else_vector.Vector |unitize)\nelse_vector = Vector XYZ()\n",
        "a = Construct Point(-1.5e20)\nb = Move(a else (1, 2, 3), (0, 0, 1) |faint) hidden -> Geometry |graft\n",
        "a = Construct Point(Z coordinate = 9)\nb = Construct Point(none)\n",
        "m = Merge(a, _, tail = b)\na = Construct Point()\nb = Construct Point()\n",
        "l = Sort List(3.5, _) -> Keys |graft, A\nm = Sort List(1.5, _, _) -> A, B\n",
        "f = Expression(\"x^2 + y\", 1.0, n)\nn = Number(3)\n",
        "v = Vector XYZ(1, 2, 3) -> Length |flatten\nn = Number(v.Length)\n",
        "x = Mystery @01234567-89ab-cdef-0123-456789abcdef(A = n, B = 3) hidden -> R |graft, S\nn = Number(3)\n",
        "x = Mystery @01234567-89ab-cdef-0123-456789abcdef(4) parameter\n",
        "_scribble = Scribble(\"look here\", size = 20, bold = true)\n",
        "p = Geometry Pipeline()\n",
        "p = Geometry Pipeline(types = [point, extrusion], layer = \"Walls*\", group = both)\n",
        "p = Geometry Pipeline(types = none, name = \"n?rth\", hidden = false, group = layer)\n",
        "p = Geometry Pipeline(types = mesh, locked = false, sublayers = false, group = type)\n",
        "p = Geometry Pipeline(layer = \"Walls\") {\n    TypeFilter = -7\n}\n",
        "a = Number(1)\ngroup _group(rgb(1, 2, 3), blob): a\ngroup outer: _group\n",
        "`a-b` = Number(1)\n`a-b`'2 = Number(`a-b`)\n",
        "title \"T\"\nabout \"\"\"\n    two\n    lines\n    \"\"\"\n\na = Number(1)\n",
        "g = Geometry(line((0, 0, 0), (1, 2, 3)))\nc = Data(circle(plane((0, 0, 1)), 3))\n",
        "p = Data(plane((1, 2, 3), (0, 1, 0), (-1, 0, 0)))\nk = Data([rgb(1, 2, 3), face(0, 1, 2), complex(1, -1), {0;1}])\n",
    ] {
        let text = format!("katydid 1\n\n{}", body.trim_start_matches("katydid"));
        let text = if body.starts_with("title") { format!("katydid 1\n{body}") } else { text };
        let written = again(&text);
        // Objects are ordered by their wires, so compare what the text means as well.
        let (a, b) = (read(&text), read(&written));
        assert_eq!(a.to_archive().root, b.to_archive().root, "{written}");
        let sorted = |text: &str| {
            let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
            lines.sort();
            lines
        };
        let kept = written.split("\nlayout {").next().unwrap();
        assert_eq!(sorted(kept), sorted(&text), "{written}");
    }
}

#[test]
fn a_pipeline_says_what_it_lets_through() {
    let text = "p = Geometry Pipeline(types = [curve, surface, brep, extrusion], layer = \"A::*\", hidden = false, group = type)";
    let document = read(text);
    let settings = document.objects[0].container();
    // The bits are openNURBS': curve 4, surface 8, brep 16, extrusion 2^30.
    assert_eq!(settings.i32("TypeFilter"), Some(0x4000_001c));
    assert_eq!((settings.str("LayerFilter"), settings.str("NameFilter")), (Some("A::*"), Some("*")));
    let flags = ["IncludeHidden", "IncludeLocked", "SublayerFiltering", "GroupByLayer", "GroupByType"];
    assert_eq!(flags.map(|name| settings.bool(name)), [false, true, true, false, true].map(Some));
    for (bad, why) in [
        ("p = Geometry Pipeline(types = [point, wall])", "types should be"),
        ("p = Geometry Pipeline(types = 4)", "types should be"),
        ("p = Geometry Pipeline(group = name)", "group should be one of layer, type, both"),
        ("p = Geometry Pipeline(layer = walls)", "layer should be a text"),
    ] {
        let problems = wrong(bad).to_string();
        assert!(problems.contains(why), "{bad}: {problems}");
    }
}

#[test]
fn a_floating_parameter_is_one_port() {
    for (behind, before) in [
        ("n = Number(3) -> Number |graft", "n = Number(3 |graft)"),
        ("n = Number(3 |reverse) -> Number |{x+1} |flatten", "n = Number(3 |reverse |{x+1} |flatten)"),
        ("n = Number() -> N |simplify", "n = Number(_ |simplify)"),
    ] {
        assert_eq!(read(behind).to_archive().root, read(before).to_archive().root, "{behind}");
    }
}

#[test]
fn a_panel_tells_components_of_the_same_name_apart() {
    let document = read("a = Grid/Square(Size = 3)\nb = Move(grid/square().Points)\n");
    assert_eq!(document.objects[0].name, "Square");
    assert_eq!(document.objects[2].inputs[0].sources, [document.objects[1].outputs[1].id]);
    assert!(wrong("a = Maths/Square(3)").to_string().contains("there is no component called Maths/Square"));
}

#[test]
fn calls_may_stand_inside_calls() {
    let document =
        read("grid = Square(Size = Number Slider(5, 0..10))\nMove(Construct Point(1), (0, 0, 2))\n");
    let names: Vec<&str> = document.objects.iter().map(|object| object.name.as_str()).collect();
    assert_eq!(names, ["Number Slider", "Square", "Construct Point", "Move"]);
    assert_eq!(document.objects[1].inputs[1].sources, [document.objects[0].id]);
    assert_eq!(document.objects[2].nickname, "Pt", "without a label the component's own nickname is shown");
    assert_eq!(document.objects[3].inputs[0].sources, [document.objects[2].outputs[0].id]);
}

#[test]
fn ids_follow_from_labels_and_stay() {
    let (a, b) = (read("A = Number(1)\nB = Number(A)\n"), read("B = Number(A)\nA = Number(2)\n"));
    assert_eq!(named(&a, "A").id, named(&b, "A").id);
    assert_ne!(named(&a, "A").id, named(&a, "B").id);
    let text = "A = Construct Point()\n\nids {\n    A: @01234567-89ab-cdef-0123-456789abcdef \
                [_, @11111111-89ab-cdef-0123-456789abcdef]\n}\n";
    let document = read(text);
    assert_eq!(document.objects[0].id.to_string(), "01234567-89ab-cdef-0123-456789abcdef");
    assert_eq!(document.objects[0].inputs[1].id.to_string(), "11111111-89ab-cdef-0123-456789abcdef");
    assert_eq!(again(text), format!("katydid 1\n\n{text}"));
}

#[test]
fn layout_places_and_orders() {
    let text =
        "A = Construct Point()\nB = Number(1)\n\nlayout {\n    B: 10 20.5\n    A: 100 40 [70 20 60 44]\n}\n";
    let document = read(text);
    assert_eq!(document.objects[0].nickname, "B", "the layout is in drawing order");
    assert_eq!(document.objects[1].bounds, Some([70.0, 20.0, 60.0, 44.0]));
    assert_eq!(document.objects[1].pivot, Some([100.0, 40.0]));
    // In the text the order is that of the wires, and of the drawing where there are none.
    assert!(again(text).contains("layout {\n    B: 10 20.5\n    A: 100 40 [70 20 60 44]\n}\n"));
}

#[test]
fn clusters_are_blocks() {
    let text = "\
katydid 1

r = Number Slider(2, 0..10)
twice = Cluster(n = r) -> sum |graft inside {
    n = Cluster Input()
    double = Addition(n, n)
    sum = Cluster Output(double)
}
shown = Panel(twice)
";
    let document = read(text);
    let cluster = named(&document, "twice");
    assert!(cluster.variable);
    assert_eq!((cluster.inputs.len(), cluster.outputs.len()), (1, 1));
    let Some(Ok(ClusterContent::Open { document: inside, hooks })) = cluster.cluster(&Limits::default())
    else {
        panic!("no inside")
    };
    assert_eq!(inside.objects.len(), 3);
    assert_eq!(hooks[0].port, cluster.inputs[0].id);
    assert_eq!(hooks[0].object, named(&inside, "n").id);
    assert_eq!(hooks[1].object, named(&inside, "sum").id);
    assert_eq!(again(text), text.replace("Cluster(n = r)", "Cluster(r)"));
    // Two clusters that are alike have insides of their own.
    let two = read(&format!("{text}other = Cluster(r) inside {{\n n = Cluster Input()\n}}\n"));
    let other = named(&two, "other").cluster(&Limits::default()).unwrap().unwrap();
    let ClusterContent::Open { document: other, .. } = other else { panic!("no inside") };
    assert_ne!(other.objects[0].id, named(&inside, "n").id);
}

#[test]
fn settings_and_details_change_the_archive() {
    let text = "\
katydid 1

a = Construct Point() {
    Strength = 0.5
    Script/Text = base64 \"\"\"
        x = 1
        print(x)
        \"\"\"
    Curve/Point[0] = uv 0.25 1.0
    + Empty/
}

details {
    a {
        /Lib = @00000000-0000-0000-0000-000000000001
        IconDisplay = 2
        - param_input[0]/SourceCount
    }
}

file {
    Definition/Author/Name = \"somebody\"
}

data {
    $1 = \"AAEC\"
}
";
    let document = read(&text.replace("Strength = 0.5", "Strength = 0.5\n    Raw = bytes $1"));
    let c = document.objects[0].container();
    assert_eq!(c.f64("Strength"), Some(0.5));
    assert_eq!(c.bytes("Raw"), Some(&[0, 1, 2][..]));
    assert_eq!(c.child("Script").and_then(|s| s.str("Text")), Some("eCA9IDEKcHJpbnQoeCk="));
    assert!(c.child("Empty").is_some());
    assert_eq!(document.objects[0].lib.map(|lib| lib.as_u128()), Some(1));
    assert_eq!(c.child_at("param_input", 0).and_then(|p| p.i32("SourceCount")), None);
    assert_eq!(document.header.author, "somebody");
    let written = kd::write(&document, &Few).unwrap().text;
    assert_eq!(read(&written).to_archive().root, document.to_archive().root);
    for line in ["Strength = 0.5", "Curve/Point[0] = uv 0.25 1.0", "- param_input[0]/SourceCount", "print(x)"]
    {
        assert!(written.contains(line), "{written}");
    }
}

#[test]
fn sliders_follow_what_is_written() {
    for (text, value, rounding, digits) in [
        ("5", 5.0, Rounding::Integer, 3),
        ("5, 0..10", 5.0, Rounding::Integer, 3),
        ("5.0, 0..10", 5.0, Rounding::Real, 1),
        ("5, 0..10.25", 5.0, Rounding::Real, 2),
        ("5, 0..10, digits = 4, rounding = real", 5.0, Rounding::Real, 4),
        ("3, rounding = odd", 3.0, Rounding::Odd, 3),
    ] {
        let document = read(&format!("s = Number Slider({text})"));
        let Some(Special::Slider(slider)) = document.objects[0].special() else { panic!("no slider") };
        assert_eq!((slider.value, slider.rounding, slider.digits), (value, rounding, digits), "{text}");
    }
    let document = read("s = Number Slider(50)\nt = Number Slider(-3)");
    let Some(Special::Slider(slider)) = document.objects[0].special() else { panic!("no slider") };
    assert_eq!((slider.min, slider.max), (0.0, 100.0));
    let Some(Special::Slider(slider)) = document.objects[1].special() else { panic!("no slider") };
    assert_eq!((slider.min, slider.max), (-10.0, 0.0));
}

#[test]
fn numbers_points_and_vectors_depend_on_the_port() {
    let document = read(
        "a = Construct Point(3)\nb = Move(Geometry = (1, 2, 3), Motion = (1, 2, 3))\nd = Data([3, 3.0])",
    );
    let kept =
        |object: &Object, k: usize| object.persistent(&object.inputs[k]).unwrap().branches[0].items.clone();
    assert_eq!(kept(&document.objects[0], 0), [Stored::Number(3.0)]);
    assert!(matches!(kept(&document.objects[1], 0)[0], Stored::Point(_)));
    assert!(matches!(kept(&document.objects[1], 1)[0], Stored::Vector(_)));
    assert_eq!(kept(&document.objects[2], 0), [Stored::Integer(3), Stored::Number(3.0)]);
    let document = read("d = Data(-2..2.5)");
    assert_eq!(kept(&document.objects[0], 0), [Stored::Domain(Interval::new(-2.0, 2.5))]);
}

#[test]
fn units_are_named_in_either_spelling() {
    assert_eq!(kd::read("units millimetres", &Few).unwrap().units, Some(Units::Millimeters));
    assert_eq!(kd::read("units feet", &Few).unwrap().units, Some(Units::Feet));
    assert_eq!(kd::read("a = Number(1)", &Few).unwrap().units, None);
    assert!(wrong("units cubits").to_string().contains("there is no such unit"));
}

#[test]
fn faults_point_to_their_place() {
    for (text, line, column, message, hint) in [
        (
            "A = Construct Pont(1)",
            1,
            5,
            "there is no component called Construct Pont",
            "did you mean Construct Point?",
        ),
        ("\n\n  A = Move(B)", 3, 12, "no object is called B", ""),
        (
            "Point A = Number(1)\nB = Number(Pont A)",
            2,
            12,
            "no object is called Pont A",
            "did you mean Point A?",
        ),
        (
            "A = Construct Point(1, 2, 3, 4)",
            1,
            30,
            "Construct Point has 3 inputs, and this is one too many",
            "X coordinate (X)",
        ),
        ("A = Construct Point(Q = 4)", 1, 21, "Construct Point has no port called Q", "X coordinate (X)"),
        ("A = Construct Point(1, X = 4)", 1, 24, "the input X coordinate is given twice", ""),
        (
            "V = Vector XYZ()\nN = Number(V.Lenght)",
            2,
            14,
            "Vector XYZ has no port called Lenght",
            "did you mean Length?",
        ),
        ("A = Number(1", 1, 11, "this bracket is never closed", ""),
        ("A = Number(1))", 1, 14, "\")\" stands where the end of the line should be", ""),
        ("A = Number(\"x)", 1, 12, "this text does not end on its line", ""),
        ("A = Number(1 |flaten)", 1, 15, "there is no such modifier", "did you mean flatten?"),
        ("A = Number(1 |graft |flatten)", 1, 21, "this modifier goes against one before it", ""),
        ("A = Number(1 |graft) -> Number |flatten", 1, 32, "given before the arrow too", ""),
        ("A = Number(1) -> Number, Text |graft", 1, 26, "Number has one output", ""),
        ("A = Number(1)\nA = Number(2)", 2, 1, "A stands for another object already", ""),
        ("A = Number([B, 2])\nB = Number(1)", 1, 16, "wires and values cannot stand in one list", ""),
        ("katydid 2", 1, 9, "only version 1 of the format is known", ""),
        ("A = Number(plane(1))", 1, 18, "(x, y, z) should stand here", ""),
        ("A = Number(rgb(300, 0, 0))", 1, 12, "a colour of numbers from 0 to 255", ""),
        ("A = Number(geometry($4))", 1, 21, "there is no $4 in the data block", ""),
        ("layout {\n    A: 1\n}", 2, 9, "the line ends where a number of pixels should be", ""),
        ("A = Cluster() inside {\n B = Number(", 1, 22, "this cluster is never closed", ""),
        ("A = Number(1) hiden", 1, 15, "stands where disabled, hidden", ""),
        (
            "x = Number Slider(1, rounding = up)",
            1,
            22,
            "rounding should be one of real, integer, even, odd",
            "",
        ),
    ] {
        let problems = wrong(text);
        let problem = &problems.list[0];
        assert_eq!((problem.line, problem.column), (line, column), "{text}\n{problems}");
        assert!(problem.message.contains(message), "{text}\n{problems}");
        assert!(problem.hint.clone().unwrap_or_default().contains(hint), "{text}\n{problems}");
        assert!(problem.to_string().contains("\n  "), "the line is quoted");
    }
}

#[test]
fn many_faults_are_told_at_once() {
    let problems =
        wrong("A = Mov(1)\nB = Number(,)\nC = Number(1)\nD = Number(E)\nlayout {\n  C: x\n  F: 1 2\n}\n");
    let lines: Vec<usize> = problems.list.iter().map(|problem| problem.line).collect();
    assert_eq!(lines, [2, 6], "what does not parse comes first");
    let problems = wrong("A = Mov(1)\nD = Number(E)\nlayout {\n  F: 1 2\n}\n");
    let lines: Vec<usize> = problems.list.iter().map(|problem| problem.line).collect();
    assert_eq!(lines, [1, 2, 4]);
    let text: String = (0..500).map(|k| format!("a{k} = Nothing At All(1)\n")).collect();
    assert_eq!(wrong(&text).list.len(), 50);
}

#[test]
fn deep_and_odd_texts_are_refused_and_nothing_panics() {
    for text in [
        "A = ".to_owned() + &"Number(".repeat(100_000),
        "A = Number(".to_owned() + &"[".repeat(100_000),
        "A = Cluster() inside {\n".repeat(1000),
        "{".repeat(1000),
        "}".repeat(1000),
        "A = Number(1) {\n".to_owned() + &"a/".repeat(2000) + "b = 1\n}",
        "data {\n $1 = \"!\"\n}".to_owned(),
        "A = Number(1e999)".to_owned(),
    ] {
        assert!(kd::read(&text, &Few).is_err(), "{}", &text[..20]);
    }
    for text in ["", "\u{feff}", "# only a comment", "\r\n\r\n", "katydid 1\r\nA = Number(1)\r\n"] {
        assert!(kd::read(text, &Few).is_ok(), "{text:?}");
        kd::format(text).unwrap();
    }
}

#[test]
fn formatting_keeps_comments_and_settles() {
    let text = "\
katydid 1
# a head
A=Construct Point( 1,2 , 3 )   # the anchor


# before B
B   =   Move(A,(0,0,1)|unitize)->Geometry|graft
list = Number([1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35])
long = Construct Point(Number Slider(1.25, 0..100), Number Slider(2.5, 0..100), Number Slider(3.75, 0..100))
few = Construct Point(
  # the first
  1, # behind it
  2)
group   g : A,
   B # members
layout{
A:0 0
}
";
    let tidy = "\
katydid 1
# a head
A = Construct Point(1, 2, 3) # the anchor

# before B
B = Move(A, (0, 0, 1) |unitize) -> Geometry |graft
list = Number([
    1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26,
    27, 28, 29, 30, 31, 32, 33, 34, 35
])
long = Construct Point(
    Number Slider(1.25, 0..100),
    Number Slider(2.5, 0..100),
    Number Slider(3.75, 0..100),
)
few = Construct Point(
    # the first
    1, # behind it
    2,
)
group g: A, B # members
layout {
    A: 0 0
}
";
    let set = kd::format(text).unwrap();
    let open = set.replace("Number(\n    [\n", "Number([\n");
    assert!(open.contains("# the first") && open.contains("# behind it") && open.contains("# members"));
    assert_eq!(kd::format(&set).unwrap(), set);
    assert_eq!(read(&set).to_archive().root, read(text).to_archive().root);
    assert_eq!(set, tidy, "{set}");
}

#[test]
fn what_has_no_place_gets_one() {
    let mut document = read("a = Number(1)\nb = Number(a)\nc = Construct Point(b)\n");
    assert_eq!(kd::arrange(&mut document), 3);
    let x: Vec<f32> = document.objects.iter().map(|object| object.pivot.unwrap()[0]).collect();
    assert!(x[0] < x[1] && x[1] < x[2]);
    assert_eq!(kd::arrange(&mut document), 0);
    assert!(document.objects.iter().all(|object| object.component != ids::GROUP));
}

#[test]
fn what_gets_a_place_covers_nothing() {
    let text = "a = Panel(\"a rather long line that wants to be read without being cut\")\nb = Number(a)\n\
        a slider with a long name = Number Slider(3, 0..10)\nc = Construct Point(b, a slider with a long name)\n";
    let mut document = read(text);
    kd::arrange(&mut document);
    let places: Vec<[f32; 4]> = document.objects.iter().filter_map(|object| object.bounds).collect();
    assert_eq!(places.len(), 4);
    for (k, a) in places.iter().enumerate() {
        for b in places.iter().skip(k + 1) {
            let apart = |i: usize| a[i] + a[i + 2] + 10.0 <= b[i] || b[i] + b[i + 2] + 10.0 <= a[i];
            assert!(apart(0) || apart(1), "{a:?} {b:?}");
        }
    }
}
