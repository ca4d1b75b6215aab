//! LunchBox Util and Data: lists split by chance, points found by their places, and tables as text.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Tree, TreeBuilder, Value};
use katydid_geometry::Point3;
use katydid_geometry::cloud::PointTree;

use crate::kept::{keep, kept};
use crate::tables::{Cell, Table};

/// Numbers by chance, the same for the same seed on every machine: SplitMix64 (G. Steele and others, *Fast splittable pseudorandom
/// number generators*, 2014).
#[derive(Debug, Clone)]
pub(super) struct Chance(u64);

impl Chance {
    pub(super) fn new(seed: i32) -> Self {
        Self(u64::from(seed.cast_unsigned()).wrapping_mul(0x9E37_79B9_7F4A_7C15))
    }

    /// The next number from 0 to 1, below 1.
    pub(super) fn draw(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Splits a list by chance into two. Stands for LunchBox's Random Split List; the chance is our own, so that other items are taken
/// for the same seed, and that a part of the list goes into the first is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c6e",
    name = "Random Split List",
    nick = "RandomSplit",
    at = "LunchBox/Util"
)]
#[output("List A", "A", "The items that were taken, in the order of the list.")]
#[output("List B", "B", "The others, in the order of the list.")]
fn random_split(
    context: &Context<'_>,
    /// The list.
    #[port("Master List", "L")]
    list: List<Value>,
    /// The seed.
    #[port("Seed", "R", default = 1)]
    seed: i32,
    /// How much of the list is taken, from 0 to 1; rounded to whole items.
    #[port("Split", "S", default = 0.5)]
    part: f64,
) -> Result<(Vec<Option<Value>>, Vec<Option<Value>>), Message> {
    if !(0.0..=1.0).contains(&part) {
        return Err(Message::error(format!("The split is {part}: it must be from 0 to 1")));
    }
    context.items(list.len())?;
    context.tell(Message::remark("The choice is Katydid's own: LunchBox takes others for the same seed"));
    let mut chance = Chance::new(seed);
    // Of the items left so many are still to be taken (algorithm S in D. Knuth, The Art of Computer Programming 2, 3.4.2).
    let mut wanted = (part * list.len() as f64).round();
    let (mut taken, mut others) = (Vec::new(), Vec::new());
    for (k, item) in list.iter().enumerate() {
        let left = (list.len() - k) as f64;
        if left * chance.draw() < wanted {
            wanted -= 1.0;
            taken.push(item);
        } else {
            others.push(item);
        }
    }
    Ok((taken, others))
}

/// Points with a tree over them to find those near a place.
struct Found {
    tree: PointTree,
    points: Vec<Point3>,
}

/// Points in a tree, in which those near a place are found soon. Stands for LunchBox's Create RTree; of a mesh it holds the
/// vertices.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c81",
    name = "Create RTree",
    nick = "RTree",
    at = "LunchBox/Util"
)]
#[output("RTree", "RTree", "The tree, for RTree Closest Point and RTree Points in Range.")]
fn create_rtree(
    context: &Context<'_>,
    /// Points, or meshes.
    #[port("Input geometry", "Geo")]
    geometry: List<Value>,
) -> Result<Value, Message> {
    let mut points = Vec::new();
    for item in geometry.present() {
        match item {
            Value::Point(p) => points.push(p),
            Value::Mesh(mesh) => points.extend(mesh.vertices()),
            other => match katydid_data::cast::value(&other, katydid_data::Kind::Point, context.rules()) {
                Some(Value::Point(p)) => points.push(p),
                _ => return Err(Message::error("A tree is made of points or meshes")),
            },
        }
    }
    if points.is_empty() {
        return Err(Message::error("There are no points"));
    }
    context.bytes(points.len().saturating_mul(100))?;
    let text = format!("RTree ({} points)", points.len());
    Ok(keep(text, Found { tree: PointTree::new(&points)?, points }))
}

/// # Errors
/// The item is no tree.
fn tree_of(value: &Value) -> Result<&Found, Message> {
    kept(value).ok_or_else(|| Message::error("The tree is not one of Create RTree"))
}

/// The point of a tree that is nearest to a place. Stands for LunchBox's RTree Closest Point.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c82",
    name = "RTree Closest Point",
    nick = "RTree CP",
    at = "LunchBox/Util"
)]
#[output("Closest Point", "CPoint", "The point.")]
#[output("Closest Index", "Index", "Its number in the tree; of equally near ones the first.")]
fn rtree_closest(
    /// The place.
    #[port("Search Points", "SPoints")]
    place: Point3,
    /// The tree.
    #[port("RTree", "RTree")]
    tree: Value,
) -> Result<(Point3, i32), Message> {
    let found = tree_of(&tree)?;
    if !place.is_finite() {
        return Err(Message::error("The place is not finite"));
    }
    let number = found.tree.closest(place);
    let point = number.and_then(|k| found.points.get(k).copied());
    let none = || Message::error("The tree has no points");
    let number = number.and_then(|k| i32::try_from(k).ok()).ok_or_else(none)?;
    Ok((point.ok_or_else(none)?, number))
}

