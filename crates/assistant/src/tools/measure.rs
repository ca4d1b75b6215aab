//! What a shape measures.

use katydid_data::cast::{self, Rules};
use katydid_data::{Kind, Value as Item};
use katydid_geometry::{BoundingBox, Point3};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Value, json};

use super::{Does, Entry, Reply, entry, values};
use crate::fault::Fault;
use crate::store::Store;
use crate::thresholds::{LONGEST_WORK, MEASURED_TO, MOST_MEASURED, MOST_ROWS};
use crate::work;

pub(super) fn entries() -> Vec<Entry> {
    vec![entry(
        "measure",
        "Measure",
        "Measures the data of an output after the last solve: how many of each type, the box around all of it, lengths of \
         curves, areas, volumes of what is closed, vertices and faces; of numbers the smallest, largest, sum and mean. In the \
         document's units. With `each` also item by item.",
        Does::Reads,
        measure,
    )]
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Measure {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// The output, as read_values takes it.
    port: String,
    /// Whether the input of that name is measured.
    #[serde(default)]
    input: bool,
    /// Whether each item is told of, the first 2000 at most.
    #[serde(default)]
    each: bool,
}

/// What all items come to.
#[derive(Default)]
struct Sums {
    nulls: usize,
    kinds: std::collections::BTreeMap<&'static str, usize>,
    bounds: Option<BoundingBox>,
    length: Option<f64>,
    area: Option<f64>,
    volume: Option<f64>,
    solids: usize,
    closed: usize,
    open: usize,
    vertices: usize,
    faces: usize,
    numbers: Vec<f64>,
    without: usize,
}

fn add(sum: &mut Option<f64>, more: f64) {
    *sum = Some(sum.unwrap_or(0.0) + more);
}

fn measure(store: &Store, given: Measure) -> Result<Reply, Fault> {
    const WHAT: &str = "nothing was measured";
    let opened = store.find(WHAT, given.document.as_deref())?;
    let (solved, name, tree) = values::data(&opened, WHAT, &given.port, given.input)?;
    let rules = solved.engine.options().rules;
    let count = tree.item_count();
    if count > MOST_MEASURED {
        let why = format!("it has {count} items, {MOST_MEASURED} are measured at most");
        return Err(Fault::new(WHAT, name, why));
    }
    let end = std::time::Instant::now() + LONGEST_WORK;
    let (mut sums, mut each) = (Sums::default(), Vec::new());
    work::within(WHAT, || {
        for branch in tree.branches() {
            for item in branch.iter() {
                let told = match item.as_ref() {
                    Some(item) => of_item(item, &rules, &mut sums, &|| std::time::Instant::now() < end),
                    None => {
                        sums.nulls += 1;
                        json!({ "type": null })
                    }
                };
                if given.each && each.len() < MOST_ROWS {
                    each.push(told);
                }
            }
        }
    })?;
    let mut told = sums.told();
    told["document"] = json!(opened.id);
    told["port"] = json!(name);
    told["items"] = json!(count);
    told["branch_count"] = json!(tree.branch_count());
    told["units"] = json!(rules.units.name());
    told["results"] = opened.standing();
    if given.each {
        told["each"] = json!(each);
    }
    Ok(told.into())
}

fn point(p: Point3) -> Value {
    json!([p.x, p.y, p.z])
}

/// Measures one item, and adds it to the sums.
fn of_item(item: &Item, rules: &Rules, sums: &mut Sums, go_on: &impl Fn() -> bool) -> Value {
    let kind = item.kind().name();
    *sums.kinds.entry(kind).or_default() += 1;
    let mut told = json!({ "type": kind });
    if let Item::Number(x) = item {
        sums.numbers.push(*x);
        told["value"] = json!(x);
        return told;
    }
    if let Item::Integer(n) = item {
        sums.numbers.push(f64::from(*n));
        told["value"] = json!(n);
        return told;
    }
    if let Some(bounds) = bounds(item, rules) {
        told["box"] = json!({ "min": point(bounds.min), "max": point(bounds.max) });
        sums.bounds = Some(sums.bounds.map_or(bounds, |all| all.union(&bounds)));
    }
    let area = match item {
        Item::Mesh(mesh) => {
            let closed = mesh.is_closed();
            sums.count(closed);
            (sums.vertices, sums.faces) =
                (sums.vertices + mesh.vertices().len(), sums.faces + mesh.faces().len());
            told["closed"] = json!(closed);
            told["vertices"] = json!(mesh.vertices().len());
            told["faces"] = json!(mesh.faces().len());
            if closed && let Ok(volume) = mesh.volume_properties() {
                sums.put_volume(volume.amount, volume.centroid, &mut told);
            }
            mesh.area_properties().ok()
        }
        Item::Kept(_) | Item::Brep(_) | Item::Surface(_) | Item::Box(_) => {
            let Some(Ok(brep)) = item.brep() else {
                sums.without += 1;
                return told;
            };
            let solid = brep.is_solid();
            sums.count(solid);
            sums.faces += brep.faces().len();
            told["closed"] = json!(solid);
            told["faces"] = json!(brep.faces().len());
            if solid && let Ok(volume) = brep.volume_properties(MEASURED_TO, go_on) {
                sums.put_volume(volume.amount, volume.centroid, &mut told);
            }
            brep.area_properties(MEASURED_TO, go_on).ok()
        }
        other => match cast::value(other, Kind::Curve, rules) {
            Some(Item::Curve(curve)) => {
                let length = curve.length();
                let closed = curve.is_closed();
                add(&mut sums.length, length);
                told["length"] = json!(length);
                told["closed"] = json!(closed);
                if closed { curve.area_properties(rules.tolerance.absolute).ok() } else { None }
            }
            _ => None,
        },
    };
    if let Some(area) = area {
        add(&mut sums.area, area.amount);
        told["area"] = json!(area.amount);
        told["centroid_of_area"] = point(area.centroid);
    }
    told
}

/// The box round a shape, tight where the kernel has that.
fn bounds(item: &Item, rules: &Rules) -> Option<BoundingBox> {
    let is_place =
        matches!(item.kind(), Kind::Text | Kind::Colour | Kind::Boolean | Kind::Domain | Kind::Path);
    if is_place {
        return None;
    }
    if let Item::Curve(curve) = item {
        return Some(curve.bounding_box());
    }
    match cast::value(item, Kind::Box, rules) {
        Some(Item::Box(found)) => Some(found.bounding_box()),
        _ => None,
    }
}

impl Sums {
    fn count(&mut self, closed: bool) {
        match closed {
            true => self.closed += 1,
            false => self.open += 1,
        }
    }

    fn put_volume(&mut self, amount: f64, centroid: Point3, told: &mut Value) {
        self.solids += 1;
        add(&mut self.volume, amount);
        told["volume"] = json!(amount);
        told["centroid"] = point(centroid);
    }

    fn told(&self) -> Value {
        let mut told = json!({ "types": self.kinds });
        let mut put = |key: &str, value: Value| told[key] = value;
        if self.nulls > 0 {
            put("nulls", json!(self.nulls));
        }
        if let Some(bounds) = &self.bounds {
            let size = bounds.max - bounds.min;
            put(
                "box",
                json!({ "min": point(bounds.min), "max": point(bounds.max), "size": [size.x, size.y, size.z] }),
            );
        }
        for (key, sum) in [("length", self.length), ("area", self.area), ("volume", self.volume)] {
            if let Some(sum) = sum {
                put(key, json!(sum));
            }
        }
        for (key, count) in [
            ("closed", self.closed),
            ("open", self.open),
            ("with_volume", self.solids),
            ("vertices", self.vertices),
            ("faces", self.faces),
            ("not_measured", self.without),
        ] {
            if count > 0 {
                put(key, json!(count));
            }
        }
        let finite: Vec<f64> = self.numbers.iter().copied().filter(|x| x.is_finite()).collect();
        if !self.numbers.is_empty() {
            let sum: f64 = finite.iter().sum();
            #[allow(clippy::cast_precision_loss, reason = "no more than the limit of items")]
            let mean = sum / finite.len() as f64;
            let least = finite.iter().copied().reduce(f64::min);
            let most = finite.iter().copied().reduce(f64::max);
            put(
                "numbers",
                json!({ "count": self.numbers.len(), "not_finite": self.numbers.len() - finite.len(),
                                   "min": least, "max": most, "sum": sum, "mean": mean }),
            );
        }
        told
    }
}
