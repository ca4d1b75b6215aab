//! Vector / Field: fields of force, and what they do at a point.

use std::sync::Arc;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::field::{Force, Source, Stepper};
use katydid_geometry::{Box3, Curve, Field, Line, Plane, Point3, PolylineCurve, Vector3};

fn one(source: Source, bounds: Option<Box3>) -> Result<Arc<Field>, Message> {
    Ok(Arc::new(Field::new(vec![Force { source, bounds }])?))
}

/// The field of a charge in one point. It pushes away from the point by charge ÷ distance to the power of the decay; a
/// negative charge pulls.
#[component(
    "cffdbaf3-8d33-4b38-9cad-c264af9fc3f4",
    name = "Point Charge",
    nick = "PCharge",
    at = "Vector/Field"
)]
#[output("Field", "F", "The field.")]
fn point_charge(
    /// Where the charge sits.
    #[port("Point", "P")]
    point: Point3,
    /// The force at distance 1.
    #[port("Charge", "C", default = 1.0)]
    charge: f64,
    /// The power of the distance that the force falls with: 2 as in nature, 0 not at all.
    #[port("Decay", "D", default = 2.0)]
    decay: f64,
    /// Where the force acts; everywhere when nothing is given.
    #[port("Bounds", "B", optional)]
    bounds: Option<Box3>,
) -> Result<Arc<Field>, Message> {
    one(Source::Point { location: point, charge, decay }, bounds)
}

/// The field of a charge spread evenly along a line. Far away it acts as a point charge of the same size does.
#[component(
    "8cc9eb88-26a7-4baa-a896-13e5fc12416a",
    name = "Line Charge",
    nick = "LCharge",
    at = "Vector/Field"
)]
#[output("Field", "F", "The field.")]
fn line_charge(
    /// Where the charge is spread.
    #[port("Line", "L")]
    line: Line,
    /// The charge of the whole line.
    #[port("Charge", "C", default = 1.0)]
    charge: f64,
    /// Where the force acts; everywhere when nothing is given.
    #[port("Bounds", "B", optional)]
    bounds: Option<Box3>,
) -> Result<Arc<Field>, Message> {
    one(Source::Segment { line, charge }, bounds)
}

/// A field that turns round an axis, counter-clockwise for a positive strength. It is the strength divided by
/// (1 + distance ÷ radius) to the power of the decay.
#[component("4b59e893-d4ee-4e31-ae24-a489611d1088", name = "Spin Force", nick = "FSpin", at = "Vector/Field")]
#[output("Field", "F", "The field.")]
fn spin_force(
    /// The plane of the turn; its normal through its origin is the axis.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The force near the middle of the turn.
    #[port("Strength", "S", default = 1.0)]
    strength: f64,
    /// The unit of the distance from the middle; of 0 the force has faded everywhere.
    #[port("Radius", "R", default = 5.0)]
    radius: f64,
    /// The power that it fades with.
    #[port("Decay", "D", default = 2.0)]
    decay: f64,
    /// Where the force acts; everywhere when nothing is given.
    #[port("Bounds", "B", optional)]
    bounds: Option<Box3>,
) -> Result<Arc<Field>, Message> {
    one(Source::Spin { plane, strength, radius, decay }, bounds)
}

/// A field with the same force everywhere: the vector from the start of a line to its end. Where the line lies does not
/// matter.
#[component(
    "d27cc1ea-9ef7-47bf-8ee2-c6662da0e3d9",
    name = "Vector Force",
    nick = "FVector",
    at = "Vector/Field"
)]
#[output("Field", "F", "The field.")]
fn vector_force(
    /// The force, as a line along it and as long as it is strong.
    #[port("Line", "L")]
    line: Line,
    /// Where the force acts; everywhere when nothing is given.
    #[port("Bounds", "B", optional)]
    bounds: Option<Box3>,
) -> Result<Arc<Field>, Message> {
    one(Source::Uniform(line.direction()), bounds)
}

