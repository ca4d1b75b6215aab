//! A definition of the book, run by the engine.

use std::collections::BTreeMap;
use std::time::Duration;

use katydid_definition::document::special::Rounding;
use katydid_definition::document::{Branch, Document, Object, Persistent, Special, Stored};
use katydid_definition::kd;
use katydid_geometry::Point3;
use katydid_session::{Items, Registry, Session};
use katydid_solver::Options;
use serde_json::Value as Json;

/// A figure answers at once: what takes longer is no figure.
const LONGEST: Duration = Duration::from_secs(20);

/// A definition with its results.
pub(crate) struct Solved {
    pub(crate) session: Session,
    /// The place of each output by `object` and `object.port`, the first of that name.
    places: BTreeMap<String, (usize, usize)>,
    outputs: Vec<Vec<(Vec<Json>, bool)>>,
    /// Warnings and errors of objects.
    pub(crate) messages: Vec<String>,
}

/// A value that is put into a definition.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Given {
    pub(crate) name: String,
    /// Which of several points.
    pub(crate) index: Option<usize>,
    pub(crate) value: String,
}

/// A slider as a reader sees it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Slider {
    pub(crate) value: f64,
    pub(crate) min: f64,
    pub(crate) max: f64,
    pub(crate) step: f64,
}

impl Solved {
    /// Reads and runs a definition, with values put in first.
    pub(crate) fn run(text: &str, given: &[Given]) -> Result<Self, String> {
        let definition = kd::read(text, &Registry).map_err(|problems| problems.to_string())?;
        let mut document = definition.document;
        for one in given {
            one.put_into(&mut document)?;
        }
        let mut options = Options::default();
        options.rules.units = definition.units.unwrap_or(options.rules.units);
        options.limits.time = Some(LONGEST);
        let mut session = Session::new(document, options);
        session.solve();
        let (places, outputs, messages) = results(&session);
        Ok(Self { session, places, outputs, messages })
    }

    /// The place of an object.
    pub(crate) fn object(&self, name: &str) -> Option<usize> {
        self.session.document().objects.iter().position(|object| object.nickname == name)
    }

    /// The place of an output: of `object` its first, or `object.port`.
    pub(crate) fn output(&self, name: &str) -> Result<(usize, usize), String> {
        self.places.get(name).copied().ok_or_else(|| {
            let near = self.places.keys().find(|known| known.eq_ignore_ascii_case(name));
            let hint = near.map(|near| format!(": did you mean '{near}'?")).unwrap_or_default();
            format!("the definition has no output '{name}'{hint}")
        })
    }

    /// The items of an output, all branches in a row, and whether they are vectors.
    pub(crate) fn items(&self, (object, port): (usize, usize)) -> (&[Json], bool) {
        let found = self.outputs.get(object).and_then(|ports| ports.get(port));
        found.map_or((&[], false), |(items, is_vector)| (items, *is_vector))
    }

    /// A slider by its nickname.
    pub(crate) fn slider(&self, name: &str) -> Option<Slider> {
        let object = self.session.document().objects.get(self.object(name)?)?;
        let Some(Special::Slider(slider)) = object.special() else { return None };
        let step = match slider.rounding {
            Rounding::Real => 10.0_f64.powi(-i32::try_from(slider.digits.min(12)).unwrap_or(2)),
            Rounding::Integer => 1.0,
            Rounding::Even | Rounding::Odd => 2.0,
        };
        let (min, max) = (slider.min.min(slider.max), slider.min.max(slider.max));
        Some(Slider { value: slider.value, min, max, step })
    }

    /// Whether an object is a toggle.
    pub(crate) fn is_toggle(&self, name: &str) -> bool {
        let object = self.object(name).and_then(|index| self.session.document().objects.get(index));
        object.is_some_and(|object| matches!(object.special(), Some(Special::Toggle(_))))
    }

    /// Whether an object is a toggle that is on.
    pub(crate) fn is_on(&self, name: &str) -> bool {
        let object = self.object(name).and_then(|index| self.session.document().objects.get(index));
        object.is_some_and(|object| matches!(object.special(), Some(Special::Toggle(true))))
    }

    /// Why a point cannot be dragged; nothing where it can.
    pub(crate) fn why_not_dragged(&self, name: &str) -> Option<String> {
        let document = self.session.document();
        let Some(object) = self.object(name).and_then(|index| document.objects.get(index)) else {
            return Some(format!("the definition has no object '{name}'"));
        };
        let lookup = document.lookup();
        let is_slider = |id: &uuid::Uuid| {
            let source = lookup.output(*id).and_then(|at| document.objects.get(at.object));
            source.is_some_and(|source| matches!(source.special(), Some(Special::Slider(_))))
        };
        let is_free = |object: &Object| {
            object.inputs.iter().all(|port| match port.sources.as_slice() {
                [] => true,
                [one] => is_slider(one),
                _ => false,
            })
        };
        match object.name.as_str() {
            "Construct Point" if is_free(object) => None,
            "Point" if object.inputs.iter().all(|port| port.sources.is_empty()) => None,
            _ => Some(format!("'{name}' is no point that can be dragged")),
        }
    }
}

