//! Pictures of definitions that show one thing of each kind: well-formed, the same each time, and with what is there.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

use std::sync::Arc;

use katydid_component::registry;
use katydid_data::Colour;
use katydid_definition::document::Document;
use katydid_definition::kd::{self, Catalogue, Facts, PortFacts};
use katydid_picture::drawing::{Anchor, Drawing, Face, Item, Label, Path, Shape, Solids, SpaceLine};
use katydid_picture::{HiddenLines, Options, View, canvas, result};
use katydid_solver::Engine;
use uuid::Uuid;

/// The registry with the names of ports, which is all that these definitions need.
struct Names;

fn facts(component: &katydid_component::Component) -> Arc<Facts> {
    let ports = |ports: &[katydid_component::Port]| {
        let port = |port: &katydid_component::Port| PortFacts {
            name: port.name.to_owned(),
            nickname: port.nick.to_owned(),
            optional: port.optional,
            many: port.many,
            ..PortFacts::default()
        };
        ports.iter().map(port).collect()
    };
    Arc::new(Facts {
        guid: component.guid,
        name: component.name.to_owned(),
        nickname: component.nick.to_owned(),
        floating: component.floating,
        inputs: ports(component.inputs),
        outputs: ports(component.outputs),
        ..Facts::default()
    })
}

impl Catalogue for Names {
    fn by_guid(&self, guid: Uuid) -> Option<Arc<Facts>> {
        registry::by_guid(guid).map(facts)
    }

    fn by_name(&self, name: &str, _: bool) -> Option<Arc<Facts>> {
        registry::by_name(name).map(facts)
    }

    fn names(&self) -> Vec<String> {
        Vec::new()
    }
}

fn solved(text: &str) -> Engine {
    katydid_components::link();
    let text = format!("katydid 1\nunits millimetres\n\n{text}\n");
    let document: Document = kd::read(&text, &Names).unwrap_or_else(|problems| panic!("{problems}")).document;
    let mut engine = Engine::new(document, Default::default());
    engine.solve();
    engine
}

const EVERYTHING: &str = r#"
one = Box 2Pt((0, 0, 0), (6, 4, 3)) hidden
two = Sphere((6, 4, 3), 2.5)
paint = Custom Preview(one.Box, rgb(90, 150, 210))
dots = Dot Display([(8, 0, 0), (9, 0, 0)], rgb(200, 30, 60), 0.6)
line = Line((0, -2, 0), (6, -2, 0))
size = Line Dimension(line.Line, "{0:0.00} mm", 0.6)
tag = Text Tag((6, 4, 5.5), "the < ball")
circle = Circle((12, -2, 0), 2)
hatch = Pattern Hatch(circle.Circle, 1, 0.3, 0.4)
order = Point Order([(0, -4, 0), (2, -5, 0), (4, -4, 0)])
arrow = Vector Display((8, -1, 0), (0, 0, 4))
comb = Curvature Graph(circle.Circle, 12, 100)
legend = Legend([rgb(90, 150, 210), rgb(240, 180, 60)], ["box", "ball"])
plane = Construct Plane((14, 0, 0), (1, 0, 0), (0, 0.7, 0.7))
"#;

/// The names of all elements; fails when the text is not well-formed.
fn elements(svg: &str) -> Vec<String> {
    let mut reader = quick_xml::Reader::from_str(svg);
    reader.config_mut().check_end_names = true;
    let mut names = Vec::new();
    loop {
        match reader.read_event().unwrap() {
            quick_xml::events::Event::Eof => return names,
            quick_xml::events::Event::Start(e) | quick_xml::events::Event::Empty(e) => {
                assert!(e.attributes().all(|attribute| attribute.is_ok()));
                names.push(e.name().as_ref().to_owned());
            }
            _ => {}
        }
    }
}

fn options() -> Options {
    Options { size: [320, 200], axes: true, grid: true, legend: true, ..Options::default() }
}

#[test]
fn everything_is_drawn_in_every_view() {
    let engine = solved(EVERYTHING);
    for view in [View::Perspective, View::Isometric, View::Top, View::Front, View::Right] {
        let picture = result(&engine, &Options { view: Some(view), ..options() });
        assert!(!picture.is_empty && picture.left_out.is_empty(), "{:?}", picture.left_out);
        let svg = picture.drawing.to_svg();
        let names = elements(&svg);
        let count = |name: &str| names.iter().filter(|n| *n == name).count();
        assert!(count("path") > 100 && count("text") >= 4, "{view:?}: {} texts", count("text"));
        assert!(svg.contains("the &lt; ball") && svg.contains("6.00 mm") && svg.contains(">box<"));
        assert!(svg.contains("role=\"img\"") && svg.contains(view.word()));
        assert!(picture.drawing.description.contains("1 surface"), "{}", picture.drawing.description);
        assert!(picture.drawing.to_png().unwrap().len() > 1000);
    }
}

