//! JSON whose properties keep their order, which decides which output each goes to.

use std::fmt;

use katydid_component::Context;
use katydid_data::{Value, text};
use serde::de::{Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// A value in JSON.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Json {
    Null,
    Boolean(bool),
    Integer(i64),
    Number(f64),
    Text(String),
    List(Vec<Json>),
    Object(Vec<(String, Json)>),
}

impl Json {
    /// # Errors
    /// The text is no JSON, or nested more than 128 deep.
    pub(crate) fn parse(text: &str) -> Result<Self, serde_json::Error> {
        serde_json::from_str(text)
    }

    pub(crate) fn text(&self) -> String {
        // No part of it can fail: keys are texts, and numbers that are not finite become null.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// As an item of data; objects and lists stay JSON.
    pub(super) fn value(&self) -> Option<Value> {
        Some(match self {
            Self::Null => return None,
            Self::Boolean(yes) => Value::from(*yes),
            Self::Integer(number) => match i32::try_from(*number) {
                Ok(small) => Value::from(small),
                Err(_) => Value::from(*number as f64),
            },
            Self::Number(number) => Value::from(*number),
            Self::Text(text) => Value::from(text.clone()),
            Self::List(_) | Self::Object(_) => Value::from(self.text()),
        })
    }

    /// An item of data in JSON: a text that is an object or a list in JSON is that.
    pub(super) fn of(value: &Value, context: &Context<'_>) -> Self {
        match value {
            Value::Boolean(yes) => Self::Boolean(*yes),
            Value::Integer(number) => Self::Integer(i64::from(*number)),
            Value::Number(number) => Self::Number(*number),
            Value::Text(text) => match text.trim_start().starts_with(['{', '[']) {
                true => Self::parse(text).unwrap_or_else(|_| Self::Text(text.to_string())),
                false => Self::Text(text.to_string()),
            },
            other => Self::Text(text::value(other, &context.style())),
        }
    }

    /// This with the properties of another in the place of its own.
    pub(super) fn merged(self, other: Self) -> Self {
        match (self, other) {
            (Self::Object(mut own), Self::Object(others)) => {
                for (name, value) in others {
                    match own.iter_mut().find(|(known, _)| *known == name) {
                        Some((_, slot)) => {
                            let before = std::mem::replace(slot, Self::Null);
                            *slot = before.merged(value);
                        }
                        None => own.push((name, value)),
                    }
                }
                Self::Object(own)
            }
            (Self::List(mut own), Self::List(others)) => {
                for item in others {
                    if !own.contains(&item) {
                        own.push(item);
                    }
                }
                Self::List(own)
            }
            (own, Self::Null) => own,
            (_, other) => other,
        }
    }
}

impl Serialize for Json {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Null => to.serialize_unit(),
            Self::Boolean(yes) => to.serialize_bool(*yes),
            Self::Integer(number) => to.serialize_i64(*number),
            Self::Number(number) => to.serialize_f64(*number),
            Self::Text(text) => to.serialize_str(text),
            Self::List(items) => to.collect_seq(items),
            Self::Object(properties) => {
                let mut map = to.serialize_map(Some(properties.len()))?;
                for (name, value) in properties {
                    map.serialize_entry(name, value)?;
                }
                map.end()
            }
        }
    }
}

impl<'de> Deserialize<'de> for Json {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_any(Reader)
    }
}

struct Reader;

impl<'de> Visitor<'de> for Reader {
    type Value = Json;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("JSON")
    }

    fn visit_unit<E>(self) -> Result<Json, E> {
        Ok(Json::Null)
    }

    fn visit_bool<E>(self, yes: bool) -> Result<Json, E> {
        Ok(Json::Boolean(yes))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Json, E> {
        Ok(Json::Integer(number))
    }

    fn visit_u64<E>(self, number: u64) -> Result<Json, E> {
        Ok(i64::try_from(number).map_or(Json::Number(number as f64), Json::Integer))
    }

    fn visit_f64<E>(self, number: f64) -> Result<Json, E> {
        Ok(Json::Number(number))
    }

    fn visit_str<E>(self, text: &str) -> Result<Json, E> {
        Ok(Json::Text(text.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Json, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = items.next_element()? {
            list.push(item);
        }
        Ok(Json::List(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Json, A::Error> {
        let mut properties = Vec::new();
        while let Some(entry) = entries.next_entry()? {
            properties.push(entry);
        }
        Ok(Json::Object(properties))
    }
}
