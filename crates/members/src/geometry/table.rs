//! The table of paths.

use std::collections::HashMap;
use std::sync::LazyLock;

use serde_json::{Map, Value as Json};
use web_time::Instant;

use super::argument::Waiting;
use super::call::{Arguments, Call, CallReply, Given};
use super::function::{Entry, Function};
use super::query::Query;
use crate::{Cause, Fault};

/// All functions that have a path, one a line: the class and the member as RhinoCommon spells them, the types of the
/// overload, and the names of the arguments that callers send. `&this` is an object that the function changes. A path is the
/// first word in small letters.
const SIGNATURES: &str = include_str!("signatures.txt");

/// One overload of a member.
pub(super) struct Row {
    /// What servers call it by; empty for a member that only scripts call.
    pub(super) path: String,
    /// `Class.Member`, as RhinoCommon spells it.
    pub(super) member: String,
    /// The names of the arguments, as callers send them.
    pub(super) names: Vec<&'static str>,
    /// Whether the last result is what the object becomes.
    pub(super) changes: bool,
    pub(super) entry: Option<Entry>,
    /// The type of what it gives.
    pub(super) gives: String,
    /// The types of what it takes.
    pub(super) takes: Vec<String>,
}

impl Row {
    /// The row of a line of signatures: the name, and the arguments.
    fn of(path: String, member: String, words: impl Iterator<Item = &'static str>) -> Self {
        let words: Vec<&'static str> = words.collect();
        let changes = words.first() == Some(&"&this");
        let names = words.into_iter().map(|name| name.trim_start_matches('&')).collect();
        Self { path, member, names, changes, entry: None, gives: String::new(), takes: Vec::new() }
    }
}

/// `Class.Member` of a spelled path.
fn member(spelled: &str) -> String {
    let name = spelled.split_once('-').map_or(spelled, |(name, _)| name);
    let mut parts = name.rsplit('/');
    let (member, class) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
    format!("{class}.{member}")
}

/// The functions that can be called by path.
pub struct Endpoints {
    pub(super) rows: Vec<Row>,
    by_path: HashMap<String, usize>,
    /// Overloads by what they have in common: the path up to its types.
    overloads: HashMap<String, Vec<usize>>,
    /// Overloads by member.
    pub(super) members: HashMap<String, Vec<usize>>,
    /// Paths that functions were entered for and `signatures.txt` has not got: none.
    strangers: Vec<String>,
}

impl std::fmt::Debug for Endpoints {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Endpoints({} of {} answer)", self.answered().count(), self.rows.len())
    }
}

/// The table that all calls share.
pub(super) fn endpoints() -> &'static Endpoints {
    static TABLE: LazyLock<Endpoints> = LazyLock::new(Endpoints::new);
    &TABLE
}

/// The path without the types of an overload.
fn base(path: &str) -> &str {
    path.split_once('-').map_or(path, |(base, _)| base)
}

impl Endpoints {
    fn new() -> Self {
        let mut table = Self {
            rows: Vec::new(),
            by_path: HashMap::new(),
            overloads: HashMap::new(),
            members: HashMap::new(),
            strangers: Vec::new(),
        };
        for line in SIGNATURES.lines() {
            let mut words = line.split_ascii_whitespace();
            let Some(spelled) = words.next() else { continue };
            let (path, place) = (spelled.to_ascii_lowercase(), table.rows.len());
            table.by_path.insert(path.clone(), place);
            table.overloads.entry(base(&path).to_owned()).or_default().push(place);
            table.enlist(Row::of(path, member(spelled), words));
        }
        super::brep::enter(&mut table);
        super::brep_boolean::enter(&mut table);
        super::brep_cut::enter(&mut table);
        super::brep_face::enter(&mut table);
        super::brep_make::enter(&mut table);
        super::brep_mend::enter(&mut table);
        super::brep_sweep::enter(&mut table);
        super::class::enter(&mut table);
        super::curve::enter(&mut table);
        super::curve_edit::enter(&mut table);
        super::curve_ends::enter(&mut table);
        super::curve_length::enter(&mut table);
        super::curve_local::enter(&mut table);
        super::curve_make::enter(&mut table);
        super::curve_onto::enter(&mut table);
        super::curve_region::enter(&mut table);
        super::geometry_base::enter(&mut table);
        super::intersection::enter(&mut table);
        super::intersection_mesh::enter(&mut table);
        super::intersection_ray::enter(&mut table);
        super::mass::enter(&mut table);
        super::mesh::enter(&mut table);
        super::mesh_edit::enter(&mut table);
        super::mesh_make::enter(&mut table);
        super::mesh_mend::enter(&mut table);
        super::mesh_pieces::enter(&mut table);
        super::mesh_round::enter(&mut table);
        super::nurbs_curve::enter(&mut table);
        super::nurbs_edit::enter(&mut table);
        super::nurbs_surface::enter(&mut table);
        super::smoothing::enter(&mut table);
        super::subd::enter(&mut table);
        super::surface::enter(&mut table);
        super::surface_curve::enter(&mut table);
        super::surface_edit::enter(&mut table);
        table
    }

