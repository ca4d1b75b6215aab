//! Rhino / Annotation: notes in a model.

use std::sync::Arc;

use katydid_3dm::{Annotation, AnnotationKind, Limits, Object, StoredPlane, TextContent};
use katydid_component::{Context, Message, component};
use katydid_data::{Content, Value};
use katydid_geometry::{Curve, Line, Plane, Point2, Point3, PolylineCurve, PolylineLimits, Vector2, Vector3};
use uuid::Uuid;

use super::{object_of, unfit};

/// Makes a leader, an arrow with a text at its end, or takes one apart and puts other parts in the place of its own.
///
/// An input without data leaves what the leader has. A leader made anew needs a curve and a text; it lies in the plane
/// given, else in that of the curve, seen from above, else in the XY plane. The curve runs from the tip of the arrow to the text, and is
/// drawn into the plane; one that is not straight is taken in pieces. The leader has the model's own style of
/// annotations.
#[component(
    "c9b4ad52-1e01-4317-bbde-3ababcc31bea",
    name = "Leader",
    nick = "Leader",
    at = "Rhino/Annotation"
)]
#[output("Leader", "L", "The leader.", kind = Generic)]
#[output("Plane", "P", "The plane it lies in.")]
#[output("Curve", "C", "Its curve, from the tip to the text.")]
#[output("Text", "T", "Its text, without formatting.")]
fn leader(
    context: &Context<'_>,
    /// A leader to start from, or an object of a model that is one.
    #[port("Leader", "L", optional)]
    leader: Option<Value>,
    /// Its plane from now on.
    #[port("Plane", "P", optional)]
    plane: Option<Plane>,
    /// Its curve from now on.
    #[port("Curve", "C", optional)]
    curve: Option<Arc<Curve>>,
    /// Its text from now on.
    #[port("Text", "T", optional)]
    text: Option<Arc<str>>,
) -> Result<(Value, Plane, Arc<Curve>, Arc<str>), Message> {
    let given = leader.as_ref().map(|value| Given::read(context, value)).transpose()?;
    let known = given.as_ref().map(|given| &given.annotation);
    let untouched = plane.is_none() && curve.is_none() && text.is_none();
    let path = match (&curve, known) {
        (Some(curve), _) => points_of(context, curve)?,
        (None, Some(known)) => points_in_space(known),
        (None, None) => return Err(Message::warning("A leader needs a curve")),
    };
    let frame = match (plane, known) {
        (Some(plane), _) => plane,
        (None, Some(known)) => known.plane.frame,
        (None, None) => {
            let tolerance = context.tolerance().absolute;
            let own = curve.as_ref().filter(|c| !c.is_linear(tolerance)).and_then(|c| c.plane(tolerance));
            own.map(readable).unwrap_or(Plane::XY.with_origin(path.first().copied().unwrap_or_default()))
        }
    };
    let annotation = if let (true, Some(known)) = (untouched, known) {
        known.clone()
    } else {
        let flat = |p: &Point3| {
            let [x, y, _] = frame.coordinates(*p);
            Point2::new(x, y)
        };
        let points: Vec<Point2> = path.iter().map(flat).collect();
        let mut made = known.cloned().unwrap_or_else(blank);
        // A plane that a file has with an equation of its own would keep the old one.
        made.plane = StoredPlane { frame, equation: None };
        made.kind = AnnotationKind::Leader { points };
        match &text {
            Some(text) => made.text.rich_text = plain(text),
            None if known.is_none() => return Err(Message::warning("A leader needs a text")),
            None => {}
        }
        made
    };
    let corners = points_in_space(&annotation);
    let shape: Curve = match corners.as_slice() {
        [a, b] => Line::new(*a, *b).into(),
        _ => PolylineCurve::new(corners)?.into(),
    };
    let words = annotation.plain_text().replace("\r\n", "\n");
    let plane = annotation.plane.frame;
    let value = match (given, untouched) {
        (Some(given), true) => given.value,
        (given, _) => {
            let made = Value::from_object(Object::Annotation(Box::new(annotation)), &[]);
            let made = made.ok_or_else(|| Message::error("The leader cannot be written"))?;
            match given.and_then(|given| given.object) {
                Some(mut object) => {
                    object.geometry = Some(made);
                    Value::from(object)
                }
                None => made,
            }
        }
    };
    Ok((value, plane, Arc::new(shape), words.into()))
}

