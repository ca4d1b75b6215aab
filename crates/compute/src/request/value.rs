//! The data of a value, read as the input takes it.

use katydid_data::{Kind, Tree, TreeBuilder, Value};
use katydid_geometry::{Arc, Box3, Circle, Curve, Interval, Line, Plane, Point3, Rectangle, Vector3, Xform};
use serde_json::Value as Json;

use super::InputTree;
use super::path::shown;
use crate::Fault;
use crate::definition::{Form, Input};
use crate::wire::{Members, Read, decode_object};

/// The tree that an input gets.
///
/// # Errors
/// `BadRequest` for the first item that is not what the input takes, with its place.
pub(crate) fn tree(input: &Input, given: &InputTree) -> Result<Tree, Fault> {
    let mut builder = TreeBuilder::<Value>::new();
    for (path, items) in &given.branches {
        builder.branch(path.clone());
        for (index, item) in items.iter().enumerate() {
            let value = read(item, input.form).map_err(|fault| {
                let place = format!("{}, item {index} of {path}", shown(&input.name));
                Fault { message: format!("{place}: the data {}", fault.message), ..fault }
            })?;
            builder.push(value);
        }
    }
    Ok(builder.finish())
}

/// One item; null is none.
fn read(data: &Json, form: Form) -> Result<Option<Value>, Fault> {
    if data.is_null() || data.as_str().is_some_and(|text| text.trim() == "null") {
        return Ok(None);
    }
    Ok(Some(match form {
        Form::Of(Kind::Number) => Value::Number(plain(data)?),
        Form::Of(Kind::Integer) => Value::Integer(plain(data)?),
        Form::Of(Kind::Boolean) => Value::Boolean(plain(data)?),
        Form::Of(Kind::Text) => Value::from(text(data)),
        Form::RawText => Value::from(raw_text(data)),
        Form::Of(Kind::Point) => Value::Point(Point3::read(data)?),
        Form::Of(Kind::Vector) => Value::Vector(Vector3::read(data)?),
        Form::Of(Kind::Plane) => Value::from(Plane::read(data)?),
        Form::Of(Kind::Line) => Value::from(Line::read(data)?),
        Form::Of(Kind::Circle) => Value::from(Circle::read(data)?),
        Form::Of(Kind::Arc) => Value::from(Arc::read(data)?),
        Form::Of(Kind::Rectangle) => Value::from(Rectangle::read(data)?),
        Form::Of(Kind::Box) => Value::from(Box3::read(data)?),
        Form::Of(Kind::Curve) => Value::from(Curve::read(data)?),
        Form::Of(Kind::Geometry) => object(&inner(data))?,
        Form::Of(_) => any(data)?,
    }))
}

/// A number, whole number or truth value; a text may hold it, in quotes of its own too.
fn plain<T: Read>(data: &Json) -> Result<T, Fault> {
    T::read(data).or_else(|fault| match data {
        Json::String(_) => T::read(&inner(data)).map_err(|_| fault),
        _ => Err(fault),
    })
}

/// The JSON in a text, or what is there.
fn inner(data: &Json) -> Json {
    let parsed = data.as_str().and_then(|text| serde_json::from_str(text).ok());
    parsed.unwrap_or_else(|| data.clone())
}

/// The text of a contextual input or panel: JSON of a text when it is that, else with its escapes resolved.
fn text(data: &Json) -> String {
    let Json::String(raw) = data else { return data.to_string() };
    match serde_json::from_str(raw) {
        Ok(Json::String(text)) => text,
        Ok(Json::Number(_) | Json::Bool(_)) => raw.trim().to_owned(),
        _ => unescape(raw),
    }
}

/// The text of a Text parameter in a group: as it is.
fn raw_text(data: &Json) -> String {
    match data {
        Json::String(raw) => raw.clone(),
        other => other.to_string(),
    }
}

