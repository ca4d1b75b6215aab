//! The body of a request, read as it comes: what is too much is noticed before it is kept.

use std::cell::{Cell, RefCell};
use std::fmt;

use katydid_data::Path;
use serde::de::{DeserializeSeed, Deserializer, Error as _, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::Value as Json;

use super::{InputTree, RequestLimits, SolveRequest, path, scalar};
use crate::{Cause, Fault};

/// Reads a body.
pub(super) fn read(body: &[u8], limits: &RequestLimits) -> Result<SolveRequest, Fault> {
    if body.len() > limits.bytes {
        return Err(Fault::too_large(format!("The body has more than {} bytes", limits.bytes)));
    }
    let body = body.strip_prefix(b"\xef\xbb\xbf").unwrap_or(body);
    let reading = Reading { limits, items: Cell::new(0), branches: Cell::new(0), fault: RefCell::new(None) };
    let mut json = serde_json::Deserializer::from_slice(body);
    let request = Body(&reading).deserialize(&mut json).and_then(|request| json.end().map(|()| request));
    request.map_err(|error| {
        // What a part says of itself goes before the place where reading stopped.
        reading
            .fault
            .take()
            .unwrap_or_else(|| Fault::bad_request(format!("The body cannot be read: {error}")))
    })
}

/// What has been read so far, against what may be.
struct Reading<'a> {
    limits: &'a RequestLimits,
    items: Cell<usize>,
    branches: Cell<usize>,
    fault: RefCell<Option<Fault>>,
}

impl Reading<'_> {
    /// Stops the reading with a fault.
    fn stop<E: serde::de::Error>(&self, fault: Fault) -> E {
        let error = E::custom(&fault.message);
        self.fault.replace(Some(fault));
        error
    }

    fn count<E: serde::de::Error>(&self, count: &Cell<usize>, most: usize, what: &str) -> Result<(), E> {
        count.set(count.get() + 1);
        if count.get() > most {
            return Err(self.stop(Fault::too_large(format!("The values have more than {most} {what}"))));
        }
        Ok(())
    }
}

/// Makes a seed of a visitor: each part of the body is read with the count at hand.
macro_rules! seed {
    ($name:ident, $value:ty) => {
        impl<'de> DeserializeSeed<'de> for $name<'_> {
            type Value = $value;

            fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<$value, D::Error> {
                from.deserialize_any(self)
            }
        }
    };
}

/// The request: an object, or a list with one.
struct Body<'a>(&'a Reading<'a>);
seed!(Body, SolveRequest);

impl<'de> Visitor<'de> for Body<'_> {
    type Value = SolveRequest;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object with the definition and its values")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<SolveRequest, A::Error> {
        let Some(first) = list.next_element_seed(Body(self.0))? else {
            return Err(A::Error::custom("the list is empty"));
        };
        while list.next_element::<IgnoredAny>()?.is_some() {}
        Ok(first)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<SolveRequest, A::Error> {
        let mut request = SolveRequest::default();
        let reading = self.0;
        while let Some(key) = map.next_key::<String>()? {
            let key = key.to_ascii_lowercase();
            if key == "values" {
                request.values = map.next_value_seed(Trees(reading))?;
                continue;
            }
            if !SCALARS.contains(&key.as_str()) {
                map.next_value::<IgnoredAny>()?;
                continue;
            }
            let value = map.next_value::<Json>()?;
            if let Err(why) = set(&mut request, &key, &value) {
                return Err(reading.stop(Fault::new(Cause::BadRequest, format!("{key} {why}"))));
            }
        }
        Ok(request)
    }
}

/// The members besides the values, in lower case.
const SCALARS: [&str; 10] = [
    "absolutetolerance",
    "angletolerance",
    "modelunits",
    "model",
    "dataversion",
    "algo",
    "pointer",
    "cachesolve",
    "alltypes",
    "recursionlevel",
];

fn set(request: &mut SolveRequest, key: &str, value: &Json) -> Result<(), String> {
    match key {
        "absolutetolerance" => request.absolute_tolerance = scalar::tolerance(value)?,
        "angletolerance" => request.angle_tolerance = scalar::tolerance(value)?,
        "modelunits" => request.units = scalar::unit(value)?,
        "dataversion" => request.data_version = scalar::whole(value)?.unwrap_or(request.data_version),
        "model" => request.model = scalar::text(value)?,
        "algo" => request.algo = scalar::text(value)?,
        "pointer" => request.pointer = scalar::text(value)?,
        "cachesolve" => request.cache_solve = scalar::flag(value)?,
        "alltypes" => request.all_types = scalar::flag(value)?,
        _ => {
            let level = scalar::whole(value)?.unwrap_or(0);
            request.recursion_level = u32::try_from(level).map_err(|_| "is below 0".to_owned())?;
        }
    }
    Ok(())
}

