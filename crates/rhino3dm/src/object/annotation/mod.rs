//! Annotations: text, leaders, dimensions and centre marks, in three generations of classes.
//!
//! The classes of version 6 and later are [`Annotation`]; those of versions 4 and 5 are [`Annotation5`], those of
//! version 2 [`Annotation2`]. Those of version 6 are written to archives before in the form of version 5, but for
//! centre marks, which that has not. The older ones are kept in their own generation, whatever version is written: the
//! official reader turns them into the newest wherever it meets them, by numbers of the dimension styles (and of
//! the fonts of the machine) that an object does not have by itself.

mod content;
mod dimension;
mod older;
mod plain_text;
mod version2;
mod version5;

pub use content::TextContent;
pub use dimension::Dimension;
pub(super) use older::to_older;
pub use version2::{Annotation2, Annotation2Kind};
pub use version5::{Annotation5, Annotation5Kind};

pub(super) use version2::{class_of as class_of_2, is_version_2, read as read_2, write as write_2};
pub(super) use version5::{class_of as class_of_5, is_version_5, read as read_5, write as write_5};

use katydid_geometry::{Point2, Vector2};
use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::class_object::ClassObject;
use crate::{Error, Result, StoredPlane, class_ids};

/// An annotation of version 6 or later.
#[derive(Debug, Clone, PartialEq)]
pub struct Annotation {
    /// What it is, with what only that kind has.
    pub kind: AnnotationKind,
    /// The text that is shown.
    pub text: TextContent,
    /// The identifier of its dimension style.
    pub style: Uuid,
    /// What differs from that style.
    pub overrides: Option<StyleOverrides>,
    /// The plane it is drawn in; its points are coordinates of this plane.
    pub plane: StoredPlane,
    /// Which way of the plane horizontal text runs.
    pub horizontal: Vector2,
    /// Whether the text is scaled with the style's model scale.
    pub scales_text: bool,
}

/// A dimension style that counts in place of an annotation's own in some of its numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StyleOverrides {
    /// The class object of that style, as archives from version 60 on hold it.
    pub bytes: Vec<u8>,
}

/// What an annotation is. All points are coordinates of its plane.
#[derive(Debug, Clone, PartialEq)]
pub enum AnnotationKind {
    /// Text.
    Text,
    /// An arrow through points, and text at its end.
    Leader {
        /// From the tip to the text.
        points: Vec<Point2>,
    },
    /// The distance between the plane's origin and a point.
    Linear {
        /// What all dimensions have.
        dimension: Dimension,
        /// Whether it runs along the two points, not in a direction of its own.
        aligned: bool,
        /// The second point that is measured.
        end: Point2,
        /// A point of the dimension line.
        line: Point2,
    },
    /// The angle between two directions from the plane's origin.
    Angular {
        /// What all dimensions have.
        dimension: Dimension,
        /// Whether it was made from three points, not from two lines.
        three_points: bool,
        /// The two directions.
        directions: [Vector2; 2],
        /// How far from the origin the two extension lines begin.
        offsets: [f64; 2],
        /// A point of the dimension arc.
        arc: Point2,
    },
    /// The radius or diameter of a circle around the plane's origin.
    Radial {
        /// What all dimensions have.
        dimension: Dimension,
        /// Whether it shows the diameter, not the radius.
        diameter: bool,
        /// The point of the circle that the arrow touches.
        on_circle: Point2,
        /// Where the line ends at the text.
        line: Point2,
    },
    /// A coordinate of a point, counted from the plane's origin.
    Ordinate {
        /// What all dimensions have.
        dimension: Dimension,
        /// The coordinate: 1 is x, 2 is y, 0 the one that the points suggest.
        direction: i32,
        /// The point that is measured.
        point: Point2,
        /// Where the leader ends.
        leader: Point2,
        /// How far from its end the leader bends, twice.
        kinks: [f64; 2],
    },
    /// The cross in the middle of a circle around the plane's origin.
    CentreMark {
        /// What all dimensions have.
        dimension: Dimension,
        /// The circle's radius.
        radius: f64,
    },
}

const WHAT: &str = "annotation";
/// The content version of annotations: overrides since 2, the horizontal direction since 3, scaling since 4.
const CONTENT: i32 = 4;

/// The numbers of the kinds.
mod number {
    pub(super) const ALIGNED: i32 = 1;
    pub(super) const ANGULAR: i32 = 2;
    pub(super) const DIAMETER: i32 = 3;
    pub(super) const RADIUS: i32 = 4;
    pub(super) const ROTATED: i32 = 5;
    pub(super) const ORDINATE: i32 = 6;
    pub(super) const CENTRE_MARK: i32 = 8;
    pub(super) const TEXT: i32 = 9;
    pub(super) const LEADER: i32 = 10;
    pub(super) const ANGULAR_3: i32 = 11;
}

