use katydid_component::Outcome;
use katydid_component::testing::Trial;
use katydid_data::{Column, Path, Tree, Value};
use katydid_geometry::{
    Curve, Interval, Line, LineCurve, Mesh, MeshFace, Plane, Point3, PolylineCurve, Rectangle, Vector3,
};

const SOLVER: &str = "313490f5-8e38-4dde-9e9a-05e4d739b35d";

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

/// All goals that a trial makes.
fn goals(trial: Trial) -> Vec<Value> {
    let outcome = trial.run();
    assert!(outcome.messages.is_empty(), "{:?}", outcome.messages);
    outcome.outputs[0].column().iter().flatten().collect()
}

fn anchor(at: Point3) -> Vec<Value> {
    goals(Trial::of_guid("3c30b1a1-4473-4ad4-a700-ea9770726c03").item(at))
}

fn spring(a: Point3, b: Point3, rest: f64, strength: f64) -> Vec<Value> {
    let line = Curve::Line(LineCurve::new(Line::new(a, b)));
    goals(Trial::of("Length(Line)").item(line).item(rest).item(strength))
}

fn load(at: Point3, force: Vector3) -> Vec<Value> {
    goals(Trial::of_guid("2019c995-53af-4eb2-976d-95b1fdc823fa").item(at).item(force))
}

fn solved(goals: Vec<Value>) -> Outcome {
    let tree = Tree::branch_at(Path::zero(), Column::of_values(goals, None));
    let outcome = Trial::of_guid(SOLVER).tree(tree).run();
    assert!(outcome.messages.is_empty(), "{:?}", outcome.messages);
    outcome
}

fn points(outcome: &Outcome) -> Vec<Point3> {
    let points = outcome.outputs[1].column().iter();
    points.map(|v| if let Some(Value::Point(p)) = v { p } else { panic!("{v:?}") }).collect()
}

fn near(a: f64, b: f64, within: f64) {
    assert!((a - b).abs() < within, "{a} instead of {b}");
}

#[test]
fn a_weight_on_a_spring() {
    let (top, end) = (p(0.0, 0.0, 0.0), p(0.0, 0.0, -1.0));
    let mut all = anchor(top);
    all.extend(spring(top, end, 1.0, 2.0));
    all.extend(load(end, Vector3::new(0.0, 0.0, -3.0)));
    let outcome = solved(all);
    let at = points(&outcome);
    // Hooke: 3 / 2 longer; the anchor gives way by 3 / 10,000.
    near(at[0].z, -3e-4, 1e-7);
    near(at[1].z, -2.5 - 3e-4, 1e-6);
    // The spring shows its line, the anchor and the load their points.
    let shown: Vec<Option<Value>> = outcome.outputs[2].column().iter().collect();
    assert!(matches!(shown[1], Some(Value::Line(_))) && matches!(shown[0], Some(Value::Point(_))));
}

#[test]
fn a_hanging_chain_is_in_balance() {
    const N: usize = 20;
    const STIFF: f64 = 2000.0;
    let at: Vec<Point3> = (0..=N).map(|i| p(i as f64, 0.0, 0.0)).collect();
    let mut all = anchor(at[0]);
    all.extend(anchor(at[N]));
    for pair in at.windows(2) {
        all.extend(spring(pair[0], pair[1], 1.2, STIFF));
    }
    for q in &at[1..N] {
        all.extend(load(*q, Vector3::new(0.0, 0.0, -1.0)));
    }
    let outcome = solved(all);
    let found = points(&outcome);
    // Particles come in the order in which goals name them: first, last, then along the chain.
    let mut chain = vec![found[0]];
    chain.extend(&found[2..]);
    chain.push(found[1]);
    let pull: Vec<Vector3> = chain
        .windows(2)
        .map(|pair| {
            let way = pair[1] - pair[0];
            way.unitized().unwrap() * (STIFF * (way.length() - 1.2))
        })
        .collect();
    for (left, right) in pull.iter().zip(&pull[1..]) {
        // The horizontal tension is the same along the chain; each node carries its weight.
        near(left.x, right.x, 1e-2);
        near(right.z - left.z, 1.0, 1e-2);
    }
    // The catenary through the same ends with the length of the stretched chain sags the same, but for its corners.
    let length: f64 = chain.windows(2).map(|pair| pair[0].distance_to(pair[1])).sum();
    let sag = -chain.iter().map(|q| q.z).fold(0.0, f64::min);
    let span = chain[0].distance_to(chain[N]);
    let (mut low, mut high) = (1e-3, 1e3);
    for _ in 0..200 {
        let a = 0.5 * (low + high);
        if 2.0 * a * (span / (2.0 * a)).sinh() > length { low = a } else { high = a }
    }
    let a = 0.5 * (low + high);
    near(sag, a * ((span / (2.0 * a)).cosh() - 1.0), 0.05);
}

