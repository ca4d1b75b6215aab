//! User strings of geometry: `SetUserString` and its kin.

use crate::geometry::answer::{Answer, Outcome};
use crate::geometry::table::Endpoints;
use crate::shape::{Geometry, Shape};
use crate::wire::Read;
use crate::{Fault, UserStrings, Value};

pub(super) fn enter(table: &mut Endpoints) {
    table.member("GeometryBase.SetUserString &this key value", |own: Geometry, key: String, text: Text| {
        // Without a text the key goes, as in RhinoCommon.
        changed(own, |strings| match text.0 {
            Some(text) if !key.is_empty() => strings.set(&key, text).map(|()| true),
            Some(_) => Ok(false),
            None => Ok(strings.remove(&key)),
        })
    });
    table.member("GeometryBase.GetUserString this key", |own: Geometry, key: String| {
        Ok(own.strings.get(&key).map(str::to_owned))
    });
    table.member("GeometryBase.get_UserStringCount this", |own: Geometry| Ok(own.strings.pairs().len()));
    table.member("GeometryBase.GetUserStrings this", |own: Geometry| {
        let pairs = own.strings.pairs().iter();
        Ok(Value::Map(pairs.map(|(key, text)| (Value::from(key.as_str()), text.as_str().into())).collect()))
    });
    table.member("GeometryBase.DeleteUserString &this key", |own: Geometry, key: String| {
        changed(own, |strings| Ok(strings.remove(&key)))
    });
    table.member("GeometryBase.DeleteAllUserStrings &this", |own: Geometry| {
        changed(own, |strings| {
            strings.clear();
            Ok(())
        })
    });
}

/// What a change of the strings says, and the object with them.
fn changed<T>(
    mut own: Geometry,
    change: impl FnOnce(&mut UserStrings) -> Outcome<T>,
) -> Outcome<(T, Geometry)> {
    let said = change(&mut own.strings)?;
    Ok((said, own))
}

/// A text, or null.
struct Text(Option<String>);

impl Read for Text {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        Option::<String>::read(json).map(Self)
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        Option::<String>::of_value(value).map(Self)
    }

    fn type_name() -> String {
        "String".into()
    }
}

impl Read for Geometry {
    fn read(json: &serde_json::Value) -> Result<Self, Fault> {
        Shape::read(json).map(Self::from)
    }

    /// Structs are no geometry that carries strings; nor are results.
    fn of_value(value: &Value) -> Result<Self, Fault> {
        match value {
            Value::Geometry(Self { shape: Shape::Record(record), .. }) => {
                Err(Fault::bad_request(format!("is a {}, which carries no user strings", record.class)))
            }
            Value::Geometry(own) => Ok(own.clone()),
            other => Err(Fault::bad_request(format!("is {}, which carries no user strings", other.noun()))),
        }
    }

    fn type_name() -> String {
        "GeometryBase".into()
    }
}

impl Answer for Geometry {
    fn name() -> String {
        "Rhino.Geometry.GeometryBase".into()
    }

    fn json(self) -> Result<serde_json::Value, Fault> {
        self.shape.to_json(crate::geometry::call::ARCHIVE)
    }

    /// Its number stays with the object that it was: a copy gets one of its own.
    fn value(self) -> Result<Value, Fault> {
        Ok(Value::Geometry(Self { id: 0, ..self }))
    }
}