/// The points of a tree within a distance of a place. Stands for LunchBox's RTree Points in Range; that nearer ones come first is
/// our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c83",
    name = "RTree Points in Range",
    nick = "RTree Range",
    at = "LunchBox/Util"
)]
#[output("Points within Range", "RPoints", "The points, from the nearest on.")]
#[output("Indices within Range", "Indices", "Their numbers in the tree.")]
fn rtree_range(
    context: &Context<'_>,
    /// The place.
    #[port("Search Points", "SPoints")]
    place: Point3,
    /// The distance, in units.
    #[port("Search Distance", "Distance", default = 1.0)]
    distance: f64,
    /// The tree.
    #[port("RTree", "RTree")]
    tree: Value,
) -> Result<(Vec<Point3>, Vec<i32>), Message> {
    if !(distance >= 0.0) || !place.is_finite() {
        return Err(Message::error("The distance is negative, or the place or the distance not finite"));
    }
    let found = tree_of(&tree)?;
    context.items(found.points.len())?;
    let mut near: Vec<(f64, usize)> = (found.points.iter().enumerate())
        .map(|(k, p)| (p.distance_to(place), k))
        .filter(|(d, _)| *d <= distance)
        .collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let points = near.iter().filter_map(|(_, k)| found.points.get(*k).copied()).collect();
    Ok((points, near.iter().map(|(_, k)| i32::try_from(*k).unwrap_or(i32::MAX)).collect()))
}

/// The sign between cells: one byte, since that is what the format knows.
///
/// # Errors
/// The text is not one sign of ASCII.
fn sign(text: &str) -> Result<u8, Message> {
    match *text.as_bytes() {
        [sign] if sign.is_ascii() && !matches!(sign, b'"' | b'\n' | b'\r') => Ok(sign),
        _ => Err(Message::error("The delimiter is one sign, such as a comma, a semicolon or a tab")),
    }
}

/// Makes a text of comma-separated values from columns. Stands for LunchBox's Create CSV. A cell with the delimiter, quotes or a
/// line break in it stands in quotes (RFC 4180).
#[component("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c91", name = "Create CSV", nick = "CSV", at = "LunchBox/Data")]
#[output("CSV String", "CSV", "The text.", kind = Text)]
fn create_csv(
    context: &Context<'_>,
    /// The headings of the columns.
    #[port("Data Grid Headers", "Headers", kind = Text, optional)]
    headers: &Tree,
    /// A branch for each column.
    #[port("Value Tree", "Values", kind = Text)]
    values: &Tree,
    /// What stands between cells.
    #[port("Delimiter", "Delimit", kind = Text, optional)]
    delimiter: &Tree,
) -> Result<Tree, Message> {
    let delimiter = match delimiter.column().get(0) {
        Some(Value::Text(text)) => sign(&text)?,
        _ => b',',
    };
    let mut table = Table::from_columns(context, values);
    if !headers.is_empty() {
        let row = (0..headers.item_count()).map(|k| Cell::of(headers.column().get(k).as_ref(), context));
        table.rows.insert(0, row.collect());
    }
    let mut writer = csv::WriterBuilder::new().delimiter(delimiter).flexible(true).from_writer(Vec::new());
    let failed = |error: &dyn std::fmt::Display| Message::error(format!("The text cannot be made: {error}"));
    for row in &table.rows {
        let texts: Vec<Shared<str>> = row.iter().map(|cell| cell.text(context)).collect();
        writer.write_record(texts.iter().map(|text| text.as_bytes())).map_err(|error| failed(&error))?;
    }
    let bytes = writer.into_inner().map_err(|error| failed(&error.error()))?;
    context.bytes(bytes.len())?;
    Ok(Tree::item(Value::text(String::from_utf8_lossy(&bytes).trim_end_matches('\n'))))
}

