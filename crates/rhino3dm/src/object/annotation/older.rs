//! Annotations of version 6 and later as versions 4 and 5 have them.

use katydid_elementary::Elementary;
use katydid_geometry::{Plane, Point2, Vector2};
use uuid::{Uuid, uuid};

use super::version5::justify;
use super::{Annotation, Annotation5, Annotation5Kind, AnnotationKind, Dimension, plain_text};
use crate::class_object::UserData;
use crate::styles::{Style, Styles};
use crate::version::Version;
use crate::{Result, StoredPlane, class_ids};

/// The user data of dimensions, of angles, and of text with a mask.
const DIMENSION_EXTRA: Uuid = uuid!("8AD5B9FC-0D5C-47FB-ADFD-74C28B6F661E");
const ANGLE_EXTRA: Uuid = uuid!("A68B151F-C778-4A6E-BCB4-23DDD1835677");
const TEXT_EXTRA: Uuid = uuid!("D90490A5-DB86-49F8-BDA1-9080B1F4E976");

/// Kinds by the numbers of version 5.
mod number {
    pub(super) const LINEAR: i32 = 1;
    pub(super) const ALIGNED: i32 = 2;
    pub(super) const ANGULAR: i32 = 3;
    pub(super) const DIAMETER: i32 = 4;
    pub(super) const RADIUS: i32 = 5;
    pub(super) const LEADER: i32 = 6;
    pub(super) const TEXT: i32 = 7;
    pub(super) const ORDINATE: i32 = 8;
}

/// How text stands: as the style says, above the line, in the line.
const AS_STYLE: i32 = 0;
const ABOVE: i32 = 2;
const IN_LINE: i32 = 3;
/// Text whose middle or bottom counts up and down.
const MIDDLE: i32 = 3;
const BOTTOM: i32 = 4;
/// A length that is none.
const TINY: f64 = 1e-12;

/// The older form of an annotation, with the user data that says the rest; nothing for centre marks, which have none.
pub(in crate::object) fn to_older(
    annotation: &Annotation,
    styles: &Styles,
    in_model: bool,
    version: Version,
) -> Result<Option<(Annotation5, Vec<UserData>)>> {
    let (place, style) =
        styles.of_annotation(annotation.style, annotation.overrides.as_ref().map(|own| own.bytes.as_slice()));
    let Some(parts) = Parts::of(annotation, &style) else { return Ok(None) };
    let is_text = matches!(annotation.kind, AnnotationKind::Text);
    // Text in the model takes the style's scale into its height: in version 5 it has another.
    let scale =
        if is_text && in_model && annotation.scales_text && style.scale > 0.0 { style.scale } else { 1.0 };
    let dimension = annotation.dimension();
    let words = dimension.map_or_else(|| annotation.plain_text(), |d| plain_text::of(&d.user_text));
    // Angles of version 5 have their words as a formula only, of which version 4 knows nothing.
    let only_formula = matches!(annotation.kind, AnnotationKind::Angular { .. }) && version.archive >= 5;
    let older = Annotation5 {
        kind: parts.kind,
        number: parts.number,
        text_display: parts.text_display,
        plane: parts.plane,
        points: parts.points,
        text: if only_formula { String::new() } else { words.clone() },
        user_positioned_text: dimension.is_some_and(|d| d.text_moved),
        style: place,
        text_height: style.height * scale,
        justification: if is_text { justification(annotation) } else { 0 },
        scales_text: !is_text || annotation.scales_text,
        text_formula: words,
    };
    let mut extras = Vec::new();
    match (dimension, parts.angle_offsets) {
        (_, Some(offsets)) => extras.push(angle_extra(offsets, version)?),
        (Some(dimension), None) => extras.push(dimension_extra(dimension, version)?),
        (None, None) if is_text && style.mask && version.archive >= 5 => extras.push(mask(&style, version)?),
        _ => {}
    }
    Ok(Some((older, extras)))
}

/// What differs from kind to kind.
struct Parts {
    kind: Annotation5Kind,
    number: i32,
    text_display: i32,
    plane: StoredPlane,
    points: Vec<Point2>,
    /// How far extension lines of angles begin from the apex.
    angle_offsets: Option<[f64; 2]>,
}

impl Parts {
    fn of(annotation: &Annotation, style: &Style) -> Option<Self> {
        let parts = |kind, number, text_display, points| Self {
            kind,
            number,
            text_display,
            plane: annotation.plane,
            points,
            angle_offsets: None,
        };
        let display = style.text_display();
        Some(match &annotation.kind {
            AnnotationKind::Text => parts(Annotation5Kind::Text, number::TEXT, AS_STYLE, Vec::new()),
            AnnotationKind::Leader { points } => {
                let display = if style.text_vertical == BOTTOM { ABOVE } else { IN_LINE };
                parts(Annotation5Kind::Leader, number::LEADER, display, with_landing(points, style))
            }
            AnnotationKind::Linear { dimension, aligned, end, line } => {
                let middle = Point2::new(end.x / 2.0, line.y);
                let points = vec![
                    Point2::ORIGIN,
                    Point2::new(0.0, line.y),
                    *end,
                    Point2::new(end.x, line.y),
                    text_point(dimension).unwrap_or(middle),
                ];
                let number = if *aligned { number::ALIGNED } else { number::LINEAR };
                parts(Annotation5Kind::Linear, number, display, points)
            }
            AnnotationKind::Angular { dimension, directions, offsets, arc, .. } => {
                return angular(
                    annotation,
                    display,
                    dimension,
                    [*directions, [arc.to_vector(); 2]],
                    *offsets,
                );
            }
            AnnotationKind::Radial { dimension, diameter, on_circle, line } => {
                let tail = tail(*on_circle, *line, style);
                let points =
                    vec![Point2::ORIGIN, *on_circle, tail, *line, text_point(dimension).unwrap_or(tail)];
                let number = if *diameter { number::DIAMETER } else { number::RADIUS };
                parts(Annotation5Kind::Radial, number, display, points)
            }
            AnnotationKind::Ordinate { direction, point, leader, kinks, .. } => {
                // Numbers of coordinates begin one lower.
                let kind = Annotation5Kind::Ordinate { direction: direction - 1, kinks: *kinks };
                parts(kind, number::ORDINATE, display, vec![*point, *leader])
            }
            AnnotationKind::CentreMark { .. } => return None,
        })
    }
}