/// One field of several: their forces add up.
#[component(
    "d9a6fbd2-2e9f-472e-8147-33bf0233a115",
    name = "Merge Fields",
    nick = "MergeF",
    at = "Vector/Field"
)]
#[output("Field", "F", "The sum of the fields.")]
fn merge_fields(
    /// The fields to add.
    #[port("Fields", "F")]
    fields: List<Arc<Field>>,
) -> Result<Arc<Field>, Message> {
    let forces = fields.present().flat_map(|field| field.forces().to_vec()).collect();
    Ok(Arc::new(Field::new(forces)?))
}

/// The single forces that a field is made of, each as a field of its own.
#[component(
    "b27d53bc-e713-475d-81fd-71cdd8de2e58",
    name = "Break Field",
    nick = "BreakF",
    at = "Vector/Field"
)]
#[output("Fields", "F", "A field for each force.")]
fn break_field(
    /// The field to take apart.
    #[port("Field", "F")]
    field: &Field,
) -> Result<Vec<Arc<Field>>, Message> {
    field.forces().iter().map(|force| Ok(Arc::new(Field::new(vec![*force])?))).collect()
}

/// The force of a field at a point.
#[component(
    "a7c9f738-f8bd-4f64-8e7f-33341183e493",
    name = "Evaluate Field",
    nick = "EvF",
    at = "Vector/Field"
)]
#[output("Tensor", "T", "The force.")]
#[output("Strength", "S", "Its length.")]
fn evaluate_field(
    /// The field.
    #[port("Field", "F")]
    field: &Field,
    /// Where to look.
    #[port("Point", "P")]
    point: Point3,
) -> (Vector3, f64) {
    let force = field.at(point);
    (force, force.length())
}