/// The same plane as a construction plane lies in Rhino's standard views, so that its texts are upright from where one looks: from
/// above, from the front where it stands upright, from the right where it also faces along x.
fn readable(plane: Plane) -> Plane {
    /// A part of a unit vector below this is rounding: the plane does not face that way.
    const FACING: f64 = 1e-9;
    let normal = plane.z_axis;
    let facing = [normal.z, -normal.y, normal.x].into_iter().find(|part| part.abs() > FACING);
    let normal = if facing.is_some_and(|part| part < 0.0) { -normal } else { normal };
    let along = |axis: Vector3| axis - normal * axis.dot(normal);
    // x runs to the right, as far as it can.
    let x = if along(Vector3::X).length() > FACING { along(Vector3::X) } else { along(Vector3::Y) };
    Plane::from_axes(plane.origin, x, normal.cross(x)).unwrap_or(plane)
}

/// A leader as it came, and what is in it.
struct Given {
    value: Value,
    /// The object of a model that it is.
    object: Option<katydid_data::ModelObject>,
    annotation: Annotation,
}

impl Given {
    fn read(context: &Context<'_>, value: &Value) -> Result<Self, Message> {
        let object = match value {
            Value::Content(content) if matches!(**content, Content::Object(_)) => {
                Some(object_of(context, value)?)
            }
            _ => None,
        };
        let geometry = object.as_ref().and_then(|object| object.geometry.as_ref()).unwrap_or(value);
        let Value::Kept(raw) = geometry else { return Err(unfit(geometry, "leader")) };
        match raw.parse(&Limits::default()) {
            Ok(Object::Annotation(annotation))
                if matches!(annotation.kind, AnnotationKind::Leader { .. }) =>
            {
                Ok(Self { value: value.clone(), object, annotation: *annotation })
            }
            Ok(_) => Err(Message::error(format!("A {} is no leader", raw.class_name()))),
            Err(error) => Err(Message::error(format!("The {} cannot be read: {error}", raw.class_name()))),
        }
    }
}

fn blank() -> Annotation {
    Annotation {
        kind: AnnotationKind::Leader { points: Vec::new() },
        // Beside the end of the arrow, on the side to which it runs.
        text: TextContent { horizontal_alignment: 3, vertical_alignment: 1, ..TextContent::new("") },
        style: Uuid::nil(),
        overrides: None,
        plane: StoredPlane { frame: Plane::XY, equation: None },
        horizontal: Vector2::X,
        scales_text: true,
    }
}

/// A text as an annotation has it without formatting: signs that mean something in rich text are marked.
fn plain(text: &str) -> String {
    if !text.contains(['\\', '{', '}', '\n']) {
        return text.to_owned();
    }
    let mut rich = String::from("{\\rtf1\\deff0{");
    for (k, line) in text.lines().enumerate() {
        if k > 0 {
            rich.push_str("\\par}{");
        }
        for c in line.chars() {
            if matches!(c, '\\' | '{' | '}') {
                rich.push('\\');
            }
            rich.push(c);
        }
    }
    rich.push_str("}}");
    rich
}

fn points_in_space(annotation: &Annotation) -> Vec<Point3> {
    let AnnotationKind::Leader { points } = &annotation.kind else { return Vec::new() };
    points.iter().map(|p| annotation.plane.frame.at(p.x, p.y, 0.0)).collect()
}