impl Annotation {
    /// The text without its formatting, as far as it can be told without the style.
    pub fn plain_text(&self) -> String {
        plain_text::of(&self.text.rich_text)
    }

    /// What it has as a dimension; text and leaders have nothing.
    pub fn dimension(&self) -> Option<&Dimension> {
        match &self.kind {
            AnnotationKind::Text | AnnotationKind::Leader { .. } => None,
            AnnotationKind::Linear { dimension, .. }
            | AnnotationKind::Angular { dimension, .. }
            | AnnotationKind::Radial { dimension, .. }
            | AnnotationKind::Ordinate { dimension, .. }
            | AnnotationKind::CentreMark { dimension, .. } => Some(dimension),
        }
    }

    /// Whether an archive of the given version can carry it, in its older form if need be.
    pub(super) fn check_writable(&self, version: i32) -> Result<()> {
        if version >= 60 || !matches!(self.kind, AnnotationKind::CentreMark { .. }) {
            return Ok(());
        }
        Err(Error::CannotWrite {
            what: "a centre mark".into(),
            version,
            why: "archives have them from version 60 on".into(),
        })
    }
}

/// Whether a class is an annotation of version 6 or later.
pub(super) fn is_annotation(class: Uuid) -> bool {
    matches!(
        class,
        class_ids::TEXT
            | class_ids::LEADER
            | class_ids::LINEAR_DIMENSION
            | class_ids::ANGULAR_DIMENSION
            | class_ids::RADIAL_DIMENSION
            | class_ids::ORDINATE_DIMENSION
            | class_ids::CENTRE_MARK
    )
}

/// The class under which an annotation is written.
pub(super) fn class_of(annotation: &Annotation) -> Uuid {
    match annotation.kind {
        AnnotationKind::Text => class_ids::TEXT,
        AnnotationKind::Leader { .. } => class_ids::LEADER,
        AnnotationKind::Linear { .. } => class_ids::LINEAR_DIMENSION,
        AnnotationKind::Angular { .. } => class_ids::ANGULAR_DIMENSION,
        AnnotationKind::Radial { .. } => class_ids::RADIAL_DIMENSION,
        AnnotationKind::Ordinate { .. } => class_ids::ORDINATE_DIMENSION,
        AnnotationKind::CentreMark { .. } => class_ids::CENTRE_MARK,
    }
}

/// The number by which an annotation states its kind.
fn number_of(kind: &AnnotationKind) -> i32 {
    match kind {
        AnnotationKind::Text => number::TEXT,
        AnnotationKind::Leader { .. } => number::LEADER,
        AnnotationKind::Linear { aligned: true, .. } => number::ALIGNED,
        AnnotationKind::Linear { .. } => number::ROTATED,
        AnnotationKind::Angular { three_points: true, .. } => number::ANGULAR_3,
        AnnotationKind::Angular { .. } => number::ANGULAR,
        AnnotationKind::Radial { diameter: true, .. } => number::DIAMETER,
        AnnotationKind::Radial { .. } => number::RADIUS,
        AnnotationKind::Ordinate { .. } => number::ORDINATE,
        AnnotationKind::CentreMark { .. } => number::CENTRE_MARK,
    }
}

/// Reads the body of an annotation class.
pub(super) fn read(class: Uuid, body: &mut Reader<'_>) -> Result<Annotation> {
    let (mut body, _) = body.versioned_1(WHAT)?;
    let annotation = match class {
        class_ids::TEXT => read_base(&mut body)?.0,
        class_ids::LEADER => {
            let (base, _) = read_base(&mut body)?;
            Annotation { kind: AnnotationKind::Leader { points: body.points2(WHAT)? }, ..base }
        }
        _ => read_dimension(class, &mut body)?,
    };
    body.finish();
    Ok(annotation)
}

