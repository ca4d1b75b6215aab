//! What a C# script is run for: the members of the table, and the limits of the solve.

use std::sync::{Arc, LazyLock, Mutex, PoisonError};

use katydid_component::{Cancel, Limits};
use katydid_csharp::vm::heap::Obj;
use katydid_csharp::vm::value::Value as Net;
use katydid_csharp::{Cx, Host, Raise, Stop};
use katydid_data::cast::Rules;
use katydid_geometry::CancellationToken;
use katydid_members::geometry::{Waiting, change_in_place, changes_in_place, endpoints};
use katydid_members::{Cause, Fault, Geometry, Value};
use web_time::Instant;

use super::breps::{self, Extracted};
use super::convert::{from_csharp, to_csharp};
use super::{declare, enums};

/// The declarations, which all scripts share.
pub(super) static DECLARATIONS: LazyLock<String> =
    LazyLock::new(|| declare::declarations(&endpoints().members()));

/// What the members of the table are called, each once, in order.
static NAMES: LazyLock<Vec<String>> = LazyLock::new(|| {
    let signatures = endpoints().members();
    let names = signatures.iter().filter_map(|text| Some(text.split_once('(')?.0.to_owned()));
    let records = RECORDS
        .iter()
        .flat_map(|(class, fields)| fields.iter().map(move |field| format!("{class}.get_{field}")));
    let mut names: Vec<String> = names.chain(records).chain(breps::MEMBERS.map(str::to_owned)).collect();
    names.sort();
    names.dedup();
    names
});

/// Properties that no member of the table is: of the document, and of results of named values.
const RECORDS: [(&str, &[&str]); 7] = [
    (
        "RhinoDoc",
        &["ModelAbsoluteTolerance", "ModelAngleToleranceRadians", "ModelAngleToleranceDegrees", "UnitNumber"],
    ),
    ("ControlPoint", &["Location", "Weight", "X", "Y", "Z"]),
    ("PointCloudItem", &["Location", "X", "Y", "Z", "Normal", "Color", "PointValue", "Hidden", "Index"]),
    ("BrepLoop", &["LoopIndex", "Face", "To3dCurve"]),
    ("BrepTrim", &["Brep", "TrimIndex", "Edge", "Face", "Loop", "Domain", "PointAtStart", "PointAtEnd"]),
    ("BrepVertex", &["VertexIndex", "Location", "EdgeIndices"]),
    (
        "SurfaceCurvature",
        &["UVPoint", "Point", "Normal", "Gaussian", "Mean", "Kappa1", "Kappa2", "Direction1", "Direction2"],
    ),
];

/// What a script's run may use, and what it printed: shared by its host and by whoever runs it.
#[derive(Debug, Default)]
pub(super) struct Turn {
    pub(super) limits: Limits,
    pub(super) cancel: Cancel,
    pub(super) end: Option<Instant>,
    /// Units and tolerances.
    pub(super) rules: Rules,
    pub(super) printed: String,
}

impl Turn {
    fn is_over(&self) -> bool {
        self.cancel.is_cancelled()
            || CancellationToken::is_over()
            || self.end.is_some_and(|end| Instant::now() >= end)
    }
}

/// The host of one script.
pub(super) struct ScriptHost {
    pub(super) turn: Arc<Mutex<Turn>>,
    /// Breps that faces were taken out of.
    extracted: Extracted,
}

impl ScriptHost {
    pub(super) fn new(turn: Arc<Mutex<Turn>>) -> Self {
        Self { turn, extracted: Extracted::default() }
    }

    /// What the document says of units and tolerances; none for another member.
    fn document(&self, name: &str) -> Option<Net> {
        let turn = self.turn();
        let tolerance = turn.rules.tolerance;
        Some(match name.strip_prefix("RhinoDoc.get_")? {
            "ModelAbsoluteTolerance" => Net::F64(tolerance.absolute),
            "ModelAngleToleranceRadians" => Net::F64(tolerance.angle),
            "ModelAngleToleranceDegrees" => Net::F64(tolerance.angle.to_degrees()),
            _ => Net::I32(enums::number("UnitSystem", &format!("{:?}", turn.rules.units)).unwrap_or(0)),
        })
    }

