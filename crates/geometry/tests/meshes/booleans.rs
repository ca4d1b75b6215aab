//! Unions, differences and intersections of random closed meshes: closed, and the volumes add up.

#![cfg(feature = "mesh-booleans")]
use katydid_geometry::{
    Box3, Error, Interval, Mesh, MeshTree, Plane, Point3, Solid, Surface, SurfaceMeshing, Torus, Vector3,
    Xform, intersect,
};

/// Numbers from a seed (S. Vigna, *splitmix64*).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    fn below(&mut self, n: usize) -> usize {
        ((self.next() * n as f64) as usize).min(n - 1)
    }

    fn vector(&mut self) -> Vector3 {
        Vector3::new(self.within(-1.0, 1.0), self.within(-1.0, 1.0), self.within(-1.0, 1.0))
    }
}

/// A closed mesh: box, ball, ring, crumpled ball or stretched box, in a random place; in every third case on a coarse
/// grid and along the axes, so that faces, edges and corners of both coincide.
fn shape(random: &mut Random, on_grid: bool) -> Mesh {
    let place = |random: &mut Random| {
        if on_grid {
            let at = |r: &mut Random| r.below(4) as f64 * 0.5;
            Plane { origin: Point3::new(at(random), at(random), at(random)), ..Plane::XY }
        } else {
            let origin = Point3::ORIGIN + random.vector();
            Plane::from_normal(origin, random.vector() + Vector3::new(0.0, 0.0, 0.01)).unwrap()
        }
    };
    let plane = place(random);
    let kind = random.below(5);
    if kind == 0 || on_grid {
        let mut side = || {
            let low = if on_grid { -0.5 * random.below(3) as f64 } else { random.within(-1.5, 0.0) };
            let high = if on_grid { 0.5 + 0.5 * random.below(3) as f64 } else { random.within(0.2, 1.5) };
            Interval::new(low, high)
        };
        let shape = Box3 { plane, x: side(), y: side(), z: side() };
        let mut n = || 1 + random.below(4);
        return Mesh::cuboid(&shape, n(), n(), n()).unwrap();
    }
    match kind {
        1 => {
            Mesh::sphere(&plane, random.within(0.3, 1.5), 3 + random.below(20), 2 + random.below(16)).unwrap()
        }
        2 => {
            let torus: Surface = Torus::new(plane, 1.0, random.within(0.1, 0.6)).unwrap().into();
            let limits = SurfaceMeshing { max_angle: random.within(0.3, 0.9), ..SurfaceMeshing::default() };
            Mesh::from_surface(&torus, &limits).unwrap()
        }
        3 => {
            // Radii that change from vertex to vertex: sharp, but seen from the middle without folds.
            let ball = Mesh::sphere(&plane, 1.0, 6 + random.below(16), 4 + random.below(12)).unwrap();
            let o = plane.origin;
            let crumple = |p: &Point3| o + (*p - o) * random.within(0.5, 1.2);
            Mesh::new(ball.vertices().iter().map(crumple).collect(), ball.faces().to_vec()).unwrap()
        }
        _ => {
            let ball = Mesh::sphere(&Plane::XY, 1.0, 12, 8).unwrap();
            let mut s = || random.within(0.05, 2.0);
            let stretch = Xform::scale_non_uniform(&Plane::XY, s(), s(), s());
            ball.transformed(&stretch)
                .unwrap()
                .transformed(&Xform::plane_to_plane(&Plane::XY, &plane))
                .unwrap()
        }
    }
}

fn checked(solid: Solid, what: &str) -> Mesh {
    let mesh = solid.to_mesh().unwrap();
    assert!(mesh.faces().is_empty() || mesh.is_closed(), "{what} is open");
    // Also every edge is walked as often one way as the other, or this would refuse it.
    assert!(Solid::new(&mesh).is_ok(), "{what} does not look to one side");
    mesh
}

