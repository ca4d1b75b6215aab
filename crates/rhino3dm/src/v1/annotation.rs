//! Annotations of version 1, restated as the classes of version 2.

use katydid_geometry::{Plane, Point3, Vector3};
use uuid::Uuid;

use super::{text, typecode as code};
use crate::chunk::{Reader, Writer};
use crate::{Error, Result, class_ids};

const WHAT: &str = "annotation of version 1";
/// Coordinates of annotation planes beyond this were never set.
const TOO_BIG: f64 = 1e10;

/// What an annotation is, with the numbers only this kind has.
#[derive(Debug, Clone, PartialEq)]
enum Kind {
    Linear { aligned: bool },
    Angular { angle: f64, radius: f64 },
    Radial { is_diameter: bool },
    Leader,
    Text { font: String, weight: i32, height: f64 },
}

/// An annotation.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Annotation {
    kind: Kind,
    plane: Plane,
    /// In the plane.
    points: Vec<[f64; 2]>,
    user_text: String,
    default_text: String,
    text_is_placed: bool,
}

/// Whether a chunk holds an annotation.
pub(super) fn is_annotation(typecode: u32) -> bool {
    matches!(
        typecode,
        code::TEXT_BLOCK
            | code::LEADER
            | code::LINEAR_DIMENSION
            | code::ANGULAR_DIMENSION
            | code::RADIAL_DIMENSION
    )
}

impl Annotation {
    /// Reads the fields that begin the chunk of an annotation; nothing comes of a text without text and a leader
    /// of fewer than two points.
    pub(super) fn read(typecode: u32, body: &mut Reader<'_>) -> Result<Option<Self>> {
        let offset = body.offset();
        let version = body.i32(WHAT)?;
        let newest = if typecode == code::TEXT_BLOCK { 2 } else { 1 };
        if !(1..=newest).contains(&version) {
            return Err(Error::malformed(offset, WHAT, format!("layout {version} is not known")));
        }
        let stored_kind = body.i32(WHAT)?;
        let plane = read_plane(body)?;
        let annotation = match typecode {
            code::TEXT_BLOCK => read_text(body, plane, version)?,
            code::LEADER => read_leader(body, plane)?,
            code::LINEAR_DIMENSION => {
                // Horizontal, vertical, rotated and linear ones; the others are aligned.
                let kind = Kind::Linear { aligned: !matches!(stored_kind, 2 | 3 | 5 | 10) };
                let points = read_points(body, 11)?;
                read_dimension(body, kind, plane, points)?
            }
            code::ANGULAR_DIMENSION => {
                let kind = Kind::Angular { angle: body.f64(WHAT)?, radius: body.f64(WHAT)? };
                // Distances from the apex, which nobody uses.
                body.take(32, WHAT)?;
                let points = read_points(body, 5)?;
                read_dimension(body, kind, plane, points)?
            }
            _ => {
                let points = read_points(body, 5)?;
                read_dimension(body, Kind::Radial { is_diameter: stored_kind == 7 }, plane, points)?
            }
        };
        let is_empty = match annotation.kind {
            Kind::Text { .. } => annotation.user_text.is_empty(),
            Kind::Leader => annotation.points.len() < 2,
            _ => false,
        };
        Ok((!is_empty).then_some(annotation))
    }

    /// The class of version 2.
    pub(super) fn class(&self) -> Uuid {
        match self.kind {
            Kind::Linear { .. } => class_ids::LINEAR_DIMENSION_2,
            Kind::Angular { .. } => class_ids::ANGULAR_DIMENSION_2,
            Kind::Radial { .. } => class_ids::RADIAL_DIMENSION_2,
            Kind::Leader => class_ids::LEADER_2,
            Kind::Text { .. } => class_ids::TEXT_2,
        }
    }

