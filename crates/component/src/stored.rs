//! Values that are kept in a port, as a data tree.

use katydid_3dm::{Limits, RawObject};
use katydid_data::{
    Colour, Complex, DateTime, Domain2, Kind, LoftOptions, Material, MeshSettings, Path, Tree, TreeBuilder,
    Value,
};
use katydid_definition::archive::Chunk;
use katydid_definition::document::{Persistent, Stored, StoredGeometry};
use katydid_geometry::MeshFace;
use uuid::Uuid;

use crate::{Message, ModelLack, RhinoModel, RhinoObject};

/// The values of a port, and what the user should know of those that could not be had. Geometry that only a Rhino
/// model has is looked up in `model`.
pub fn tree(persistent: &Persistent, model: Option<&RhinoModel>) -> (Tree, Vec<Message>) {
    let mut missing = Missing { model, ..Missing::default() };
    let mut builder = TreeBuilder::<Value>::new();
    for branch in &persistent.branches {
        builder.branch(Path::from(branch.path.as_slice()));
        for item in &branch.items {
            builder.push(value(item, &mut missing));
        }
    }
    (builder.finish(), missing.into_messages())
}

/// A kept value that needs no Rhino model; none for a null.
///
/// # Errors
/// Why it cannot be had, in words.
pub fn item(stored: &Stored) -> Result<Option<Value>, String> {
    let mut missing = Missing::default();
    let found = value(stored, &mut missing);
    match missing.into_messages().pop() {
        Some(message) if found.is_none() => Err(message.text),
        _ => Ok(found),
    }
}

/// Where geometry is looked up, and what could not be had, each reason once.
#[derive(Default)]
struct Missing<'a> {
    model: Option<&'a RhinoModel>,
    referenced: Vec<Uuid>,
    others: Vec<String>,
}

impl Missing<'_> {
    fn add(&mut self, reason: String) {
        if !self.others.contains(&reason) {
            self.others.push(reason);
        }
    }

    fn into_messages(self) -> Vec<Message> {
        let lack = ModelLack {
            kind: Kind::Generic,
            objects: self.referenced.len(),
            has_model: self.model.is_some(),
        };
        let referenced =
            (!self.referenced.is_empty()).then(|| Message::warning(self.without_geometry()).lacking(lack));
        referenced.into_iter().chain(self.others.into_iter().map(Message::warning)).collect()
    }

    /// The objects of a model that are referenced and not to be had, as many as one cares to read.
    fn without_geometry(&self) -> String {
        const SHOWN: usize = 8;
        let mut ids: Vec<String> = self.referenced.iter().take(SHOWN).map(Uuid::to_string).collect();
        if let Some(more) = self.referenced.len().checked_sub(SHOWN).filter(|more| *more > 0) {
            ids.push(format!("and {more} more"));
        }
        let (objects, are) = if self.referenced.len() == 1 { ("object", "is") } else { ("objects", "are") };
        let ids = ids.join(", ");
        match self.model {
            None => format!(
                "Needs the Rhino model: {objects} {ids} {are} referenced, and not in this file \
                 (katydid run FILE --model MODEL.3dm)"
            ),
            Some(_) => format!("Referenced {objects} {ids} {are} not in the Rhino model"),
        }
    }
}