/// The line that always runs along the force of a field, from a point on.
///
/// It ends at a charge, where there is no force, and after the given number of steps. Methods of a higher order stay
/// nearer to the true line at the same step.
#[component("add6be3e-c57f-4740-96e4-5680abaa9169", name = "Field Line", nick = "FLine", at = "Vector/Field")]
#[output("Curve", "C", "The line, as a polyline; null where there is no force at its start.")]
fn field_line(
    context: &Context<'_>,
    /// The field.
    #[port("Field", "F")]
    field: &Field,
    /// Where the line starts.
    #[port("Point", "P")]
    point: Point3,
    /// The most steps to make.
    #[port("Steps", "N", default = 1000)]
    steps: i32,
    /// The length of a step, above 0.
    #[port("Accuracy", "A", default = 0.1)]
    accuracy: f64,
    /// How steps are made: 1 Euler, 2 midpoint, 3 Kutta, 4 Runge–Kutta, the number being the order of the error; 5 cuts
    /// steps as short as an error of a thousandth of a step needs.
    #[port("Method", "M", default = 3)]
    method: i32,
) -> Result<Option<Arc<Curve>>, Message> {
    let steps = crate::sets::count(steps, "Steps")?;
    context.bytes(steps.saturating_mul(size_of::<[f64; 4]>()))?;
    let stepper = match method {
        1 => Stepper::Euler,
        2 => Stepper::Midpoint,
        3 => Stepper::Kutta3,
        4 => Stepper::RungeKutta4,
        5 => Stepper::DormandPrince(1e-3 * accuracy),
        other => return Err(Message::error(format!("Method is {other}, which must be between 1 and 5"))),
    };
    let mut stopped = None;
    let points = field.line(point, steps, accuracy, stepper, || {
        stopped = context.check().err();
        stopped.is_none()
    })?;
    if let Some(message) = stopped {
        return Err(message);
    }
    if points.len() < 2 {
        context.warn("There is no force at the start of the line");
        return Ok(None);
    }
    Ok(Some(Arc::new(PolylineCurve::new(points)?.into())))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::{Tree, Value};
    use katydid_geometry::{Line, Plane, Point3, Vector3};

    const O: Point3 = Point3::ORIGIN;

    fn first(trial: Trial) -> Tree {
        trial.run().outputs[0].clone()
    }

    fn at(field: &Tree, p: Point3) -> Vec<String> {
        let out = Trial::of("Evaluate Field").tree(field.clone()).item(p).run().outputs;
        [texts(&out[0]), texts(&out[1])].concat()
    }

    #[test]
    fn forces() {
        let p = Point3::new(2.0, 0.0, 0.0);
        let charge = first(Trial::of("Point Charge").item(O).item(8.0));
        assert_eq!(texts(&charge), ["{0}: Field of 1 force"]);
        assert_eq!(at(&charge, p), ["{0}: {2, 0, 0}", "{0}: 2"]);
        let spin = first(Trial::of("Spin Force").item(Plane::XY).item(3.0).item(1.0).item(1.0));
        assert_eq!(at(&spin, p), ["{0}: {0, 1, 0}", "{0}: 1"]);
        let wind = first(Trial::of("Vector Force").item(Line::new(p, Point3::new(2.0, 0.0, 4.0))));
        assert_eq!(at(&wind, O), ["{0}: {0, 0, 4}", "{0}: 4"]);
        // On the axis of a unit charge from 0 to 1, at distance 2: the integral of 1/s² from 1 to 2.
        let line = first(Trial::of("Line Charge").item(Line::new(O, Point3::new(1.0, 0.0, 0.0))));
        assert_eq!(at(&line, p), ["{0}: {0.5, 0, 0}", "{0}: 0.5"]);
        assert!(Trial::of("Spin Force").item(Plane::XY).item(1.0).item(-1.0).message().contains("radius"));
        let bounds = katydid_geometry::Interval::new(0.0, 1.0);
        let cell = katydid_geometry::Box3 { plane: Plane::XY, x: bounds, y: bounds, z: bounds };
        let bounded = first(Trial::of("Point Charge").item(O).item(8.0).item(2.0).item(cell));
        assert_eq!(at(&bounded, p), ["{0}: {0, 0, 0}", "{0}: 0"]);
    }

    #[test]
    fn fields_add_up_and_come_apart() {
        let forces: Vec<Value> = [1.0, -1.0]
            .map(|x| first(Trial::of("Point Charge").item(Point3::new(x, 0.0, 0.0)).item(x)))
            .iter()
            .filter_map(|tree| tree.column().get(0))
            .collect();
        let both = first(Trial::of("Merge Fields").list(forces));
        assert_eq!(texts(&both), ["{0}: Field of 2 forces"]);
        // A dipole: both forces point from the positive to the negative charge.
        assert_eq!(at(&both, O), ["{0}: {-2, 0, 0}", "{0}: 2"]);
        let parts = first(Trial::of("Break Field").tree(both));
        assert_eq!(texts(&parts), ["{0;0}: Field of 1 force, Field of 1 force"]);
    }

    #[test]
    fn lines_follow_the_force() {
        let wind = first(Trial::of("Vector Force").item(Line::new(O, Point3::new(0.0, 0.0, 4.0))));
        for method in 1..=5 {
            let trial = Trial::of("Field Line").tree(wind.clone()).item(O).item(10).item(0.5).item(method);
            let out = trial.run().outputs[0].column().get(0);
            let Some(Value::Curve(curve)) = out else { panic!("{out:?}") };
            assert!((curve.end() - O - Vector3::Z * 5.0).length() < 1e-12, "{method}");
        }
        let line = || Trial::of("Field Line").tree(wind.clone()).item(O);
        assert!(line().item(5).item(0.1).item(0).message().contains("between 1 and 5"));
        assert!(line().item(-5).message().contains("negative"));
        assert!(line().item(5).item(0.0).message().contains("step"));
        let charge = first(Trial::of("Point Charge").item(O));
        assert_eq!(Trial::of("Field Line").tree(charge).item(O).texts(0), ["{0}: null"]);
    }
}
