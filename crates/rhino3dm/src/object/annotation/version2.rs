//! The annotation classes of version 2. They hold no chunks, so that every version can carry them as they are.

use katydid_geometry::Point2;
use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::object::major_1;
use crate::{Result, StoredPlane, class_ids};

/// An annotation of version 2.
#[derive(Debug, Clone, PartialEq)]
pub struct Annotation2 {
    /// What it is, with what only that kind has.
    pub kind: Annotation2Kind,
    /// The kind by its number: 1 linear, 2 aligned, 3 angular, 4 diameter, 5 radius, 6 leader, 7 text, 8 ordinate.
    pub number: i32,
    /// The plane it is drawn in.
    pub plane: StoredPlane,
    /// Its points in coordinates of the plane.
    pub points: Vec<Point2>,
    /// The text of the user.
    pub user_text: String,
    /// The text that is shown when the user wrote none.
    pub default_text: String,
    /// Whether the user placed the text.
    pub user_positioned_text: bool,
}

/// What an annotation of version 2 is.
#[derive(Debug, Clone, PartialEq)]
pub enum Annotation2Kind {
    /// A distance.
    Linear,
    /// A radius or diameter.
    Radial,
    /// An angle.
    Angular {
        /// The angle in radians.
        angle: f64,
        /// The radius of the dimension arc.
        radius: f64,
    },
    /// Text.
    Text {
        /// The face of its font.
        font: String,
        /// The weight of its font; 400 is regular.
        weight: i32,
        /// Its height.
        height: f64,
    },
    /// An arrow through points.
    Leader,
}

impl Annotation2 {
    /// The text that is shown.
    pub fn text(&self) -> &str {
        if self.user_text.is_empty() { &self.default_text } else { &self.user_text }
    }
}

const WHAT: &str = "annotation of version 2";

/// Whether a class is an annotation of version 2.
pub(in crate::object) fn is_version_2(class: Uuid) -> bool {
    matches!(
        class,
        class_ids::LINEAR_DIMENSION_2
            | class_ids::RADIAL_DIMENSION_2
            | class_ids::ANGULAR_DIMENSION_2
            | class_ids::TEXT_2
            | class_ids::LEADER_2
    )
}

/// The class under which an annotation is written.
pub(in crate::object) fn class_of(annotation: &Annotation2) -> Uuid {
    match annotation.kind {
        Annotation2Kind::Linear => class_ids::LINEAR_DIMENSION_2,
        Annotation2Kind::Radial => class_ids::RADIAL_DIMENSION_2,
        Annotation2Kind::Angular { .. } => class_ids::ANGULAR_DIMENSION_2,
        Annotation2Kind::Text { .. } => class_ids::TEXT_2,
        Annotation2Kind::Leader => class_ids::LEADER_2,
    }
}

/// Reads the body of an annotation class.
pub(in crate::object) fn read(class: Uuid, body: &mut Reader<'_>) -> Result<Annotation2> {
    major_1(body, WHAT)?;
    let base = Annotation2 {
        kind: Annotation2Kind::Leader,
        number: body.i32(WHAT)?,
        plane: body.stored_plane(WHAT)?,
        points: body.points2(WHAT)?,
        user_text: body.string(WHAT)?,
        default_text: body.string(WHAT)?,
        user_positioned_text: body.i32(WHAT)? != 0,
    };
    let kind = match class {
        class_ids::LINEAR_DIMENSION_2 => Annotation2Kind::Linear,
        class_ids::RADIAL_DIMENSION_2 => Annotation2Kind::Radial,
        class_ids::ANGULAR_DIMENSION_2 => {
            Annotation2Kind::Angular { angle: body.f64(WHAT)?, radius: body.f64(WHAT)? }
        }
        class_ids::TEXT_2 => Annotation2Kind::Text {
            font: body.string(WHAT)?,
            weight: body.i32(WHAT)?,
            height: body.f64(WHAT)?,
        },
        _ => Annotation2Kind::Leader,
    };
    Ok(Annotation2 { kind, ..base })
}

/// Writes the body.
pub(in crate::object) fn write(annotation: &Annotation2, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 0);
    w.i32(annotation.number);
    w.stored_plane(&annotation.plane);
    w.points2(&annotation.points)?;
    w.string(&annotation.user_text)?;
    w.string(&annotation.default_text)?;
    w.i32(i32::from(annotation.user_positioned_text));
    match &annotation.kind {
        Annotation2Kind::Linear | Annotation2Kind::Radial | Annotation2Kind::Leader => {}
        Annotation2Kind::Angular { angle, radius } => {
            w.f64(*angle);
            w.f64(*radius);
        }
        Annotation2Kind::Text { font, weight, height } => {
            w.string(font)?;
            w.i32(*weight);
            w.f64(*height);
        }
    }
    Ok(())
}