    fn turn(&self) -> std::sync::MutexGuard<'_, Turn> {
        self.turn.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Host for ScriptHost {
    fn declarations(&self) -> &str {
        &DECLARATIONS
    }

    fn member(&self, key: &str) -> Option<u32> {
        let name = key.split_once('(')?.0.replacen("raw_", "", 1);
        u32::try_from(NAMES.binary_search(&name).ok()?).ok()
    }

    fn call(&mut self, member: u32, cx: &mut Cx<'_>) -> Result<Net, Raise> {
        let missing = || Raise::Stop(Stop::NotSupported("This member".to_owned()));
        let name = NAMES.get(member as usize).ok_or_else(missing)?;
        if let Some(value) = self.document(name) {
            return Ok(value);
        }
        if let Some(given) = in_place(name, cx) {
            return Ok(given);
        }
        let waiting = {
            let turn = self.turn();
            let left = turn.end.map(|end| end.saturating_duration_since(Instant::now()));
            Waiting::new(&Limits { time: left, ..turn.limits }, None, &turn.cancel)
        };
        let first = usize::from(name.ends_with(".new"));
        let (mut arguments, mut outs) = (Vec::new(), Vec::new());
        for place in first..cx.len() {
            if cx.is_reference(place) {
                outs.push(place);
                continue;
            }
            let refused = |what| Raise::new("ArgumentException", format!("{name} does not take {what}"));
            arguments.push(from_csharp(cx, cx.arg(place)).map_err(refused)?);
        }
        let (value, changed) = match breps::call(name, &arguments, &mut self.extracted) {
            Some(given) => given.map_err(raised)?,
            None => {
                let reply = endpoints().call_member(name, &arguments, &waiting).map_err(raised)?;
                (reply.value, reply.changed)
            }
        };
        if let Some(changed) = changed {
            let object = owner(cx, cx.arg(0));
            if let Some(own) = cx.host_data_mut::<Geometry>(object) {
                own.become_changed(changed);
            }
        }
        give(name, value, &outs, cx)
    }

    fn write(&mut self, text: &str) {
        self.turn().printed.push_str(text);
    }

    fn cancelled(&mut self) -> bool {
        self.turn().is_over()
    }
}

/// A member that changes one part of a large object, done in the object: nobody else sees it change, and a loop of them
/// costs no copy for each.
fn in_place(name: &str, cx: &mut Cx<'_>) -> Option<Net> {
    if !changes_in_place(name) {
        return None;
    }
    let mut arguments = Vec::new();
    for place in 1..cx.len() {
        let value = cx.arg(place);
        arguments.push(from_csharp(cx, value).ok()?);
    }
    let object = owner(cx, cx.arg(0));
    let given = change_in_place(name, &mut cx.host_data_mut::<Geometry>(object)?.shape, &arguments)?;
    to_csharp(cx, &given)
}

/// The object that changes: that of a list, for the list.
fn owner(cx: &Cx<'_>, object: Net) -> Net {
    match object {
        Net::Ref(handle) if matches!(cx.st.heap.get(handle), Obj::Inst(..)) => cx.field(object, 0),
        object => object,
    }
}

/// The result of a member as the program has it; what stands behind it goes to the `out` parameters.
fn give(name: &str, value: Value, outs: &[usize], cx: &mut Cx<'_>) -> Result<Net, Raise> {
    let (value, rest) = match value.items() {
        Some(items) if !outs.is_empty() => {
            let mut items = items.into_iter();
            (items.next().unwrap_or(Value::Null), items.collect())
        }
        _ => (value, Vec::new()),
    };
    let refused =
        |value: &Value| Raise::Stop(Stop::NotSupported(format!("{} as the result of {name}", value.noun())));
    for (place, value) in outs.iter().zip(rest) {
        let made = to_csharp(cx, &value).ok_or_else(|| refused(&value))?;
        // What was not found leaves the variable as it began: a struct is no reference that may be null.
        if made != Net::Null || !matches!(cx.read(*place), Net::Ref(_)) {
            cx.set(*place, made);
        }
    }
    to_csharp(cx, &value).ok_or_else(|| refused(&value))
}

fn raised(fault: Fault) -> Raise {
    match fault.cause {
        Cause::Cancelled | Cause::TimedOut => Raise::Stop(Stop::Cancelled),
        Cause::NotSupported(name) => Raise::Stop(Stop::NotSupported(name)),
        Cause::BadRequest => Raise::new("ArgumentException", fault.message),
        _ => Raise::new("InvalidOperationException", fault.message),
    }
}
