use std::sync::Arc;

use katydid_component::Outbox;
use katydid_component::testing::{Trial, texts};
use katydid_data::Value;
use katydid_geometry::Point3;

/// What each output of an Xml Parser gives.
fn parsed(xml: &str) -> Vec<Vec<String>> {
    let outcome = Trial::of("Xml Parser").item(xml).run();
    assert!(outcome.messages.is_empty(), "{:?}", outcome.messages);
    outcome.outputs.iter().map(texts).collect()
}

#[test]
fn xml_is_taken_apart() {
    let xml = "<?xml version=\"1.0\"?>\n<list kind=\"a&amp;b\" n=\"2\">\n  <thing>one &lt; two</thing>\n  \
        <thing><part/><part>&#169;</part></thing>\n  <note><![CDATA[<plain>]]></note>\n</list>";
    let [elements, values, names, attributes, data] = <[Vec<String>; 5]>::try_from(parsed(xml)).unwrap();
    assert_eq!(
        elements,
        ["{0}: list", "{0;0}: thing", "{0;1}: thing", "{0;1;0}: part", "{0;1;1}: part", "{0;2}: note"]
    );
    assert_eq!(values, ["{0;0}: one < two", "{0;1;1}: \u{a9}"]);
    assert_eq!(names, ["{0}: kind, n"]);
    assert_eq!(attributes, ["{0}: a&b, 2"]);
    assert_eq!(data, ["{0;2}: <plain>"]);
}

#[test]
fn an_empty_element_with_attributes_counts_as_open() {
    // As the plug-in has it: the next element stands a step deeper.
    let elements = parsed("<r><a x=\"1\"/><b/><c/></r>").swap_remove(0);
    assert_eq!(elements, ["{0}: r", "{0;0}: a", "{0;0;0}: b", "{0;0;1}: c"]);
}

#[test]
fn what_is_no_xml_is_refused() {
    let message = |text: &str| Trial::of("Xml Parser").item(text).message();
    assert!(message("<a><b></a>").starts_with("The XML is broken"), "{}", message("<a><b></a>"));
    assert!(message("<a>&nothing;</a>").starts_with("The XML is broken"));
    assert!(message("<a x=1></a>").starts_with("The XML is broken"));
    assert!(message("https://example.org/a.xml").contains("not fetched"));
    assert!(message("missing.xml").contains("may not be read here"));
    let deep = "<a>".repeat(1000);
    assert!(message(&deep).contains("more than 256 deep"));
}

#[test]
fn trees_are_written_as_xml() {
    let data =
        [("{0}", ["root"]), ("{0;0}", ["a < b"]), ("{0;1}", ["c"]), ("{0;1;0}", ["d"]), ("{1}", ["e"])];
    let xml = Trial::of("Write XML").branches(data).branches([("{0;1}", ["pair"])]).texts(0);
    let wanted = "{0}: <GHPath_0>root<GHPath_0-0>a &lt; b</GHPath_0-0><pair>c<GHPath_0-1-0>d</GHPath_0-1-0></pair>\
        <GHPath_1>e</GHPath_1></GHPath_0>";
    assert_eq!(xml, [wanted]);
    let apart = Trial::of("Write XML").branches([("{0;1}", ["x"]), ("{0;2}", ["y"])]).default().texts(0);
    let wanted = "{0}: <GHPath_0>\n  <GHPath_0-0 />\n  <GHPath_0-1>x</GHPath_0-1>\n  <GHPath_0-2>y</GHPath_0-2>\n</GHPath_0>";
    assert_eq!(apart, [wanted]);
    let wrong = Trial::of("Write XML").item(1).item("two words").message();
    assert!(wrong.contains("is no name of an element"), "{wrong}");
}

#[test]
fn what_is_written_is_read_again() {
    let data =
        [("{0}", ["1"]), ("{0;0}", ["2"]), ("{0;1}", ["\"3\" & 4"]), ("{0;1;0}", ["5"]), ("{0;1;1}", ["6"])];
    let outcome = Trial::of("Write XML").branches(data).default().run();
    let xml = outcome.outputs.into_iter().next().unwrap();
    let values = Trial::of("Xml Parser").tree(xml).texts(1);
    assert_eq!(values, ["{0}: 1", "{0;0}: 2", "{0;1}: \"3\" & 4", "{0;1;0}: 5", "{0;1;1}: 6"]);
}

#[test]
fn places_between_two_known_ones() {
    let points = |x: f64, y: f64, z: f64| Point3::new(x, y, z);
    let trial = |place: Point3| {
        Trial::of("Geo to XYZ")
            .item(place)
            .item(points(0.0, 0.0, 0.0))
            .item(points(100.0, 50.0, 0.0))
            .item(points(2.0, 41.0, 0.0))
            .item(points(3.0, 42.0, 0.0))
    };
    assert_eq!(trial(points(2.25, 41.5, 7.0)).texts(0), ["{0}: {25, 25, 7}"]);
    let same = Trial::of("Geo to XYZ")
        .item(Point3::ORIGIN)
        .item(Point3::ORIGIN)
        .item(points(1.0, 1.0, 0.0))
        .item(points(2.0, 41.0, 0.0))
        .item(points(2.0, 42.0, 0.0));
    assert_eq!(same.message(), "The two places have the same longitude");
}

