//! Annotations of all generations, text dots, lights, blocks and clipping planes.

use katydid_3dm::{
    Annotation, Annotation2, Annotation5, AnnotationKind, BlockReference, ClippingPlane, Dimension, Hatch,
    Light, TextDot,
};
use katydid_geometry::{Plane, Point2};
use serde_json::{Value, json};

use crate::numbers::{plane, point, vector};
use crate::surface::surface;

fn on(plane: &Plane, p: Point2) -> [f64; 3] {
    point(plane.at(p.x, p.y, 0.0))
}

pub(crate) fn annotation(a: &Annotation) -> Value {
    let frame = &a.plane.frame;
    let at = |p: Point2| on(frame, p);
    let text_point = a.dimension().filter(|d| d.text_moved).and_then(|d| d.text_point).map(at);
    let points = match &a.kind {
        AnnotationKind::Text => json!({}),
        AnnotationKind::Leader { points } => {
            json!({"points": points.iter().map(|p| at(*p)).collect::<Vec<_>>()})
        }
        AnnotationKind::Linear { end, line, .. } => {
            json!({"defpt1": point(frame.origin), "defpt2": at(*end),
                "arrowpt1": at(Point2::new(0.0, line.y)), "arrowpt2": at(Point2::new(end.x, line.y)),
                "dimline": at(*line)})
        }
        AnnotationKind::Angular { directions: [a, b], offsets, arc, .. } => {
            let radius = arc.to_vector().length();
            json!({"centerpt": point(frame.origin), "defpt1": at((*a * offsets[0]).to_point()),
                "defpt2": at((*b * offsets[1]).to_point()), "arrowpt1": at((*a * radius).to_point()),
                "arrowpt2": at((*b * radius).to_point()), "dimlinept": at(*arc)})
        }
        AnnotationKind::Radial { on_circle, line, .. } => {
            json!({"centerpt": point(frame.origin), "radiuspt": at(*on_circle), "dimlinept": at(*line)})
        }
        AnnotationKind::Ordinate { point: p, leader, .. } => {
            json!({"basept": point(frame.origin), "defpt": at(*p), "leaderpt": at(*leader)})
        }
        AnnotationKind::CentreMark { radius, .. } => json!({"radius": radius}),
    };
    json!({"plain_text": a.plain_text(), "rich_text": a.text.rich_text, "style": a.style.to_string(),
        "plane": plane(frame), "wrapped": a.text.wrapped, "rotation": a.text.rotation, "points": points,
        "text_point": text_point, "user_text": a.dimension().map(|d: &Dimension| d.user_text.clone()),
        "overrides": a.overrides.is_some()})
}

pub(crate) fn annotation_5(a: &Annotation5) -> Value {
    // Text of archives before version 5 stands on its point; newer readers let it hang from one above.
    let stands = a.number == 7 && a.justification == 0;
    let frame = a.plane.frame;
    let hung = if stands { frame.with_origin(frame.at(0.0, a.text_height, 0.0)) } else { frame };
    json!({"plain_text": a.text, "formula": a.text_formula, "plane": plane(&hung),
        "flat_points": a.points.iter().map(|p| on(&a.plane.frame, *p)).collect::<Vec<_>>(),
        "height": a.text_height, "justification": a.justification})
}

pub(crate) fn annotation_2(a: &Annotation2) -> Value {
    json!({"plain_text": a.text(), "stored_plane": plane(&a.plane.frame),
        "flat_points": a.points.iter().map(|p| on(&a.plane.frame, *p)).collect::<Vec<_>>()})
}

pub(crate) fn text_dot(dot: &TextDot) -> Value {
    json!({"point": point(dot.point), "text": dot.text, "secondary": dot.secondary_text, "font": dot.font,
        "height": dot.height})
}

pub(crate) fn light(light: &Light) -> Value {
    json!({"style": format!("{:?}", light.style), "on": light.on, "name": light.name,
        "intensity": light.intensity, "watts": light.watts, "location": point(light.location),
        "direction": vector(light.direction), "length": vector(light.length), "width": vector(light.width),
        "spot_angle": light.spot_angle.to_radians(), "spot_exponent": light.spot_exponent,
        "hot_spot": light.hot_spot, "shadow": light.shadow_intensity, "attenuation": vector(light.attenuation),
        "ambient": light.ambient, "diffuse": light.diffuse, "specular": light.specular})
}

pub(crate) fn block_reference(block: &BlockReference) -> Value {
    json!({"definition": block.definition.to_string(), "transform": block.transform.rows})
}

pub(crate) fn clipping_plane(clipping: &ClippingPlane) -> Value {
    let surface = clipping.surface().map(|s| surface(&s.into()));
    json!({"plane": plane(&clipping.plane.frame), "enabled": clipping.enabled, "depth": clipping.depth,
        "views": clipping.viewports.len(), "surface": surface.ok()})
}

pub(crate) fn hatch(hatch: &Hatch) -> Value {
    json!({"plane": plane(&hatch.plane.frame), "scale": hatch.scale, "rotation": hatch.rotation,
        "pattern": hatch.pattern, "loops": hatch.loops.len(), "base_point": on(&hatch.plane.frame, hatch.base_point)})
}