/// The values: a list of trees.
struct Trees<'a>(&'a Reading<'a>);
seed!(Trees, Vec<InputTree>);

impl<'de> Visitor<'de> for Trees<'_> {
    type Value = Vec<InputTree>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of values, each with ParamName and InnerTree")
    }

    fn visit_unit<E>(self) -> Result<Self::Value, E> {
        Ok(Vec::new())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let mut trees = Vec::new();
        while let Some(tree) = list.next_element_seed(OneTree(self.0))? {
            self.0.count(&self.0.branches, self.0.limits.branches, "branches")?;
            trees.extend(tree);
        }
        Ok(trees)
    }
}

/// The value of one input.
struct OneTree<'a>(&'a Reading<'a>);
seed!(OneTree, Option<InputTree>);

impl<'de> Visitor<'de> for OneTree<'_> {
    type Value = Option<InputTree>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object with ParamName and InnerTree")
    }

    fn visit_unit<E>(self) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let (mut name, mut branches) = (None, Vec::new());
        while let Some(key) = map.next_key::<String>()? {
            match key.to_ascii_lowercase().as_str() {
                "paramname" => {
                    let value = map.next_value::<Json>()?;
                    name = scalar::text(&value)
                        .map_err(|why| self.0.stop(Fault::bad_request(format!("ParamName {why}"))))?;
                }
                "innertree" => branches = map.next_value_seed(Branches(self.0))?,
                _ => {
                    map.next_value::<IgnoredAny>()?;
                }
            }
        }
        let name = name.ok_or_else(|| self.0.stop(Fault::bad_request("A value has no ParamName")))?;
        Ok(Some(InputTree { name, branches }))
    }
}

/// Branches by path.
struct Branches<'a>(&'a Reading<'a>);
seed!(Branches, Vec<(Path, Vec<Json>)>);

impl<'de> Visitor<'de> for Branches<'_> {
    type Value = Vec<(Path, Vec<Json>)>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object with a list for each path")
    }

    fn visit_unit<E>(self) -> Result<Self::Value, E> {
        Ok(Vec::new())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let mut branches = Vec::new();
        while let Some(key) = map.next_key::<String>()? {
            let path = path::parse(&key).map_err(|why| self.0.stop(Fault::bad_request(why)))?;
            self.0.count(&self.0.branches, self.0.limits.branches, "branches")?;
            branches.push((path, map.next_value_seed(Items(self.0))?));
        }
        Ok(branches)
    }
}

/// The items of a branch.
struct Items<'a>(&'a Reading<'a>);
seed!(Items, Vec<Json>);

impl<'de> Visitor<'de> for Items<'_> {
    type Value = Vec<Json>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of items, each an object with data")
    }

    fn visit_unit<E>(self) -> Result<Self::Value, E> {
        Ok(Vec::new())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let mut items = Vec::new();
        while let Some(item) = list.next_element_seed(OneItem)? {
            self.0.count(&self.0.items, self.0.limits.items, "items")?;
            items.push(item);
        }
        Ok(items)
    }
}

/// The data of an item; what type it says it has does not count. An item that is no object is its data.
struct OneItem;

impl<'de> DeserializeSeed<'de> for OneItem {
    type Value = Json;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Json, D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for OneItem {
    type Value = Json;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object with data")
    }

    fn visit_unit<E>(self) -> Result<Json, E> {
        Ok(Json::Null)
    }

    fn visit_bool<E>(self, flag: bool) -> Result<Json, E> {
        Ok(Json::Bool(flag))
    }

    fn visit_i64<E>(self, whole: i64) -> Result<Json, E> {
        Ok(Json::from(whole))
    }

    fn visit_u64<E>(self, whole: u64) -> Result<Json, E> {
        Ok(Json::from(whole))
    }

    fn visit_f64<E>(self, number: f64) -> Result<Json, E> {
        Ok(Json::from(number))
    }

    fn visit_str<E>(self, text: &str) -> Result<Json, E> {
        Ok(Json::from(text))
    }

    fn visit_string<E>(self, text: String) -> Result<Json, E> {
        Ok(Json::String(text))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Json, A::Error> {
        let mut items = Vec::new();
        while let Some(item) = list.next_element::<Json>()? {
            items.push(item);
        }
        Ok(Json::Array(items))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Json, A::Error> {
        let mut data = Json::Null;
        while let Some(key) = map.next_key::<String>()? {
            if key.eq_ignore_ascii_case("data") {
                data = map.next_value()?;
            } else {
                map.next_value::<IgnoredAny>()?;
            }
        }
        Ok(data)
    }
}
