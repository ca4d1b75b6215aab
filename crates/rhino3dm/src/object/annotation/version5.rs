//! The annotation classes of versions 4 and 5.
//!
//! Archives before version 5 hold them bare; later ones wrap them in chunks and add to them.

use katydid_geometry::Point2;
use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::object::major_1;
use crate::version::Version;
use crate::{Result, StoredPlane, class_ids};

/// An annotation of version 4 or 5.
#[derive(Debug, Clone, PartialEq)]
pub struct Annotation5 {
    /// What it is, with what only that kind has.
    pub kind: Annotation5Kind,
    /// The kind by its number: 1 linear, 2 aligned, 3 angular, 4 diameter, 5 radius, 6 leader, 7 text, 8 ordinate.
    pub number: i32,
    /// How the text of dimensions stands: 0 as the style says, 1 horizontal to the view, 2 above the line, 3 in it.
    pub text_display: i32,
    /// The plane it is drawn in.
    pub plane: StoredPlane,
    /// Its points in coordinates of the plane; which is which depends on the kind.
    pub points: Vec<Point2>,
    /// The text.
    pub text: String,
    /// Whether the user placed the text.
    pub user_positioned_text: bool,
    /// The number of its text style (text) or dimension style (all others).
    pub style: i32,
    /// The height of the text.
    pub text_height: f64,
    /// How the text stands from its point, as bits: 1 left, 2 centre, 4 right, 2^16 bottom, 2^17 middle, 2^18 top.
    /// 0 in archives before version 5.
    pub justification: i32,
    /// Whether the text is scaled with the model's annotation scale.
    pub scales_text: bool,
    /// The text with fields that are computed.
    pub text_formula: String,
}

/// What an annotation of version 4 or 5 is.
#[derive(Debug, Clone, PartialEq)]
pub enum Annotation5Kind {
    /// Text.
    Text,
    /// An arrow through points.
    Leader,
    /// A distance.
    Linear,
    /// An angle.
    Angular {
        /// The angle in radians.
        angle: f64,
        /// The radius of the dimension arc.
        radius: f64,
    },
    /// A radius or diameter.
    Radial,
    /// A coordinate.
    Ordinate {
        /// Which coordinate: 0 is x, 1 is y, −1 the one that the points suggest.
        direction: i32,
        /// How far from its end the leader bends, twice.
        kinks: [f64; 2],
    },
}

impl Annotation5 {
    /// Whether it is text, whose style is a text style.
    fn is_text(&self) -> bool {
        self.number == TEXT_NUMBER
    }
}

/// How text stands from its point, as bits.
pub(super) mod justify {
    pub(in super::super) const LEFT: i32 = 1;
    pub(in super::super) const CENTRE: i32 = 2;
    pub(in super::super) const RIGHT: i32 = 4;
    pub(in super::super) const BOTTOM: i32 = 1 << 16;
    pub(in super::super) const MIDDLE: i32 = 1 << 17;
    pub(in super::super) const TOP: i32 = 1 << 18;
}

const WHAT: &str = "annotation of version 5";
const TEXT_NUMBER: i32 = 7;
/// Text that hangs from its point, to the right of it.
const TOP_LEFT: i32 = justify::TOP | justify::LEFT;
/// openNURBS wraps them in chunks since then.
const WRAPPED_SINCE: u32 = 200_710_180;
/// What stands for no bend.
const UNSET: f64 = -1.234_321_012_343_21e308;

/// Whether the classes are wrapped in chunks.
fn is_wrapped(version: Version) -> bool {
    version.archive >= 5 && version.opennurbs >= WRAPPED_SINCE
}

/// Whether a class is an annotation of version 4 or 5.
pub(in crate::object) fn is_version_5(class: Uuid) -> bool {
    matches!(
        class,
        class_ids::TEXT_5
            | class_ids::LEADER_5
            | class_ids::LINEAR_DIMENSION_5
            | class_ids::ANGULAR_DIMENSION_5
            | class_ids::RADIAL_DIMENSION_5
            | class_ids::ORDINATE_DIMENSION_5
    )
}

/// The class under which an annotation is written.
pub(in crate::object) fn class_of(annotation: &Annotation5) -> Uuid {
    match annotation.kind {
        Annotation5Kind::Text => class_ids::TEXT_5,
        Annotation5Kind::Leader => class_ids::LEADER_5,
        Annotation5Kind::Linear => class_ids::LINEAR_DIMENSION_5,
        Annotation5Kind::Angular { .. } => class_ids::ANGULAR_DIMENSION_5,
        Annotation5Kind::Radial => class_ids::RADIAL_DIMENSION_5,
        Annotation5Kind::Ordinate { .. } => class_ids::ORDINATE_DIMENSION_5,
    }
}

/// Reads the body of an annotation class.
pub(in crate::object) fn read(class: Uuid, body: &mut Reader<'_>) -> Result<Annotation5> {
    if class == class_ids::ORDINATE_DIMENSION_5 {
        return read_ordinate(body);
    }
    if !is_wrapped(body.version()) {
        return read_parts(class, body);
    }
    let (mut body, _) = body.versioned_1(WHAT)?;
    let annotation = read_parts(class, &mut body)?;
    body.finish();
    Ok(annotation)
}

/// What all have, then what the class adds.
fn read_parts(class: Uuid, body: &mut Reader<'_>) -> Result<Annotation5> {
    let base = read_base(body)?;
    let kind = match class {
        class_ids::TEXT_5 => Annotation5Kind::Text,
        class_ids::LEADER_5 => Annotation5Kind::Leader,
        class_ids::LINEAR_DIMENSION_5 => Annotation5Kind::Linear,
        class_ids::ANGULAR_DIMENSION_5 => {
            Annotation5Kind::Angular { angle: body.f64(WHAT)?, radius: body.f64(WHAT)? }
        }
        _ => Annotation5Kind::Radial,
    };
    Ok(Annotation5 { kind, ..base })
}

