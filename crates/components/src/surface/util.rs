//! Surface / Util.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::{Domain2, Face, Item, Tree, TreeBuilder, Value};
use katydid_geometry::{Direction, Interval, Plane, Point3, Surface, Vector3};

use super::{named, shared, warning};

/// The parameters of a grid of so many cells, evenly spread over both domains.
fn grid(context: &Context<'_>, surface: &Surface, cells: [i32; 2]) -> Result<[Vec<f64>; 2], Message> {
    let [m, n] = cells.map(|n| usize::try_from(n).ok().filter(|&n| n > 0));
    let (Some(m), Some(n)) = (m, n) else {
        return Err(Message::error("Both counts must be at least 1"));
    };
    let all = m.saturating_add(1).saturating_mul(n.saturating_add(1));
    context.items(all.saturating_mul(3))?;
    context.bytes(all.saturating_mul(96))?;
    let along = |d: Direction, n: usize| {
        let domain = surface.domain(d);
        (0..=n).map(|i| domain.at(i as f64 / n as f64)).collect::<Vec<f64>>()
    };
    Ok([along(Direction::U, m), along(Direction::V, n)])
}

/// A tree with a branch for each u and an item for each v.
fn rows<T: Item>(
    context: &Context<'_>,
    [us, vs]: &[Vec<f64>; 2],
    make: impl Fn(f64, f64) -> Option<T>,
) -> Result<Tree, Message> {
    let start = context.path().child(context.iteration());
    let mut tree = TreeBuilder::<T>::new();
    for (i, &u) in us.iter().enumerate() {
        context.check()?;
        tree.branch(start.child(i));
        vs.iter().for_each(|&v| tree.push(make(u, v)));
    }
    Ok(tree.finish())
}

/// The same in one list, u running slowest.
fn list<T>([us, vs]: &[Vec<f64>; 2], make: impl Fn(f64, f64) -> T) -> Vec<T> {
    us.iter().flat_map(|&u| vs.iter().map(move |&v| (u, v))).map(|(u, v)| make(u, v)).collect()
}

fn parameters(u: f64, v: f64) -> Point3 {
    Point3::new(u, v, 0.0)
}

/// Points on a surface at even steps of its parameters.
///
/// A branch holds the points of one u. Even steps of the parameters are not always even lengths.
#[component(
    "5106bafc-d5d4-4983-83e7-7be3ed07f502",
    name = "Divide Surface",
    nick = "SDivide",
    at = "Surface/Util"
)]
#[output("Points", "P", "The points, U + 1 branches of V + 1.", kind = Point)]
#[output("Normals", "N", "The unit normals there.", kind = Vector)]
#[output("Parameters", "uv", "The parameters, u as x and v as y.", kind = Point)]
fn divide_surface(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    face: Face,
    /// The number of steps along u, at least 1.
    #[port("U Count", "U", default = 10)]
    u_count: i32,
    /// The number of steps along v, at least 1.
    #[port("V Count", "V", default = 10)]
    v_count: i32,
) -> Result<(Tree, Tree, Tree), Message> {
    let grid = grid(context, &face.surface, [u_count, v_count])?;
    let normals = if context.is_wanted(1) {
        rows::<Vector3>(context, &grid, |u, v| face.normal_at(u, v))?
    } else {
        Tree::empty()
    };
    Ok((
        rows(context, &grid, |u, v| Some(face.point_at(u, v)))?,
        normals,
        rows(context, &grid, |u, v| Some(parameters(u, v)))?,
    ))
}

/// Points on a surface at even steps of its parameters, in one list.
#[component(
    "082976f0-c741-4df8-a1d4-89891bf8619f",
    name = "Divide Surface [OBSOLETE]",
    nick = "Divide",
    at = "Surface/Util",
    old
)]
#[output("Points", "P", "The points, v running fastest.")]
#[output("Normals", "N", "The unit normals there.")]
#[output("Parameters", "uv", "The parameters, u as x and v as y.")]
fn divide_surface_into_list(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    face: Face,
    /// The number of steps along u, at least 1.
    #[port("U Count", "U", default = 10)]
    u_count: i32,
    /// The number of steps along v, at least 1.
    #[port("V Count", "V", default = 10)]
    v_count: i32,
) -> Result<(Vec<Point3>, Vec<Option<Vector3>>, Vec<Point3>), Message> {
    let grid = grid(context, &face.surface, [u_count, v_count])?;
    Ok((
        list(&grid, |u, v| face.point_at(u, v)),
        list(&grid, |u, v| face.normal_at(u, v)),
        list(&grid, parameters),
    ))
}