    /// Writes the body of the class.
    pub(super) fn write(&self, w: &mut Writer) -> Result<()> {
        w.packed_version(1, 0);
        w.i32(match self.kind {
            Kind::Linear { aligned: false } => 1,
            Kind::Linear { aligned: true } => 2,
            Kind::Angular { .. } => 3,
            Kind::Radial { is_diameter: true } => 4,
            Kind::Radial { is_diameter: false } => 5,
            Kind::Leader => 6,
            Kind::Text { .. } => 7,
        });
        w.plane_and_offset(&self.plane, None);
        w.count(self.points.len(), "points")?;
        self.points.iter().flatten().for_each(|x| w.f64(*x));
        w.string(&self.user_text)?;
        w.string(&self.default_text)?;
        w.i32(i32::from(self.text_is_placed));
        match &self.kind {
            Kind::Angular { angle, radius } => {
                w.f64(*angle);
                w.f64(*radius);
            }
            Kind::Text { font, weight, height } => {
                w.string(font)?;
                w.i32(*weight);
                w.f64(*height);
            }
            _ => {}
        }
        Ok(())
    }
}

/// The origin and two axes; numbers that were never set are put right.
fn read_plane(body: &mut Reader<'_>) -> Result<Plane> {
    let tame = |v: Vector3, default: [f64; 3]| {
        let [x, y, z] = default;
        let one = |x: f64, default: f64| if x.abs() > TOO_BIG { default } else { x };
        Vector3::new(one(v.x, x), one(v.y, y), one(v.z, z))
    };
    let origin = tame(body.vector(WHAT)?, [0.0; 3]);
    let x = unit(tame(body.vector(WHAT)?, [1.0, 0.0, 0.0]));
    let y = unit(tame(body.vector(WHAT)?, [0.0, 1.0, 0.0]));
    let z = unit(x.cross(y));
    Ok(Plane { origin: Point3::new(origin.x, origin.y, origin.z), x_axis: x, y_axis: y, z_axis: z })
}

/// The vector at length 1, or itself when it has none.
fn unit(v: Vector3) -> Vector3 {
    let length = v.length();
    if length > 0.0 && length.is_finite() { v * (1.0 / length) } else { v }
}

/// Points with a third coordinate that says nothing.
fn read_points(body: &mut Reader<'_>, count: usize) -> Result<Vec<[f64; 2]>> {
    body.check_count(count, 24, WHAT)?;
    (0..count).map(|_| body.point(WHAT).map(|p| [p.x, p.y])).collect()
}

fn read_dimension(
    body: &mut Reader<'_>,
    kind: Kind,
    plane: Plane,
    points: Vec<[f64; 2]>,
) -> Result<Annotation> {
    let user_text = text::counted(body, "annotation text")?;
    let default_text = text::counted(body, "annotation text")?;
    let text_is_placed = body.i32(WHAT)? != 0;
    read_flags(body)?;
    Ok(Annotation { kind, plane, points, user_text, default_text, text_is_placed })
}

/// Flags, and whether the object has settings of its own; neither was ever used.
fn read_flags(body: &mut Reader<'_>) -> Result<()> {
    body.take(8, WHAT).map(drop)
}

fn read_leader(body: &mut Reader<'_>, plane: Plane) -> Result<Annotation> {
    read_flags(body)?;
    let count = body.count(24, "points of a leader")?;
    let points = read_points(body, count)?;
    Ok(Annotation {
        kind: Kind::Leader,
        plane,
        points,
        user_text: String::new(),
        default_text: String::new(),
        text_is_placed: false,
    })
}

fn read_text(body: &mut Reader<'_>, plane: Plane, version: i32) -> Result<Annotation> {
    let user_text = text::counted(body, "annotation text")?;
    read_flags(body)?;
    let font = text::counted(body, "font")?;
    let kind = Kind::Text { font, weight: body.i32(WHAT)?, height: body.f64(WHAT)? };
    if version == 1 {
        // Two numbers that were written by mistake.
        body.take(16, WHAT)?;
    }
    Ok(Annotation {
        kind,
        plane,
        points: Vec::new(),
        user_text,
        default_text: String::new(),
        text_is_placed: false,
    })
}
