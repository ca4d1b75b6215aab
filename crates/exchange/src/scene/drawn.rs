//! Text, dots and hatches of a model as what drawings show of them.

use std::collections::HashMap;

use katydid_3dm::{
    Annotation, Annotation2, Annotation2Kind, Annotation5, Annotation5Kind, AnnotationKind, Hatch, HatchFill,
    Model, StoredPlane, TextDot,
};
use katydid_elementary::Elementary;
use katydid_geometry::{Plane, Vector3, Xform};
use uuid::Uuid;

use super::{Fill, Label, LabelSize, Region, Shape};

type Told<T> = std::result::Result<T, String>;

const NO_TEXT: &str = "it has no text";
const NO_SIZE: &str = "its text has no size";
const DIMENSION: &str = "dimensions and leaders are not supported";

/// What annotations and hatches look up in the tables of a model.
pub(super) struct Styles {
    /// The heights of text of dimension styles.
    heights: HashMap<Uuid, f64>,
    /// The hatch patterns, by their places in the table.
    fills: HashMap<i32, Fill>,
}

impl Styles {
    pub(super) fn of(model: &Model) -> Self {
        let heights = model.dimension_styles().into_iter().map(|style| (style.id, style.text_height));
        let fill = |fill: &HatchFill| if *fill == HatchFill::Solid { Fill::Solid } else { Fill::Pattern };
        let fills = (0..).zip(&model.hatch_patterns).map(|(place, pattern)| (place, fill(&pattern.fill)));
        Self { heights: heights.collect(), fills: fills.collect() }
    }

    /// The height of letters of a style. An annotation that names none has openNURBS's own style, whose letters are 1 high.
    fn height(&self, style: Uuid) -> Option<f64> {
        self.heights.get(&style).copied().or(style.is_nil().then_some(1.0))
    }

    /// Text of version 6 and later. A style's own numbers count, not what the text changes of them.
    pub(super) fn text(&self, annotation: &Annotation) -> Told<Shape> {
        if annotation.kind != AnnotationKind::Text {
            return Err(DIMENSION.into());
        }
        let height = self.height(annotation.style).ok_or(NO_SIZE)?;
        let text = annotation.plain_text();
        let content = &annotation.text;
        let lines = text.lines().count();
        let across = match content.horizontal_alignment {
            1 => 0.5,
            2 => 1.0,
            _ => 0.0,
        };
        // Of several lines the first and the last take an equal share each.
        let line = 1.0 / lines.max(1) as f64;
        let upward = match content.vertical_alignment {
            1 => 1.0 - line / 2.0,
            2 => 1.0 - line,
            3 => 0.5,
            4 | 5 => 0.0,
            6 => line / 2.0,
            _ => 1.0,
        };
        let mut label = label(text, &annotation.plane, height, [across, upward]);
        let (sin, cos) = content.rotation.sine_cosine();
        let [x, y] = label.axes;
        label.axes = [x * cos + y * sin, y * cos - x * sin];
        shown(label)
    }

    /// A hatch by its boundaries.
    pub(super) fn hatch(&self, hatch: &Hatch) -> Told<Shape> {
        let plane = checked(&hatch.plane)?;
        let to_world = Xform::plane_to_world(&plane);
        let boundaries = hatch.loops.iter().map(|one| {
            let curve = one.curve.to_curve().map_err(|error| error.to_string())?;
            curve.transformed(&to_world).map_err(|error| error.to_string())
        });
        let boundaries = boundaries.collect::<Told<Vec<_>>>()?;
        if boundaries.is_empty() {
            return Err("it has no boundary".into());
        }
        let fill = self.fills.get(&hatch.pattern).copied().unwrap_or_default();
        Ok(Shape::Region(Region { boundaries, fill }))
    }
}

/// Text of versions 4 and 5.
pub(super) fn text_5(annotation: &Annotation5) -> Told<Shape> {
    const CENTRE: i32 = 2;
    const RIGHT: i32 = 4;
    const MIDDLE: i32 = 1 << 17;
    const TOP: i32 = 1 << 18;
    if annotation.kind != Annotation5Kind::Text {
        return Err(DIMENSION.into());
    }
    let has = |bit: i32| annotation.justification & bit != 0;
    let across = if has(RIGHT) {
        1.0
    } else if has(CENTRE) {
        0.5
    } else {
        0.0
    };
    let upward = if has(TOP) {
        1.0
    } else if has(MIDDLE) {
        0.5
    } else {
        0.0
    };
    let mut label =
        label(annotation.text.clone(), &annotation.plane, annotation.text_height, [across, upward]);
    if let Some(point) = annotation.points.first() {
        label.point = label.point + label.axes[0] * point.x + label.axes[1] * point.y;
    }
    shown(label)
}

/// Text of version 2.
pub(super) fn text_2(annotation: &Annotation2) -> Told<Shape> {
    let Annotation2Kind::Text { font, height, .. } = &annotation.kind else { return Err(DIMENSION.into()) };
    let mut label = label(annotation.text().to_owned(), &annotation.plane, *height, [0.0, 0.0]);
    label.font.clone_from(font);
    if let Some(point) = annotation.points.first() {
        label.point = label.point + label.axes[0] * point.x + label.axes[1] * point.y;
    }
    shown(label)
}

/// A dot: its text about its point.
pub(super) fn dot(dot: &TextDot) -> Told<Shape> {
    shown(Label {
        text: dot.text.clone(),
        point: dot.point,
        axes: [Vector3::X, Vector3::Y],
        size: LabelSize::Screen(f64::from(dot.height.max(1))),
        across: 0.5,
        upward: 0.5,
        font: dot.font.clone(),
    })
}

fn label(text: String, plane: &StoredPlane, height: f64, [across, upward]: [f64; 2]) -> Label {
    let Plane { origin, x_axis, y_axis, .. } = plane.frame;
    let axes = [x_axis, y_axis];
    Label { text, point: origin, axes, size: LabelSize::Units(height), across, upward, font: String::new() }
}

fn shown(label: Label) -> Told<Shape> {
    if label.text.trim().is_empty() {
        return Err(NO_TEXT.into());
    }
    if !label.is_finite() {
        return Err(NO_SIZE.into());
    }
    Ok(Shape::Text(label))
}

/// The frame of a stored plane, whose axes nobody has looked at.
fn checked(plane: &StoredPlane) -> Told<Plane> {
    let frame = &plane.frame;
    Plane::from_axes(frame.origin, frame.x_axis, frame.y_axis).map_err(|error| error.to_string())
}
