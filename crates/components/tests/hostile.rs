//! Every component on data that nobody meant for it: nothing, nulls, NaN and infinity, huge and negative counts,
//! items of the wrong type, ragged trees. None may panic, hang or put out more than it is allowed.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use katydid_component::{Account, Budget, Call, Component, Limits, Port, registry};
use katydid_data::{
    BlockDefinition, BlockInstance, Column, Filter, ModelLayer, ModelLinetype, ModelObject, Path, Tree,
    TreeBuilder, Value, cast,
};
use katydid_definition::archive::Chunk;
use katydid_geometry::{
    Box3, Circle, Curve, Interval, Line, Matrix, Mesh, NurbsCurve, NurbsSurface, Plane, PlaneSurface, Point3,
    Rectangle, RevolutionSurface, Sphere, Surface, Vector3, Xform,
    field::{Field, Force, Source},
};

#[global_allocator]
static ALLOCATOR: katydid_memory::Counting = katydid_memory::Counting;

/// No component may take this long over a handful of items: it hangs.
const WAIT: u64 = 60;

/// Numbers that are awkward as counts, lengths, parameters and exponents.
const NUMBERS: [f64; 14] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN_POSITIVE,
    -f64::MIN_POSITIVE,
    0.0,
    -1.0,
    0.5,
    3.0,
    1e9,
    -1e9,
    2_147_483_647.0,
    -2_147_483_648.0,
];

fn nurbs() -> Curve {
    let points = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, -1.0, 1.0], [4.0, 0.0, 0.0], [5.0, 1.0, 2.0]];
    NurbsCurve::clamped_uniform(3, &points.map(Point3::from)).unwrap().into()
}

/// Content of a model, sound and unsound.
fn contents() -> Vec<Value> {
    let lost = Xform::translation(Vector3::new(f64::NAN, 0.0, f64::INFINITY));
    let point = ModelObject::new(Value::from(Point3::ORIGIN));
    let block = Arc::new(BlockDefinition::new("odd", vec![point.clone(), ModelObject::default()]));
    let empty = Arc::new(BlockDefinition::default());
    let placed = |definition: &Arc<BlockDefinition>, transform| BlockInstance {
        definition: definition.clone(),
        transform,
    };
    vec![
        point.into(),
        ModelObject::default().into(),
        ModelObject::new(Value::from(placed(&block, Xform::IDENTITY))).into(),
        placed(&block, lost).into(),
        placed(&empty, Xform::IDENTITY).into(),
        block.into(),
        ModelLayer::at("::").into(),
        ModelLinetype { width: f64::NAN, segments: vec![f64::NAN], ..ModelLinetype::default() }.into(),
        Filter::all([]).into(),
    ]
}

/// One of everything, sound and unsound.
fn oddities() -> Vec<Value> {
    let far = Point3::new(1e300, -1e300, 1e300);
    let lost = Point3::new(f64::NAN, f64::INFINITY, 0.0);
    let nowhere = Line { from: far, to: far };
    let mut all: Vec<Value> = NUMBERS.map(Value::from).to_vec();
    all.extend([i32::MIN, -1, 0, 1, 7, i32::MAX].map(Value::from));
    let long = "x".repeat(10_000);
    let texts =
        ["", " ", "{0;1}", "0 to 1", "1e999", "-", "a,b", "{", "(((((", "[[", "%", "\u{0}", "𝕂atydid", &long];
    all.extend(texts.map(|t| Value::from(t.to_owned())));
    all.extend([true.into(), false.into()]);
    all.extend(contents());
    all.extend([Point3::ORIGIN, far, lost].map(Value::from));
    all.extend(
        [Vector3::ZERO, Vector3::new(1.0, 2.0, 3.0), Vector3::new(f64::NAN, 0.0, 0.0)].map(Value::from),
    );
    all.extend(
        [Interval::new(0.0, 0.0), Interval::new(1.0, -1.0), Interval::new(f64::NAN, 1e308)].map(Value::from),
    );
    all.extend([Plane::XY, Plane { origin: lost, ..Plane::XY }].map(Value::from));
    all.extend([Line { from: Point3::ORIGIN, to: Point3::new(1.0, 0.0, 0.0) }, nowhere].map(Value::from));
    all.push(Value::from(Circle { plane: Plane::XY, radius: 1.0 }));
    all.push(Value::from(Circle { plane: Plane::XY, radius: 0.0 }));
    all.push(Value::Curve(Arc::new(nurbs())));
    all.push(Value::Curve(Arc::new(nowhere.into())));
    all.push(Value::Mesh(Arc::new(Mesh::default())));
    all.extend(surfaces().map(Value::from));
    all.push(Value::from(Box3 {
        plane: Plane::XY,
        x: Interval::new(0.0, 1.0),
        y: Interval::new(0.0, 0.0),
        z: Interval::new(2.0, 1.0),
    }));
    all.push(Value::from(Xform::scale(Point3::ORIGIN, 0.0)));
    all.push(Value::from(Xform::IDENTITY));
    all
}