#[test]
fn volumes_of_random_pairs_add_up() {
    let cases: u64 = std::env::var("KATYDID_CASES").ok().and_then(|s| s.parse().ok()).unwrap_or(100);
    let (mut worst, mut meetings, mut slowest) = (0.0_f64, 0, 0.0_f64);
    for case in 0..cases {
        let mut random = Random(0x5eed_0000 + case);
        let on_grid = case % 3 == 0;
        let (a, b) = (shape(&mut random, on_grid), shape(&mut random, on_grid));
        let start = std::time::Instant::now();
        let (p, q) = (Solid::new(&a).unwrap(), Solid::new(&b).unwrap());
        let name = |what: &str| format!("case {case}: {what}");
        let union = checked(p.union(&q).unwrap(), &name("A ∪ B"));
        let both = checked(p.intersection(&q).unwrap(), &name("A ∩ B"));
        let less = checked(p.difference(&q).unwrap(), &name("A − B"));
        slowest = slowest.max(start.elapsed().as_secs_f64());
        let [va, vb, vu, vi, vd] = [&a, &b, &union, &both, &less].map(Mesh::volume);
        let size = va + vb;
        let errors = [vu + vi - va - vb, vd + vi - va, vu - vd - vb].map(|e| e.abs() / size);
        for (error, law) in errors.into_iter().zip(["∪ + ∩ = A + B", "(A − B) + ∩ = A", "∪ = (A − B) + B"])
        {
            assert!(error < 1e-9, "case {case}: {law} is wrong by {error:e} of {size}");
            worst = worst.max(error);
        }
        assert!(
            vi >= -1e-9 * size && vi <= va.min(vb) + 1e-9 * size,
            "case {case}: the common volume is {vi}"
        );
        meetings += usize::from(vi > 1e-6 * size);
        // Where the skins cross, the curves of the meshes' intersection are closed.
        if !on_grid {
            let lines = intersect::mesh_mesh(&MeshTree::new(&a), &MeshTree::new(&b), 1e-9).unwrap();
            assert!(lines.iter().all(|l| l.first() == l.last()), "case {case}: an open intersection curve");
            assert!(!lines.is_empty() || vi.min(va - vi).min(vb - vi) < 1e-9 * size, "case {case}: no curve");
        }
    }
    println!("{cases} pairs, {meetings} meet, volumes within {worst:.1e}, slowest {slowest:.3} s");
    assert!(meetings * 2 > cases as usize);
}

#[test]
fn shapes_that_nearly_coincide() {
    let side = Interval::new(-1.0, 1.0);
    let cube = Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 3, 3, 3).unwrap();
    let ball = Mesh::sphere(&Plane::XY, 1.0, 16, 12).unwrap();
    for shape in [&cube, &ball] {
        for power in 1..18 {
            let little = 10_f64.powi(-power);
            let axis = Vector3::new(0.2, 0.3, 1.0);
            let moves = [
                Xform::rotation(little, axis, Point3::ORIGIN).unwrap(),
                Xform::translation(axis * little),
                Xform::scale(Point3::ORIGIN, 1.0 + little),
            ];
            for (k, motion) in moves.iter().enumerate() {
                let other = shape.transformed(motion).unwrap();
                let (p, q) = (Solid::new(shape).unwrap(), Solid::new(&other).unwrap());
                let name = |what: &str| format!("{what} at 1e-{power}, motion {k}");
                let union = checked(p.union(&q).unwrap(), &name("A ∪ B")).volume();
                let both = checked(p.intersection(&q).unwrap(), &name("A ∩ B")).volume();
                let less = checked(p.difference(&q).unwrap(), &name("A − B")).volume();
                let (a, b) = (shape.volume(), other.volume());
                assert!((union + both - a - b).abs() < 1e-9, "{}: {union} + {both}", name("volumes"));
                assert!((less + both - a).abs() < 1e-9, "{}: {less} + {both}", name("the difference"));
                // Curves of meshes that all but coincide are made of rounding: they may only not be endless.
                let lines =
                    intersect::mesh_mesh(&MeshTree::new(shape), &MeshTree::new(&other), 1e-6).unwrap();
                assert!(lines.len() < 2000, "{}", name("curves"));
            }
        }
    }
}