#[test]
fn bends_and_folds_reach_their_angles() {
    let (a, b, c) = (p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(1.8, 0.6, 0.0));
    for rest in [0.0, 0.3, 1.2] {
        let mut all: Vec<Value> = [anchor(a), anchor(b), spring(b, c, 1.0, 100.0)].concat();
        let (u, v) = (Line::new(a, b), Line::new(b, c));
        all.extend(goals(Trial::of_guid("f5f95b51-7431-4e80-a32f-d33e5dee53a5").item(u).item(v).item(rest)));
        let at = points(&solved(all));
        let angle = (at[1] - at[0]).angle_to(at[2] - at[1]).unwrap();
        near(angle, rest, 1e-4);
    }
    for rest in [0.0, 0.5, -0.8] {
        let (s, e, f, g) = (p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(0.4, 1.0, 0.1), p(0.6, -1.0, 0.1));
        let trial = Trial::of("Hinge").item(s).item(e).item(f).item(g).item(rest);
        let at = points(&solved(goals(trial)));
        near(super::folds::fold_angle([at[0], at[1], at[2], at[3]]).unwrap(), rest, 1e-5);
    }
    let flat = Trial::of("FoldAngle")
        .item(p(0., 0., 0.))
        .item(p(1., 0., 0.))
        .item(p(0., 1., 0.))
        .item(p(0., -1., 0.));
    assert_eq!(flat.texts(0), ["{0}: 0"]);
    let valley = Trial::of("FoldAngle")
        .item(p(0., 0., 0.))
        .item(p(1., 0., 0.))
        .item(p(0., 1., 1.))
        .item(p(0., -1., 1.));
    assert_eq!(valley.texts(0), ["{0}: 1.570796"]);
}

fn wavy(n: usize) -> Mesh {
    let side = Interval::new(0.0, n as f64);
    let flat = Mesh::plane(&Rectangle { plane: Plane::XY, x: side, y: side }, n, n).unwrap();
    let lift = |q: &Point3| p(q.x, q.y, 0.3 * (q.x * 1.3 + q.y * 0.7).sin() * (q.y * 1.1).cos());
    Mesh::new(flat.vertices().iter().map(lift).collect(), flat.faces().to_vec()).unwrap()
}

#[test]
fn quads_become_flat_and_points_fit() {
    let mesh = wavy(4);
    let mut all = goals(Trial::of("Planarize").item(mesh.clone()).item(1.0));
    all.extend(goals(Trial::of("Show").item(mesh)));
    let outcome = solved(all);
    let shown = outcome.outputs[2].column().iter().last().flatten();
    let Some(Value::Mesh(flat)) = shown else { panic!("{shown:?}") };
    let values = Trial::of("PlanarityAnalysis").tree(Tree::item(Value::Mesh(flat))).run();
    for value in values.outputs[1].column().iter() {
        assert!(matches!(value, Some(Value::Number(x)) if x < 1e-4), "{value:?}");
    }
    let odd = [p(1.0, 0.1, 0.0), p(0.0, 1.2, 0.1), p(-1.1, 0.0, 0.0), p(0.0, -1.0, -0.1), p(0.6, 0.7, 0.9)];
    let at = points(&solved(goals(Trial::of("CoCircular").list(odd))));
    let (plane, off) = Plane::fit(&at).unwrap();
    assert!(off < 1e-6);
    let circle = katydid_geometry::Circle::through(at[0], at[1], at[2]);
    let centre = circle.map_or(plane.origin, |circle| circle.plane.origin);
    let radii: Vec<f64> = at.iter().map(|q| q.distance_to(centre)).collect();
    radii.iter().for_each(|r| near(*r, radii[0], 1e-5));
    let at = points(&solved(goals(Trial::of("CoLinear").list(odd))));
    let line = Line::new(at[0], at[2]);
    assert!(at.iter().all(|q| {
        let way = line.direction().unitized().unwrap();
        (*q - at[0]).cross(way).length() < 1e-6
    }));
    let volume = Trial::of_guid("26efde70-0c5c-4181-af3e-1a767d64b449");
    let side = Interval::new(0.0, 1.0);
    let shape = katydid_geometry::Box3 { plane: Plane::XY, x: side, y: side, z: side };
    let cube = Mesh::cuboid(&shape, 1, 1, 1).unwrap();
    let mut all = goals(volume.item(cube.clone()).item(8.0));
    all.extend(goals(Trial::of("Show").item(cube)));
    let outcome = solved(all);
    let Some(Some(Value::Mesh(big))) = outcome.outputs[2].column().iter().last() else { panic!() };
    near(big.volume(), 8.0, 1e-6);
}

