//! Loops as a face's boundary: trims, and what joins them to the edges where the two lie apart.
//!
//! A solid's shell is closed where its faces share edges. The faces end at their trims, though, and files hold trims
//! whose images lie beside the edges by more than rounding: there the faces alone leave gaps, and what they enclose
//! would depend on the point that one looks from. Two things close them. A trim that is clearly apart gives way to its
//! edge, pulled to the surface; and strips of straight lines join trims to edges, and edges to their vertices.

use super::rule::Work;
use super::strip::{Far, Near, Strip};
use crate::brep::Brep;
use crate::brep::pulled::pulled;
use crate::brep::thresholds::LEAST_SHARE_OF_EDGE;
use crate::{ClosestOnCurve, Curve, Error, Line, Point3, Result, Surface};

/// What counts as near.
#[derive(Debug, Clone, Copy)]
pub(super) struct Nearness {
    /// Gaps up to this width stay open.
    pub(super) still: f64,
    /// Trims that are farther from their edges give way to them.
    pub(super) apart: f64,
}

/// A gap up to this part of the solid's half diagonal keeps the trim as it is: strips over it are as good, for they
/// differ from the surface by the cube of their width.
const APART: f64 = 1e-7;
/// How much narrower gaps are that stay open than what is asked for.
const STILL: f64 = 1e-2;
/// Places of a trim, for each of its pieces, at which its edge's parameter is looked for.
const PLACES: usize = 8;
/// The most such places.
const MOST_PLACES: usize = 400;

impl Nearness {
    /// Trims as they are, whatever their edges do.
    pub(super) const TRIMS: Self = Self { still: f64::INFINITY, apart: f64::INFINITY };

    /// For integrals to a fraction of those of a shape with this half diagonal.
    pub(super) fn of(fraction: f64, size: f64) -> Self {
        let still = STILL * fraction * size;
        Self { still, apart: (APART * size).max(still) }
    }
}

/// A loop of a face.
pub(super) struct Bound {
    /// Curves in the parameter plane, each from where the one before ends.
    pub(super) curves: Vec<Curve>,
    /// From these curves to the edges, outward.
    pub(super) strips: Vec<Strip>,
}

/// One trim of a loop: where it runs, and what it should run along.
struct Piece {
    flat: Curve,
    /// Its edge as it runs along it, where the gap between them has to be closed: the edge and pairs of parameters.
    beside: Option<(Curve, Vec<[f64; 2]>)>,
    /// The ends of its edge, or the vertex of a singular side.
    ends: Option<[Point3; 2]>,
    /// The vertices there.
    vertices: Option<[Point3; 2]>,
}

/// A loop's trims on a surface.
pub(super) fn bound(
    brep: &Brep,
    surface: &Surface,
    trims: &[usize],
    near: Nearness,
    work: &Work<'_>,
) -> Result<Bound> {
    let mut pieces = Vec::with_capacity(trims.len());
    for trim in trims {
        work.check()?;
        pieces.push(piece(brep, surface, *trim, near)?);
    }
    let image = |uv: Point3| surface.point_at(uv.x, uv.y);
    let (mut curves, mut strips) = (Vec::with_capacity(pieces.len()), Vec::new());
    for (k, piece) in pieces.iter().enumerate() {
        curves.push(piece.flat.clone());
        let (end, next) = (piece.flat.end(), pieces[(k + 1) % pieces.len()].flat.start());
        let closing = (end != next).then(|| Curve::from(Line::new(end, next)));
        if let Some((edge, pairs)) = &piece.beside {
            let far = Far::Curve { curve: edge.clone(), pairs: pairs.clone() };
            strips.push(Strip { near: Near::Image(piece.flat.clone()), far });
        }
        if let Some([at_start, at_end]) = piece.vertices {
            match piece.ends {
                Some([first, last]) => {
                    let corners = [(piece.flat.start(), at_start, first), (end, last, at_end)];
                    for (corner, from, to) in corners {
                        if from.distance_to(to) > near.still {
                            let far = Far::Curve { curve: Line::new(from, to).into(), pairs: Vec::new() };
                            strips.push(Strip { near: Near::Point(image(corner)), far });
                        }
                    }
                }
                // A singular side: its image is a point, beside the vertex at most.
                None if image(end).distance_to(at_start) > near.still => {
                    strips.push(Strip { near: Near::Image(piece.flat.clone()), far: Far::Point(at_start) });
                }
                None => {}
            }
            if let Some(line) = &closing
                && [end, next].iter().any(|uv| image(*uv).distance_to(at_end) > near.still)
            {
                strips.push(Strip { near: Near::Image(line.clone()), far: Far::Point(at_end) });
            }
        }
        curves.extend(closing);
    }
    Ok(Bound { curves, strips })
}

