//! Breps, meshed and drawn with their edges; and what is kept as a program wrote it, drawn by the meshes that it
//! brought.

use std::sync::Arc as Shared;
use std::time::Duration;

use katydid_3dm::{Hatch, Limits, Model, ModelObject, Object, RawObject};
use katydid_exchange::{Label, LabelSize, Scene as Exchanged, Shape};
use katydid_geometry::{Brep, Curve, MeshSettings, Plane, Point3, Xform};
use web_time::Instant;

use crate::display::hatches;
use crate::{Facets, Form, Place, leader, tessellated};

/// Edges stray from their curves by this part of their size at most.
const SMOOTH: f64 = 5e-4;

/// A brep that takes longer than this to mesh is drawn by its edges.
const WAIT: Duration = Duration::from_secs(10);

/// A brep, shaded and with its edges; by its edges alone when it cannot be meshed.
pub(crate) fn of_brep(brep: &Brep) -> Result<Form, String> {
    let since = Instant::now();
    let mesh = brep.mesh_unless(&MeshSettings::default(), &|| since.elapsed() > WAIT);
    let mesh =
        mesh.and_then(|mesh| mesh.to_mesh()).map_err(|error| format!("a Brep cannot be meshed: {error}"))?;
    let edges = (0..brep.edges().len()).filter_map(|edge| brep.edge_as_curve(edge).ok().flatten());
    Ok(Form::Surface(Shared::new(Facets::made(mesh, edges.map(|edge| line(&edge)).collect()))))
}

/// The forms of a kept object.
pub(crate) fn of(raw: &RawObject) -> Result<Vec<Form>, String> {
    let class = raw.class_name();
    let object =
        raw.parse(&Limits::default()).map_err(|error| format!("a {class} cannot be read: {error}"))?;
    if let Object::Brep(brep) = &object
        && brep.render_meshes.iter().flatten().next().is_none()
        && let Ok(form) = of_brep(&brep.brep)
    {
        return Ok(vec![form]);
    }
    if let Object::Annotation(annotation) = &object
        && let Some(forms) = leader::of(annotation)
    {
        return Ok(forms);
    }
    let filling = match &object {
        Object::Hatch(hatch) => filling(hatch),
        _ => Vec::new(),
    };
    let model = Model { objects: vec![ModelObject::from(object)], ..Model::default() };
    let exchanged = Exchanged::from_model(&model);
    if exchanged.things.is_empty() {
        let why = exchanged.left_out.first().map(|left| format!(": {left}")).unwrap_or_default();
        return Err(format!("a {class} is kept whole, but cannot be drawn yet{why}"));
    }
    Ok(exchanged.things.into_iter().flat_map(|thing| forms(thing.shape)).chain(filling).collect())
}

/// The lines of a hatch's pattern, drawn as the Pattern Hatch component draws them: what a pattern looks like stands in
/// the model, and only its number is kept with the hatch.
fn filling(hatch: &Hatch) -> Vec<Form> {
    let to_world = Xform::plane_to_world(&hatch.plane.frame);
    let boundaries =
        hatch.loops.iter().filter_map(|own| own.curve.to_curve().ok()?.transformed(&to_world).ok());
    let boundaries: Vec<Shared<Curve>> = boundaries.map(Shared::new).collect();
    let lines = hatches::lines(&boundaries, hatch.pattern, hatch.scale, hatch.rotation);
    lines.into_iter().map(|ends| Form::Lines(ends.to_vec())).collect()
}

fn forms(shape: Shape) -> Vec<Form> {
    match shape {
        Shape::Points(set) => set.points.into_iter().map(Form::Point).collect(),
        Shape::Curve(curve) => vec![Form::Curve(Shared::new(curve))],
        Shape::Mesh(mesh) => vec![Form::Mesh(Shared::new(mesh))],
        Shape::Region(region) => {
            region.boundaries.into_iter().map(|curve| Form::Curve(Shared::new(curve))).collect()
        }
        Shape::Text(label) => writing(label).into_iter().collect(),
        Shape::Brep(brep) => {
            let size = brep.bounds_of_faces().map_or(1.0, |bounds| bounds.diagonal().length());
            forms(Shape::of_brep(&brep, SMOOTH * size))
        }
        Shape::Faces { facets: Some(mesh), edges } => {
            let borders = edges.iter().map(line).collect();
            vec![Form::Surface(Shared::new(Facets::made(mesh, borders)))]
        }
        Shape::Faces { facets: None, edges } => {
            edges.into_iter().map(|edge| Form::Curve(Shared::new(edge))).collect()
        }
    }
}

/// A text where it stands; none whose directions make no plane.
fn writing(label: Label) -> Option<Form> {
    let Label { text, point: at, axes: [right, up], .. } = label;
    let third = |share: f64| (share * 2.0).round().clamp(0.0, 2.0) as i32;
    match label.size {
        LabelSize::Screen(size) => Some(Form::Tag { at, text, size, place: Place::Beside }),
        LabelSize::Units(size) => Some(Form::Writing {
            plane: Plane::from_points(at, at + right, at + up).ok()?,
            text,
            size,
            // Rows of three from the top left.
            justification: 1 + third(label.across) + 3 * (2 - third(label.upward)),
        }),
    }
}

fn line(edge: &Curve) -> Vec<Point3> {
    tessellated(edge, SMOOTH * edge.bounding_box().diagonal().length())
}