/// Resolves `\n`, `\t`, `\"`, `\x41`, `\u00e9` and the like. What is no escape stays.
fn unescape(raw: &str) -> String {
    let mut text = String::with_capacity(raw.len());
    let mut rest = raw.chars();
    while let Some(c) = rest.next() {
        if c != '\\' {
            text.push(c);
            continue;
        }
        let mut ahead = rest.clone();
        let Some(sign) = ahead.next() else {
            text.push(c);
            break;
        };
        let digits = match sign {
            'u' => 4,
            'x' => 2,
            _ => 0,
        };
        let resolved = match sign {
            'n' => Some('\n'),
            't' => Some('\t'),
            'r' => Some('\r'),
            'a' => Some('\u{7}'),
            'b' => Some('\u{8}'),
            'f' => Some('\u{c}'),
            'v' => Some('\u{b}'),
            'e' => Some('\u{1b}'),
            'u' | 'x' => {
                let code: String = ahead.by_ref().take(digits).collect();
                let code = (code.len() == digits).then(|| u32::from_str_radix(&code, 16).ok()).flatten();
                code.and_then(char::from_u32)
            }
            sign if !sign.is_ascii_alphanumeric() => Some(sign),
            _ => None,
        };
        match resolved {
            Some(resolved) => {
                text.push(resolved);
                rest = ahead;
            }
            None => text.push(c),
        }
    }
    text
}

/// Geometry: an object of Rhino's, or the form of something simpler.
fn object(data: &Json) -> Result<Value, Fault> {
    let members = match data {
        Json::Array(items) if items.first().is_some_and(|item| item.is_array() || item.is_object()) => {
            return Ok(Value::from(Curve::read(data)?));
        }
        Json::Array(_) => return Ok(Value::Point(Point3::read(data)?)),
        _ => Members::of(data)?,
    };
    let has = |name| members.get(name).is_some();
    if has("data") {
        decode_object(data)
    } else if has("From") {
        Ok(Value::from(Line::read(data)?))
    } else if has("AngleDomain") || has("StartAngle") || has("Angle") {
        Ok(Value::from(Arc::read(data)?))
    } else if has("Radius") {
        Ok(Value::from(Circle::read(data)?))
    } else if has("Plane") && has("Z") {
        Ok(Value::from(Box3::read(data)?))
    } else if has("Plane") {
        Ok(Value::from(Rectangle::read(data)?))
    } else if has("Origin") {
        Ok(Value::from(Plane::read(data)?))
    } else if has("X") {
        Ok(Value::Point(Point3::read(data)?))
    } else {
        // Its message says what is missing.
        decode_object(data)
    }
}

/// Data for an input of another type: what it looks like, for the input to make of it what it can.
fn any(data: &Json) -> Result<Value, Fault> {
    let data = &inner(data);
    Ok(match data {
        Json::Bool(flag) => Value::Boolean(*flag),
        Json::Number(number) => match number.as_i64().and_then(|whole| i32::try_from(whole).ok()) {
            Some(whole) => Value::Integer(whole),
            None => Value::Number(f64::read(data)?),
        },
        Json::String(text) => Value::from(text.as_str()),
        Json::Object(_) => {
            let members = Members::of(data)?;
            if members.get("T0").is_some() {
                Value::from(Interval::read(data)?)
            } else if members.get("M00").is_some() {
                Value::from(Xform::read(data)?)
            } else {
                object(data)?
            }
        }
        _ => object(data)?,
    })
}

#[cfg(test)]
mod tests {
    use katydid_data::Path;
    use serde_json::json;

    use super::*;

    fn one(data: Json, form: Form) -> Result<Option<Value>, Fault> {
        read(&data, form)
    }

