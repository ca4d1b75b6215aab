//! LunchBox Generate: panels cut into smaller ones again and again.

use katydid_component::{Context, Message, component};
use katydid_data::{Kind, Value, cast};
use katydid_geometry::{Brep, Curve, Direction, Point3, PolylineCurve, Surface};

use super::panel;

/// The most steps: after them a side is a millionth of what it was.
const MOST: i32 = 20;

/// The bytes of a cell as a surface of four control points.
const CELL_BYTES: usize = 1000;

/// # Errors
/// The number of steps is negative or too large.
fn steps(n: i32) -> Result<i32, Message> {
    if (0..=MOST).contains(&n) {
        Ok(n)
    } else {
        Err(Message::error(format!("N is {n}: it must be from 0 to {MOST}")))
    }
}

/// A cell as a closed polyline or as a surface.
fn cell(corners: &[Point3], wires: bool) -> Result<Value, Message> {
    if !wires {
        return panel(corners);
    }
    let mut points = corners.to_vec();
    points.extend(corners.first());
    Ok(Value::from(Curve::Polyline(PolylineCurve::new(points)?)))
}

/// Cuts cells again and again: what `cut` gives of a cell with true goes on, the rest stays. Gives the cells that would go on and
/// those that stay.
fn cut_again<T>(
    context: &Context<'_>,
    first: T,
    count: i32,
    cut: impl Fn(&T) -> Vec<(T, bool)>,
) -> Result<(Vec<T>, Vec<T>), Message> {
    let (mut going, mut staying) = (vec![first], Vec::new());
    for _ in 0..count {
        context.check()?;
        let most = going.len().saturating_mul(4).saturating_add(staying.len());
        context.items(most)?;
        context.bytes(most.saturating_mul(CELL_BYTES))?;
        let mut next = Vec::new();
        for (part, on) in going.iter().flat_map(&cut) {
            if on { next.push(part) } else { staying.push(part) }
        }
        going = next;
    }
    Ok((going, staying))
}

/// A part of a surface: parts of both domains, from 0 to 1.
#[derive(Debug, Clone, Copy)]
struct Part {
    u: [f64; 2],
    v: [f64; 2],
}

impl Part {
    const WHOLE: Self = Self { u: [0.0, 1.0], v: [0.0, 1.0] };

    /// The part from `i` to `i + 1` of `m` along u, and likewise along v.
    fn piece(&self, [i, m]: [u8; 2], [j, n]: [u8; 2]) -> Self {
        let at = |[a, b]: [f64; 2], k: u8, n: u8| a + (b - a) * f64::from(k) / f64::from(n);
        let between = |range: [f64; 2], k: u8, n: u8| [at(range, k, n), at(range, k + 1, n)];
        Self { u: between(self.u, i, m), v: between(self.v, j, n) }
    }

    /// The quarters, counter-clockwise from where u and v are least.
    fn quarters(&self) -> [Self; 4] {
        [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[i, j]| self.piece([i, 2], [j, 2]))
    }

    fn corners(&self, surface: &Surface) -> [Point3; 4] {
        let [u, v] = [Direction::U, Direction::V].map(|d| surface.domain(d));
        let ([a, b], [c, d]) = (self.u, self.v);
        [[a, c], [b, c], [b, d], [a, d]].map(|[s, t]| surface.point_at(u.at(s), v.at(t)))
    }
}

/// Cuts a quad into quarters, and chosen quarters again. Stands for LunchBox's Subdivide Quad; that the four booleans tell which
/// quarters are cut again, counter-clockwise from where u and v are least, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c53",
    name = "Subdivide Quad",
    nick = "QuadSub",
    at = "LunchBox/Generate"
)]
#[output("Quad Cells A", "QuadA", "The cells of the last step that would be cut next.")]
#[output("Quad Cells B", "QuadB", "The cells that stay, from large to small.")]
fn subdivide_quad(
    context: &Context<'_>,
    /// The surface, whose trims do not count.
    #[port("Quad Surface", "Quad")]
    surface: &Surface,
    /// How many times cells are cut, from 0 to 20.
    #[port("Subdivide", "N", default = 2)]
    n: i32,
    /// Whether the quarter at the least u and v is cut again.
    #[port("Boolean 1", "B1", default = true)]
    b1: bool,
    /// Whether the one at the most u and the least v is.
    #[port("Boolean 2", "B2", default = false)]
    b2: bool,
    /// Whether the one at the most u and v is.
    #[port("Boolean 3", "B3", default = true)]
    b3: bool,
    /// Whether the one at the least u and the most v is.
    #[port("Boolean 4", "B4", default = false)]
    b4: bool,
    /// Whether cells are polylines and not surfaces.
    #[port("Wires", "Wires", default = true)]
    wires: bool,
) -> Result<(Vec<Value>, Vec<Value>), Message> {
    let chosen = [b1, b2, b3, b4];
    let cut = |part: &Part| part.quarters().into_iter().zip(chosen).collect();
    let (going, staying) = cut_again(context, Part::WHOLE, steps(n)?, cut)?;
    let made = |parts: Vec<Part>| -> Result<Vec<Value>, Message> {
        parts.iter().map(|part| cell(&part.corners(surface), wires)).collect()
    };
    Ok((made(going)?, made(staying)?))
}