#[test]
fn the_same_definition_gives_the_same_bytes() {
    let bytes = || {
        let engine = solved(EVERYTHING);
        let drawing = result(&engine, &options()).drawing;
        let of_canvas = canvas(&engine, &options());
        (drawing.to_svg(), drawing.to_png().unwrap(), of_canvas.to_svg(), of_canvas.to_png().unwrap())
    };
    assert!(bytes() == bytes());
}

#[test]
fn what_lies_flat_is_seen_from_above() {
    let words = |text: &str| result(&solved(text), &options()).drawing.description;
    assert_eq!(words("c = Circle((1, 2, 0), 3)"), "The result seen in top view: 1 curve.");
    assert!(words("c = Circle((1, 2, 0), 3)\np = Construct Point(0, 0, 4)").contains("perspective"));
}

#[test]
fn objects_without_preview_are_not_seen() {
    let picture = result(&solved("p = Construct Point(1, 2, 3) hidden"), &options());
    assert!(picture.is_empty);
    let svg = picture.drawing.to_svg();
    assert!(svg.contains("Nothing to show") && svg.contains("shows no geometry"), "{svg}");
    assert!(!result(&solved("p = Construct Point(1, 2, 3)"), &options()).is_empty);
}

#[test]
fn a_value_that_goes_on_is_drawn_once() {
    let text = "p = Construct Point(1, 2, 3)\nq = Point(p)\nr = Merge(q, p)";
    let picture = result(&solved(text), &options());
    assert!(picture.drawing.description.contains("1 point"), "{}", picture.drawing.description);
}

#[test]
fn a_canvas_shows_names_values_and_signs() {
    let text = r#"
size = Number Slider(2.50, 0..10)
twice = Multiplication(size, [1, 2])
shown = Panel(twice)
wrong = Division(1, 0)
words = Panel("a note")
switch = Boolean Toggle(true)
group both(rgb(1, 2, 3)): size, twice
"#;
    let engine = solved(text);
    let drawing = canvas(&engine, &options());
    let svg = drawing.to_svg();
    elements(&svg);
    for wanted in [">size<", ">2.50<", ">twice<", ">2.5<", ">5<", ">a note<", ">True<", ">both<", "Division"]
    {
        assert!(svg.contains(wanted), "{wanted} is not in {svg}");
    }
    // A division by nothing is told by a sign, not by colour alone, and in words.
    assert!(svg.contains(">×<") || svg.contains(">!<"), "{svg}");
    assert!(drawing.description.contains("6 objects, 2 wires and 1 groups"), "{}", drawing.description);
    assert!(drawing.description.contains("wrong"), "{}", drawing.description);
    assert!(drawing.to_png().unwrap().len() > 2000);
    let [w, h] = drawing.fitted([100.0, 50.0]).size;
    assert_eq!([w, h], [100.0, 50.0]);
}

/// A hundred thousand faces: as pixels in the vector file too, and quickly.
#[test]
fn many_faces_are_put_in_as_pixels() {
    let engine = solved("ball = Mesh Sphere(XY Plane(), 10, 320, 160)");
    let drawing = result(&engine, &options()).drawing;
    let svg = drawing.to_svg();
    assert!(svg.contains("data:image/png;base64,") && svg.len() < 1_000_000, "{}", svg.len());
    elements(&svg);
}

/// Whatever numbers a drawing holds, the file is well-formed.
#[test]
fn broken_numbers_do_not_break_a_file() {
    let bad = [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e300, -1e300, 0.0];
    let mut drawing = Drawing { size: [20.0, 20.0], background: None, ..Drawing::default() };
    for x in bad {
        for y in bad {
            let path = Path::cubic([[x, y], [y, x], [1.0, y], [x, 1.0]]);
            drawing.push(Shape::filled(path, Colour::rgb(1, 2, 3)).outlined(Colour::argb(7, 1, 2, 3), x));
            let label = Label::new([x, y], "text\u{1}", y, Colour::default()).anchored(Anchor::End);
            drawing.push(label.with_halo(Colour::default()));
            let corner = |at| katydid_picture::drawing::Corner { at, colour: Colour::argb(90, 1, 2, 3) };
            let corners = [[x, y, 0.0], [1.0, 1.0, y], [5.0, x, 1.0]].map(corner).to_vec();
            let line =
                SpaceLine { points: vec![[x, y, 1.0], [3.0, 4.0, x]], colour: Colour::default(), width: y };
            let faces = vec![Face { corners, sign: false }];
            drawing.items.push(Item::Solids(Solids { faces, lines: vec![line] }));
        }
    }
    elements(&drawing.to_svg());
    assert!(drawing.to_png().is_ok());
}