/// The union of many is that of one after the other, in whatever order, and holds the points that any of them holds.
#[test]
fn unions_of_many_are_unions_in_turn() {
    let cases: u64 = std::env::var("KATYDID_CASES").ok().and_then(|s| s.parse().ok()).unwrap_or(30);
    for case in 0..cases {
        let mut random = Random(0xfeed_0000 + case);
        let on_grid = case % 3 == 0;
        let mut meshes: Vec<Mesh> =
            (0..2 + random.below(10)).map(|_| shape(&mut random, on_grid && case % 2 == 0)).collect();
        // Some lie beside the others, so that there are boxes that do not touch.
        for mesh in &mut meshes {
            let step = Vector3::new(random.below(3) as f64 * 3.0, 0.0, 0.0);
            *mesh = mesh.transformed(&Xform::translation(step)).unwrap();
        }
        // In some cases one goes through itself, and one looks inwards.
        if case % 4 == 1 {
            let [a, b] = [shape(&mut random, false), shape(&mut random, false)];
            meshes.push(Mesh::join(&[a, b]).unwrap());
        }
        if let (true, Some(first)) = (case % 5 == 2, meshes.first_mut()) {
            *first = first.flipped();
        }
        let solids: Vec<Solid> = meshes.iter().map(|mesh| Solid::new(mesh).unwrap()).collect();
        let united = checked(Solid::united(&solids).unwrap(), &format!("case {case}: all"));
        let mut turns = solids[0].clone();
        for solid in &solids[1..] {
            turns = turns.union(solid).unwrap();
        }
        let turns = checked(turns, &format!("case {case}: one after the other"));
        let (got, want) = (united.volume(), turns.volume());
        assert!((got - want).abs() <= 1e-9 * want, "case {case}: {got} for {want}");
        let trees: Vec<MeshTree> = meshes.iter().map(MeshTree::new).collect();
        let whole = MeshTree::new(&united);
        for _ in 0..100 {
            let p = Point3::new(random.within(-2.0, 8.0), random.within(-2.0, 2.0), random.within(-2.0, 2.0));
            let any = trees.iter().any(|tree| tree.winding_number(p).abs() > 0.5);
            assert_eq!(whole.winding_number(p).abs() > 0.5, any, "case {case}: {p:?}");
        }
    }
    assert!(Solid::united(&[]).unwrap().is_empty());
}

#[test]
fn open_meshes_are_refused_with_the_reason() {
    for case in 0..20 {
        let mut random = Random(case);
        let whole = shape(&mut random, false);
        let faces = whole.faces()[1..].to_vec();
        let open = Mesh::new(whole.vertices().to_vec(), faces).unwrap();
        let Err(Error::Invalid { why, .. }) = Solid::new(&open) else { panic!("an open mesh was taken") };
        assert!(why.contains("not closed"), "{why}");
    }
}

#[test]
fn points_inside_agree_with_the_booleans() {
    let mut random = Random(77);
    let (a, b) = (shape(&mut random, false), shape(&mut random, true));
    let union = Solid::new(&a).unwrap().union(&Solid::new(&b).unwrap()).unwrap().to_mesh().unwrap();
    let [a, b, union] = [&a, &b, &union].map(MeshTree::new);
    for _ in 0..500 {
        let p = Point3::ORIGIN + random.vector() * 2.0;
        let inside = |t: &MeshTree| t.containment(p, 0.0) == katydid_geometry::Containment::Inside;
        assert_eq!(inside(&union), inside(&a) || inside(&b), "{p:?}");
        // The winding number says the same as the rays.
        assert_eq!(inside(&a), a.winding_number(p).abs() > 0.5, "{p:?}");
    }
}