/// A whole, a pointed, a vanishing, a huge and a turned-in surface.
fn surfaces() -> [Surface; 5] {
    let (o, x, y) = (Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Point3::new(0.0, 1.0, 0.0));
    let huge = Interval::new(-1e150, 1e150);
    let profile = Line { from: Point3::new(-1.0, 0.0, 0.0), to: Point3::new(1.0, 0.0, 1.0) };
    let axis = Line { from: o, to: Point3::new(0.0, 0.0, 1.0) };
    [
        Sphere::around(o, 1.0).unwrap().into(),
        NurbsSurface::from_triangle(o, x, y).unwrap().into(),
        NurbsSurface::bezier([2, 2], &[x; 4]).unwrap().into(),
        PlaneSurface::new(Plane::XY, huge, huge).unwrap().into(),
        RevolutionSurface::new(profile.into(), axis, Interval::new(0.0, 6.0)).unwrap().into(),
    ]
}

/// Items that most ports of a kind can do something with.
fn sensible() -> Vec<Value> {
    let circle = Circle { plane: Plane::XY, radius: 2.0 };
    let square = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 1.0), y: Interval::new(0.0, 1.0) };
    vec![
        Value::from(2.0),
        Value::from(1),
        Value::from("abc".to_owned()),
        Value::from(true),
        Value::from(Point3::new(1.0, 2.0, 3.0)),
        Value::from(Interval::new(0.0, 1.0)),
        Value::from(Plane::XY),
        Value::Curve(Arc::new(nurbs())),
        Value::from(circle),
        Value::from(Line { from: Point3::ORIGIN, to: Point3::new(1.0, 1.0, 0.0) }),
        Value::from(Xform::translation(Vector3::new(1.0, 0.0, 0.0))),
        Value::Mesh(Arc::new(Mesh::plane(&square, 2, 2).unwrap())),
        Value::from(surfaces()[0].clone()),
        Value::from(Matrix::new(2, 2, vec![1.0, 2.0, 3.0, 4.0]).unwrap()),
        Value::from(
            Field::new(vec![Force {
                source: Source::Point { location: Point3::ORIGIN, charge: 1.0, decay: 2.0 },
                bounds: None,
            }])
            .unwrap(),
        ),
    ]
}

/// A repeatable sequence (xorshift64*).
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let high = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33;
        usize::try_from(high).unwrap() % sides
    }
}

fn list(values: Vec<Option<Value>>) -> Tree {
    Tree::branch_at(Path::zero(), Column::of_options(values))
}

/// A tree of branches of unequal lengths, an empty one among them, at paths of unequal depth.
fn ragged(values: &[Value], dice: &mut Dice) -> Tree {
    let mut builder = TreeBuilder::<Value>::new();
    for (k, path) in ["{0}", "{0;0}", "{0;1;5}", "{7}", "{2147483647;-3}"].iter().enumerate() {
        builder.branch(path.parse().unwrap());
        for _ in 0..[2, 0, 3, 1, 1][k] {
            let item = (dice.roll(6) > 0).then(|| values[dice.roll(values.len())].clone());
            builder.push(item);
        }
    }
    builder.finish()
}

/// As the solver does before a component runs: cast to the port's type.
fn cast_to(port: Option<&Port>, tree: Tree) -> Tree {
    let kind = port.map_or(katydid_data::Kind::Generic, |p| p.kind);
    let column = cast::column(tree.column(), kind, &cast::Rules::default()).column;
    tree.with_column(column)
}

/// What the port has by default, else an item of its kind.
fn ordinary(port: Option<&Port>) -> Tree {
    if let Some(default) = port.and_then(|p| p.default) {
        return default();
    }
    let whole = |v: &Value| cast_to(port, Tree::item(v.clone()));
    let fits = |t: &Tree| t.column().get(0).is_some();
    sensible().iter().map(whole).find(fits).unwrap_or_else(Tree::empty)
}

struct Watch {
    running: Arc<Mutex<String>>,
    beats: Arc<AtomicU64>,
}

