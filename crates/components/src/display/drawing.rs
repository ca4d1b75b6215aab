//! Display / Dimensions: drawings with hidden lines.

use std::sync::Arc;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Geometry, Kind, Projection, Value, cast};
use katydid_geometry::drawing::{self, DrawingOptions, Drawn, View, Visibility};
use katydid_geometry::{Brep, Curve, Plane, Point3, Rectangle, Vector3};

/// Groups in groups beyond this depth are left out.
const DEEPEST: usize = 100;

/// Draws geometry as it is seen in a view: outlines, edges and curves, the visible ones and those that something hides.
///
/// The curves lie in the world's XY plane: the axes of the view's frame become those of the world. An edge that has the
/// same picture as a nearer one is left out. Points are not drawn. Nothing fills the cut of a clipping plane: what lies
/// behind it is seen through it.
///
/// Types are those of Rhino: Tangent (a smooth surface turns away), Crease (an edge of which only one side is seen),
/// Boundary (a naked edge), Projecting (the end of a face that is seen edge-on), NonSilhouetteCrease (any other edge),
/// NonSilhouetteTangent (a smooth edge), NonSilhouetteSeam, SectionCut (by a clipping plane), and MiscellaneousFeature
/// (a curve that was given).
#[component(
    "96e40f6b-ba46-4102-bf15-ebf90471f4a0",
    name = "Make2D",
    nick = "Make2D",
    at = "Display/Dimensions"
)]
#[output("Visible curves", "V", "The curves that are seen.")]
#[output("Visible index", "Vi", "For each the place in the list of what it is a curve of.")]
#[output("Visible type", "Vt", "What each is.")]
#[output("Hidden curves", "H", "The curves before which something lies.")]
#[output("Hidden index", "Hi", "For each the place in the list of what it is a curve of.")]
#[output("Hidden type", "Ht", "What each is.")]
fn make_2d(
    context: &Context<'_>,
    /// Curves, surfaces, Breps and meshes.
    #[port("Geometry", "G")]
    geometry: List<Geometry>,
    /// What lies on the negative side of such a plane is cut away.
    #[port("Clipping Planes", "C", optional)]
    clipping: List<Plane>,
    /// From where it is seen.
    #[port("View", "V")]
    view: Projection,
    /// Whether smooth edges between faces are drawn.
    #[port("Tangent Edges", "Te", default = false)]
    tangent_edges: bool,
    /// Whether smooth edges where a surface meets itself are drawn.
    #[port("Tangent Seams", "Ts", default = false)]
    tangent_seams: bool,
) -> Result<(Vec<Arc<Curve>>, Vec<i32>, Vec<Arc<str>>, Vec<Arc<Curve>>, Vec<i32>, Vec<Arc<str>>), Message> {
    let mut objects = Vec::new();
    let mut places: Vec<i32> = Vec::new();
    let mut points = 0_usize;
    for (place, Geometry(value)) in geometry.iter().enumerate().filter_map(|(i, v)| Some((i, v?))) {
        context.check()?;
        add(context, &value, &mut objects, &mut points, 0)?;
        places.resize(objects.len(), i32::try_from(place).unwrap_or(i32::MAX));
    }
    if points > 0 {
        context.warn("Points are not drawn");
    }
    let options = DrawingOptions {
        tangent_edges,
        tangent_seams,
        clipping: clipping.present().collect(),
        tolerance: context.tolerance(),
    };
    let view = seen_from(&view)?;
    let stop = context.stop();
    let made = drawing::drawing(&objects, &view, &options, &|| !stop());
    // Why it was stopped is told in the words of the budget.
    context.check()?;
    let made = made.map_err(|e| Message::warning(e.to_string()))?;
    if !made.complete {
        context.warn("A face turns away in so many places that some outlines may be missing");
    }
    context.items(made.curves.len())?;
    let (mut seen, mut hidden) = ((Vec::new(), Vec::new(), Vec::new()), (Vec::new(), Vec::new(), Vec::new()));
    for one in made.curves {
        let list = match one.visibility {
            Visibility::Visible => &mut seen,
            Visibility::Hidden => &mut hidden,
            Visibility::Duplicate => continue,
        };
        list.0.push(Arc::new(one.curve));
        list.1.push(places.get(one.object).copied().unwrap_or(-1));
        list.2.push(Arc::from(one.kind.name()));
    }
    Ok((seen.0, seen.1, seen.2, hidden.0, hidden.1, hidden.2))
}