/// Ordinates have been wrapped in two chunks from the first.
fn read_ordinate(body: &mut Reader<'_>) -> Result<Annotation5> {
    let (mut body, minor) = body.versioned_1(WHAT)?;
    let (mut inner, _) = body.versioned_1(WHAT)?;
    let base = read_base(&mut inner)?;
    inner.finish();
    let direction = body.i32(WHAT)?;
    let kinks = if minor >= 1 { [body.f64(WHAT)?, body.f64(WHAT)?] } else { [UNSET; 2] };
    body.finish();
    Ok(Annotation5 { kind: Annotation5Kind::Ordinate { direction, kinks }, ..base })
}

/// What all annotations have; the kind is text for now.
fn read_base(body: &mut Reader<'_>) -> Result<Annotation5> {
    if !is_wrapped(body.version()) {
        major_1(body, WHAT)?;
        return read_fields(body);
    }
    let (mut body, minor) = body.versioned_1(WHAT)?;
    let mut annotation = read_fields(&mut body)?;
    annotation.justification = body.i32(WHAT)?;
    if minor >= 1 {
        annotation.scales_text = body.bool(WHAT)?;
    }
    if minor >= 2 {
        annotation.text_formula = body.string(WHAT)?;
    }
    if minor >= 3 {
        let [text_style, dimension_style] = [body.i32(WHAT)?, body.i32(WHAT)?];
        let own = if annotation.is_text() { text_style } else { dimension_style };
        // Where the two places disagree, the first that names a style counts.
        if own != annotation.style && own >= 0 {
            annotation.style = own;
        }
    }
    body.finish();
    Ok(annotation)
}

/// The fields that were there from the first.
fn read_fields(body: &mut Reader<'_>) -> Result<Annotation5> {
    Ok(Annotation5 {
        kind: Annotation5Kind::Text,
        number: body.i32(WHAT)?,
        text_display: body.i32(WHAT)?,
        plane: body.stored_plane(WHAT)?,
        points: body.points2(WHAT)?,
        text: body.string(WHAT)?,
        user_positioned_text: body.i32(WHAT)? != 0,
        style: body.i32(WHAT)?,
        text_height: body.f64(WHAT)?,
        justification: 0,
        scales_text: false,
        text_formula: String::new(),
    })
}

/// Writes the body.
pub(in crate::object) fn write(annotation: &Annotation5, w: &mut Writer) -> Result<()> {
    if let Annotation5Kind::Ordinate { direction, kinks } = annotation.kind {
        return w.versioned(1, 1, |w| {
            w.versioned(1, 0, |w| write_base(annotation, w))?;
            w.i32(direction);
            kinks.into_iter().for_each(|x| w.f64(x));
            Ok(())
        });
    }
    if is_wrapped(w.version()) {
        w.versioned(1, 0, |w| write_parts(annotation, w))
    } else {
        write_parts(annotation, w)
    }
}

fn write_parts(annotation: &Annotation5, w: &mut Writer) -> Result<()> {
    write_base(annotation, w)?;
    if let Annotation5Kind::Angular { angle, radius } = annotation.kind {
        w.f64(angle);
        w.f64(radius);
    }
    Ok(())
}

fn write_base(annotation: &Annotation5, w: &mut Writer) -> Result<()> {
    if !is_wrapped(w.version()) {
        w.packed_version(1, 0);
        return write_fields(annotation, &standing_plane(annotation), &hard_returns(&annotation.text), w);
    }
    w.versioned(1, 3, |w| {
        write_fields(annotation, &annotation.plane, &annotation.text, w)?;
        w.i32(annotation.justification);
        w.bool(annotation.scales_text);
        w.string(&annotation.text_formula)?;
        let none = -1;
        let [text_style, dimension_style] =
            if annotation.is_text() { [annotation.style, none] } else { [none, annotation.style] };
        w.i32(text_style);
        w.i32(dimension_style);
        Ok(())
    })
}

fn write_fields(annotation: &Annotation5, plane: &StoredPlane, text: &str, w: &mut Writer) -> Result<()> {
    w.i32(annotation.number);
    w.i32(annotation.text_display);
    w.stored_plane(plane);
    w.points2(&annotation.points)?;
    w.string(text)?;
    w.i32(i32::from(annotation.user_positioned_text));
    w.i32(annotation.style);
    w.f64(annotation.text_height);
    Ok(())
}

/// The plane where text stands on its point, as in archives before version 5: readers take it to hang from a point
/// that lies its height above. Text that neither hangs nor stands to the right of its point is left where it is.
fn standing_plane(annotation: &Annotation5) -> StoredPlane {
    if annotation.number != TEXT_NUMBER || annotation.justification != TOP_LEFT {
        return annotation.plane;
    }
    let frame = annotation.plane.frame;
    frame.with_origin(frame.at(0.0, -annotation.text_height, 0.0)).into()
}

/// Every line end as the pair of characters that version 4 knows; version 5 marks wrapping by one of them.
fn hard_returns(text: &str) -> String {
    text.replace("\r\n", "\n").replace('\r', "\n").replace('\n', "\r\n")
}

#[cfg(test)]
mod tests {
    use super::hard_returns;

    #[test]
    fn line_ends_become_pairs() {
        assert_eq!(hard_returns("a\nb\r\nc\rd"), "a\r\nb\r\nc\r\nd");
        assert_eq!(hard_returns("a\r\n\r\nb"), "a\r\n\r\nb");
    }
}
