//! The regions into which faces are cut, and points inside of them.

use super::arrangement::{Loops, Track, regions};
use super::operands::{Face, Operands};
use super::pieces::{OnFace, Pieces};
use super::refusal::RefusalClass;
use super::thresholds::SAMPLES;
use crate::region::Outline;
use crate::{Curve, Plane, Point3, Result, Vector3, cancellation};

/// A connected part of a face.
#[derive(Debug)]
pub(super) struct Region {
    pub(super) face: usize,
    pub(super) loops: Loops,
    /// Points inside, the one that is farthest from the border first.
    pub(super) samples: Vec<Sample>,
    /// The pieces around it that occur an odd number of times.
    pub(super) rim: Vec<usize>,
    outlines: Vec<Outline>,
}

/// A point inside a region.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    pub(super) point: Point3,
    /// The normal of the face there, away from its operand.
    pub(super) normal: Vector3,
}

impl Region {
    /// The pieces around it, each as often as it occurs.
    pub(super) fn pieces(&self) -> impl Iterator<Item = (usize, bool)> + '_ {
        self.loops.iter().flatten().filter_map(|step| match step.track {
            Track::Piece(piece, reversed) => Some((piece, reversed)),
            Track::Point(_) => None,
        })
    }

    /// Lets go of what tells which parameters lie in it.
    pub(super) fn forget_outlines(&mut self) {
        self.outlines = Vec::new();
    }

    /// Whether parameters lie in it; anything at its border.
    pub(super) fn covers(&self, uv: [f64; 2]) -> bool {
        self.outlines.iter().map(|o| o.winding(uv)).sum::<i32>() != 0
    }
}

/// All faces, cut.
pub(super) struct Cut {
    /// The regions, by the places of the faces.
    pub(super) regions: Vec<Region>,
    /// The pieces on faces that divide nothing.
    pub(super) idle: Vec<OnFace>,
}

/// Cuts every face into its regions.
pub(super) fn all_regions(all: &Operands, pieces: &Pieces) -> Result<Cut> {
    let mut out = Vec::new();
    let mut idle = pieces.beside.clone();
    for (place, face) in all.faces.iter().enumerate() {
        cancellation::check()?;
        let (found, lost) = regions(all, pieces, place)?;
        for loops in found {
            out.push(region(all, place, face, loops)?);
        }
        idle.extend(lost.into_iter().map(|piece| OnFace { face: place, piece }));
    }
    Ok(Cut { regions: out, idle })
}

fn region(all: &Operands, place: usize, face: &Face, loops: Loops) -> Result<Region> {
    let chained = |chain: &Vec<super::arrangement::Step>| {
        crate::curve::chained(chain.iter().map(|s| s.curve.clone()).collect(), 0.0)
    };
    let outlines: Vec<Outline> = loops.iter().map(|c| Outline::new(&chained(c), &Plane::XY)).collect();
    let mut own = Region { face: place, loops, samples: Vec::new(), rim: Vec::new(), outlines };
    own.rim = Pieces::odd(own.pieces().map(|p| p.0));
    own.samples = samples(face, &own);
    if own.samples.is_empty() {
        let corner = own.loops.first().and_then(|c| c.first()).map(|s| s.curve.start());
        let at = corner.map(|uv| face.surface.point_at(uv.x, uv.y));
        return Err(all.refuse(RefusalClass::UnclosedSplit, &[place], at));
    }
    Ok(own)
}

/// Shares of the extent at which lines are laid through a region in search of points inside.
const LINES: [f64; 9] = [0.5, 0.31, 0.69, 0.17, 0.83, 0.07, 0.93, 0.43, 0.57];
/// How many points inside are kept.
const KEPT: usize = 4;
/// Of so many points it is asked how far they are from the border: four for each pair of lines in both directions.
const MOST_ASKED: usize = 4 * LINES.len();
/// Points nearer to the border than this part of the largest distance are not asked.
const LEAST_CLEARANCE: f64 = 0.1;

