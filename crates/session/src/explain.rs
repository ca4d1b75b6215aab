//! Objects whose result the kernel can tell step by step.

use katydid_component::registry;
use katydid_data::{Tree, Value};
use katydid_geometry::explain::{self, Algorithm, Explanation, Number, Quantity};
use katydid_geometry::{NurbsCurve, Point3, Vector3};
use katydid_solver::{Engine, Inputs};

use crate::protocol::{ExplanationView, NumberView, NurbsView, QuantityView, StepView, TermView};

/// The algorithms by which the result of an object can be told; the first is the one that is told when none is named.
pub fn explainable(engine: &Engine, index: usize) -> Vec<Algorithm> {
    let Some(object) = engine.document().objects.get(index) else { return Vec::new() };
    let Some(component) = registry::by_guid(object.component) else { return Vec::new() };
    let inputs = || Inputs::new(engine).of(index);
    match component.name {
        "Evaluate Curve" => match curve_of(&inputs()) {
            Some(curve) if is_bezier(&curve) => {
                vec![Algorithm::DeCasteljau, Algorithm::DeBoor, Algorithm::KnotInsertion]
            }
            Some(_) => vec![Algorithm::DeBoor, Algorithm::KnotInsertion],
            None => Vec::new(),
        },
        "Curve Closest Point" | "Surface Closest Point" => vec![Algorithm::Newton],
        "Construct Plane" | "Plane 3Pt" => vec![Algorithm::GramSchmidt],
        "Multiplication"
            if inputs().iter().filter(|tree| matches!(first(tree), Some(Value::Matrix(_)))).count() == 2 =>
        {
            vec![Algorithm::MatrixProduct]
        }
        _ => Vec::new(),
    }
}

/// How the result of an object comes about, for the first item of each of its inputs: by the algorithm that is named, or
/// the first that [`explainable`] gives.
///
/// # Errors
/// The object is not one whose steps can be told, or not by that algorithm, or its inputs have no data that it works on.
pub fn explain(engine: &Engine, index: usize, algorithm: Option<Algorithm>) -> Result<Explanation, String> {
    let known = explainable(engine, index);
    let algorithm = match (algorithm, known.first()) {
        (_, None) => return Err("the steps of this object cannot be told".to_owned()),
        (None, Some(first)) => *first,
        (Some(wanted), Some(_)) if known.contains(&wanted) => wanted,
        (Some(wanted), Some(_)) => {
            let names: Vec<&str> = known.iter().map(|one| one.name()).collect();
            return Err(format!("it does not work by {}, but by {}", wanted.name(), names.join(", ")));
        }
    };
    let inputs = Inputs::new(engine).of(index);
    let lacking = || "its inputs have no data to tell the steps of".to_owned();
    let told = match algorithm {
        Algorithm::DeCasteljau | Algorithm::DeBoor | Algorithm::KnotInsertion => {
            let curve = curve_of(&inputs).ok_or_else(lacking)?;
            let t = inputs.iter().find_map(number_of).ok_or_else(lacking)?;
            match algorithm {
                Algorithm::DeCasteljau => explain::de_casteljau(&curve, t),
                Algorithm::DeBoor => explain::de_boor(&curve, t),
                _ => explain::knot_insertion(&curve, t),
            }
        }
        Algorithm::Newton => {
            let point = inputs.iter().find_map(point_of).ok_or_else(lacking)?;
            match inputs
                .iter()
                .filter_map(first)
                .find(|value| matches!(value, Value::Curve(_) | Value::Surface(_) | Value::Brep(_)))
            {
                Some(Value::Curve(curve)) => explain::newton_on_curve(&curve, point),
                Some(Value::Surface(surface)) => explain::newton_on_surface(&surface, point),
                Some(Value::Brep(brep)) => {
                    let surface = brep.face_surface(0).filter(|_| brep.faces().len() == 1);
                    let surface = surface.ok_or_else(lacking)?;
                    explain::newton_on_surface(surface, point)
                }
                _ => return Err(lacking()),
            }
        }
        Algorithm::GramSchmidt => explain::gram_schmidt(&axes(&inputs).ok_or_else(lacking)?),
        Algorithm::MatrixProduct => {
            let matrices: Vec<Value> =
                inputs.iter().filter_map(first).filter(|value| matches!(value, Value::Matrix(_))).collect();
            let [Value::Matrix(a), Value::Matrix(b)] = matrices.as_slice() else { return Err(lacking()) };
            explain::matrix_product(a, b)
        }
    };
    told.map_err(|error| error.to_string())
}

