//! Intersect / Shape: unions, differences and intersections of meshes.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{Error, Mesh, Solid};

/// The solid inside a mesh; the message says which mesh of which port encloses none.
fn solid(context: &Context<'_>, mesh: &Mesh, place: &str) -> Result<Solid, Message> {
    context.check()?;
    Solid::new(mesh).map_err(|error| match error {
        Error::Invalid { why, .. } => Message::error(format!("{place} cannot be used: {why}")),
        other => Message::error(format!("{place} cannot be used: {other}")),
    })
}

fn solids(context: &Context<'_>, meshes: &List<'_, Shared<Mesh>>, name: &str) -> Result<Vec<Solid>, Message> {
    let one = |(i, mesh): (usize, Option<Shared<Mesh>>)| {
        Some(solid(context, &*mesh?, &format!("Mesh {i} of {name}")))
    };
    meshes.iter().enumerate().filter_map(one).collect()
}

/// The meshes of a solid, one for each part that hangs together.
fn meshes(context: &Context<'_>, solid: &Solid) -> Result<Vec<Shared<Mesh>>, Message> {
    let parts = solid.to_mesh()?.solids()?;
    context.items(parts.len())?;
    Ok(parts.into_iter().map(Shared::new).collect())
}

/// Joins closed meshes: what is inside any of them.
///
/// A mesh with naked edges is an error.
#[component(
    "88060a82-0bf7-46bb-9af8-bdc860cf7e1d",
    name = "Mesh Union",
    nick = "MUnion",
    at = "Intersect/Shape"
)]
#[output("Result", "R", "The closed meshes, one for each part that hangs together.")]
fn mesh_union(
    context: &Context<'_>,
    /// Closed meshes; nulls are skipped.
    #[port("Meshes", "M")]
    list: List<Shared<Mesh>>,
) -> Result<Vec<Shared<Mesh>>, Message> {
    meshes(context, &Solid::united(&solids(context, &list, "M")?)?)
}

/// Takes closed meshes away from closed meshes: what is inside each of the first and in none of the second.
///
/// A mesh with naked edges is an error.
#[component(
    "4f3147f4-9fcd-4a7e-be0e-b1841caa5f97",
    name = "Mesh Difference",
    nick = "MDif",
    at = "Intersect/Shape"
)]
#[output(
    "Result",
    "R",
    "The closed meshes, one for each part that hangs together, in order of the first meshes."
)]
fn mesh_difference(
    context: &Context<'_>,
    /// Closed meshes to cut; nulls are skipped.
    #[port("Meshes A", "A")]
    a: List<Shared<Mesh>>,
    /// Closed meshes to take away; nulls are skipped.
    #[port("Meshes B", "B")]
    b: List<Shared<Mesh>>,
) -> Result<Vec<Shared<Mesh>>, Message> {
    let (a, b) = (solids(context, &a, "A")?, Solid::united(&solids(context, &b, "B")?)?);
    let mut out = Vec::new();
    for solid in a {
        context.check()?;
        let left = if b.is_empty() { solid } else { solid.difference(&b)? };
        out.extend(meshes(context, &left)?);
    }
    context.items(out.len())?;
    Ok(out)
}

/// What two sets of closed meshes have in common: inside any of the first and any of the second.
///
/// A mesh with naked edges is an error; nothing in common gives an empty list and a warning.
#[component(
    "95aef4f6-66fc-477e-b8f8-32395a837831",
    name = "Mesh Intersection",
    nick = "MInt",
    at = "Intersect/Shape"
)]
#[output("Result", "R", "The closed meshes, one for each part that hangs together.")]
fn mesh_intersection(
    context: &Context<'_>,
    /// Closed meshes; nulls are skipped.
    #[port("Meshes A", "A")]
    a: List<Shared<Mesh>>,
    /// Closed meshes; nulls are skipped.
    #[port("Meshes B", "B")]
    b: List<Shared<Mesh>>,
) -> Result<Vec<Shared<Mesh>>, Message> {
    let (a, b) = (solids(context, &a, "A")?, solids(context, &b, "B")?);
    if a.is_empty() || b.is_empty() {
        return Ok(Vec::new());
    }
    let (a, b) = (Solid::united(&a)?, Solid::united(&b)?);
    let both = a.intersection(&b)?;
    if both.is_empty() {
        context.warn("The meshes have nothing in common");
    }
    meshes(context, &both)
}