    fn enlist(&mut self, row: Row) {
        self.members.entry(row.member.clone()).or_default().push(self.rows.len());
        self.rows.push(row);
    }

    /// Enters what a path does.
    pub(super) fn add<A>(&mut self, path: &str, function: impl Function<A>) {
        match self.by_path.get(path).and_then(|&place| self.rows.get_mut(place)) {
            Some(row) => {
                row.gives = function.gives();
                row.takes = function.takes();
                row.entry = Some(function.entry());
            }
            None => self.strangers.push(path.to_owned()),
        }
    }

    /// Enters a member that no path has, by `Class.Member` and the names of its arguments; `this` is the object that it
    /// belongs to, `&this` one that it changes: then the last result is what the object becomes.
    pub(super) fn member<A>(&mut self, signature: &'static str, function: impl Function<A>) {
        let mut words = signature.split_ascii_whitespace();
        let name = words.next().unwrap_or_default().to_owned();
        let row = Row::of(String::new(), name, words);
        let (gives, takes) = (function.gives(), function.takes());
        self.enlist(Row { gives, takes, entry: Some(function.entry()), ..row });
    }

    /// The names of a path's arguments, in the order in which callers send them; `None` for a path that is not one of
    /// [`paths`](Self::paths).
    pub fn parameters(&self, path: &str) -> Option<&[&'static str]> {
        let row = self.by_path.get(path).and_then(|&place| self.rows.get(place))?;
        Some(&row.names)
    }

    /// All paths, in order, without the part before the class.
    pub fn paths(&self) -> impl Iterator<Item = &str> + '_ {
        self.rows.iter().map(|row| row.path.as_str()).filter(|path| !path.is_empty())
    }

    /// The paths that answer, in order.
    pub fn answered(&self) -> impl Iterator<Item = &str> + '_ {
        let answered = self.rows.iter().filter(|row| row.entry.is_some());
        answered.map(|row| row.path.as_str()).filter(|path| !path.is_empty())
    }

    /// The rows that a path means: one overload, or all of a method.
    pub(super) fn rows_of(&self, path: &str) -> Result<Vec<&Row>, Fault> {
        let lower = path.to_ascii_lowercase();
        let short = lower.trim_matches('/');
        let short = short.strip_prefix("rhino/").unwrap_or(short);
        let short = short.strip_prefix("geometry/").unwrap_or(short);
        if let Some(row) = self.by_path.get(short).and_then(|&place| self.rows.get(place)) {
            return Ok(vec![row]);
        }
        let all = self.overloads.get(short).into_iter().flatten().filter_map(|&place| self.rows.get(place));
        let rows: Vec<&Row> = all.collect();
        if rows.is_empty() {
            Err(Fault::not_found(format!("there is no function {short}")))
        } else {
            Ok(rows)
        }
    }

    /// Calls the function of a path with the arguments of a body: JSON, a list of arguments, or with
    /// [`Query::multiple`] a list of such lists. A path without types means the overload that the arguments fit.
    ///
    /// # Errors
    /// No such function, arguments that it does not take, what it says of them, or a limit.
    pub fn call(
        &self,
        path: &str,
        query: &Query,
        body: &[u8],
        waiting: &Waiting,
    ) -> Result<CallReply, Fault> {
        let started = Instant::now();
        let rows = self.rows_of(path)?;
        let arguments = arguments(body)?;
        let seconds = || Ok(CallReply { json: Some(crate::wire::number(started.elapsed().as_secs_f64())) });
        if query.stop_at == Some(1) {
            return seconds();
        }
        let one = |arguments: &[Json]| {
            waiting.check()?;
            fitting(&rows, Arguments::Json(arguments), waiting).and_then(|fit| match fit.given {
                Given::Json(json) => wanted(fit.row, json, query),
                Given::Value(_) => Err(Fault::failed("a value where JSON was asked for")),
            })
        };
        let json = if query.multiple {
            let several = |(i, arguments): (usize, &Json)| {
                let list =
                    arguments.as_array().ok_or_else(|| Fault::bad_request("is not a list of arguments"));
                list.and_then(|list| one(list)).map_err(|fault| Fault {
                    message: format!("call {i}: {}", fault.message),
                    cause: fault.cause,
                })
            };
            Json::Array(arguments.iter().enumerate().map(several).collect::<Result<_, _>>()?)
        } else {
            one(&arguments)?
        };
        if query.stop_at.is_some() { seconds() } else { Ok(CallReply { json: Some(json) }) }
    }
}

