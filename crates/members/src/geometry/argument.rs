//! What functions take: numbers with their bounds, lists, what may be missing.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use katydid_component::{Account, Cancel, Limits};
use katydid_geometry::{CancellationToken, Tolerance};
use serde_json::Value as Json;
use web_time::Instant;

use super::call::Call;
use crate::wire::{Read, Script, Wire};
use crate::{Cause, Fault, Record, Value};

/// One parameter of a function.
pub(super) trait Argument: Sized {
    /// Takes the next argument of a call, or what else of it the parameter stands for.
    fn take(call: &mut Call<'_>) -> Result<Self, Fault>;

    /// What signatures call the types of what callers send for it.
    fn type_names() -> Vec<String>;
}

impl<T: Read> Argument for T {
    fn take(call: &mut Call<'_>) -> Result<Self, Fault> {
        call.next()
    }

    fn type_names() -> Vec<String> {
        vec![T::type_name()]
    }
}

/// Whether whoever asked still waits, and until when.
#[derive(Clone)]
pub struct Waiting {
    cancel: Cancel,
    end: Option<Instant>,
    account: Arc<Account>,
    /// Whether there was no memory: what was given up for that may have been given back since.
    refused: Arc<AtomicBool>,
}

impl katydid_geometry::Waiting for Waiting {
    fn go_on(&self) -> bool {
        self.check().is_ok()
    }

    fn has_room(&self, bytes: u64) -> bool {
        self.account.settle();
        let has_room = self.account.without_room(bytes).is_none();
        self.refused.fetch_or(!has_room, Ordering::Relaxed);
        has_room
    }

    fn begin(&self) {
        self.account.begin();
    }

    fn end(&self) {
        self.account.end();
    }
}

impl Waiting {
    /// From now on, for as long as the bounds allow.
    pub fn new(limits: &Limits, memory: Option<&Arc<Account>>, cancel: &Cancel) -> Self {
        let end = limits.time.and_then(|time| Instant::now().checked_add(time));
        let most = limits.solve_bytes;
        let account = match memory {
            Some(whole) => Account::part_of(whole.clone(), most),
            None => Account::new(most),
        };
        Self { cancel: cancel.clone(), end, account: Arc::new(account), refused: Arc::default() }
    }

    /// Whether to go on.
    pub(super) fn go_on(&self) -> bool {
        self.check().is_ok()
    }

    /// The same for what the kernel does on this thread.
    pub(super) fn token(&self) -> CancellationToken {
        CancellationToken::of(Arc::new(self.clone()))
    }

    /// Stops here when nobody waits any more: between the parts of work that may be long.
    pub(super) fn check(&self) -> Result<(), Fault> {
        if self.cancel.is_cancelled() {
            return Err(Fault::new(Cause::Cancelled, "it was cancelled"));
        }
        if self.end.is_some_and(|end| Instant::now() >= end) {
            return Err(Fault::new(Cause::TimedOut, "the time limit is over"));
        }
        if katydid_geometry::Waiting::has_room(self, 0) && !self.refused.load(Ordering::Relaxed) {
            return Ok(());
        }
        Err(match self.account.was_refused() {
            true => Fault::busy(),
            false => Fault::too_large(format!("it takes more than {} bytes", self.account.limit())),
        })
    }
}

impl Argument for Waiting {
    fn take(call: &mut Call<'_>) -> Result<Self, Fault> {
        Ok(call.waiting().clone())
    }

    fn type_names() -> Vec<String> {
        Vec::new()
    }
}

/// The most members of a list.
const MOST: usize = 1_000_000;

impl<T: Read> Read for Vec<T> {
    /// A list; a single value counts as a list of one, as some clients send it.
    fn read(json: &Json) -> Result<Self, Fault> {
        match &*crate::wire::unwrapped(json) {
            Json::Array(items) => {
                if items.len() > MOST {
                    return Err(Fault::too_large(format!("has {} items, more than {MOST}", items.len())));
                }
                // A point may be a list of its own.
                let several = |(i, item)| {
                    T::read(item).map_err(|f| Fault { message: format!("item {i} {}", f.message), ..f })
                };
                let read: Result<Self, Fault> = items.iter().enumerate().map(several).collect();
                read.or_else(|fault| match T::read(json) {
                    Ok(single) if !items.is_empty() => Ok(vec![single]),
                    _ => Err(fault),
                })
            }
            Json::Null => Err(Fault::bad_request("is missing")),
            other => T::read(other).map(|single| vec![single]),
        }
    }

    /// A list; a single value is none, so that overloads are told apart.
    fn of_value(value: &Value) -> Result<Self, Fault> {
        let items = value.items().ok_or_else(|| match value {
            Value::Null => Fault::bad_request("is missing"),
            other => Fault::bad_request(format!("is {}, not a list", other.noun())),
        })?;
        if items.len() > MOST {
            return Err(Fault::too_large(format!("has {} items, more than {MOST}", items.len())));
        }
        let several = |(i, item)| {
            T::of_value(item).map_err(|f| Fault { message: format!("item {i} {}", f.message), ..f })
        };
        items.iter().enumerate().map(several).collect()
    }

    fn type_name() -> String {
        format!("{}[]", T::type_name())
    }
}

impl<T: Read> Read for Option<T> {
    fn read(json: &Json) -> Result<Self, Fault> {
        if json.is_null() { Ok(None) } else { T::read(json).map(Some) }
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        if *value == Value::Null { Ok(None) } else { T::of_value(value).map(Some) }
    }