/// The lines and faces of a picture.
fn solids(drawing: &Drawing) -> &Solids {
    let found = drawing.items.iter().find_map(|item| if let Item::Solids(s) = item { Some(s) } else { None });
    found.unwrap()
}

#[test]
fn lines_behind_faces_are_left_out_dashed_or_drawn() {
    let engine =
        solved("b = Box 2Pt((0, 0, 0), (6, 4, 3)) -> Box |hidden\np = Custom Preview(b, rgb(90, 150, 210))");
    let drawn = |hidden_lines| {
        result(&engine, &Options { hidden_lines, size: [320, 200], ..Options::default() }).drawing
    };
    let over = |drawing: &Drawing| {
        let group = drawing.items.iter().find_map(|item| match item {
            Item::Group(name, items) if name == "Hidden lines" => Some(items.clone()),
            _ => None,
        });
        group.unwrap_or_default()
    };
    // Of the twelve edges of a box three are hidden, those that meet at the corner in the back.
    let natural = drawn(HiddenLines::Natural);
    assert_eq!((solids(&natural).lines.len(), over(&natural).len()), (12, 0));
    let hide = drawn(HiddenLines::Hide);
    assert_eq!((solids(&hide).lines.len(), over(&hide).len()), (9, 0));
    for (choice, is_dashed) in [(HiddenLines::Dash, true), (HiddenLines::Show, false)] {
        let drawing = drawn(choice);
        let behind = over(&drawing);
        assert_eq!((solids(&drawing).lines.len(), behind.len()), (9, 3));
        assert_eq!(drawing.to_svg().contains("stroke-dasharray"), is_dashed);
    }
}

#[test]
fn dots_on_one_height_are_seen_from_above() {
    let picture =
        result(&solved("d = Dot Display([(0, 0, 0), (5, 3, 0)], rgb(200, 30, 60), 0.6)"), &options());
    assert!(picture.drawing.description.contains("top view"), "{}", picture.drawing.description);
}

#[test]
fn planes_at_the_border_are_seen_whole() {
    let text = "p = XY Plane([(0, 0, 0), (9, 0, 0)])\nq = XZ Plane((4, 3, 0))";
    let plain = Options { size: [320, 200], ..Options::default() };
    let drawing = result(&solved(text), &plain).drawing;
    for p in solids(&drawing).lines.iter().flat_map(|line| &line.points) {
        assert!((0.0..=320.0).contains(&p[0]) && (0.0..=200.0).contains(&p[1]), "{p:?}");
    }
}

#[test]
fn arrows_too_short_for_a_head_get_no_ring() {
    let text = "c = Circle((0, 0, 0), 50)\na = Vector Display((1, 0, 0), (0.001, 0, 0))\n\
        d = Angular Dimension((0, 0, 0), (3, 0, 0), (3, 0.2, 0), false, _, 0.5)";
    let drawing = result(&solved(text), &Options { size: [320, 200], ..Options::default() }).drawing;
    // A ring is a closed line of 25 points.
    assert!(solids(&drawing).lines.iter().all(|line| line.points.len() != 25));
}

#[test]
fn a_legend_with_a_rectangle_stands_in_the_model() {
    let text = "l = Legend([rgb(90, 150, 210), rgb(240, 180, 60)], [\"box\", \"ball\"], \
        rectangle(plane((0, 0, 0)), 0..8, 0..4))";
    let drawing = result(&solved(text), &Options { size: [320, 200], ..Options::default() }).drawing;
    let faces: Vec<Colour> = solids(&drawing).faces.iter().map(Face::colour).collect();
    assert_eq!(faces, [Colour::rgb(90, 150, 210), Colour::rgb(240, 180, 60)]);
    let svg = drawing.to_svg();
    assert!(svg.contains(">box<") && svg.contains(">ball<"));
}

#[test]
fn sides_that_boxes_share_are_drawn_once() {
    let text = "b = Domain Box([plane((0, 0, 0)), plane((2, 0, 0))], 0..2, 0..2, 0..2)";
    let drawing = result(&solved(text), &Options { size: [320, 200], ..Options::default() }).drawing;
    assert_eq!(solids(&drawing).faces.len(), 11);
}

#[test]
fn a_panel_shows_geometry_as_text_only() {
    let engine = solved("p = Construct Point(1, 2, 3) hidden\nt = Panel(p)");
    assert!(result(&engine, &options()).is_empty);
}

#[test]
fn a_panel_shows_the_numbers_of_a_matrix() {
    let engine = solved("m = Construct Matrix(2, 2, [1, 2, 3, 4.5])\nt = Panel(m)");
    let svg = canvas(&engine, &options()).to_svg();
    assert!(svg.contains(">1   2<") && svg.contains(">3   4.5<"), "{svg}");
}