fn value(stored: &Stored, missing: &mut Missing<'_>) -> Option<Value> {
    Some(match stored {
        Stored::Null => return None,
        Stored::Number(x) => Value::Number(*x),
        Stored::Integer(i) => Value::Integer(*i),
        Stored::Boolean(b) => Value::Boolean(*b),
        Stored::Text(text) => Value::from(text.as_str()),
        Stored::Colour(c) => Value::Colour(colour(*c)),
        Stored::Time(ticks) => Value::Time(DateTime { ticks: *ticks }),
        Stored::Guid(id) => Value::Guid(*id),
        // The component that takes it looks the path up.
        Stored::Content(path) => Value::from(path.as_str()),
        Stored::Point(p) => Value::Point(*p),
        Stored::Vector(v) => Value::Vector(*v),
        Stored::Plane(p) => Value::from(**p),
        Stored::Line(l) => Value::from(**l),
        Stored::Circle(c) => Value::from(**c),
        Stored::Arc(a) => Value::from(**a),
        Stored::Rectangle(r) => Value::from(**r),
        Stored::Box(b) => Value::from(**b),
        Stored::Domain(d) => Value::Domain(*d),
        Stored::Domain2([u, v]) => Value::from(Domain2 { u: *u, v: *v }),
        Stored::Complex([re, im]) => Value::Complex(Complex { re: *re, im: *im }),
        Stored::MeshFace(face) => match mesh_face(*face) {
            Some(face) => Value::MeshFace(face),
            None => {
                missing.add(format!("A mesh face has negative indices: {face:?}"));
                return None;
            }
        },
        Stored::Path(path) => Value::Path(Path::from(path.as_slice())),
        Stored::Material(m) => Value::from(Material {
            diffuse: colour(m.diffuse),
            specular: colour(m.specular),
            emission: colour(m.emission),
            transparency: m.transparency,
            shine: m.shine,
        }),
        Stored::LoftOptions(o) => Value::from(LoftOptions {
            closed: o.closed,
            adjust: o.adjust,
            kind: o.kind,
            // The numbers are kept even where sections are not simplified by them.
            rebuild: if o.simplify == 1 { o.rebuild } else { 0 },
            refit: if o.simplify == 2 { o.refit } else { 0.0 },
        }),
        Stored::MeshSettings(m) => Value::from(MeshSettings {
            max_edge: m.max_edge,
            min_edge: m.min_edge,
            tolerance: m.tolerance,
            min_tolerance: m.min_tolerance,
            relative_tolerance: m.relative_tolerance,
            refine_angle: m.refine_angle,
            // Files do not keep it.
            aspect: 0.0,
            grid_min: m.grid_min,
            grid_max: m.grid_max,
            refine: m.refine,
            jagged_seams: m.jagged_seams,
            simple_planes: m.simple_planes,
        }),
        Stored::QuadSettings(q) => Value::from(**q),
        Stored::Geometry(g) => return geometry(g, missing),
        // Which coordinates Points to Numbers takes; the meaning of other codes is not known.
        Stored::Unknown(chunk) if chunk.i32("CMask") == Some(4) => Value::text("XYZ"),
        // A culture by its number, a unit by its own.
        Stored::Unknown(chunk) if is_only(chunk, "LCID") => return chunk.i32("LCID").map(Value::Integer),
        Stored::Unknown(chunk) if is_only(chunk, "BaseSystem") => {
            return chunk.i32("BaseSystem").map(Value::Integer);
        }
        Stored::Unknown(chunk) => {
            let names: Vec<&str> = chunk.items.iter().map(|i| i.name.as_str()).collect();
            missing.add(format!("A stored value is of an unknown form ({})", names.join(", ")));
            return None;
        }
        other => {
            missing.add(format!("Stored {} cannot be used yet", other.type_name()));
            return None;
        }
    })
}

/// Whether a stored value has this item and no other, but for the name of its type.
fn is_only(chunk: &Chunk, name: &str) -> bool {
    let mut others = chunk.items.iter().filter(|item| item.name != "TypeName");
    chunk.chunks.is_empty() && others.next().is_some_and(|item| item.name == name) && others.next().is_none()
}

fn colour(c: katydid_definition::archive::Colour) -> Colour {
    Colour { a: c.a, r: c.r, g: c.g, b: c.b }
}

/// A triangle repeats its third index or has −1 behind it.
fn mesh_face(indices: [i32; 4]) -> Option<MeshFace> {
    let [a, b, c, d] = indices;
    let index = |i: i32| u32::try_from(i).ok();
    Some(if d < 0 || d == c {
        MeshFace::Triangle([index(a)?, index(b)?, index(c)?])
    } else {
        MeshFace::Quad([index(a)?, index(b)?, index(c)?, index(d)?])
    })
}

fn geometry(stored: &StoredGeometry, missing: &mut Missing<'_>) -> Option<Value> {
    // The model comes first: what a file carries beside a reference is how the object looked when it was saved.
    if let Some(found) = missing.model.and_then(|model| model.object(stored.ref_id)) {
        return referenced(stored, found, missing);
    }
    let Some(unpacked) = stored.decode(&Default::default()) else {
        if !stored.ref_id.is_nil() {
            missing.referenced.push(stored.ref_id);
        }
        return None;
    };
    let read = unpacked.map_err(|error| error.to_string()).and_then(|data| {
        let version = data.opennurbs.cast_unsigned();
        let (raw, _) = RawObject::read(data.archive3dm, version, &data.data, &Limits::default())
            .map_err(|error| error.to_string())?;
        let class = raw.class_name();
        Value::from_raw(raw).map(|value| (class, value)).map_err(|error| error.to_string())
    });
    match read {
        Ok((class, value)) => {
            if value.is_none() {
                missing.add(format!("{class} is kept, but cannot be used yet"));
            }
            value
        }
        Err(error) => {
            missing.add(format!("Stored geometry cannot be read: {error}"));
            None
        }
    }
}

/// What a reference to an object of the model stands for: its geometry, or one of its edges.
fn referenced(stored: &StoredGeometry, found: &RhinoObject, missing: &mut Missing<'_>) -> Option<Value> {
    if let Some(kind) = stored.ref_type.as_deref().filter(|kind| *kind != "point_object") {
        missing.add(format!("A point that is referenced as {kind} cannot be had yet"));
        return None;
    }
    let edge = stored.edge.and_then(|edge| usize::try_from(edge).ok());
    let value = match edge {
        Some(edge) => found.edge(edge),
        None => found.geometry.clone().ok_or_else(|| format!("A {} cannot be used yet", found.class)),
    };
    value.map_err(|reason| missing.add(reason)).ok()
}