#[test]
fn a_soap_film_is_flat_and_pressure_balances() {
    let rim = [p(0.0, 0.0, 0.0), p(2.0, 0.0, 0.0), p(2.0, 2.0, 0.0), p(0.0, 2.0, 0.0)];
    let top = p(0.7, 1.2, 1.5);
    let vertices = [rim.to_vec(), vec![top]].concat();
    let faces = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]].map(MeshFace::Triangle);
    let mesh = Mesh::new(vertices, faces.to_vec()).unwrap();
    let mut all: Vec<Value> = rim.iter().flat_map(|q| anchor(*q)).collect();
    all.extend(goals(Trial::of_guid("76ab889c-8593-4892-861d-a80b5311a981").item(mesh.clone())));
    let at = points(&solved(all.clone()));
    near(at[4].z, 0.0, 1e-6);
    // Under pressure the force on the middle vertex is the slope of the area times the tension: both by differences.
    all.extend(goals(Trial::of("Pressure").item(mesh).item(0.2)));
    let at = points(&solved(all));
    let lifted = |q: Point3| -> f64 {
        (0..4).map(|k| 0.5 * (at[(k + 1) % 4] - at[k]).cross(q - at[k]).length()).sum()
    };
    let up = Vector3::new(0.0, 0.0, 1e-5);
    let slope = (lifted(at[4] + up) - lifted(at[4] + up * -1.0)) / 2e-5;
    near(slope, 0.2 * 4.0 / 3.0, 1e-4);
}

#[test]
fn what_collides_keeps_apart() {
    let spheres =
        Trial::of("SphereCollide").list([p(0.0, 0.0, 0.0), p(0.5, 0.0, 0.0), p(9.0, 0.0, 0.0)]).item(1.0);
    let at = points(&solved(goals(spheres)));
    near(at[0].distance_to(at[1]), 2.0, 1e-6);
    near(at[2].x, 9.0, 1e-12);
    let lines =
        [Line::new(p(-1.0, 0.0, 0.0), p(1.0, 0.0, 0.0)), Line::new(p(0.0, -1.0, 0.3), p(0.0, 1.0, 0.3))];
    let at = points(&solved(goals(Trial::of("Collider").list(lines).item(0.5))));
    near(at[2].z - at[0].z, 1.0, 1e-6);
    let side = Interval::new(0.0, 1.0);
    let square =
        PolylineCurve::new(vec![p(0., 0., 0.), p(4., 0., 0.), p(4., 4., 0.), p(0., 4., 0.), p(0., 0., 0.)]);
    let inside = Trial::of("CurvePointCollide").list([p(1.0, 2.0, 0.0), p(7.0, 2.0, 0.0)]);
    let at = points(&solved(goals(inside.item(Curve::Polyline(square.unwrap())))));
    near(at[0].x, 0.0, 1e-6);
    near(at[1].x, 7.0, 1e-12);
    let shape = katydid_geometry::Box3 { plane: Plane::XY, x: side, y: side, z: side };
    let cube = Mesh::cuboid(&shape, 1, 1, 1).unwrap();
    let at = points(&solved(goals(Trial::of("SolidPointCollide").list([p(0.5, 0.9, 0.5)]).item(cube))));
    near(at[0].y, 1.0, 1e-6);
    let mut all = goals(Trial::of("Floor"));
    all.extend(spring(p(0.0, 0.0, -1.0), p(1.0, 0.0, 2.0), 1.0, 1.0));
    assert!(points(&solved(all)).iter().all(|q| q.z > -1e-5));
}