/// The corners of a curve, or those of a polyline near it.
fn points_of(context: &Context<'_>, curve: &Curve) -> Result<Vec<Point3>, Message> {
    if let Some(points) = curve.as_polyline() {
        return Ok(points);
    }
    let limits = PolylineLimits { angle: Some(0.1), ..PolylineLimits::within(0.01 * curve.length()) };
    let line = curve.to_polyline(&limits).map_err(|error| Message::warning(error.to_string()))?;
    context.items(line.points().len())?;
    Ok(line.points().to_vec())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Curve, Line, Plane, Point3, PolylineCurve, Vector3};

    fn bent() -> Curve {
        let corners = [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [2.0, 3.0, 1.0]].map(Point3::from);
        PolylineCurve::new(corners.to_vec()).unwrap().into()
    }

    fn made(text: &str) -> katydid_data::Tree {
        let run = Trial::of("Leader").default().default().item(bent()).item(text).run();
        assert!(run.messages.is_empty(), "{:?}", run.messages);
        run.outputs[0].clone()
    }

    #[test]
    fn a_leader_is_made_and_taken_apart() {
        let out = Trial::of("Leader").tree(made("steel")).run();
        assert!(out.messages.is_empty(), "{:?}", out.messages);
        assert_eq!(texts(&out.outputs[3]), ["{0}: steel"]);
        let ends = Trial::of("End Points").tree(out.outputs[2].clone());
        assert_eq!(ends.texts(1), ["{0}: {2, 3, 1}"]);
        assert_eq!(Trial::of("Length").tree(out.outputs[2].clone()).texts(0), ["{0}: 5"]);
        // Untouched it stays what it was.
        assert_eq!(out.outputs[0], made("steel"));
    }

    /// Whichever way the curve turns, the text is read from above, or from the front where the curve stands upright.
    #[test]
    fn texts_are_readable() {
        let frame = |corners: [[f64; 3]; 3]| {
            let curve: Curve = PolylineCurve::new(corners.map(Point3::from).to_vec()).unwrap().into();
            let run = Trial::of("Leader").default().default().item(curve).item("steel").run();
            match run.outputs[1].column().get(0) {
                Some(Value::Plane(plane)) => plane,
                other => panic!("{other:?}"),
            }
        };
        let above = [Vector3::X, Vector3::Y, Vector3::Z];
        let front = [Vector3::X, Vector3::Z, -Vector3::Y];
        let right = [Vector3::Y, Vector3::Z, Vector3::X];
        let cases = [
            ([[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [2.0, 3.0, 1.0]], above),
            ([[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [2.0, -3.0, 1.0]], above),
            ([[2.0, 1.0, 0.0], [-2.0, 0.0, 0.0], [-2.0, -3.0, 0.0]], above),
            ([[0.0, 1.0, 0.0], [2.0, 1.0, 0.0], [2.0, 1.0, 3.0]], front),
            ([[0.0, 1.0, 0.0], [2.0, 1.0, 0.0], [2.0, 1.0, -3.0]], front),
            ([[1.0, 0.0, 0.0], [1.0, 2.0, 0.0], [1.0, 2.0, -3.0]], right),
        ];
        for (corners, wanted) in cases {
            let plane = frame(corners);
            for (axis, wanted) in [plane.x_axis, plane.y_axis, plane.z_axis].into_iter().zip(wanted) {
                assert!((axis - wanted).length() < 1e-12, "{corners:?}: {plane:?}");
            }
        }
    }

    #[test]
    fn parts_are_put_in_the_place_of_others() {
        let text = Trial::of("Leader").tree(made("steel")).default().default().item("a {b}\\c\nd");
        assert_eq!(text.texts(3), ["{0}: a {b}\\c\nd"]);
        let line = Line::new(Point3::ORIGIN, Point3::new(0.0, 4.0, 0.0));
        let out = Trial::of("Leader").tree(made("x")).default().item(line).run();
        assert_eq!(texts(&out.outputs[3]), ["{0}: x"]);
        let moved = Trial::of("Leader").tree(made("x")).item(Plane::XY.offset(5.0));
        let curve = moved.run().outputs[2].clone();
        assert_eq!(Trial::of("End Points").tree(curve).texts(0), ["{0}: {0, 0, 5}"]);
    }

    #[test]
    fn what_is_missing_or_no_leader() {
        assert!(Trial::of("Leader").message().contains("needs a curve"));
        assert!(Trial::of("Leader").default().default().item(bent()).message().contains("needs a text"));
        assert!(Trial::of("Leader").item(1.5).message().contains("no leader"));
    }
}
