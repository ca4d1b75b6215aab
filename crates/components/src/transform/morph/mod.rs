//! Transform / Morph: maps that bend.

mod along;
mod cages;
mod forces;
mod kept;
mod mirrors;
mod onto;

use std::sync::Arc as Shared;

use katydid_component::{Context, Message};
use katydid_data::{Content, Geometry, Group, Kind, ModelObject, Value, cast};
use katydid_geometry::morph::{Morph, morphed_frame, rigid_part};
use katydid_geometry::{Brep, Curve, Line, Plane, Point3, Surface, TwistedBox};

/// Groups in groups beyond this depth are refused.
const DEEPEST: usize = 100;
/// The reach over which the directions of a map are taken, in parts of the size of what is mapped.
const REACH: f64 = 1e-4;

/// How geometry follows a map.
#[derive(Clone, Copy)]
enum Manner {
    /// Every point of it.
    Bent,
    /// As a whole: as the middle of its box goes and turns.
    Rigid,
    /// By its control points and vertices.
    Controls,
}

impl Manner {
    fn of(rigid: bool) -> Self {
        if rigid { Self::Rigid } else { Self::Bent }
    }
}

/// The image of geometry.
fn morphed(
    context: &Context<'_>,
    geometry: &Geometry,
    morph: &dyn Morph,
    manner: Manner,
) -> Result<Geometry, Message> {
    deformed(context, &geometry.0, morph, manner, 0).map(Geometry)
}

fn deformed(
    context: &Context<'_>,
    value: &Value,
    morph: &dyn Morph,
    manner: Manner,
    depth: usize,
) -> Result<Value, Message> {
    context.check()?;
    if let (Manner::Rigid, false) = (manner, matches!(value, Value::Point(_) | Value::Group(_))) {
        return moved(value, morph);
    }
    let bent = |curve: &Curve| -> Result<Curve, Message> {
        Ok(match manner {
            Manner::Controls => curve.with_morphed_controls(morph)?,
            _ => curve.morphed(morph, &context.tolerance())?,
        })
    };
    let sheet = |surface: &Surface| -> Result<Value, Message> {
        Ok(Value::from(match manner {
            Manner::Controls => surface.with_morphed_controls(morph)?,
            _ => surface.morphed(morph, &context.tolerance())?,
        }))
    };
    Ok(match value {
        Value::Point(p) => Value::Point(morph.image(*p)?),
        Value::Plane(plane) => Value::from(morphed_frame(morph, plane, REACH)?),
        Value::TwistedBox(b) => {
            let mut corners = b.corners;
            for corner in &mut corners {
                *corner = morph.image(*corner)?;
            }
            Value::from(TwistedBox::new(corners)?)
        }
        Value::Line(line) => match bent(&Curve::from(**line))? {
            Curve::Line(image) => Value::from(image.line),
            image => Value::from(image),
        },
        Value::Circle(_) | Value::Arc(_) | Value::Rectangle(_) => {
            match cast::value(value, Kind::Curve, context.rules()) {
                Some(Value::Curve(curve)) => Value::from(bent(&curve)?),
                _ => return Err(Message::error(format!("This {} is no sound curve", value.kind()))),
            }
        }
        Value::Curve(curve) => Value::from(bent(curve)?),
        Value::Surface(surface) => sheet(surface)?,
        Value::Mesh(mesh) => {
            context.bytes(mesh.vertices().len().saturating_mul(48))?;
            Value::from(mesh.morphed(morph)?)
        }
        Value::Group(group) => {
            if depth > DEEPEST {
                return Err(Message::error("Groups are nested too deep to be deformed"));
            }
            let member = |m: &Option<Value>| {
                m.as_ref().map(|m| deformed(context, m, morph, manner, depth + 1)).transpose()
            };
            let members = group.members.iter().map(member).collect::<Result<_, Message>>()?;
            Value::Group(Shared::new(Group { members }))
        }
        Value::Vector(v) => {
            let origin = Point3::ORIGIN;
            Value::Vector(morph.image(origin + *v)? - morph.image(origin)?)
        }
        Value::Brep(brep) => solid(context, brep, morph, manner)?,
        Value::Box(_) => solid(context, &*value.solid()?, morph, manner)?,
        Value::Kept(object) => match object.bare_surface() {
            Ok(Some(bare)) => sheet(&bare.surface)?,
            _ => kept::deformed(context, value, object, morph, manner)?,
        },
        Value::Content(content) => match &**content {
            Content::Object(ModelObject { geometry: Some(geometry), geometry_text, .. }) => {
                let image = deformed(context, geometry, morph, manner, depth + 1)?;
                ModelObject::carrying(image, geometry_text.clone())
            }
            // What is drawn by a block of its own is carried as a whole.
            Content::Instance(_) => {
                context.tell(Message::remark("A block is carried as a whole: it cannot bend"));
                moved(value, morph)?
            }
            other => return Err(Message::error(format!("A {} cannot be deformed", other.type_name()))),
        },
        other => return Err(Message::error(format!("A {} cannot be deformed", other.kind()))),
    })
}

/// The image of a solid, with a warning where the map leaves a sound one unsound: it folds or tears what it maps.
fn solid(context: &Context<'_>, brep: &Brep, morph: &dyn Morph, manner: Manner) -> Result<Value, Message> {
    let image = match manner {
        Manner::Controls => brep.with_morphed_controls(morph)?,
        _ => brep.morphed(morph, &context.tolerance())?,
    };
    if !image.is_valid() && brep.is_valid() {
        context.warn("Edges and faces of the result do not fit together: the map may fold or tear the shape");
    }
    Ok(Value::from(image))
}

/// The value carried as a whole, as the map carries the middle of its box.
fn moved(value: &Value, morph: &dyn Morph) -> Result<Value, Message> {
    let around = super::around(value, &Plane::XY);
    let (center, size) = match (&around, value) {
        (_, Value::Plane(plane)) => (plane.origin, 1.0),
        (Some(b), _) => {
            let c = b.corners();
            (b.center(), c.first().zip(c.get(6)).map_or(1.0, |(a, b)| a.distance_to(*b)))
        }
        (None, _) => {
            return Err(Message::error(format!("A {} has no middle to be carried by", value.kind())));
        }
    };
    let frame = Plane { origin: center, ..Plane::XY };
    Ok(value.transformed(&rigid_part(morph, &frame, REACH * size.max(1e-6))?)?)
}

/// A list of points, each with the vector of its place in another list; the last vector serves for the points that are
/// left over. Nulls are passed over.
fn paired<T: Copy>(
    points: impl Iterator<Item = Option<Point3>>,
    vectors: impl Iterator<Item = Option<T>>,
) -> Vec<(Point3, T)> {
    let vectors: Vec<Option<T>> = vectors.collect();
    let last = vectors.last().copied().flatten();
    points.enumerate().filter_map(|(i, p)| Some((p?, vectors.get(i).copied().unwrap_or(last)?))).collect()
}

/// An axis that must have a length.
fn sound(axis: Line) -> Result<Line, Message> {
    if axis.is_finite() && axis.length() > 0.0 {
        Ok(axis)
    } else {
        Err(Message::error("The axis has no length"))
    }
}
