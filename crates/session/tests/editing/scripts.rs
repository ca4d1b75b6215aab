//! Scripts: their text and ports, stored as Grasshopper stores them.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use katydid_definition::document::{Access, Object};
use katydid_definition::kd;
use katydid_session::Registry;
use katydid_session::protocol::{AccessView, Control, Edit, PortChange};
use uuid::Uuid;

use crate::common::Studio;

const GH_PYTHON: &str = "410755b1-224a-4c1e-a407-bf32fb45ea7e";
const PYTHON_3: &str = "719467e6-7cf5-4848-99b0-c5dd57e5442c";
const C_SHARP: &str = "a9a8ebd2-fff5-4c44-a8f5-739736d129ba";

/// A studio with one script component of an input `x` and an output `a`.
fn studio(component: &str, settings: &str) -> (Studio, Uuid) {
    let text = format!("katydid 1\ns = Script @{component}(x = 1) variable -> a {{\n{settings}\n}}\n");
    let read = kd::read(&text, &Registry).unwrap_or_else(|problems| panic!("{problems}"));
    let id = read.document.objects.iter().find(|object| object.script().is_some()).map(|object| object.id);
    (Studio::new(read.document), id.unwrap())
}

fn control(object: &Object, text: &str, additional: Option<&str>) -> Edit {
    let control = Control::Script {
        language: String::new(),
        text: text.to_owned(),
        additional: additional.map(str::to_owned),
        using: None,
        from_wire: false,
        hints: Vec::new(),
    };
    Edit::Reshape { object: object.id, control }
}

#[test]
fn a_text_is_written_where_its_component_keeps_it() {
    let (mut studio, id) = studio(GH_PYTHON, "    CodeInput = \"a = x\"");
    let edit = control(studio.object(id), "a = 2\nb = 3", None);
    studio.make(edit.clone());
    assert_eq!(studio.object(id).container().str("CodeInput"), Some("a = 2\nb = 3"));
    assert!(studio.make(edit).is_empty(), "the same again is no step");
    assert!(studio.undo());
    assert_eq!(studio.object(id).container().str("CodeInput"), Some("a = x"));
}

#[test]
fn line_ends_stay_those_of_the_file() {
    let (mut studio, id) = studio(GH_PYTHON, "    CodeInput = \"a = x\\r\\nb = x\"");
    assert!(studio.object(id).container().str("CodeInput").unwrap().contains("\r\n"));
    let same = control(studio.object(id), "a = x\nb = x", None);
    assert!(studio.make(same).is_empty());
    let other = control(studio.object(id), "a = x\nb = y", None);
    studio.make(other);
    assert_eq!(studio.object(id).container().str("CodeInput"), Some("a = x\r\nb = y"));
}

#[test]
fn members_of_c_sharp_stand_beside_its_text() {
    let (mut studio, id) = studio(C_SHARP, "    ScriptSource = \"A = x;\"");
    let edit = control(studio.object(id), "A = F();", Some("int F() { return 1; }"));
    studio.make(edit);
    let container = studio.object(id).container().clone();
    assert_eq!(container.str("ScriptSource"), Some("A = F();"));
    assert_eq!(container.str("AdditionalSource"), Some("int F() { return 1; }"));
    assert_eq!(container.str("UsingSource"), None, "what was not there and is empty stays away");
}

#[test]
fn rhino_8_keeps_it_in_base64() {
    let text = BASE64.encode("a = x");
    let settings = format!("    Script/Text = \"{text}\"\n    Script/LanguageSpec/Taxon = \"*.*.python\"");
    let (mut studio, id) = studio(PYTHON_3, &settings);
    assert_eq!(studio.object(id).script().unwrap().text, "a = x");
    let edit = control(studio.object(id), "a = 'ü'", None);
    studio.make(edit);
    // By hand: base64 of 61 20 3D 20 27 C3 BC 27.
    let chunk = studio.object(id).container().child("Script").unwrap();
    assert_eq!(chunk.str("Text"), Some("YSA9ICfDvCc="));
}

#[test]
fn inputs_have_hints_and_access_as_files_have_them() {
    let (mut studio, id) = studio(GH_PYTHON, "    CodeInput = \"a = x\"");
    let port = studio.input(id, 0);
    studio.make(Edit::ChangePort { port, change: PortChange::Hint { hint: "float".to_owned() } });
    studio.make(Edit::ChangePort { port, change: PortChange::Access { access: AccessView::Tree } });
    let input = &studio.object(id).inputs[0];
    assert_eq!(input.type_hint, Some("39fbc626-7a01-46ab-a18e-ec1c0c41685b".parse().unwrap()));
    assert_eq!(input.access, Access::Tree);
    let chunk = input.chunk(studio.object(id).container()).unwrap();
    assert_eq!(chunk.i32("ScriptParamAccess"), Some(2));
    let unknown = PortChange::Hint { hint: "Sphere".to_owned() };
    assert!(studio.try_do(&Edit::ChangePort { port, change: unknown }).is_err());
    let output = studio.output(id, 0);
    let of_output = PortChange::Access { access: AccessView::List };
    assert!(studio.try_do(&Edit::ChangePort { port: output, change: of_output }).is_err());
}

#[test]
fn a_new_input_is_of_the_type_that_grasshopper_gives_it() {
    for (component, settings, type_id) in [
        (GH_PYTHON, "    CodeInput = \"a = x\"", "84fa917c-1ed8-4db3-8be1-7bdc4a6495a2"),
        (PYTHON_3, "    Script/Text = \"YSA9IHg=\"", "08908df5-fa14-4982-9ab2-1aa0927566aa"),
    ] {
        let (mut studio, id) = studio(component, settings);
        studio.make(Edit::AddPort { object: id, input: true, index: 1, id: None });
        let input = studio.object(id).inputs.get(1).unwrap().clone();
        assert_eq!(input.type_id, Some(type_id.parse().unwrap()));
        let chunk = input.chunk(studio.object(id).container()).unwrap();
        assert_eq!(chunk.bool("ShowTypeHints"), Some(true));
        assert_eq!(chunk.i32("ScriptParamAccess"), Some(0));
    }
}

#[test]
fn what_comes_over_a_wire_is_not_written_here() {
    let (mut studio, id) = studio(GH_PYTHON, "    HideInput = false\n    CodeInput = \"a = x\"");
    let edit = control(studio.object(id), "a = 2", None);
    assert!(studio.try_do(&edit).is_err());
    let sine = studio.place("Sine", [0.0, 0.0]);
    let edit = control(studio.object(sine), "a = 2", None);
    assert!(studio.try_do(&edit).is_err());
}