/// Cuts a closed mesh by closed meshes, one after the other, and keeps all parts, each closed.
///
/// A mesh with naked edges is an error.
#[component(
    "afbf2fe0-4965-48d2-8470-9e991540093b",
    name = "Mesh Split",
    nick = "MSplit",
    at = "Intersect/Shape"
)]
#[output("Result", "R", "The parts: outside the splitters first.")]
fn mesh_split(
    context: &Context<'_>,
    /// The closed mesh to cut.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// Closed meshes to cut with; nulls are skipped.
    #[port("Splitters", "S")]
    splitters: List<Shared<Mesh>>,
) -> Result<Vec<Shared<Mesh>>, Message> {
    let mut parts = vec![solid(context, mesh, "The mesh")?];
    for splitter in solids(context, &splitters, "S")? {
        let mut next = Vec::with_capacity(parts.len());
        let mut inside = Vec::new();
        for part in parts {
            context.check()?;
            next.push(part.difference(&splitter)?);
            inside.push(part.intersection(&splitter)?);
        }
        next.append(&mut inside);
        next.retain(|part| !part.is_empty());
        context.items(next.len())?;
        parts = next;
    }
    let mut out = Vec::new();
    for part in &parts {
        out.extend(meshes(context, part)?);
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Box3, Interval, Mesh, Plane};

    fn cube(low: f64, high: f64) -> Mesh {
        let side = Interval::new(low, high);
        Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 2, 2, 2).unwrap()
    }

    /// The volumes of the resulting meshes, which are closed.
    fn volumes(trial: Trial) -> Vec<f64> {
        let made = trial.run();
        let column = made.outputs[0].column();
        let volume = |i| match column.get(i) {
            Some(Value::Mesh(m)) => {
                assert!(m.is_closed());
                (m.volume() * 1e9).round() / 1e9
            }
            other => panic!("{other:?}"),
        };
        (0..column.len()).map(volume).collect()
    }

    #[test]
    fn of_boxes() {
        let (a, b, far) = (cube(0.0, 2.0), cube(1.0, 3.0), cube(9.0, 10.0));
        let union = |list: Vec<Mesh>| volumes(Trial::of("Mesh Union").list(list));
        assert_eq!(union(vec![a.clone(), b.clone()]), [15.0]);
        assert_eq!(union(vec![a.clone(), far.clone(), b.clone()]).len(), 2);
        assert_eq!(union(vec![]), [0.0; 0]);
        let cut = |b: Vec<Mesh>| volumes(Trial::of("Mesh Difference").list([a.clone()]).list(b));
        assert_eq!(cut(vec![b.clone()]), [7.0]);
        assert_eq!(cut(vec![far.clone()]), [8.0]);
        assert_eq!(cut(vec![cube(0.5, 1.5)]), [7.0]);
        assert_eq!(cut(vec![cube(-1.0, 4.0)]), [0.0; 0]);
        let both = |b: Mesh| Trial::of("Mesh Intersection").list([a.clone()]).list([b]);
        assert_eq!(volumes(both(b.clone())), [1.0]);
        assert!(both(far).message().contains("nothing in common"));
        let split = volumes(Trial::of("Mesh Split").item(a.clone()).list([b, cube(0.0, 1.0)]));
        assert_eq!(split, [6.0, 1.0, 1.0]);
    }

    #[test]
    fn open_meshes_are_named() {
        let open =
            Mesh::new(cube(0.0, 1.0).vertices().to_vec(), cube(0.0, 1.0).faces()[2..].to_vec()).unwrap();
        let said = Trial::of("Mesh Union").list([cube(0.0, 1.0), open.clone()]).message();
        assert!(said.contains("Mesh 1 of M") && said.contains("not closed"), "{said}");
        assert!(Trial::of("Mesh Split").item(open).list([cube(0.0, 1.0)]).message().contains("not closed"));
    }
}
