use katydid_data::{Item, Value, text};
use katydid_definition::document::ObjectKind;
use katydid_solver::{Engine, Status, Summary};
use serde::Serialize;
use uuid::Uuid;

/// The form that items have in a report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Items {
    /// The text a panel shows.
    #[default]
    Texts,
    /// Numbers in full precision, structures as JSON.
    Values,
}

/// The results of a solve, as `katydid run --json` prints them.
#[derive(Debug, Clone, Serialize)]
pub struct Report {
    /// The version of Katydid.
    pub katydid: &'static str,
    /// The file, where there is one.
    pub file: String,
    /// The document's units.
    pub units: &'static str,
    /// How long the solve took.
    pub milliseconds: f64,
    /// The objects, in the order of the file.
    pub objects: Vec<ObjectEntry>,
}

/// One object of a report.
#[derive(Debug, Clone, Serialize)]
pub struct ObjectEntry {
    pub id: Uuid,
    pub component: Uuid,
    pub name: String,
    pub nickname: String,
    pub kind: &'static str,
    pub status: &'static str,
    pub messages: Vec<MessageEntry>,
    pub milliseconds: f64,
    pub outputs: Vec<OutputEntry>,
}

/// One message of an object.
#[derive(Debug, Clone, Serialize)]
pub struct MessageEntry {
    pub level: String,
    pub text: String,
}

/// One output of an object.
#[derive(Debug, Clone, Serialize)]
pub struct OutputEntry {
    pub name: String,
    pub nickname: String,
    #[serde(rename = "type")]
    pub kind: &'static str,
    pub branches: Vec<BranchEntry>,
}

/// One branch of an output.
#[derive(Debug, Clone, Serialize)]
pub struct BranchEntry {
    pub path: String,
    pub items: Vec<serde_json::Value>,
}

impl Report {
    pub(crate) fn new(engine: &Engine, summary: Summary, items: Items) -> Self {
        let rules = engine.options().rules;
        let style = text::Style { units: rules.units, tolerance: rules.tolerance };
        let objects = engine.document().objects.iter().enumerate().map(|(index, object)| {
            let report = engine.report(index);
            let component = katydid_component::registry::by_guid(object.component);
            let outputs = object.outputs.iter().enumerate().map(|(k, port)| {
                let tree = report.and_then(|r| r.outputs.get(k));
                let declared = component.and_then(|c| c.output(k)).map(|p| p.kind);
                let branches = tree.into_iter().flat_map(|tree| tree.branches()).map(|branch| BranchEntry {
                    path: branch.path().to_string(),
                    items: branch.iter().map(|item| entry(item.as_ref(), items, &style)).collect(),
                });
                let held = tree.map(|t| t.column().kind()).filter(|k| *k != Value::KIND);
                let kind = declared.filter(|k| *k != Value::KIND).or(held).unwrap_or(Value::KIND);
                OutputEntry {
                    name: port.name.clone(),
                    nickname: port.nickname.clone(),
                    kind: kind.name(),
                    branches: branches.collect(),
                }
            });
            let messages = report.map_or(&[][..], |r| r.messages.as_slice()).iter();
            ObjectEntry {
                id: object.id,
                component: object.component,
                name: object.name.clone(),
                nickname: object.nickname.clone(),
                kind: match object.kind {
                    ObjectKind::Component => "component",
                    ObjectKind::Parameter => "parameter",
                    ObjectKind::Annotation(_) => "annotation",
                },
                status: report.map_or(Status::NoData, |r| r.status).word(),
                messages: messages
                    .map(|m| MessageEntry { level: m.level.to_string(), text: m.text.clone() })
                    .collect(),
                milliseconds: milliseconds(report.map_or(0.0, |r| r.time.as_secs_f64())),
                outputs: outputs.collect(),
            }
        });
        Self {
            katydid: env!("CARGO_PKG_VERSION"),
            file: String::new(),
            units: rules.units.name(),
            milliseconds: milliseconds(summary.time.as_secs_f64()),
            objects: objects.collect(),
        }
    }
}

/// Seconds as milliseconds, to the microsecond.
fn milliseconds(seconds: f64) -> f64 {
    (seconds * 1e6).round() / 1e3
}

fn entry(item: Option<&Value>, items: Items, style: &text::Style) -> serde_json::Value {
    match (items, item) {
        (Items::Texts, item) => text::item(item, style).into(),
        (Items::Values, None) => serde_json::Value::Null,
        (Items::Values, Some(value)) => structured(value, style),
    }
}

/// A value in full precision. Types without a form of their own are given by their text.
fn structured(value: &Value, style: &text::Style) -> serde_json::Value {
    use serde_json::json;
    let point = |p: katydid_geometry::Point3| json!([p.x, p.y, p.z]);
    let vector = |v: katydid_geometry::Vector3| json!([v.x, v.y, v.z]);
    let plane = |p: &katydid_geometry::Plane| json!({"origin": point(p.origin), "x": vector(p.x_axis), "y": vector(p.y_axis)});
    let range = |d: katydid_geometry::Interval| json!([d.start, d.end]);
    match value {
        Value::Boolean(b) => json!(b),
        Value::Integer(i) => json!(i),
        // JSON has no NaN and no infinity: those stay texts.
        Value::Number(x) if x.is_finite() => json!(x),
        Value::Text(text) => json!(**text),
        Value::Point(p) => point(*p),
        Value::Vector(v) => vector(*v),
        Value::Plane(p) => plane(p),
        Value::Line(l) => json!({"from": point(l.from), "to": point(l.to)}),
        Value::Circle(c) => json!({"plane": plane(&c.plane), "radius": c.radius}),
        Value::Arc(a) => {
            json!({"plane": plane(&a.circle.plane), "radius": a.circle.radius, "angle": range(a.angle)})
        }
        Value::Rectangle(r) => json!({"plane": plane(&r.plane), "x": range(r.x), "y": range(r.y)}),
        Value::Box(b) => json!({"plane": plane(&b.plane), "x": range(b.x), "y": range(b.y), "z": range(b.z)}),
        Value::TwistedBox(b) => b.corners.iter().map(|p| point(*p)).collect(),
        Value::Domain(d) => range(*d),
        Value::Domain2(d) => json!({"u": range(d.u), "v": range(d.v)}),
        Value::Complex(z) => json!([z.re, z.im]),
        Value::Colour(c) => json!([c.a, c.r, c.g, c.b]),
        Value::Transform(x) => json!(x.rows),
        Value::Compound(c) => json!(c.whole().rows),
        Value::Matrix(m) => m.values().chunks(m.columns().max(1)).map(|row| json!(row)).collect(),
        Value::MeshFace(face) => json!(face.indices()),
        Value::Mesh(mesh) => json!({
            "vertices": mesh.vertices().iter().map(|p| point(*p)).collect::<Vec<_>>(),
            "faces": mesh.faces().iter().map(|f| json!(f.indices())).collect::<Vec<_>>(),
        }),
        Value::Group(group) => {
            let members = group.members.iter();
            members.map(|m| m.as_ref().map_or(serde_json::Value::Null, |m| structured(m, style))).collect()
        }
        other => text::value(other, style).into(),
    }
}