/// Points inside a region: the middles of the widest stretches of lines in both directions.
fn samples(face: &Face, region: &Region) -> Vec<Sample> {
    let mut outline: Vec<Vec<[f64; 2]>> = Vec::new();
    for chain in &region.loops {
        let mut points = Vec::new();
        for step in chain {
            let domain = step.curve.domain();
            let count = if matches!(step.curve, Curve::Line(_)) { 1 } else { SAMPLES };
            points.extend((0..count).map(|k| {
                let p = step.curve.point_at(domain.at(k as f64 / count as f64));
                [p.x, p.y]
            }));
        }
        outline.push(points);
    }
    if outline.iter().all(Vec::is_empty) {
        return Vec::new();
    }
    let ends = [0, 1].map(|k: usize| {
        let coordinates = outline.iter().flatten().map(|p| p[k]);
        coordinates.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], x| [l.min(x), h.max(x)])
    });
    let whole = speeds(face, ends.map(|[low, high]| 0.5 * (low + high)));
    // The widest stretches first: their middles may be the farthest from the border.
    let mut stretches = stretches(&outline, ends, whole);
    stretches.sort_by(|a, b| b.0.total_cmp(&a.0));
    let inside = stretches.into_iter().filter(|(_, uv)| region.covers(*uv)).take(MOST_ASKED);
    let even = face.surface.is_affine();
    let mut found: Vec<(f64, [f64; 2])> = inside
        .map(|(_, uv)| (clearance(if even { whole } else { speeds(face, uv) }, &outline, uv), uv))
        .collect();
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    // After the one farthest from the border those farthest from the ones before: what misses a part of the region is
    // seen by points that disagree.
    let clearest = found.first().map_or(0.0, |f| f.0);
    let mut left: Vec<([f64; 2], Point3)> = (found.into_iter())
        .filter(|(clear, _)| *clear >= LEAST_CLEARANCE * clearest)
        .map(|(_, uv)| (uv, face.surface.point_at(uv[0], uv[1])))
        .collect();
    let mut out: Vec<Sample> = Vec::new();
    while out.len() < KEPT && !left.is_empty() {
        let apart = |p: Point3| out.iter().map(|o| o.point.distance_to(p)).fold(f64::INFINITY, f64::min);
        let farthest =
            (0..left.len()).max_by(|a, b| apart(left[*a].1).total_cmp(&apart(left[*b].1)).then(b.cmp(a)));
        let Some(place) = farthest else { break };
        let (uv, point) = left.remove(place);
        out.extend(face.normal(uv).map(|normal| Sample { point, normal }));
    }
    out
}

/// The lengths of a face's derivatives at parameters.
fn speeds(face: &Face, [u, v]: [f64; 2]) -> [f64; 2] {
    let d = face.surface.derivatives(u, v, 1, face.surface.inner_quadrant(u, v));
    [d.get(1, 0).length(), d.get(0, 1).length()]
}

/// Half the length and the middle of every stretch between two crossings with the border of lines laid between the ends of
/// a region in both directions.
fn stretches(outline: &[Vec<[f64; 2]>], ends: [[f64; 2]; 2], speeds: [f64; 2]) -> Vec<(f64, [f64; 2])> {
    let mut out = Vec::new();
    for across in 0..2 {
        let along = 1 - across;
        let [low, high] = ends[across];
        for share in LINES {
            let level = low + share * (high - low);
            let mut hits = Vec::new();
            for points in outline {
                let next = points.iter().cycle().skip(1);
                for (p, q) in points.iter().zip(next) {
                    if (p[across] > level) != (q[across] > level) {
                        let x = (level - p[across]) / (q[across] - p[across]);
                        hits.push(p[along] + x * (q[along] - p[along]));
                    }
                }
            }
            hits.sort_by(f64::total_cmp);
            for pair in hits.chunks_exact(2) {
                let mut uv = [level; 2];
                uv[along] = 0.5 * (pair[0] + pair[1]);
                out.push((0.5 * (pair[1] - pair[0]) * speeds[along], uv));
            }
        }
    }
    out
}

/// About how far parameters are from the border, as a length on a surface whose derivatives there have two lengths.
fn clearance([a, b]: [f64; 2], outline: &[Vec<[f64; 2]>], uv: [f64; 2]) -> f64 {
    let mut least = f64::INFINITY;
    for points in outline {
        let next = points.iter().cycle().skip(1);
        for (p, q) in points.iter().zip(next) {
            let from = [(p[0] - uv[0]) * a, (p[1] - uv[1]) * b];
            let way = [(q[0] - p[0]) * a, (q[1] - p[1]) * b];
            let square = way[0] * way[0] + way[1] * way[1];
            let t = if square > 0.0 {
                (-(from[0] * way[0] + from[1] * way[1]) / square).clamp(0.0, 1.0)
            } else {
                0.0
            };
            let off = [from[0] + t * way[0], from[1] + t * way[1]];
            least = least.min(off[0] * off[0] + off[1] * off[1]);
        }
    }
    least.sqrt()
}