type Results = (BTreeMap<String, (usize, usize)>, Vec<Vec<(Vec<Json>, bool)>>, Vec<String>);

fn results(session: &Session) -> Results {
    let values = session.report_with(Items::Values);
    let (mut places, mut outputs, mut messages) = (BTreeMap::new(), Vec::new(), Vec::new());
    for (index, object) in values.objects.into_iter().enumerate() {
        messages
            .extend(object.messages.iter().map(|message| format!("{}: {}", object.nickname, message.text)));
        let mut ports = Vec::new();
        for (k, port) in object.outputs.into_iter().enumerate() {
            if !object.nickname.is_empty() {
                let names = [Some(port.nickname), Some(port.name)].into_iter().flatten();
                let full = names.map(|port| format!("{}.{port}", object.nickname));
                for name in full.chain((k == 0).then(|| object.nickname.clone())) {
                    places.entry(name).or_insert((index, k));
                }
            }
            let items: Vec<Json> = port.branches.into_iter().flat_map(|branch| branch.items).collect();
            ports.push((items, port.kind == "Vector"));
        }
        outputs.push(ports);
    }
    (places, outputs, messages)
}

impl Given {
    /// Reads `name = value` or `name[1] = value`.
    pub(crate) fn read(text: &str) -> Result<Self, String> {
        let (name, value) = text.split_once('=').ok_or_else(|| format!("'{text}' is not `name = value`"))?;
        let (name, value) = (name.trim(), value.trim().replace('−', "-"));
        let (name, index) = match name.strip_suffix(']').and_then(|rest| rest.rsplit_once('[')) {
            Some((name, index)) => {
                let index = index.parse().map_err(|_| format!("[{index}] is no index"))?;
                (name.trim(), Some(index))
            }
            None => (name, None),
        };
        Ok(Self { name: name.to_owned(), index, value })
    }

    fn put_into(&self, document: &mut Document) -> Result<(), String> {
        let name = &self.name;
        let place = document.objects.iter().position(|object| object.nickname == *name);
        let place = place.ok_or_else(|| format!("the definition has no object '{name}'"))?;
        let point = point(&self.value);
        // A point made of coordinates: each goes where its coordinate comes from.
        if let (Some(point), Some("Construct Point")) =
            (point, document.objects.get(place).map(|object| object.name.as_str()))
        {
            return coordinates(document, place, point);
        }
        let Some(object) = document.objects.get_mut(place) else { return Ok(()) };
        match (point, self.index) {
            (Some(point), Some(index)) => {
                let mut stored = object.inputs.first().and_then(|port| object.persistent(port));
                let item = stored
                    .as_mut()
                    .and_then(|stored| stored.branches.iter_mut().flat_map(|b| &mut b.items).nth(index));
                *item.ok_or_else(|| format!("'{name}' has no point [{index}]"))? = Stored::Point(point);
                object.set_persistent(0, stored.as_ref()).map_err(|error| error.to_string())
            }
            (Some(point), None) => {
                let branches = vec![Branch { path: vec![0], items: vec![Stored::Point(point)] }];
                object.set_persistent(0, Some(&Persistent { branches })).map_err(|error| error.to_string())
            }
            _ => katydid_session::assign_input(object, &self.value).map_err(|error| error.to_string()),
        }
    }
}

/// Puts coordinates into a Construct Point: into the sliders that its inputs read, else into the inputs.
fn coordinates(document: &mut Document, place: usize, point: Point3) -> Result<(), String> {
    for (k, x) in [point.x, point.y, point.z].into_iter().enumerate() {
        let lookup = document.lookup();
        let Some(port) = document.objects.get(place).and_then(|object| object.inputs.get(k)) else {
            continue;
        };
        let source = port.sources.first().and_then(|id| lookup.output(*id)).map(|at| at.object);
        let told = |error: &dyn std::fmt::Display| error.to_string();
        match source.and_then(|source| document.objects.get_mut(source)) {
            Some(slider) => {
                katydid_session::assign_input(slider, &x.to_string()).map_err(|error| told(&error))?;
            }
            None => {
                let Some(object) = document.objects.get_mut(place) else { continue };
                let branches = vec![Branch { path: vec![0], items: vec![Stored::Number(x)] }];
                object.set_persistent(k, Some(&Persistent { branches })).map_err(|error| told(&error))?;
            }
        }
    }
    Ok(())
}

/// `(1, 2, 0)` as a point.
pub(crate) fn point(text: &str) -> Option<Point3> {
    let inner = text.trim().strip_prefix('(')?.strip_suffix(')')?;
    let numbers: Vec<f64> =
        inner.split(',').map(|x| x.trim().replace('−', "-").parse().ok()).collect::<Option<_>>()?;
    match numbers.as_slice() {
        [x, y] => Some(Point3::new(*x, *y, 0.0)),
        [x, y, z] => Some(Point3::new(*x, *y, *z)),
        _ => None,
    }
    .filter(|p| p.x.is_finite() && p.y.is_finite() && p.z.is_finite())
}
