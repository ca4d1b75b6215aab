//! Polygons cut into triangles and quads, and the component that does it with the faces of a mesh.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;

use super::each;
use crate::polygons::{Polygons, sides};

/// How a polygon is cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Fill {
    /// Not at all: it is left out.
    Skip,
    /// Triangles and quads stay; others get a fan about their middle.
    Best,
    /// Triangles about the middle.
    Fan,
    /// Triangles from the first corner.
    Hand,
    /// Triangles to and fro; the first edge is cut from the last corner, or from the second where `late`.
    Strip { late: bool },
    /// Quads side by side, with a triangle at the end where the corners are odd.
    Stitch,
    /// Quads about the middle, each along two edges.
    QuadFan,
}

impl Fill {
    /// The way of a number, as Weaverbird counts them.
    ///
    /// # Errors
    /// There is none of that number.
    pub(super) fn of(number: i32) -> Result<Self, Message> {
        Ok(match number {
            0 => Self::Skip,
            1 => Self::Best,
            2 => Self::Fan,
            3 => Self::Hand,
            4 => Self::Strip { late: true },
            5 => Self::Strip { late: false },
            6 => Self::Stitch,
            7 => Self::QuadFan,
            _ => return Err(Message::error(format!("There is no way to fill {number}: there are 0 to 7"))),
        })
    }
}

/// What a polygon becomes; its middle is added to the points where it is needed.
pub(super) fn fill(body: &mut Polygons, face: &[usize], strategy: Fill) -> Vec<Vec<usize>> {
    match strategy {
        Fill::Skip => Vec::new(),
        Fill::Best if face.len() < 5 => vec![face.to_vec()],
        Fill::Best | Fill::Fan => {
            let middle = add_middle(body, face);
            sides(face).map(|(a, b)| vec![a, b, middle]).collect()
        }
        Fill::Hand => {
            let Some((&first, rest)) = face.split_first() else { return Vec::new() };
            rest.windows(2).map(|pair| [&[first], pair].concat()).collect()
        }
        Fill::Strip { late } => strip(face, late),
        Fill::Stitch => stitch(face),
        Fill::QuadFan => {
            let middle = add_middle(body, face);
            let mut round = face.to_vec();
            round.extend(face.first().copied());
            let starts = (0..face.len()).step_by(2);
            starts
                .filter_map(|k| round.get(k..(k + 3).min(round.len())).filter(|part| part.len() > 1))
                .map(|part| [part, &[middle]].concat())
                .collect()
        }
    }
}

fn add_middle(body: &mut Polygons, face: &[usize]) -> usize {
    body.points.push(body.middle(face));
    body.points.len() - 1
}

/// Triangles from both ends of the polygon in turn.
fn strip(face: &[usize], late: bool) -> Vec<Vec<usize>> {
    let mut rest = face.to_vec();
    let mut turn = late;
    let mut triangles = Vec::with_capacity(face.len().saturating_sub(2));
    if late {
        rest.rotate_left(1);
    }
    while let [a, b, .., y, z] = *rest.as_slice() {
        if turn {
            triangles.push(vec![y, z, a]);
            rest.pop();
        } else {
            triangles.push(vec![a, b, z]);
            rest.remove(0);
        }
        turn = !turn;
    }
    if rest.len() == 3 {
        triangles.push(rest);
    }
    triangles
}

fn stitch(face: &[usize]) -> Vec<Vec<usize>> {
    let mut faces = Vec::with_capacity(face.len() / 2);
    let mut rest = face;
    while let [a, b, .., y, z] = *rest {
        faces.push(vec![a, b, y, z]);
        rest = rest.get(1..rest.len() - 1).unwrap_or_default();
        if rest.len() == 2 {
            return faces;
        }
    }
    if rest.len() == 3 {
        faces.push(rest.to_vec());
    }
    faces
}

/// Whether faces of so many corners are cut, by the number that Weaverbird has for it.
fn takes(which: i32) -> Result<fn(usize) -> bool, Message> {
    Ok(match which {
        0 => |_| true,
        1 => |n| n > 3,
        2 => |n| n > 4,
        9 => |n| n == 3,
        16 => |n| n == 4,
        _ => {
            let told = format!("There is no choice of faces {which}: there are 0, 1, 2, 9 and 16");
            return Err(Message::error(told));
        }
    })
}

/// Cuts the faces of meshes, or closed polylines, into triangles or quads. Stands for Weaverbird's Tile; what the ways 1, 4 and 5
/// do in detail is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b55",
    name = "Tile",
    nick = "wbTile",
    at = "Weaverbird/Wb Create"
)]
#[output(
    "Output Mesh/Curves",
    "O",
    "The results: meshes from meshes, closed polylines from closed polylines."
)]
fn tile(
    context: &Context<'_>,
    /// Meshes, or closed polylines that are the faces of one body.
    #[port("Mesh/Curves", "M")]
    bodies: List<Value>,
    /// How faces are cut: 0 they are left out, 1 triangles and quads stay and others get a fan, 2 a fan about the middle, 3 triangles
    /// from the first corner, 4 and 5 triangles to and fro, 6 quads side by side, 7 quads about the middle.
    #[port("FillStrategy", "F", default = 1)]
    strategy: i32,
    /// Which faces are cut: 0 all, 1 all but triangles, 2 all but triangles and quads, 9 triangles, 16 quads.
    #[port("Opt-in", "O", default = 0)]
    which: i32,
) -> Result<Vec<Value>, Message> {
    let (strategy, takes) = (Fill::of(strategy)?, takes(which)?);
    each(context, &bodies, |mut body| {
        let faces = std::mem::take(&mut body.faces);
        context.items(faces.iter().map(Vec::len).sum())?;
        for face in faces {
            if takes(face.len()) {
                let cut = fill(&mut body, &face, strategy);
                body.faces.extend(cut);
            } else {
                body.faces.push(face);
            }
        }
        Ok(body)
    })
}

#[cfg(test)]
mod tests {
    use super::{Fill, Polygons, fill};
    use katydid_geometry::Point3;

    fn polygon(n: usize) -> Polygons {
        let at = |k: usize| {
            let turn = std::f64::consts::TAU * k as f64 / n as f64;
            Point3::new(turn.cos(), turn.sin(), 0.0)
        };
        Polygons { points: (0..n).map(at).collect::<Vec<Point3>>(), faces: Vec::new() }
    }

    #[test]
    fn pieces_cover_the_polygon() {
        for n in 3..9 {
            let ring: Vec<usize> = (0..n).collect();
            let whole = polygon(n).area_vector(&ring).z;
            for number in 1..8 {
                let mut body = polygon(n);
                let pieces = fill(&mut body, &ring, Fill::of(number).unwrap());
                let areas: Vec<f64> = pieces.iter().map(|face| body.area_vector(face).z).collect();
                assert!(areas.iter().all(|area| *area > 0.0), "way {number} of {n} corners: {pieces:?}");
                assert!((areas.iter().sum::<f64>() - whole).abs() < 1e-12, "way {number} of {n} corners");
                let most = if matches!(number, 2..6) { 3 } else { 4 };
                assert!(
                    pieces.iter().all(|face| face.len() <= most),
                    "way {number} of {n} corners: {pieces:?}"
                );
            }
            assert!(fill(&mut polygon(n), &ring, Fill::Skip).is_empty());
        }
        assert!(Fill::of(8).is_err() && Fill::of(-1).is_err());
    }
}