/// Tangent planes of a surface at even steps of its parameters, their z axes along its normals and their x axes along u;
/// along v on a face that looks against its surface.
///
/// A branch holds the planes of one u.
#[component(
    "332378f4-acb2-43fe-8593-ed22bfeb2721",
    name = "Surface Frames",
    nick = "SFrames",
    at = "Surface/Util"
)]
#[output("Frames", "F", "The planes, U + 1 branches of V + 1.", kind = Plane)]
#[output("Parameters", "uv", "The parameters, u as x and v as y.", kind = Point)]
fn surface_frames(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    face: Face,
    /// The number of steps along u, at least 1.
    #[port("U Count", "U", default = 10)]
    u_count: i32,
    /// The number of steps along v, at least 1.
    #[port("V Count", "V", default = 10)]
    v_count: i32,
) -> Result<(Tree, Tree), Message> {
    let grid = grid(context, &face.surface, [u_count, v_count])?;
    Ok((
        rows::<Plane>(context, &grid, |u, v| face.frame_at(u, v))?,
        rows(context, &grid, |u, v| Some(parameters(u, v)))?,
    ))
}

/// Tangent planes of a surface at even steps of its parameters, in one list.
#[component(
    "59143f40-32f3-47c1-b9ae-1a09eb9c926b",
    name = "Surface Frames [OBSOLETE]",
    nick = "Frames",
    at = "Surface/Util",
    old
)]
#[output("Frames", "F", "The planes, v running fastest.")]
#[output("Parameters", "uv", "The parameters, u as x and v as y.")]
fn surface_frames_in_list(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    face: Face,
    /// The number of steps along u, at least 1.
    #[port("U Count", "U", default = 10)]
    u_count: i32,
    /// The number of steps along v, at least 1.
    #[port("V Count", "V", default = 10)]
    v_count: i32,
) -> Result<(Vec<Option<Plane>>, Vec<Point3>), Message> {
    let grid = grid(context, &face.surface, [u_count, v_count])?;
    Ok((list(&grid, |u, v| face.frame_at(u, v)), list(&grid, parameters)))
}

/// The part of a surface over a part of its domains.
///
/// What reaches outside the domains is cut off; a part that lies outside altogether is none: a warning.
#[component("6a9ccaab-1b03-484e-bbda-be9c81584a66", name = "Isotrim", nick = "SubSrf", at = "Surface/Util")]
#[output("Surface", "S", "The part, with its part of the domains.")]
fn isotrim(
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// The part, in the surface's own domains.
    #[port("Domain", "D")]
    part: Domain2,
) -> Result<Shared<Surface>, Message> {
    let inside = |d: Direction, part: Interval| {
        let cut = surface.domain(d).intersection(part.ordered()).filter(|cut| cut.is_increasing());
        cut.ok_or_else(|| Message::warning("The domain does not reach into that of the surface"))
    };
    let (u, v) = (inside(Direction::U, part.u)?, inside(Direction::V, part.v)?);
    Ok(shared(surface.sub_surface(u, v).map_err(warning)?))
}

/// Turns a surface over, so that its normals point to the other side.
///
/// With a guide, only when its normal is opposed to the guide's where the guide is nearest to the middle of the surface.
/// A surface without trims is walked through backwards in u then, over the same domain.
#[component("c3d1f2b8-8596-4e8d-8861-c28ba8ffb4f4", name = "Flip", nick = "Flip", at = "Surface/Util")]
#[output("Surface", "S", "The surface.", kind = Surface)]
#[output("Result", "R", "Whether it was turned over.")]
fn flip(
    /// The surface.
    #[port("Surface", "S", kind = Brep)]
    surface: Value,
    /// A surface whose normal side is wanted.
    #[port("Guide", "G")]
    guide: Option<Shared<Surface>>,
) -> Result<(Value, bool), Message> {
    let brep = surface.brep().transpose().map_err(Message::warning)?;
    let brep = brep.ok_or_else(|| Message::error(format!("A {} has no faces", named(&surface))))?;
    let opposed = match (guide, brep.face_surface(0)) {
        (Some(guide), Some(own)) => {
            let [u, v] = Direction::BOTH.map(|d| own.domain(d).middle());
            let near = guide.closest_point(own.point_at(u, v))?;
            let reversed = brep.faces().first().is_some_and(|face| face.reversed);
            match (own.normal_at(u, v), guide.normal_at(near.u, near.v)) {
                (Some(own), Some(wanted)) => (own.dot(wanted) < 0.0) != reversed,
                _ => false,
            }
        }
        _ => true,
    };
    if !opposed {
        return Ok((surface, false));
    }
    let Value::Surface(whole) = &surface else { return Ok((Value::from((*brep).clone().flipped()), true)) };
    let turned = whole.reversed(Direction::U).with_domain(Direction::U, whole.domain(Direction::U));
    Ok((Value::from(turned.map_err(warning)?), true))
}