/// The control points, weights and knots of the first curve that an output of an object gives.
///
/// # Errors
/// The output gives no curve, or one without such a form.
pub fn nurbs_of(engine: &Engine, index: usize, output: usize) -> Result<NurbsView, String> {
    let tree = engine.report(index).and_then(|report| report.outputs.get(output));
    let curve = tree.and_then(|tree| nurbs(first(tree)?)).ok_or("it gives no curve")?;
    let domain = curve.domain();
    Ok(NurbsView {
        degree: u32::try_from(curve.degree()).unwrap_or_default(),
        points: curve.control_points().iter().map(|p| [p.x, p.y, p.z]).collect(),
        weights: curve.weights(),
        knots: curve.knots().to_vec(),
        domain: [domain.start, domain.end],
    })
}

/// The first item of all.
fn first(tree: &Tree) -> Option<Value> {
    tree.branches().flat_map(|branch| branch.iter()).flatten().next()
}

fn nurbs(value: Value) -> Option<NurbsCurve> {
    match value {
        Value::Curve(curve) => curve.to_nurbs().ok(),
        Value::Line(line) => katydid_geometry::Curve::from(*line).to_nurbs().ok(),
        Value::Circle(circle) => katydid_geometry::Curve::from(*circle).to_nurbs().ok(),
        Value::Arc(arc) => katydid_geometry::Curve::from(*arc).to_nurbs().ok(),
        _ => None,
    }
}

fn curve_of(inputs: &[Tree]) -> Option<NurbsCurve> {
    inputs.iter().find_map(|tree| nurbs(first(tree)?))
}

fn is_bezier(curve: &NurbsCurve) -> bool {
    let domain = curve.domain();
    curve.point_count() == curve.degree() + 1
        && curve.knots().iter().all(|knot| *knot == domain.start || *knot == domain.end)
}

fn number_of(tree: &Tree) -> Option<f64> {
    match first(tree)? {
        Value::Number(x) => Some(x),
        #[allow(clippy::cast_precision_loss, reason = "a whole number on a wire has 32 bits")]
        Value::Integer(i) => Some(i as f64),
        _ => None,
    }
}

fn point_of(tree: &Tree) -> Option<Point3> {
    match first(tree)? {
        Value::Point(p) => Some(p),
        _ => None,
    }
}

/// The two directions that the axes of a plane are made of: given as such, or from the first of three points to the others.
fn axes(inputs: &[Tree]) -> Option<Vec<Vector3>> {
    let values: Vec<Value> = inputs.iter().filter_map(first).collect();
    match values.as_slice() {
        [Value::Point(a), Value::Point(b), Value::Point(c)] => Some(vec![*b - *a, *c - *a]),
        [_, Value::Vector(x), Value::Vector(y)] => Some(vec![*x, *y]),
        _ => None,
    }
}

impl From<&Explanation> for ExplanationView {
    fn from(told: &Explanation) -> Self {
        let quantities = |list: &[Quantity]| list.iter().map(QuantityView::from).collect();
        let step = |step: &explain::Step| StepView {
            made: (&step.made).into(),
            rule: step.rule.clone(),
            terms: step
                .terms
                .iter()
                .map(|(factor, name)| TermView { factor: factor.into(), name: name.clone() })
                .collect(),
        };
        Self {
            algorithm: told.algorithm.name().to_owned(),
            given: quantities(&told.given),
            rounds: told.rounds.iter().map(|round| round.steps.iter().map(step).collect()).collect(),
            result: quantities(&told.result),
        }
    }
}

impl From<&Quantity> for QuantityView {
    fn from(quantity: &Quantity) -> Self {
        Self { name: quantity.name.clone(), numbers: quantity.numbers.iter().map(NumberView::from).collect() }
    }
}

impl From<&Number> for NumberView {
    fn from(number: &Number) -> Self {
        Self { value: number.value, exact: number.exact.map(|fraction| fraction.to_string()) }
    }
}