#[test]
fn solvers_agree_and_stay_when_told() {
    let (a, b) = (p(0.0, 0.0, 0.0), p(3.0, 0.0, 0.0));
    let all: Vec<Value> = [anchor(a), spring(a, b, 1.0, 5.0)].concat();
    let tree = || Tree::branch_at(Path::zero(), Column::of_values(all.clone(), None));
    let end = |outcome: &Outcome| points(outcome)[1].x;
    near(end(&Trial::of_guid(SOLVER).tree(tree()).run()), 1.0, 1e-5);
    near(end(&Trial::of_guid(SOLVER).tree(tree()).item(true).run()), 3.0, 1e-12);
    near(end(&Trial::of("ZombieSolver").tree(tree()).default().default().item(1000).run()), 1.0, 1e-3);
    near(end(&Trial::of("BouncySolver").tree(tree()).run()), 1.0, 1e-4);
    near(end(&Trial::of("StepSolver").tree(tree()).run()), 3.0, 1e-12);
    let soft: Vec<Value> = load(b, Vector3::new(0.5, 0.0, 0.0));
    let soft = Tree::branch_at(Path::zero(), Column::of_values(soft, None));
    let both = Trial::of("Soft & Hard Solver").tree(soft).tree(tree()).item(200).item(0.001).run();
    assert!((points(&both)[0].x - 1.0).abs() < 0.05, "{:?}", points(&both));
    let strange = Trial::of_guid(SOLVER).item(5.0);
    assert!(strange.message().contains("no goals"));
    let lost =
        Trial::of_guid("b476d3d0-4daf-489c-b91a-49f5dd72a256").item(a).item(40).run().outputs[0].clone();
    assert!(Trial::of_guid(SOLVER).tree(lost).message().contains("particle 40"));
}

#[test]
fn rigid_points_turn_as_a_whole() {
    let body = [p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(0.0, 2.0, 0.0), p(0.0, 0.0, 3.0)];
    let mut all = goals(Trial::of("RigidPointSet").list(body).default().item(100.0));
    let turned = [p(5.0, 0.0, 0.0), p(5.0, 1.0, 0.0), p(3.0, 0.0, 0.0)];
    for (q, to) in body.iter().zip(turned) {
        all.extend(goals(Trial::of_guid("3c30b1a1-4473-4ad4-a700-ea9770726c03").item(*q).item(to).item(1.0)));
    }
    let at = points(&solved(all));
    for (k, want) in
        [p(5.0, 0.0, 0.0), p(5.0, 1.0, 0.0), p(3.0, 0.0, 0.0), p(5.0, 0.0, 3.0)].into_iter().enumerate()
    {
        assert!(at[k].distance_to(want) < 1e-4, "{k}: {:?}", at[k]);
    }
}

fn sheet(nx: usize, ny: usize) -> Mesh {
    let side = |n: usize| Interval::new(0.0, n as f64);
    Mesh::plane(&Rectangle { plane: Plane::XY, x: side(nx), y: side(ny) }, nx, ny).unwrap()
}

#[test]
fn mesh_tools() {
    let items = |trial: Trial, k: usize| trial.run().outputs[k].item_count();
    let warp = Trial::of("WarpWeft").item(sheet(3, 2)).run();
    let mut counts = [warp.outputs[0].item_count(), warp.outputs[1].item_count()];
    counts.sort_unstable();
    assert_eq!(counts, [8, 9]);
    assert_eq!(items(Trial::of("NakedVertices").item(sheet(3, 3)), 0), 4);
    assert_eq!(items(Trial::of("NakedVertices").item(sheet(3, 3)), 1), 12);
    assert_eq!(items(Trial::of("HingePoints").item(sheet(3, 2)), 3), 7);
    assert_eq!(items(Trial::of("MeshCorners").item(sheet(3, 2)), 0), 4);
    assert_eq!(items(Trial::of("Stripper").item(sheet(3, 2)), 0), 3);
    assert_eq!(Trial::of("Refine").item(sheet(2, 1)).item(2).texts(0), ["{0}: Mesh (V:45  F:32)"]);
    assert_eq!(
        Trial::of("ByParent").item(sheet(2, 1)).item(1).texts(0),
        ["{0;0}: Mesh (V:9  F:4), Mesh (V:9  F:4)"]
    );
    assert_eq!(Trial::of("Diagonalize").item(sheet(1, 1)).texts(0), ["{0}: Mesh (V:5  F:4)"]);
    let two = [sheet(1, 1), sheet(2, 1)];
    assert_eq!(Trial::of("Combine&Clean").list(two).texts(0), ["{0}: Mesh (V:6  F:3)"]);
    assert_eq!(Trial::of("Checkerboard").item(sheet(3, 1)).texts(0), ["{0;0}: 0, 1, 0"]);
    assert_eq!(Trial::of("Bipartite").item(sheet(1, 1)).run().outputs[0].item_count(), 4);
    // A strip folded along its middle is flat again when it is unrolled, with the same area.
    let bent = sheet(4, 1);
    let fold = |q: &Point3| if q.x > 2.0 { p(2.0, q.y, q.x - 2.0) } else { *q };
    let folded = Mesh::new(bent.vertices().iter().map(fold).collect(), bent.faces().to_vec()).unwrap();
    let unrolled = Trial::of("Unroller").item(folded).run().outputs[0].column().get(0);
    let Some(Value::Mesh(unrolled)) = unrolled else { panic!("{unrolled:?}") };
    near(unrolled.area(), 4.0, 1e-9);
    assert_eq!(unrolled.vertices().len(), 10);
    assert!(unrolled.vertices().iter().all(|q| q.z.abs() < 1e-9));
    near(unrolled.vertices().iter().map(|q| q.x).fold(0.0, f64::max), 4.0, 1e-9);
}