    #[test]
    fn numbers_come_in_many_forms() {
        for data in [json!(4.5), json!("4.5"), json!(" 4.5 "), json!("\"4.5\"")] {
            assert_eq!(one(data, Form::Of(Kind::Number)), Ok(Some(Value::Number(4.5))));
        }
        assert_eq!(one(json!("4"), Form::Of(Kind::Integer)), Ok(Some(Value::Integer(4))));
        assert_eq!(one(json!(4.0), Form::Of(Kind::Integer)), Ok(Some(Value::Integer(4))));
        assert_eq!(one(json!("True"), Form::Of(Kind::Boolean)), Ok(Some(Value::Boolean(true))));
        assert_eq!(one(json!("null"), Form::Of(Kind::Number)), Ok(None));
        assert_eq!(one(json!(null), Form::Of(Kind::Text)), Ok(None));
        for (data, form) in [
            (json!("4.5"), Form::Of(Kind::Integer)),
            (json!("NaN"), Form::Of(Kind::Number)),
            (json!("1e999"), Form::Of(Kind::Number)),
            (json!("four"), Form::Of(Kind::Number)),
            (json!(3e10), Form::Of(Kind::Integer)),
            (json!("maybe"), Form::Of(Kind::Boolean)),
            (json!({}), Form::Of(Kind::Number)),
            (json!([]), Form::Of(Kind::Point)),
            (json!({"X": 1}), Form::Of(Kind::Point)),
            (json!("{\"version\":10000}"), Form::Of(Kind::Geometry)),
        ] {
            assert!(one(data.clone(), form).is_err(), "{data} as {form:?}");
        }
    }

    #[test]
    fn texts_are_unquoted_where_rhino_does_so() {
        let text = |data: Json, form| match one(data, form) {
            Ok(Some(Value::Text(text))) => text.to_string(),
            other => panic!("{other:?}"),
        };
        assert_eq!(text(json!("\"a\\nb\""), Form::Of(Kind::Text)), "a\nb");
        assert_eq!(text(json!("plain"), Form::Of(Kind::Text)), "plain");
        assert_eq!(text(json!("C:\\new\\x41\\u00e9\\q\\"), Form::Of(Kind::Text)), "C:\new\u{41}é\\q\\");
        assert_eq!(text(json!("{\"a\": 1}"), Form::Of(Kind::Text)), "{\"a\": 1}");
        assert_eq!(text(json!(4), Form::Of(Kind::Text)), "4");
        assert_eq!(text(json!(true), Form::Of(Kind::Text)), "true");
        assert_eq!(text(json!("\"a\""), Form::RawText), "\"a\"");
        assert_eq!(text(json!("\\n"), Form::RawText), "\\n");
    }

    #[test]
    fn geometry_is_known_by_its_members() {
        let kind = |data: Json| one(data, Form::Of(Kind::Geometry)).unwrap().unwrap().kind().name();
        assert_eq!(kind(json!("{\"X\":1,\"Y\":2,\"Z\":3}")), "Point");
        assert_eq!(kind(json!([1, 2, 3])), "Point");
        assert_eq!(kind(json!([[0, 0, 0], [1, 0, 0], [1, 1, 0]])), "Curve");
        assert_eq!(kind(json!({"From": [0, 0, 0], "To": [1, 0, 0]})), "Line");
        assert_eq!(kind(json!({"radius": 2, "plane": {"Origin": [0, 0, 0]}})), "Circle");
        assert_eq!(one(json!("255,0,0"), Form::Of(Kind::Generic)), Ok(Some(Value::from("255,0,0"))));
        assert_eq!(
            one(json!({"T0": 0, "T1": 2}), Form::Of(Kind::Generic)).unwrap().unwrap().kind().name(),
            "Domain"
        );
    }

    #[test]
    fn what_is_wrong_is_named() {
        let input = Input::new("RH_IN:width".to_owned(), 0, 0, Form::Of(Kind::Number));
        let branches = vec![(Path::from([0, 1]), vec![json!(1), json!("wide")])];
        let fault = tree(&input, &InputTree { name: input.name.clone(), branches }).unwrap_err();
        assert_eq!(fault.message, "RH_IN:width, item 1 of {0;1}: the data is text, not a number");
    }
}