/// Cuts a triangle into four at the middles of its sides, and chosen ones again. Stands for LunchBox's Subdivide Triangle; that
/// the booleans tell which triangles are cut again, those at the three corners and the one in the middle, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c54",
    name = "Subdivide Triangle",
    nick = "TriSub",
    at = "LunchBox/Generate"
)]
#[output("Triangle Cells A", "TriA", "The cells of the last step that would be cut next.")]
#[output("Triangle Cells B", "TriB", "The cells that stay, from large to small.")]
fn subdivide_triangle(
    context: &Context<'_>,
    /// A closed polyline of three corners, or a surface with three.
    #[port("Triangular Curve", "Tri")]
    triangle: Value,
    /// How many times cells are cut, from 0 to 20.
    #[port("Subdivide", "N", default = 2)]
    n: i32,
    /// Whether the triangle at the first corner is cut again.
    #[port("Boolean 1", "B1", default = true)]
    b1: bool,
    /// Whether the one at the second corner is.
    #[port("Boolean 2", "B2", default = true)]
    b2: bool,
    /// Whether the one at the third corner is.
    #[port("Boolean 3", "B3", default = true)]
    b3: bool,
    /// Whether the one in the middle is.
    #[port("Boolean 4", "B4", default = false)]
    b4: bool,
    /// Whether cells are polylines and not surfaces.
    #[port("Wires", "Wires", default = true)]
    wires: bool,
) -> Result<(Vec<Value>, Vec<Value>), Message> {
    let corners = <[Point3; 3]>::try_from(corners_of(context, &triangle)?);
    let corners =
        corners.map_err(|all| Message::error(format!("A triangle has 3 corners, not {}", all.len())))?;
    let chosen = [b1, b2, b3, b4];
    let cut = |cell: &[Point3; 3]| quarters(*cell).into_iter().zip(chosen).collect();
    let (going, staying) = cut_again(context, corners, steps(n)?, cut)?;
    let made = |cells: Vec<[Point3; 3]>| -> Result<Vec<Value>, Message> {
        cells.iter().map(|corners| cell(corners, wires)).collect()
    };
    Ok((made(going)?, made(staying)?))
}

/// The triangles at the corners and the one in the middle.
fn quarters([a, b, c]: [Point3; 3]) -> [[Point3; 3]; 4] {
    let (ab, bc, ca) = (a.lerp(b, 0.5), b.lerp(c, 0.5), c.lerp(a, 0.5));
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
}

/// Cuts a quad into quads of equal parts, and all of them again. Stands for LunchBox's Constant Quad Subdivide, of which is known
/// that there are two patterns: that one cuts a cell into quarters, and the other into three strips, across at one step and
/// along at the next, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c55",
    name = "Constant Quad Subdivide",
    nick = "ConstQuad",
    at = "LunchBox/Generate"
)]
#[output("Quad Cells", "Quad", "The cells.")]
fn constant_quads(
    context: &Context<'_>,
    /// The surface, whose trims do not count.
    #[port("Quad Surface", "Quad")]
    surface: &Surface,
    /// How many times cells are cut, from 0 to 20.
    #[port("Subdivide", "N", default = 2)]
    n: i32,
    /// Whether cells are cut into three strips and not into quarters.
    #[port("Recursion Toggle", "R", default = false)]
    strips: bool,
    /// Whether cells are polylines and not surfaces.
    #[port("Wires", "Wires", default = true)]
    wires: bool,
) -> Result<Vec<Value>, Message> {
    context.tell(Message::remark("The pattern is Katydid's reading: LunchBox may cut cells in another way"));
    let cut = |&(part, step): &(Part, i32)| -> Vec<((Part, i32), bool)> {
        let pieces: Vec<Part> = if !strips {
            part.quarters().to_vec()
        } else if step % 2 == 0 {
            [0, 1, 2].map(|k| part.piece([k, 3], [0, 1])).to_vec()
        } else {
            [0, 1, 2].map(|k| part.piece([0, 1], [k, 3])).to_vec()
        };
        pieces.into_iter().map(|piece| ((piece, step + 1), true)).collect()
    };
    let (cells, _) = cut_again(context, (Part::WHOLE, 0), steps(n)?, cut)?;
    cells.iter().map(|(part, _)| cell(&part.corners(surface), wires)).collect()
}

/// The corners of a closed polyline, or of the outline of a surface; corners in one place are one.
///
/// # Errors
/// The sides are not straight, or it is open or no such thing.
pub(super) fn corners_of(context: &Context<'_>, value: &Value) -> Result<Vec<Point3>, Message> {
    let limit = context.tolerance().absolute;
    let wrong = || Message::error("A panel is a closed polyline, or a surface with straight sides");
    let outline = match value.brep() {
        Some(Ok(brep)) => outer(&brep, limit)?,
        Some(Err(why)) => return Err(Message::error(why)),
        None => match cast::value(value, Kind::Curve, context.rules()) {
            Some(Value::Curve(curve)) => curve.as_polyline(),
            _ => None,
        },
    };
    let mut points = outline.ok_or_else(wrong)?;
    if points.len() < 4 || !points.first().zip(points.last()).is_some_and(|(a, b)| a.distance_to(*b) <= limit)
    {
        return Err(wrong());
    }
    points.dedup_by(|a, b| a.distance_to(*b) <= limit);
    // The first corner comes again at the end.
    points.pop();
    Ok(points)
}

/// The corners of the first border of a brep.
fn outer(brep: &Brep, limit: f64) -> Result<Option<Vec<Point3>>, Message> {
    Ok(brep.borders(limit)?.first().and_then(Curve::as_polyline))
}