fn text_point(dimension: &Dimension) -> Option<Point2> {
    dimension.text_point.filter(|_| dimension.text_moved)
}

/// The points of a leader, and the end of the piece that leads to its text.
fn with_landing(points: &[Point2], style: &Style) -> Vec<Point2> {
    let mut all = points.to_vec();
    if let Some(last) = points.last().filter(|_| style.has_landing) {
        let before =
            points.len().checked_sub(2).and_then(|place| points.get(place)).unwrap_or(&Point2::ORIGIN);
        let along = *last - *before;
        let length = style.landing * style.scale;
        let ahead = if style.leader_angle == 0 || along.length() <= TINY {
            Vector2::new(if along.x < 0.0 { -1.0 } else { 1.0 }, 0.0)
        } else {
            along / along.length()
        };
        all.push(*last + ahead * length);
    }
    all
}

/// Where the line of a radius ends: beyond its knee by the landing, or by the height of the text.
fn tail(on_circle: Point2, knee: Point2, style: &Style) -> Point2 {
    let length = if style.has_landing { style.landing } else { style.height } * style.scale;
    let sign = if knee.x >= on_circle.x { 1.0 } else { -1.0 };
    Point2::new(knee.x + sign * length, knee.y)
}

/// An angle of version 5 lies in a plane whose x axis is one of its directions, the arc between that and the other.
fn angular(
    annotation: &Annotation,
    text_display: i32,
    dimension: &Dimension,
    [[first, second], [arc, _]]: [[Vector2; 2]; 2],
    offsets: [f64; 2],
) -> Option<Parts> {
    let turn = |from: Vector2, to: Vector2| {
        let angle = (from.x * to.y - from.y * to.x).arctangent_of(from.x * to.x + from.y * to.y);
        if angle < 0.0 { angle + std::f64::consts::TAU } else { angle }
    };
    let [mut from, mut to] = [(first, offsets[0]), (second, offsets[1])];
    if turn(first, arc) > turn(first, second) {
        (from, to) = (to, from);
    }
    let angle = turn(from.0, to.0);
    let frame = annotation.plane.frame;
    let x = from.0 / from.0.length();
    if !(x.x.is_finite() && x.y.is_finite()) {
        return None;
    }
    let x_axis = frame.x_axis * x.x + frame.y_axis * x.y;
    let y_axis = frame.y_axis * x.x - frame.x_axis * x.y;
    let turned = Plane { x_axis, y_axis, ..frame };
    let local = |p: Vector2| Point2::new(p.x * x.x + p.y * x.y, p.y * x.x - p.x * x.y);
    let points = vec![
        text_point(dimension).map_or(Point2::ORIGIN, |p| local(p.to_vector())),
        local(from.0 * from.1),
        local(to.0 * to.1),
        local(arc),
    ];
    Some(Parts {
        kind: Annotation5Kind::Angular { angle, radius: arc.length() },
        number: number::ANGULAR,
        text_display,
        plane: turned.into(),
        points,
        angle_offsets: Some([from.1, to.1]),
    })
}

/// Where text stands from its point, as bits.
fn justification(annotation: &Annotation) -> i32 {
    let horizontal = match annotation.text.horizontal_alignment {
        0 => justify::LEFT,
        1 => justify::CENTRE,
        2 => justify::RIGHT,
        _ => 0,
    };
    let vertical = match annotation.text.vertical_alignment {
        0 => justify::TOP,
        MIDDLE => justify::MIDDLE,
        BOTTOM => justify::BOTTOM,
        _ => 0,
    };
    horizontal | vertical
}

/// User data of openNURBS, as version 5 owns it.
fn owned(mut data: UserData) -> UserData {
    data.application = class_ids::OPENNURBS_5_APPLICATION;
    data
}

fn dimension_extra(dimension: &Dimension, version: Version) -> Result<UserData> {
    let data = UserData::core(DIMENSION_EXTRA, 1, version, |w| {
        w.versioned(1, 2, |w| {
            // What it hangs on, how arrows are placed, and no rectangles.
            w.uuid(Uuid::nil());
            w.i32(0);
            w.i32(0);
            w.f64(dimension.distance_scale);
            w.uuid(dimension.detail);
            Ok(())
        })
    })?;
    Ok(owned(data))
}

fn angle_extra(offsets: [f64; 2], version: Version) -> Result<UserData> {
    let data = UserData::core(ANGLE_EXTRA, 1, version, |w| {
        w.versioned(1, 0, |w| {
            offsets.iter().for_each(|offset| w.f64(*offset));
            Ok(())
        })
    })?;
    Ok(owned(data))
}

fn mask(style: &Style, version: Version) -> Result<UserData> {
    let data = UserData::core(TEXT_EXTRA, 1, version, |w| {
        w.versioned(1, 0, |w| {
            w.uuid(Uuid::nil());
            w.bool(style.mask);
            w.i32(i32::from(style.mask_source == 1));
            w.colour(style.mask_colour);
            // As a multiple of the height.
            w.f64(if style.height > 0.0 { style.mask_border / style.height } else { 0.0 });
            Ok(())
        })
    })?;
    Ok(owned(data))
}
