//! The inputs that the menu of a component shows: where it asks, and whether.

use super::*;

const TEXT: &str = "Get String";

/// Asks at what a text says, and if a boolean says so.
fn steered(saved: &str) -> Maker {
    let mut maker = hops(saved, &[], "Sum");
    let ids: Vec<Uuid> = (0..4).map(|_| maker.id()).collect();
    let object = &mut maker.document.objects[0];
    object.container_mut().set("ShowInput_Path", true);
    object.container_mut().set("ShowInput_Enabled", true);
    for (id, (name, nickname)) in
        ids.into_iter().zip([("_Path", "Path"), ("_Enabled", "Enabled"), ("A", "A"), ("B", "B")])
    {
        let port = NewPort {
            id,
            name: name.to_owned(),
            nickname: nickname.to_owned(),
            type_id: Some(NUMBER).filter(|_| name.len() == 1),
            ..NewPort::default()
        };
        object.add_port(Side::Input, &port);
    }
    for (k, (get, name)) in
        [(TEXT, "path"), ("Get Boolean", "enabled"), ("Get Number", "A"), ("Get Number", "B")]
            .into_iter()
            .enumerate()
    {
        let get = maker.get(get, name);
        maker.wire(get, 0, 0, k);
    }
    maker
}

fn with(maker: &Maker, host: &str, values: &[(&str, Json)]) -> (bool, Json) {
    let values = values.iter().map(|(name, x)| value(name, "0", std::slice::from_ref(x))).collect();
    answer(settings(&[host.to_owned()]), maker, values, &Bounds::default()).unwrap()
}

#[test]
fn the_path_that_is_wired_counts_and_not_the_one_that_was_saved() {
    let host = format!("127.0.0.1:{}", serve(components));
    let maker = steered("http://127.0.0.1:1/gone");
    let path = ("path", json!(format!("http://{host}/add")));
    let enabled = ("enabled", json!(true));
    let numbers = [("A", json!(4)), ("B", json!(5))];
    let (failed, reply) = with(&maker, &host, &[&[path.clone(), enabled.clone()][..], &numbers].concat());
    assert!(!failed && item(&reply, "RH_OUT:x") == "9.0", "{reply}");
    // Without a path nobody is asked, whatever was saved.
    let (failed, reply) = with(&maker, &host, &[&[enabled.clone()][..], &numbers].concat());
    assert!(!failed && output(&reply, "RH_OUT:x").is_empty(), "{reply}");
    assert!(reply["warnings"].to_string().contains("Input parameter Path failed to collect data"), "{reply}");
    let (_, reply) = with(&maker, &host, &[&[("path", json!(" ")), enabled][..], &numbers].concat());
    assert!(reply["warnings"].to_string().contains("No definition is named"), "{reply}");
}

#[test]
fn one_that_is_not_enabled_asks_nobody_and_says_nothing() {
    let maker = steered("http://127.0.0.1:1/gone");
    let host = format!("127.0.0.1:{}", serve(|_| panic!("asked")));
    let path = ("path", json!(format!("http://{host}/add")));
    let (failed, reply) =
        with(&maker, &host, &[path.clone(), ("enabled", json!(false)), ("A", json!(4)), ("B", json!(5))]);
    assert!(!failed && output(&reply, "RH_OUT:x").is_empty(), "{reply}");
    assert!(!reply["warnings"].to_string().contains("component \"Hops\""), "{reply}");
    let (_, reply) = with(&maker, &host, &[path, ("A", json!(4)), ("B", json!(5))]);
    assert!(
        reply["warnings"].to_string().contains("Input parameter Enabled failed to collect data"),
        "{reply}"
    );
}

#[test]
fn a_definition_that_is_kept_is_not_taken_for_one_of_another_path() {
    let host = format!("127.0.0.1:{}", serve(components));
    let saved = "C:\\gone\\double.gh";
    let mut maker = hops(saved, &["_Path", "N"], "D");
    let kept = double().document.to_gh().unwrap();
    let settings = maker.document.objects[0].container_mut();
    settings.set("ShowInput_Path", true);
    settings.set("InternalizeDefinition", katydid_definition::archive::ItemValue::ByteArray(kept));
    // The input of numbers that stands before the first is a text in truth.
    let at = maker.get(TEXT, "path");
    let source = maker.document.objects[at].outputs[0].id;
    maker.document.objects[0].set_sources(0, &[source]).unwrap();
    let (failed, reply) = with(&maker, &host, &[("path", json!(saved)), ("N", json!(4))]);
    assert!(!failed && item(&reply, "RH_OUT:x") == "8.0", "{reply}");
    let (failed, reply) = with(&maker, &host, &[("path", json!("D:\\other.gh")), ("N", json!(4))]);
    assert!(failed && reply["errors"].to_string().contains("files may not be read here"), "{reply}");
}

#[test]
fn inputs_of_such_names_are_plain_ones_unless_the_menu_shows_them() {
    let host = format!("127.0.0.1:{}", serve(counts));
    let maker = hops(&format!("http://{host}/count"), &["_Path"], "L");
    let (failed, reply) = with(&maker, &host, &[("_Path", json!(2))]);
    assert!(!failed && output(&reply, "RH_OUT:x")[0].1.len() == 2, "{reply}");
}
