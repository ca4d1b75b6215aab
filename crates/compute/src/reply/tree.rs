use std::collections::BTreeMap;

use katydid_data::{Kind, Tree, Value};
use katydid_geometry::CancellationToken;
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use crate::wire::encode;

/// The data of an output, or the default of an input: `{"ParamName", "InnerTree"}`.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "PascalCase")]
pub struct OutputTree {
    /// The name.
    pub param_name: String,
    /// The branches by their paths, in order.
    #[serde(serialize_with = "in_order")]
    pub inner_tree: Vec<(String, Vec<OutputItem>)>,
}

/// One item.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OutputItem {
    /// The full name of its .NET type.
    #[serde(rename = "type")]
    pub type_name: &'static str,
    /// The item as a JSON text.
    pub data: String,
}

/// The branches as an object whose members stand in their order.
fn in_order<S: Serializer>(branches: &[(String, Vec<OutputItem>)], to: S) -> Result<S::Ok, S::Error> {
    let mut map = to.serialize_map(Some(branches.len()))?;
    for (path, items) in branches {
        map.serialize_entry(path, items)?;
    }
    map.end()
}

impl OutputTree {
    /// A tree as a reply has it, geometry for an archive of that version, and words on what it does not hold. Nulls are
    /// skipped, and items of types that the protocol does not know are left out unless all types are asked for, as
    /// Rhino.Compute does both; the branches stay. It is not whole when whoever waits for it gave up.
    pub(crate) fn of(name: &str, tree: &Tree, archive: i32, all_types: bool) -> (Self, Option<String>) {
        let mut left_out = BTreeMap::new();
        let mut items = |value: Option<Value>| -> Option<OutputItem> {
            let value = value.filter(|_| !CancellationToken::is_over())?;
            let encoded = (all_types || is_known(value.kind())).then(|| encode(&value, archive)).flatten();
            if encoded.is_none() {
                *left_out.entry(value.kind().name()).or_insert(0_usize) += 1;
            }
            encoded.map(|encoded| OutputItem { type_name: encoded.type_name, data: encoded.json.to_string() })
        };
        let branches = tree.branches();
        let inner_tree = branches
            .map(|branch| (branch.path().to_string(), branch.iter().filter_map(&mut items).collect()))
            .collect();
        let words = left_out.iter().map(|(kind, count)| format!("{count} of type {kind}"));
        let words: Vec<String> = words.collect();
        let left_out =
            (!words.is_empty()).then(|| format!("{name}: items are left out, {}", words.join(", ")));
        (Self { param_name: name.to_owned(), inner_tree }, left_out)
    }
}

/// Whether the protocol knows items of a type. Others have a form in JSON too, but its clients do not expect them.
fn is_known(kind: Kind) -> bool {
    !matches!(
        kind,
        Kind::Colour
            | Kind::Domain
            | Kind::Domain2
            | Kind::Transform
            | Kind::Compound
            | Kind::Matrix
            | Kind::Complex
            | Kind::Guid
            | Kind::Time
            | Kind::MeshFace
            | Kind::Field
    )
}

#[cfg(test)]
mod tests {
    use katydid_data::{Colour, Column, Path};

    use super::*;

    fn text(values: Vec<Option<Value>>) -> (String, Option<String>) {
        told(values, false)
    }

    fn told(values: Vec<Option<Value>>, all_types: bool) -> (String, Option<String>) {
        let tree = Tree::branch_at(Path::from([0, 1]), Column::of_options(values));
        let (tree, left_out) = OutputTree::of("RH_OUT:x", &tree, 70, all_types);
        (serde_json::to_string(&tree).unwrap(), left_out)
    }

    #[test]
    fn data_is_json_in_a_text() {
        let (json, left_out) = text(vec![
            Some(Value::Number(5.0)),
            Some(Value::Integer(5)),
            Some(Value::Boolean(true)),
            Some(Value::from("a \"b\"")),
            None,
            Some(Value::Number(f64::NAN)),
        ]);
        let expected = concat!(
            r#"{"ParamName":"RH_OUT:x","InnerTree":{"{0;1}":["#,
            r#"{"type":"System.Double","data":"5.0"},"#,
            r#"{"type":"System.Int32","data":"5"},"#,
            r#"{"type":"System.Boolean","data":"true"},"#,
            r#"{"type":"System.String","data":"\"a \\\"b\\\"\""},"#,
            r#"{"type":"System.Double","data":"\"NaN\""}]}}"#
        );
        assert_eq!((json.as_str(), left_out), (expected, None));
    }

    #[test]
    fn what_the_protocol_does_not_know_is_left_out_and_told() {
        let colour = Some(Value::Colour(Colour { a: 255, r: 1, g: 2, b: 3 }));
        let (json, left_out) = text(vec![colour.clone(), Some(Value::Integer(1)), colour]);
        assert_eq!(
            json,
            r#"{"ParamName":"RH_OUT:x","InnerTree":{"{0;1}":[{"type":"System.Int32","data":"1"}]}}"#
        );
        assert_eq!(left_out.as_deref(), Some("RH_OUT:x: items are left out, 2 of type Colour"));
        let (json, left_out) = told(vec![Some(Value::Colour(Colour { a: 255, r: 1, g: 2, b: 3 }))], true);
        assert!(json.contains(r#""type":"System.Drawing.Color""#), "{json}");
        assert_eq!(left_out, None);
    }
}