/// Reads a text of comma-separated values into columns. Stands for LunchBox's Read CSV; that the first line holds the headings, and
/// values stay texts, is our reading.
#[component("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c92", name = "Read CSV", nick = "CSV", at = "LunchBox/Data")]
#[output("Headers", "Headers", "The headings of the columns.")]
#[output("Values", "Values", "A branch for each column; cells that are not there are null.", kind = Text)]
fn read_csv(
    context: &Context<'_>,
    /// The text.
    #[port("CSV String", "CSV")]
    text: Shared<str>,
    /// What stands between cells.
    #[port("Delimiter", "Delimit", default = ",")]
    delimiter: Shared<str>,
) -> Result<(Vec<Value>, Tree), Message> {
    context.bytes(text.len().saturating_mul(20))?;
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(sign(&delimiter)?)
        .flexible(true)
        .has_headers(false)
        .from_reader(text.as_bytes());
    let mut rows: Vec<csv::StringRecord> = Vec::new();
    for record in reader.records() {
        context.check()?;
        rows.push(record.map_err(|error| Message::error(format!("The text cannot be read: {error}")))?);
    }
    let width = rows.iter().map(csv::StringRecord::len).max().unwrap_or(0);
    context.items(width.saturating_mul(rows.len()))?;
    let mut rows = rows.iter();
    let headers = rows.next().map(|row| row.iter().map(Value::text).collect()).unwrap_or_default();
    let mut values = TreeBuilder::<Value>::new();
    for column in 0..width {
        values.branch(context.path().child(column));
        rows.clone().for_each(|row| values.push(row.get(column).map(Value::text)));
    }
    Ok((headers, values.finish()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::Point3;

    #[test]
    fn a_list_is_split_once() {
        let of = |seed: i32, part: f64| {
            let out = Trial::of("Random Split List").list(0..100).item(seed).item(part).run().outputs;
            [0, 1].map(|k| katydid_component::testing::texts(&out[k]).concat())
        };
        for (part, taken) in [(0.0, 0), (0.3, 30), (1.0, 100)] {
            let [a, b] = of(7, part);
            let numbers = |text: &str| -> Vec<i32> {
                let list = text.split_once(": ").map_or("", |(_, list)| list);
                list.split(", ").filter_map(|n| n.parse().ok()).collect()
            };
            let (a, b) = (numbers(&a), numbers(&b));
            assert_eq!(a.len(), taken);
            assert!(a.is_sorted() && b.is_sorted());
            let mut all = [a, b].concat();
            all.sort_unstable();
            assert_eq!(all, (0..100).collect::<Vec<i32>>());
        }
        assert_eq!(of(7, 0.5), of(7, 0.5));
        assert_ne!(of(7, 0.5), of(8, 0.5));
        assert!(
            Trial::of("Random Split List")
                .list(0..3)
                .item(1)
                .item(f64::NAN)
                .message()
                .contains("from 0 to 1")
        );
    }

    #[test]
    fn points_near_places() {
        let points: Vec<Point3> = (0..50).map(|k| Point3::new(f64::from(k), 0.0, 0.0)).collect();
        let tree = || Trial::of("Create RTree").list(points.clone()).run().outputs[0].clone();
        let closest = Trial::of("RTree Closest Point").item(Point3::new(7.4, 3.0, 0.0)).tree(tree());
        assert_eq!(closest.texts(1), ["{0}: 7"]);
        let range =
            Trial::of("RTree Points in Range").item(Point3::new(7.4, 0.0, 0.0)).item(1.5).tree(tree());
        assert_eq!(range.texts(1), ["{0;0}: 7, 8, 6"]);
        assert_eq!(Trial::of("Create RTree").list(points.clone()).texts(0), ["{0}: RTree (50 points)"]);
        let wrong = Trial::of("RTree Closest Point").item(Point3::ORIGIN).item(3.0);
        assert!(wrong.message().contains("Create RTree"));
        assert!(Trial::of("Create RTree").list(["oak"]).message().contains("points or meshes"));
    }

    #[test]
    fn tables_there_and_back() {
        let table = || {
            Trial::of("Create CSV")
                .list(["tree", "note"])
                .branches([("{0}", ["oak", "elm"]), ("{1}", ["high, wide", "says \"no\""])])
        };
        let text = "tree,note\noak,\"high, wide\"\nelm,\"says \"\"no\"\"\"";
        assert_eq!(table().run().outputs[0].column().get(0), Some(katydid_data::Value::text(text)));
        let read = |k: usize| Trial::of("Read CSV").item(text).texts(k);
        assert_eq!(read(0), ["{0;0}: tree, note"]);
        assert_eq!(read(1), ["{0;0}: oak, elm", "{0;1}: high, wide, says \"no\""]);
        assert_eq!(Trial::of("Read CSV").item("a;b\n1;2").item(";").texts(1), ["{0;0}: 1", "{0;1}: 2"]);
        assert!(Trial::of("Read CSV").item("a").item("::").message().contains("one sign"));
    }
}