#[test]
fn duplicates_and_corners() {
    let near_points = [p(0.0, 0.0, 0.0), p(0.005, 0.0, 0.0), p(1.0, 0.0, 0.0), p(0.0, 0.0, 0.0)];
    assert_eq!(Trial::of("removeDuplicatePts").list(near_points).run().outputs[0].item_count(), 2);
    let (a, b) = (p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0));
    let lines = [Line::new(a, b), Line::new(b, a), Line::new(a, p(1.0, 1.0, 0.0))];
    assert_eq!(Trial::of("removeDuplicateLines").list(lines).run().outputs[0].item_count(), 2);
    assert_eq!(
        Trial::of("interconnectPoints").list([a, b, p(2.0, 0.0, 0.0)]).run().outputs[0].item_count(),
        3
    );
    let corner = PolylineCurve::new(vec![a, b, p(1.0, 1.0, 0.0)]).unwrap();
    let split = Trial::of("SplitAtCorners").item(Curve::Polyline(corner)).run();
    assert_eq!([split.outputs[0].item_count(), split.outputs[1].item_count()], [1, 2]);
}

fn line(a: Point3, b: Point3) -> Curve {
    Curve::Line(LineCurve::new(Line::new(a, b)))
}

fn drawn(from: Point3, to: Point3, strength: f64) -> Vec<Value> {
    goals(Trial::of_guid("3c30b1a1-4473-4ad4-a700-ea9770726c03").item(from).item(to).item(strength))
}

/// Each length ends at the bound that it exceeds; from 9 the first step leads just past the other bound.
#[test]
fn lengths_are_clamped_to_the_bound_exceeded() {
    for (length, wanted) in [(1.0, 3.0), (2.2, 3.0), (4.5, 4.5), (7.0, 6.0), (9.0, 6.0), (20.0, 6.0)] {
        let clamp = Trial::of("ClampLength").item(line(p(0.0, 0.0, 0.0), p(length, 0.0, 0.0)));
        let at = points(&solved(goals(clamp.item(3.0).item(6.0))));
        near(at[0].distance_to(at[1]), wanted, 1e-9);
    }
}

/// Spheres that overlap rest in contact, whether or not another goal works on them too; those apart stay where they are.
#[test]
fn spheres_that_overlap_rest_in_contact() {
    for gap in [0.1, 0.5, 1.3, 1.99, 2.5] {
        let two = vec![p(0.0, 0.0, 0.0), p(gap, 0.0, 0.0)];
        let spheres = goals(Trial::of("SphereCollide").list(two.clone()).item(1.0));
        let thick = goals(Trial::of("Collider").list(two.clone()).list([0.7, 1.3]));
        let plane = goals(Trial::of("OnPlane").list(two.clone()));
        for apart in [spheres, thick] {
            for others in [Vec::new(), plane.clone(), anchor(two[0])] {
                let at = points(&solved([apart.clone(), others].concat()));
                near(at[0].distance_to(at[1]), gap.max(2.0), 1e-6);
            }
        }
    }
}

/// Two thick sticks across each other, whose lengths are kept.
#[test]
fn sticks_rest_in_contact() {
    let first = Line::new(p(-5.0, 0.0, 0.3), p(5.0, 0.0, 0.3));
    let second = Line::new(p(0.2, -5.0, -0.3), p(0.2, 5.0, -0.3));
    let mut all = goals(Trial::of("Collider").list([first, second]).item(0.8));
    all.extend([first, second].iter().flat_map(|l| spring(l.from, l.to, 10.0, 10.0)));
    let at = points(&solved(all));
    let [u, v] = [at[1] - at[0], at[3] - at[2]];
    let across = u.cross(v).unitized().unwrap();
    near((at[0] - at[2]).dot(across).abs(), 1.6, 1e-3);
}