    fn type_name() -> String {
        T::type_name()
    }
}

/// A list that is not empty.
pub(super) struct Some1<T>(pub(super) Vec<T>);

impl<T: Read> Read for Some1<T> {
    fn read(json: &Json) -> Result<Self, Fault> {
        let items = Vec::read(json)?;
        Self::filled(items)
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        Vec::of_value(value).and_then(Self::filled)
    }

    fn type_name() -> String {
        Vec::<T>::type_name()
    }
}

impl<T> Some1<T> {
    fn filled(items: Vec<T>) -> Result<Self, Fault> {
        if items.is_empty() { Err(Fault::bad_request("is an empty list")) } else { Ok(Self(items)) }
    }
}

/// A size: finite and above 0.
#[derive(Clone, Copy)]
pub(super) struct Positive(pub(super) f64);

impl Read for Positive {
    fn read(json: &Json) -> Result<Self, Fault> {
        let x = f64::read(json)?;
        if x > 0.0 { Ok(Self(x)) } else { Err(Fault::bad_request(format!("is {x}, not above 0"))) }
    }

    fn type_name() -> String {
        "Double".into()
    }
}

/// A distance tolerance; 0, which Rhino takes for its document's, is 0.001.
#[derive(Clone, Copy)]
pub(super) struct Within(pub(super) f64);

/// The largest tolerance: beyond it nothing can be told apart.
const COARSEST: f64 = 1e6;

impl Read for Within {
    fn read(json: &Json) -> Result<Self, Fault> {
        let x = f64::read(json)?;
        if !(0.0..=COARSEST).contains(&x) {
            return Err(Fault::bad_request(format!("is {x}, which is no tolerance: 0 to {COARSEST}")));
        }
        Ok(Self(if x > 0.0 { x.max(1e-12) } else { Tolerance::default().absolute }))
    }

    fn type_name() -> String {
        "Double".into()
    }
}

impl Within {
    /// With the angle that Rhino's documents have.
    pub(super) fn tolerance(self) -> Tolerance {
        Tolerance { absolute: self.0, ..Tolerance::default() }
    }
}

/// An angle tolerance in radians; 0, which Rhino takes for its document's, is 1°.
#[derive(Clone, Copy)]
pub(super) struct Turn(pub(super) f64);

impl Read for Turn {
    fn read(json: &Json) -> Result<Self, Fault> {
        let x = f64::read(json)?;
        if !(0.0..=std::f64::consts::TAU).contains(&x) {
            return Err(Fault::bad_request(format!("is {x}, which is no angle in radians")));
        }
        Ok(Self(if x > 0.0 { x } else { Tolerance::default().angle }))
    }

    fn type_name() -> String {
        "Double".into()
    }
}

impl Turn {
    /// Together with a distance.
    pub(super) fn and(self, distance: Within) -> Tolerance {
        Tolerance { absolute: distance.0, angle: self.0 }
    }
}

/// A count from `LEAST` to `MOST`.
#[derive(Clone, Copy)]
pub(super) struct Count<const LEAST: usize, const MOST: usize>(pub(super) usize);

impl<const LEAST: usize, const MOST: usize> Read for Count<LEAST, MOST> {
    fn read(json: &Json) -> Result<Self, Fault> {
        let count = i32::read(json)?;
        match usize::try_from(count) {
            Ok(count) if (LEAST..=MOST).contains(&count) => Ok(Self(count)),
            _ => Err(Fault::bad_request(format!("is {count}, not {LEAST} to {MOST}"))),
        }
    }

    fn type_name() -> String {
        "Int32".into()
    }
}

/// A choice that .NET has as an enumeration: its number, or its name in any case.
pub(super) fn choice<T: Copy>(json: &Json, what: &str, choices: &[(&str, T)]) -> Result<T, Fault> {
    let found = match json {
        Json::String(name) => choices.iter().find(|(own, _)| own.eq_ignore_ascii_case(name.trim())),
        number => usize::try_from(i32::read(number)?).ok().and_then(|place| choices.get(place)),
    };
    let names = || choices.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ");
    found.map(|(_, value)| *value).ok_or_else(|| {
        Fault::bad_request(format!("is no {what}: 0 to {}, for {}", choices.len().saturating_sub(1), names()))
    })
}

/// A point on a mesh: a face and how much each of its corners takes part.
pub(super) struct OnMesh {
    /// The face.
    pub(super) face: usize,
    /// The shares of its corners.
    pub(super) shares: [f64; 4],
}

impl Script for OnMesh {
    /// A record of the same members.
    fn from_script(_: &Value) -> Option<Result<Self, Fault>> {
        None
    }

    fn into_script(self) -> Result<Value, Fault> {
        let face = i64::try_from(self.face).map_or(Value::Null, Value::Int);
        let fields = vec![("FaceIndex", face), ("T", Value::Numbers(self.shares.to_vec()))];
        Ok(Record::value("MeshPoint", fields))
    }
}

impl Wire for OnMesh {
    const TYPE: &'static str = "Rhino.Geometry.MeshPoint";
    const NAME: &'static str = "a mesh point";

    fn from_json(json: &Json) -> Result<Self, Fault> {
        let members = crate::wire::Members::of(json)?;
        let Count(face): Count<0, { i32::MAX as usize }> = members.read("FaceIndex")?;
        let given: Vec<f64> = members.read("T")?;
        let mut shares = [0.0; 4];
        if !(3..=4).contains(&given.len()) {
            return Err(Fault::bad_request(format!("its T has {} numbers, not 4", given.len())));
        }
        shares.iter_mut().zip(given).for_each(|(share, x)| *share = x);
        Ok(Self { face, shares })
    }

    fn to_json(&self, _: i32) -> Result<Json, Fault> {
        Ok(serde_json::json!({ "FaceIndex": self.face, "T": self.shares }))
    }
}