/// Adds a value to what is drawn.
fn add(
    context: &Context<'_>,
    value: &Value,
    objects: &mut Vec<Drawn>,
    points: &mut usize,
    depth: usize,
) -> Result<(), Message> {
    let to = |kind| cast::value(value, kind, context.rules());
    let solid = |objects: &mut Vec<Drawn>, brep: Result<Arc<Brep>, String>| -> Result<(), Message> {
        objects.push(Drawn::Brep(brep.map_err(Message::warning)?));
        Ok(())
    };
    // What has faces of its own; a surface is such a thing.
    if let Some(brep) = value.brep() {
        return solid(objects, brep);
    }
    match value {
        Value::Group(group) if depth < DEEPEST => {
            for member in group.members.iter().flatten() {
                add(context, member, objects, points, depth + 1)?;
            }
        }
        Value::Point(_) => *points += 1,
        Value::Mesh(mesh) => objects.push(Drawn::Mesh(mesh.clone())),
        _ => match (to(Kind::Curve), to(Kind::Brep).as_ref().and_then(Value::brep), to(Kind::Mesh)) {
            (Some(Value::Curve(curve)), _, _) => objects.push(Drawn::Curve((*curve).clone())),
            (_, Some(brep), _) => return solid(objects, brep),
            (_, _, Some(Value::Mesh(mesh))) => objects.push(Drawn::Mesh(mesh)),
            _ => {
                return Err(Message::error(format!(
                    "A {} cannot be drawn: only curves, surfaces, Breps and meshes",
                    value.kind().name()
                )));
            }
        },
    }
    Ok(())
}

fn seen_from(view: &Projection) -> Result<View, Message> {
    let made = match view.camera {
        None => View::parallel(view.plane),
        Some(camera) => View::perspective(camera, view.plane),
    };
    made.map_err(|e| Message::error(e.to_string()))
}

/// The view straight onto a rectangle, from the side to which its normal points.
///
/// The origin and the axes of the rectangle's plane become those of the drawing; its size does not matter.
#[component(
    "3fc08088-d75d-43bc-83cc-7a654f156cb7",
    name = "Make2D Parallel View",
    nick = "M2D Parallel",
    at = "Display/Dimensions"
)]
#[output("View", "V", "The view, for Make2D.")]
fn parallel_view(
    /// The frame of the picture.
    #[port("Projection", "P")]
    projection: Rectangle,
) -> Result<Projection, Message> {
    let made = Projection { plane: projection.plane, camera: None };
    seen_from(&made)?;
    Ok(made)
}

/// The view from a camera through a frame, on whose plane the picture lies.
///
/// The origin and the axes of the frame's plane become those of the drawing; what lies in that plane is drawn as large as
/// it is, what is farther away smaller. What lies behind the camera is not drawn. A camera in the plane is an error.
#[component(
    "33359c6d-984e-42f3-a869-0c3364ab33b6",
    name = "Make2D Perspective View",
    nick = "M2D Perspective",
    at = "Display/Dimensions"
)]
#[output("View", "V", "The view, for Make2D.")]
fn perspective_view(
    /// The camera.
    #[port("Camera", "C")]
    camera: Point3,
    /// The frame of the picture.
    #[port("Frame", "F")]
    frame: Rectangle,
) -> Result<Projection, Message> {
    let made = Projection { plane: frame.plane, camera: Some(camera) };
    seen_from(&made)?;
    Ok(made)
}