fn piece(brep: &Brep, surface: &Surface, place: usize, near: Nearness) -> Result<Piece> {
    let flat = brep.trim_as_curve(place)?.ok_or(Error::degenerate("trim", "it has no curve"))?;
    let parts = brep.parts();
    let Some(trim) = parts.trims.get(place) else { return Ok(Piece::alone(flat)) };
    let point = |vertex: Option<usize>| parts.vertices.get(vertex?).map(|vertex| vertex.point);
    let Some((at, edge)) = trim.edge.and_then(|at| Some((at, parts.edges.get(at)?))) else {
        let vertices = point(trim.vertices[0]).map(|vertex| [vertex; 2]);
        return Ok(Piece { vertices, ..Piece::alone(flat) });
    };
    let Some(curve) = parts.edge_curve(edge) else { return Ok(Piece::alone(flat)) };
    if near.still == f64::INFINITY {
        return Ok(Piece::alone(flat));
    }
    let turned = |pair: [Point3; 2]| if trim.reversed { [pair[1], pair[0]] } else { pair };
    let ends = [edge.part.domain.start, edge.part.domain.end].map(|t| edge.part.point_at(curve, t));
    let vertices = [0, 1].map(|k: usize| point(edge.vertices[k]).unwrap_or(ends[k]));
    let known = Piece { ends: Some(turned(ends)), vertices: Some(turned(vertices)), ..Piece::alone(flat) };
    let gap = parts.distance(trim, edge, curve);
    if gap <= near.still {
        return Ok(known);
    }
    let Some(edge) = brep.edge_as_curve(at).ok().flatten() else { return Ok(known) };
    let edge = if trim.reversed { edge.reversed() } else { edge };
    if gap > near.apart
        && let Some((flat, width)) = pulled(surface, &edge, &known.flat, gap, 0.1 * near.apart)
    {
        let beside = (width > near.still).then_some((edge, Vec::new()));
        return Ok(Piece { flat, beside, ..known });
    }
    let pairs = pairs(surface, &known.flat, &edge, gap);
    Ok(Piece { beside: Some((edge, pairs)), ..known })
}

impl Piece {
    fn alone(flat: Curve) -> Self {
        Self { flat, beside: None, ends: None, vertices: None }
    }
}

/// Parameters of a trim and of the nearest places of its edge, both rising from one end to the other.
fn pairs(surface: &Surface, flat: &Curve, edge: &Curve, gap: f64) -> Vec<[f64; 2]> {
    let (own, other) = (flat.domain(), edge.domain());
    let count = (PLACES * flat.pieces().len()).clamp(2 * PLACES, MOST_PLACES);
    let samples: Vec<(f64, Point3)> = (1..count)
        .map(|k| k as f64 / count as f64)
        .map(|x| (x, flat.point_at(own.at(x))))
        .map(|(x, uv)| (x, surface.point_at(uv.x, uv.y)))
        .collect();
    let ends = [[own.start, other.start], [own.end, other.end]];
    // At one pace the ends say it all.
    if samples.iter().all(|(x, image)| edge.point_at(other.at(*x)).distance_to(*image) <= 2.0 * gap) {
        return ends.to_vec();
    }
    let index = ClosestOnCurve::new(edge);
    let mut out = vec![ends[0]];
    let least = LEAST_SHARE_OF_EDGE / count as f64 * other.length();
    for (x, image) in samples {
        let Ok(near) = index.nearest(image) else { continue };
        let before = out.last().map_or(other.start, |pair| pair[1]);
        // A closed edge has its start beside its end.
        let leaps = (other.normalized(near.parameter) - x).abs() > 0.5;
        if near.parameter > before + least && near.parameter < other.end - least && !leaps {
            out.push([own.at(x), near.parameter]);
        }
    }
    out.push(ends[1]);
    out
}