/// A surface without its trims.
#[component("fa92858a-a180-4545-ad4d-0dc644b3a2a8", name = "Untrim", nick = "Untrim", at = "Surface/Util")]
#[output("Surface", "S", "The whole surface.")]
fn untrim(
    /// The surface.
    #[port("Surface", "S")]
    surface: Shared<Surface>,
) -> Shared<Surface> {
    surface
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Domain2, Value};
    use katydid_geometry::{Direction, Interval, Plane, PlaneSurface, Point3, Sphere, Surface};

    fn flat() -> Surface {
        PlaneSurface::new(Plane::XY, Interval::new(0.0, 4.0), Interval::new(0.0, 3.0)).unwrap().into()
    }

    fn surface(trial: Trial) -> Surface {
        match trial.run().outputs[0].column().get(0) {
            Some(Value::Surface(surface)) => (*surface).clone(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn grids_on_surfaces() {
        let divided = || Trial::of("Divide Surface").item(flat()).item(2).item(1);
        assert_eq!(
            divided().texts(0),
            [
                "{0;0;0}: {0, 0, 0}, {0, 3, 0}",
                "{0;0;1}: {2, 0, 0}, {2, 3, 0}",
                "{0;0;2}: {4, 0, 0}, {4, 3, 0}"
            ]
        );
        assert_eq!(divided().texts(1)[2], "{0;0;2}: {0, 0, 1}, {0, 0, 1}");
        assert_eq!(divided().texts(2)[1], "{0;0;1}: {2, 0, 0}, {2, 3, 0}");
        let frames = Trial::of("Surface Frames").item(flat()).item(1).item(1).texts(0);
        assert_eq!(
            frames[1],
            "{0;0;1}: O(4.00,0.00,0.00) Z(0.00,0.00,1.00), O(4.00,3.00,0.00) Z(0.00,0.00,1.00)"
        );
        let old = Trial::of("Divide Surface [OBSOLETE]").item(flat()).item(1).item(1).texts(0);
        assert_eq!(old, ["{0;0}: {0, 0, 0}, {0, 3, 0}, {4, 0, 0}, {4, 3, 0}"]);
        let old = Trial::of("Surface Frames [OBSOLETE]").item(flat()).item(1).item(1).texts(1);
        assert_eq!(old, ["{0;0}: {0, 0, 0}, {0, 3, 0}, {4, 0, 0}, {4, 3, 0}"]);
        assert!(Trial::of("Divide Surface").item(flat()).item(0).message().contains("at least 1"));
        let too_many = Trial::of("Divide Surface").item(flat()).item(i32::MAX).item(i32::MAX);
        assert!(!too_many.message().is_empty());
    }

    #[test]
    fn parts_and_sides() {
        let part = |u: Interval, v: Interval| Trial::of("Isotrim").item(flat()).item(Domain2 { u, v });
        let cut = surface(part(Interval::new(3.0, 1.0), Interval::new(2.0, 9.0)));
        assert_eq!(cut.domain(Direction::U), Interval::new(1.0, 3.0));
        assert!((cut.area().unwrap().area - 2.0).abs() < 1e-9);
        assert!(part(Interval::new(5.0, 6.0), Interval::UNIT).message().contains("reach"));

        let turned = surface(Trial::of("Flip").item(flat()));
        assert_eq!(turned.normal_at(1.0, 1.0).unwrap().z, -1.0);
        assert_eq!(turned.domain(Direction::U), Interval::new(0.0, 4.0));
        assert_eq!(Trial::of("Flip").item(flat()).item(flat()).texts(1), ["{0}: False"]);
        assert_eq!(Trial::of("Flip").item(flat()).item(turned).texts(1), ["{0}: True"]);
        let ball = Surface::from(Sphere::around(Point3::ORIGIN, 1.0).unwrap());
        assert_eq!(surface(Trial::of("Untrim").item(ball.clone())), ball);
    }
}
