//! The kinds of surfaces, each with a place that is not special and a solid that has it.

use katydid_geometry::construct::{box_brep, cone, cylinder, extrude, revolve, sphere, torus};
use katydid_geometry::{
    Box3, Brep, Cone, Curve, Cylinder, Interval, KnotSpacing, Line, NurbsCurve, Plane, PlaneSurface, Point3,
    RevolutionSurface, Sphere, SumSurface, Surface, Tolerance, Torus, Vector3,
};

/// A surface and a solid of its kind.
pub(crate) struct Subject {
    pub(crate) surface: Surface,
    /// Closed, with that kind of surface among its faces.
    pub(crate) solid: Brep,
    pub(crate) tolerance: Tolerance,
}

impl Subject {
    fn new(surface: impl Into<Surface>, solid: Brep) -> Self {
        Self { surface: surface.into(), solid, tolerance: Tolerance::default() }
    }

    /// The parameters of a place that is on no seam, pole or symmetry.
    pub(crate) fn place(&self) -> [f64; 2] {
        use katydid_geometry::Direction::{U, V};
        [self.surface.domain(U).at(0.37), self.surface.domain(V).at(0.41)]
    }

    /// The point and the normal there.
    pub(crate) fn frame(&self) -> (Point3, Vector3) {
        let [u, v] = self.place();
        (self.surface.point_at(u, v), self.surface.normal_at(u, v).unwrap())
    }
}

pub(crate) fn names() -> Vec<&'static str> {
    vec!["plane", "cylinder", "cone", "sphere", "torus", "extrusion", "revolution", "NURBS", "trimmed"]
}

/// In the order of the names.
pub(crate) fn all() -> Vec<Subject> {
    let tolerance = Tolerance::default();
    let block = Box3 {
        plane: Plane::XY,
        x: Interval::new(-2.0, 3.0),
        y: Interval::new(-1.0, 2.0),
        z: Interval::new(-1.0, 1.5),
    };
    let round = Cylinder::new(Plane::XY, 1.5, Interval::new(0.0, 4.0)).unwrap();
    let pointed = Cone::new(Plane::XY, 4.0, 1.5).unwrap();
    let ball = Sphere::around(Point3::new(0.3, -0.2, 0.1), 2.0).unwrap();
    let ring = Torus::new(Plane::XY, 3.0, 1.0).unwrap();
    let outline = wavy();
    let profile = vase();
    let axis = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 1.0));
    let turn = Interval::new(0.0, std::f64::consts::TAU);
    let free: Surface = ball.to_nurbs().unwrap().into();
    // Half of a ball with a lid: its round face is trimmed by the lid.
    let half = sphere(&ball).unwrap();
    let cut = Plane::from_normal(Point3::new(0.3, -0.2, 0.4), Vector3::new(0.3, 0.2, 1.0)).unwrap();
    let below = half.split_by_plane(&cut, &tolerance, || true).unwrap()[0].remove_first();
    let trimmed = below.capped(&tolerance).unwrap().0;
    vec![
        Subject::new(
            PlaneSurface::new(Plane::XY, Interval::new(-2.0, 3.0), Interval::new(-1.0, 2.0)).unwrap(),
            box_brep(&block).unwrap(),
        ),
        Subject::new(round, cylinder(&round, [true, true]).unwrap()),
        Subject::new(pointed, cone(&pointed, true).unwrap()),
        Subject::new(ball, sphere(&ball).unwrap()),
        Subject::new(ring, torus(&ring).unwrap()),
        Subject::new(
            SumSurface::extrusion(outline.clone(), Vector3::new(0.0, 0.0, 3.0)).unwrap(),
            extrude(&outline, Vector3::new(0.0, 0.0, 3.0), true, &tolerance).unwrap(),
        ),
        Subject::new(
            RevolutionSurface::new(profile.clone(), axis, turn).unwrap(),
            revolve(&profile, axis, turn, &tolerance).unwrap().capped(&tolerance).unwrap().0,
        ),
        Subject::new(free.clone(), Brep::from_surface(free).unwrap()),
        Subject::new(ball, trimmed),
    ]
}

/// The first of a list; the cut must have left one.
trait First<T> {
    fn remove_first(&self) -> T;
}

impl<T: Clone> First<T> for Vec<T> {
    fn remove_first(&self) -> T {
        self.first().cloned().unwrap()
    }
}

/// A closed, smooth curve in the plane z = 0 that is no circle.
fn wavy() -> Curve {
    let points: Vec<Point3> = (0..9)
        .map(|k| {
            let (sine, cosine) =
                katydid_elementary::Elementary::sine_cosine(std::f64::consts::TAU * f64::from(k) / 9.0);
            let radius = 2.0 + if k % 3 == 0 { 0.4 } else { 0.0 };
            Point3::new(radius * cosine, radius * sine, 0.0)
        })
        .collect();
    NurbsCurve::interpolate_periodic(3, &points, KnotSpacing::Chord).unwrap().into()
}

/// An open curve beside the z axis that bulges.
fn vase() -> Curve {
    let points = [[1.0, 0.0], [1.8, 1.0], [1.2, 2.2], [1.5, 3.0]].map(|[x, z]| Point3::new(x, 0.0, z));
    NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None).unwrap().into()
}