/// A standard view by its name: Top, Bottom, Front, Back, Right or Left.
///
/// There is no Rhino document whose views could be looked up: the six names, in capitals or not, stand for the parallel
/// views that Rhino gives them at first, about the world's origin. Any other name is an error, Perspective among them: its
/// camera is known to no one but the document.
#[component(
    "4ac24770-e38b-4363-be38-551a3b134707",
    name = "Make2D Rhino View",
    nick = "M2D Rhino",
    at = "Display/Dimensions"
)]
#[output("View", "V", "The view, for Make2D.")]
fn rhino_view(
    /// The name of the view.
    #[port("Name", "N")]
    name: Arc<str>,
    /// Whether the clipping planes of the view cut; a standard view has none, and it changes nothing.
    #[port("Clip", "C", default = false)]
    _clip: bool,
) -> Result<Projection, Message> {
    let (x, y) = match name.trim().to_lowercase().as_str() {
        "top" => (Vector3::X, Vector3::Y),
        "bottom" => (Vector3::X, -Vector3::Y),
        "front" => (Vector3::X, Vector3::Z),
        "back" => (-Vector3::X, Vector3::Z),
        "right" => (Vector3::Y, Vector3::Z),
        "left" => (-Vector3::Y, Vector3::Z),
        "perspective" => {
            return Err(Message::error(
                "The camera of the view Perspective is in a Rhino document, and there is none: give it with Make2D \
                 Perspective View",
            ));
        }
        _ => {
            return Err(Message::error(format!(
                "There is no view \"{name}\": without a Rhino document there are Top, Bottom, Front, Back, Right and Left"
            )));
        }
    };
    let plane = Plane::from_axes(Point3::ORIGIN, x, y).map_err(|e| Message::error(e.to_string()))?;
    Ok(Projection { plane, camera: None })
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Projection, Value};
    use katydid_geometry::{Box3, Circle, Curve, Interval, Line, Plane, Point3, Rectangle};

    fn cube() -> Box3 {
        let side = Interval::new(0.0, 2.0);
        Box3 { plane: Plane::XY, x: side, y: side, z: side }
    }

    fn named(name: &str) -> Trial {
        Trial::of("Make2D Rhino View").item(name)
    }

    #[test]
    fn a_box_from_above() {
        let trial =
            || Trial::of("Make2D").list([cube()]).list(Vec::<Plane>::new()).item(Projection::default());
        assert_eq!(trial().texts(1), ["{0;0}: 0, 0, 0, 0"]);
        assert_eq!(trial().texts(2), ["{0;0}: Projecting, Projecting, Projecting, Projecting"]);
        assert_eq!(trial().texts(4), ["{0;0}:"]);
    }

    #[test]
    fn standard_views() {
        for (name, point) in [
            ("Top", Point3::new(1.0, 2.0, 3.0)),
            ("front", Point3::new(1.0, 3.0, -2.0)),
            ("Right", Point3::new(2.0, 3.0, 1.0)),
            ("LEFT", Point3::new(-2.0, 3.0, -1.0)),
            ("Back", Point3::new(-1.0, 3.0, 2.0)),
            ("Bottom", Point3::new(1.0, -2.0, -3.0)),
        ] {
            let out = named(name).run();
            let found = out.outputs[0].branches().next().and_then(|b| b.get(0));
            let Some(Value::Projection(view)) = found else { panic!("{name}") };
            let [x, y, z] = view.plane.coordinates(Point3::new(1.0, 2.0, 3.0));
            assert!(Point3::new(x, y, z).distance_to(point) < 1e-12, "{name}");
        }
        assert!(named("Perspective").message().contains("Perspective View"));
        assert!(named("Kitchen").message().contains("Kitchen"));
    }

    #[test]
    fn views_of_rectangles() {
        let frame = Rectangle { plane: Plane::YZ, x: Interval::new(0.0, 1.0), y: Interval::new(0.0, 1.0) };
        assert_eq!(Trial::of("Make2D Parallel View").item(frame).texts(0), ["{0}: Parallel Projection"]);
        let far = Trial::of("Make2D Perspective View").item(Point3::new(9.0, 0.0, 0.0)).item(frame);
        assert_eq!(far.texts(0), ["{0}: Perspective Projection"]);
        let flat = Trial::of("Make2D Perspective View").item(Point3::new(0.0, 5.0, 0.0)).item(frame);
        assert!(flat.message().contains("picture plane"));
    }

    #[test]
    fn curves_keep_their_place_in_the_list() {
        let circle: Curve = Circle::new(Plane::XY, 1.0).unwrap().into();
        let line: Curve = Line::new(Point3::new(5.0, 0.0, 0.0), Point3::new(6.0, 0.0, 1.0)).into();
        let trial = || {
            Trial::of("Make2D")
                .list([Value::from(circle.clone()), Value::from(Point3::ORIGIN), Value::from(line.clone())])
                .list(Vec::<Plane>::new())
                .item(Projection { plane: Plane::XY, camera: None })
        };
        assert_eq!(trial().texts(1), ["{0;0}: 0, 2"]);
        assert_eq!(trial().texts(2), ["{0;0}: MiscellaneousFeature, MiscellaneousFeature"]);
        assert_eq!(trial().message(), "Points are not drawn");
    }
}