/// The only item of a tree.
fn point(trial: Trial) -> Point3 {
    match trial.run().outputs[0].column().get(0) {
        Some(Value::Point(point)) => point,
        other => panic!("{other:?}"),
    }
}

#[test]
fn points_of_the_model_on_the_earth() {
    let at = |point: Point3, place: Point3| {
        Trial::of("XYZ to Geo").item(point).item(Point3::new(10.0, 20.0, 0.0)).item(place)
    };
    let place = Point3::new(2.0, 60.0, 5.0);
    assert_eq!(point(at(Point3::new(10.0, 20.0, 0.0), place)), place);
    // On the equator the earth is as wide as long: a degree is a 360th of its circle. The unit is a millimetre.
    let degree = 1000.0 * 6_378_135.0 * std::f64::consts::PI / 180.0;
    let equator = Point3::ORIGIN;
    let east = point(at(Point3::new(10.0 + degree, 20.0, 0.0), equator));
    assert!((east - Point3::new(1.0, 0.0, 0.0)).length() < 1e-9, "{east:?}");
    // At 60 degrees a degree of longitude is half as long as one of latitude.
    let away = point(at(Point3::new(1e7, 1e7 + 10.0, 2000.0), place)) - place;
    assert!((away.x / away.y - 2.0).abs() < 1e-9, "{away:?}");
    assert!((away.z - 2.0).abs() < 1e-12);
    assert!(at(equator, Point3::new(0.0, 90.0, 0.0)).message().contains("between the poles"));
}

#[test]
fn degrees_and_minutes() {
    let formatted = |x: f64, y: f64| Trial::of("Format Geo").item(Point3::new(x, y, 3.0)).texts(0);
    assert_eq!(formatted(4130.0, -1245.0), ["{0}: {41.5, -12.75, 3}"]);
    assert_eq!(formatted(15.0, 10006.0), ["{0}: {0.25, 100.1, 3}"]);
}

#[test]
fn messages_go_to_their_address() {
    let channel =
        |name: &str| Trial::of("OSC Channel").list(["/fader", "0.5", "2"]).setting("NickName", name).texts(0);
    assert_eq!(channel("/fader"), ["{0}: 0.5,2"]);
    assert_eq!(channel("/knob"), ["{0}: null"]);
    let dispatch =
        |k: usize| Trial::of("OSC Dispatch").list(["/knob", "/fader"]).list(["/fader", "1"]).texts(k);
    assert_eq!(dispatch(0), ["{0}: /fader"]);
    assert_eq!(dispatch(1), ["{0}: null, 1"]);
    assert_eq!(
        Trial::of("OSC Dispatch").list(["/knob"]).list(["/fader", "1"]).message(),
        "The address of the message is not in the list"
    );
}

#[test]
fn geometry_is_written_as_kml() {
    let outbox = Arc::new(Outbox::default());
    let style = Trial::of("KML Style").default().default().item(2.0).item("A & B").run();
    let mut items: Vec<Value> = vec![style.outputs[0].column().get(0).unwrap()];
    items.push(Point3::new(0.0, 0.0, 1000.0).into());
    let outcome = Trial::of("KML Exporter")
        .item("C:\\places.kml")
        .list(items)
        .item(Point3::ORIGIN)
        .item(Point3::new(2.0, 41.0, 0.0))
        .default()
        .outbox(&outbox)
        .run();
    assert!(outcome.messages.is_empty(), "{:?}", outcome.messages);
    let files = outbox.take();
    assert_eq!(files[0].name, "places.kml");
    let text = String::from_utf8(files[0].bytes.clone()).unwrap();
    assert!(
        text.contains(
            "<Point><altitudeMode>absolute</altitudeMode><coordinates>2,41,1</coordinates></Point>"
        ),
        "{text}"
    );
    assert!(text.contains("<name>A &amp; B</name>"), "{text}");
    assert!(text.contains("<LineStyle><color>ff000000</color><width>2</width>"), "{text}");
    // It is XML.
    assert_eq!(parsed(&text)[0][0], "{0}: kml");
    let unwanted = Trial::of("KML Exporter")
        .item("places.kml")
        .item(Point3::ORIGIN)
        .item(Point3::ORIGIN)
        .item(Point3::new(2.0, 41.0, 0.0))
        .default()
        .message();
    assert!(unwanted.contains("--write FOLDER"), "{unwanted}");
}

#[test]
fn spreadsheets_are_written_and_read() {
    let folder = tempfile::tempdir().unwrap();
    let outbox = Arc::new(Outbox::default());
    let written = Trial::of("Spreadsheet Writer")
        .item("out/table.csv")
        .branches([("{0}", ["name", "x"]), ("{1}", ["a, b", "1.5"])])
        .names(["P", "Sheet 1"])
        .outbox(&outbox)
        .texts(0);
    assert_eq!(written, ["{0}: Spreadsheet saved to: table.csv"]);
    let file = outbox.take().swap_remove(0);
    assert_eq!(file.bytes, b"name,x\r\n\"a, b\",1.5\r\n");
    std::fs::write(folder.path().join(&file.name), &file.bytes).unwrap();
    let files = katydid_component::Files::Inside(folder.path().to_path_buf());
    let read = Trial::of("Spreadsheet Reader").item("table.csv").default().files(files).texts(1);
    assert_eq!(read, ["{0}: name, x", "{1}: a, b, 1.5"]);
    assert!(
        Trial::of("Spreadsheet Reader").item("table.csv").default().message().contains("may not be read")
    );
}