/// The list that a body is.
fn arguments(body: &[u8]) -> Result<Vec<Json>, Fault> {
    let body = body.strip_prefix(b"\xef\xbb\xbf").unwrap_or(body);
    if body.iter().all(u8::is_ascii_whitespace) {
        return Ok(Vec::new());
    }
    match serde_json::from_slice(body) {
        Ok(Json::Array(arguments)) => Ok(arguments),
        Ok(_) => Err(Fault::bad_request("the body is not a list of arguments")),
        Err(error) => Err(Fault::bad_request(format!("the body is not JSON: {error}"))),
    }
}

/// What an overload made of arguments that fit it.
pub(super) struct Fit<'a> {
    pub(super) row: &'a Row,
    pub(super) given: Given,
}

/// What a row gives for arguments, and whether a fault is theirs.
fn run<'a>(row: &'a Row, arguments: Arguments<'_>, waiting: &Waiting) -> Result<Fit<'a>, (Fault, bool)> {
    let name = if row.path.is_empty() { &row.member } else { &row.path };
    let Some(entry) = &row.entry else { return Err((Fault::not_supported(name), true)) };
    let mut call = Call::new(arguments, &row.names, waiting);
    let outcome = waiting.token().during(|| entry(&mut call));
    // What was given up on the way is no result, and no fault of the arguments.
    let outcome = waiting.check().and(outcome);
    outcome.map(|given| Fit { row, given }).map_err(|fault| {
        let fault = match fault.cause {
            Cause::NotSupported(what) if what != *name => Fault::not_supported(format!("{name}: {what}")),
            cause => Fault { cause, message: fault.message },
        };
        let is_theirs =
            !call.ready && !matches!(fault.cause, Cause::Busy | Cause::Cancelled | Cause::TimedOut);
        (fault, is_theirs)
    })
}

/// The first overload that the arguments fit, with what it gives: those with just as many parameters come first.
pub(super) fn fitting<'a>(
    rows: &[&'a Row],
    arguments: Arguments<'_>,
    waiting: &Waiting,
) -> Result<Fit<'a>, Fault> {
    let mut ordered: Vec<&Row> = rows.to_vec();
    ordered.sort_by_key(|row| (row.entry.is_none(), row.names.len().abs_diff(arguments.len())));
    let mut first = None;
    for row in ordered {
        match run(row, arguments, waiting) {
            Ok(fit) => return Ok(fit),
            Err((fault, true)) => first = first.or(Some(fault)),
            Err((fault, false)) => return Err(fault),
        }
    }
    Err(first.unwrap_or_else(|| Fault::not_found("there is no such function")))
}

/// The members that the query wants of a result.
fn wanted(row: &Row, json: Json, query: &Query) -> Result<Json, Fault> {
    let own = row.gives.to_ascii_lowercase();
    let asked = query.wanted.iter().find(|(name, _)| own.contains(name.as_str()));
    match asked {
        Some((_, members)) => picked(json, members),
        None => Ok(json),
    }
}

fn picked(json: Json, members: &[String]) -> Result<Json, Fault> {
    match json {
        Json::Array(items) => {
            items.into_iter().map(|item| picked(item, members)).collect::<Result<_, _>>().map(Json::Array)
        }
        Json::Object(map) => {
            if map.contains_key("archive3dm") {
                return Err(Fault::not_supported(format!("return of {}", members.join(","))));
            }
            let one = |name: &String| {
                let found = map.iter().find(|(key, _)| key.eq_ignore_ascii_case(name));
                found
                    .map(|(key, value)| (key.clone(), value.clone()))
                    .ok_or_else(|| Fault::bad_request(format!("the result has no {name}")))
            };
            members.iter().map(one).collect::<Result<Map<_, _>, _>>().map(Json::Object)
        }
        other => Ok(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_function_has_a_path_and_every_path_a_class() {
        let table = endpoints();
        assert_eq!(table.strangers, Vec::<String>::new());
        assert_eq!(table.paths().count(), table.by_path.len(), "a path stands twice");
        assert!(table.paths().all(|path| path.contains('/')));
    }
}