impl Watch {
    /// Ends the whole test with the component's name when one run does not end.
    fn start() -> Self {
        let running = Arc::new(Mutex::new(String::new()));
        let beats = Arc::new(AtomicU64::new(0));
        let (name, count) = (running.clone(), beats.clone());
        std::thread::spawn(move || {
            loop {
                let before = count.load(Ordering::Relaxed);
                std::thread::sleep(Duration::from_secs(WAIT));
                if count.load(Ordering::Relaxed) == before {
                    eprintln!("{} does not come to an end", name.lock().unwrap());
                    std::process::exit(1);
                }
            }
        });
        Self { running, beats }
    }
}

/// Runs the component; what is wrong with that, if anything.
fn feed(component: &Component, inputs: &[Tree], watch: &Watch) -> Option<String> {
    *watch.running.lock().unwrap() = component.name.to_owned();
    watch.beats.fetch_add(1, Ordering::Relaxed);
    let time = Some(Duration::from_secs(2));
    let limits = Limits { items: 20_000, time, ..Limits::default() }.with_bytes(16 << 20);
    let deadline = katydid_component::Deadline::after(limits.time);
    let solve = Arc::new(Account::new(limits.solve_bytes));
    let budget = Budget::new(limits, Default::default(), deadline, solve);
    let names: Vec<String> = (0..inputs.len())
        .map(|i| component.input(i).map_or_else(String::new, |p| p.nick.to_owned()))
        .collect();
    let settings = Chunk::default();
    let call = Call {
        inputs,
        input_names: &names,
        output_count: component.outputs.len(),
        wanted: &[],
        settings: &settings,
        rules: Default::default(),
        budget: &budget,
        files: &Default::default(),
        outbox: None,
        kept: None,
        model: None,
    };
    let Ok(outcome) = catch_unwind(AssertUnwindSafe(|| budget.token().during(|| (component.run)(&call))))
    else {
        return Some("panics".into());
    };
    if outcome.outputs.len() < component.outputs.iter().filter(|p| !p.many).count() {
        return Some(format!("gives {} outputs", outcome.outputs.len()));
    }
    if outcome.messages.iter().any(|m| m.text.trim().is_empty()) {
        return Some("gives a message without words".into());
    }
    None
}

#[test]
fn no_component_breaks() {
    assert!(katydid_components::link() > 100);
    let watch = Watch::start();
    let odd = oddities();
    let mut dice = Dice(0x9E37_79B9_7F4A_7C15);
    let mut broken = Vec::new();
    let mut runs = 0_u32;
    for component in registry::all() {
        let count = component.inputs.len() + usize::from(component.has_variable_inputs());
        let port = |i: usize| component.input(i);
        let mut meals: Vec<Vec<Tree>> = vec![
            (0..count).map(|_| Tree::empty()).collect(),
            (0..count).map(|_| list(vec![])).collect(),
            (0..count).map(|_| list(vec![None, None])).collect(),
            (0..count).map(|i| ordinary(port(i))).collect(),
        ];
        // One input at a time is odd, the others are as they should be.
        for i in 0..count {
            let others = |tree: Tree| -> Vec<Tree> {
                (0..count)
                    .map(|k| if k == i { cast_to(port(k), tree.clone()) } else { ordinary(port(k)) })
                    .collect()
            };
            meals.push(others(Tree::empty()));
            meals.push(others(list(vec![None])));
            meals.push(others(ragged(&odd, &mut dice)));
            meals.extend(
                odd.iter()
                    .filter(|v| {
                        // Only what the port can take, or one of those that it cannot.
                        cast_to(port(i), Tree::item((*v).clone())).column().get(0).is_some()
                    })
                    .map(|v| others(Tree::item(v.clone()))),
            );
        }
        // All at once.
        for _ in 0..20 {
            meals.push((0..count).map(|i| cast_to(port(i), ragged(&odd, &mut dice))).collect());
        }
        for meal in meals {
            runs += 1;
            if let Some(fault) = feed(component, &meal, &watch) {
                let data: Vec<String> =
                    meal.iter().map(|t| katydid_component::testing::texts(t).join(" ")).collect();
                let mut data = data.join(" | ");
                data.truncate(data.char_indices().nth(300).map_or(data.len(), |(at, _)| at));
                broken.push(format!("{} {} {fault} on {data}", component.name, component.guid));
                break;
            }
        }
    }
    println!("{runs} runs");
    assert!(broken.is_empty(), "{} components break:\n{}", broken.len(), broken.join("\n"));
}