/// What all dimensions have, then what the class adds.
fn read_dimension(class: Uuid, body: &mut Reader<'_>) -> Result<Annotation> {
    let (mut inner, content) = body.versioned_1(WHAT)?;
    let (base, stated) = read_base(&mut inner)?;
    let dimension = dimension::read(&mut inner, content)?;
    inner.finish();
    let kind = match class {
        class_ids::LINEAR_DIMENSION => AnnotationKind::Linear {
            dimension,
            aligned: stated != number::ROTATED,
            end: body.point2(WHAT)?,
            line: body.point2(WHAT)?,
        },
        class_ids::ANGULAR_DIMENSION => AnnotationKind::Angular {
            dimension,
            three_points: stated == number::ANGULAR_3,
            directions: [body.point2(WHAT)?.to_vector(), body.point2(WHAT)?.to_vector()],
            offsets: [body.f64(WHAT)?, body.f64(WHAT)?],
            arc: body.point2(WHAT)?,
        },
        class_ids::RADIAL_DIMENSION => AnnotationKind::Radial {
            dimension,
            diameter: stated != number::RADIUS,
            on_circle: body.point2(WHAT)?,
            line: body.point2(WHAT)?,
        },
        class_ids::ORDINATE_DIMENSION => AnnotationKind::Ordinate {
            dimension,
            direction: body.i32(WHAT)?,
            point: body.point2(WHAT)?,
            leader: body.point2(WHAT)?,
            kinks: [body.f64(WHAT)?, body.f64(WHAT)?],
        },
        _ => AnnotationKind::CentreMark { dimension, radius: body.f64(WHAT)? },
    };
    Ok(Annotation { kind, ..base })
}

/// What all annotations have, and the number of the kind they state; the kind is text for now.
fn read_base(body: &mut Reader<'_>) -> Result<(Annotation, i32)> {
    let (mut body, content) = body.versioned_1(WHAT)?;
    let mut annotation = Annotation {
        kind: AnnotationKind::Text,
        text: content::read(&mut body)?,
        style: body.uuid(WHAT)?,
        overrides: None,
        plane: body.stored_plane(WHAT)?,
        horizontal: Vector2::X,
        scales_text: true,
    };
    let stated = if content >= 1 { body.i32(WHAT)? } else { 0 };
    if content >= 2 {
        annotation.overrides = read_overrides(&mut body)?;
    }
    if content >= 3 {
        annotation.horizontal = body.point2(WHAT)?.to_vector();
    }
    if content >= 4 {
        annotation.scales_text = body.bool(WHAT)?;
    }
    body.finish();
    Ok((annotation, stated))
}

/// Whether there is a style object, and the object.
fn read_overrides(body: &mut Reader<'_>) -> Result<Option<StyleOverrides>> {
    let offset = body.offset();
    let (mut body, _) = body.versioned_1(WHAT)?;
    if !body.version().is_wide() {
        return Err(Error::malformed(offset, WHAT, "archives of this version hold no such annotations"));
    }
    let overrides = if body.bool(WHAT)? {
        Some(StyleOverrides { bytes: ClassObject::read(&mut body)?.to_raw().bytes })
    } else {
        None
    };
    body.finish();
    Ok(overrides)
}

/// Writes the body.
pub(super) fn write(annotation: &Annotation, w: &mut Writer) -> Result<()> {
    // Leaders count their content from 1, the others from 0.
    let content = i32::from(matches!(annotation.kind, AnnotationKind::Leader { .. }));
    w.versioned(1, content, |w| {
        match annotation.dimension() {
            Some(dimension) => w.versioned(1, 1, |w| {
                write_base(annotation, w)?;
                dimension::write(dimension, w)
            })?,
            None => write_base(annotation, w)?,
        }
        write_kind(&annotation.kind, w)
    })
}

fn write_kind(kind: &AnnotationKind, w: &mut Writer) -> Result<()> {
    match kind {
        AnnotationKind::Text => {}
        AnnotationKind::Leader { points } => w.points2(points)?,
        AnnotationKind::Linear { end, line, .. } => {
            w.point2(*end);
            w.point2(*line);
        }
        AnnotationKind::Angular { directions, offsets, arc, .. } => {
            directions.iter().for_each(|d| w.point2(d.to_point()));
            offsets.iter().for_each(|x| w.f64(*x));
            w.point2(*arc);
        }
        AnnotationKind::Radial { on_circle, line, .. } => {
            w.point2(*on_circle);
            w.point2(*line);
        }
        AnnotationKind::Ordinate { direction, point, leader, kinks, .. } => {
            w.i32(*direction);
            w.point2(*point);
            w.point2(*leader);
            kinks.iter().for_each(|x| w.f64(*x));
        }
        AnnotationKind::CentreMark { radius, .. } => w.f64(*radius),
    }
    Ok(())
}

fn write_base(annotation: &Annotation, w: &mut Writer) -> Result<()> {
    w.versioned(1, CONTENT, |w| {
        content::write(&annotation.text, w)?;
        w.uuid(annotation.style);
        w.stored_plane(&annotation.plane);
        w.i32(number_of(&annotation.kind));
        w.versioned(1, 1, |w| {
            w.bool(annotation.overrides.is_some());
            annotation.overrides.iter().for_each(|style| w.chunks(&style.bytes));
            Ok(())
        })?;
        w.point2(annotation.horizontal.to_point());
        w.bool(annotation.scales_text);
        Ok(())
    })
}