/// What is plastic gives way by what exceeds its limit: its force is then the limit times its strength.
#[test]
fn plastic_lengths_give_way_to_their_limit() {
    let (o, q, r) = (p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(4.0, 0.0, 0.0));
    let plastic = |strength: f64| {
        let made = Trial::of("PlasticLength").item(line(o, q)).item(0.1).item(strength);
        goals(made)
    };
    let against = [anchor(o), anchor(r), spring(q, r, 0.0, 1.0), plastic(1.0)].concat();
    near(points(&solved(against))[2].x, 3.9, 1e-3);
    let pulled = [anchor(o), drawn(q, p(2.0, 0.0, 0.0), 20.0), plastic(5.0)].concat();
    near(points(&solved(pulled))[1].x, 2.0 - 0.5 / 20.0, 1e-3);
    // Within its limit it is a spring.
    let little = [anchor(o), drawn(q, p(1.08, 0.0, 0.0), 5.0), plastic(5.0)].concat();
    near(points(&solved(little))[1].x, 1.04, 1e-3);
}

/// The end of a chain of hard lengths drawn softly to a place out of reach: 400 steps of the soft goal, each with 50 of the hard ones,
/// are not enough.
#[test]
fn soft_goals_come_to_rest_beside_hard_ones() {
    let at: Vec<Point3> = (0..=4).map(|i| p(2.0 * f64::from(i), f64::from(i % 2), 0.0)).collect();
    let out_of_reach = p(14.0, 4.0, 0.0);
    let soft = Tree::branch_at(Path::zero(), Column::of_values(drawn(at[4], out_of_reach, 1.0), None));
    let links = at.windows(2).flat_map(|pair| spring(pair[0], pair[1], 5_f64.sqrt(), 1.0));
    let hard: Vec<Value> = anchor(at[0]).into_iter().chain(links).collect();
    let hard = Tree::branch_at(Path::zero(), Column::of_values(hard, None));
    let outcome = Trial::of("Soft & Hard Solver").tree(soft).tree(hard).item(50).item(0.05).run();
    assert!(outcome.messages.is_empty(), "{:?}", outcome.messages);
    let end = points(&outcome)[0] - at[0];
    let way = (out_of_reach - at[0]).unitized().unwrap();
    near(end.cross(way).length(), 0.0, 1e-5);
    near(end.length(), 4.0 * 5_f64.sqrt(), 0.02);
}

/// A steep dome with uneven faces, its rim held.
#[test]
fn tangential_smoothing_comes_to_rest_on_the_surface() {
    const N: usize = 12;
    let side = Interval::new(0.0, 8.0);
    let flat = Mesh::plane(&Rectangle { plane: Plane::XY, x: side, y: side }, N, N).unwrap();
    let height = |x: f64, y: f64| x * (8.0 - x) / 6.0 * y * (8.0 - y) / 16.0;
    let on_rim = |q: &Point3| [q.x, q.y].iter().any(|x| *x <= 0.0 || *x >= 8.0);
    let uneven = |q: &Point3| {
        let by = if on_rim(q) { 0.0 } else { 0.3 };
        let (x, y) = (q.x + by * (37.0 * q.x + 11.0 * q.y).sin(), q.y + by * (17.0 * q.x - 53.0 * q.y).cos());
        p(x, y, height(x, y))
    };
    let mesh = Mesh::new(flat.vertices().iter().map(uneven).collect(), flat.faces().to_vec()).unwrap();
    let mut all = goals(Trial::of("TangentialSmooth").item(mesh.clone()));
    all.extend(mesh.vertices().iter().filter(|q| on_rim(q)).flat_map(|q| anchor(*q)));
    all.extend(goals(Trial::of("Show").item(mesh)));
    let tree = Tree::branch_at(Path::zero(), Column::of_values(all, None));
    let outcome = Trial::of("ZombieSolver").tree(tree).default().default().item(200).run();
    let steps = outcome.outputs[0].column().get(0);
    assert!(matches!(steps, Some(Value::Integer(n)) if n < 200), "{steps:?}");
    let Some(Some(Value::Mesh(smooth))) = outcome.outputs[2].column().iter().last() else { panic!() };
    for q in smooth.vertices() {
        assert!((q.z - height(q.x, q.y)).abs() < 0.2, "{q:?} left the dome at {}", height(q.x, q.y));
    }
}
