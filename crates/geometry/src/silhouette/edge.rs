//! Edges of Breps, told by how the faces beside them are seen.

use katydid_elementary::Elementary;

use super::{Silhouette, SilhouetteKind, SilhouettePart, Viewpoint};
use crate::silhouette::thresholds::{ASIDE, FOOT_FOUND, INSIDE_ENDS, SIGHT_STEP};
use crate::{Brep, Curve, Direction, Interval, Point3, Result, Surface, Tolerance, Vector3};

/// Cosines below this count as edge-on, until the face is seen a little inside.
const FLAT: f64 = 1e-6;
/// How far inside the face is looked at, in parts of the domain.
const INSIDE: [f64; 4] = [1e-3, 1e-2, 3e-2, 1e-1];
/// Places on an edge where its kind is asked, for each smooth piece.
const PLACES: usize = 12;
/// The most such places.
const MOST: usize = 600;
/// Halvings between two places of different kind.
const HALVINGS: usize = 40;

/// One side of an edge.
struct Beside<'a> {
    brep: &'a Brep,
    trim: usize,
    face: usize,
    surface: &'a Surface,
    /// Whether the face's normal is the surface's turned over.
    reversed: bool,
    /// Whether the trim runs against the edge.
    backwards: bool,
    domain: Interval,
}

/// How a face is seen at a point of its edge.
#[derive(Debug, Clone, Copy)]
struct Seen {
    /// 1 from the front, −1 from behind, 0 edge-on.
    sign: i8,
    normal: Option<Vector3>,
}

impl<'a> Beside<'a> {
    fn new(brep: &'a Brep, trim: usize) -> Option<Self> {
        let own = brep.trims().get(trim).filter(|t| !t.deleted)?;
        let face = brep.face_of(trim)?;
        let reversed = brep.faces().get(face).filter(|f| !f.deleted)?.reversed;
        let surface = brep.face_surface(face)?;
        brep.trim_curve(trim)?;
        Some(Self { brep, trim, face, surface, reversed, backwards: own.reversed, domain: own.part.domain })
    }

    fn uv(&self, t: f64) -> Point3 {
        self.brep.trim_point(self.trim, t).unwrap_or(Point3::ORIGIN)
    }

    /// The trim's parameter for a point at a share of the edge: trims need not run as fast as their edge.
    fn parameter(&self, p: Point3, share: f64) -> f64 {
        let mut t = self.domain.at(if self.backwards { 1.0 - share } else { share });
        let image = |t: f64| {
            let uv = self.uv(t);
            self.surface.point_at(uv.x, uv.y)
        };
        let step = SIGHT_STEP * self.domain.length();
        let clamp = |t: f64| t.clamp(self.domain.start, self.domain.end);
        for _ in 0..8 {
            let (low, high) = (clamp(t - step), clamp(t + step));
            let slope = (image(high) - image(low)) / (high - low);
            let square = slope.length_squared();
            if !(square > 0.0) {
                break;
            }
            let next = clamp(t + (p - image(t)).dot(slope) / square);
            let moved = (next - t).abs();
            t = next;
            if moved <= FOOT_FOUND * step {
                break;
            }
        }
        t
    }

    fn seen(&self, p: Point3, share: f64, viewpoint: Viewpoint) -> Seen {
        let t = self.parameter(p, share);
        let at = self.uv(t);
        let turned = |n: Vector3| if self.reversed { -n } else { n };
        let normal = self.surface.normal_at(at.x, at.y).map(turned);
        let sign = |x: f64| if x > 0.0 { 1 } else { -1 };
        let facing = normal.map_or(0.0, |n| viewpoint.facing(n, p));
        if facing.abs() > FLAT {
            return Seen { sign: sign(facing), normal };
        }
        // The face lies to the left of its trims.
        let step = ASIDE * self.domain.length();
        let along = self.uv((t + step).min(self.domain.end)) - self.uv((t - step).max(self.domain.start));
        let Some(inward) = Vector3::new(-along.y, along.x, 0.0).unitized() else {
            return Seen { sign: 0, normal };
        };
        let spans = Direction::BOTH.map(|d| self.surface.domain(d).length());
        let reach = (inward.x.abs() / spans[0]).hypotenuse(inward.y.abs() / spans[1]).recip();
        for part in INSIDE {
            let q = at + inward * (part * reach);
            let facing = self
                .surface
                .normal_at(q.x, q.y)
                .map_or(0.0, |n| viewpoint.facing(turned(n), self.surface.point_at(q.x, q.y)));
            if facing.abs() > FLAT {
                return Seen { sign: sign(facing), normal };
            }
        }
        Seen { sign: 0, normal }
    }
}

/// The parts of an edge, each with its kind.
pub(super) fn silhouettes(
    brep: &Brep,
    edge: usize,
    viewpoint: Viewpoint,
    tolerance: &Tolerance,
) -> Result<Vec<Silhouette>> {
    let Some(own) = brep.edges().get(edge).filter(|e| !e.deleted) else { return Ok(Vec::new()) };
    let Some(curve) = brep.edge_as_curve(edge)? else { return Ok(Vec::new()) };
    let sides: Vec<Beside> = own.trims.iter().filter_map(|t| Beside::new(brep, *t)).collect();
    let part = SilhouettePart::Edge(edge);
    let [a, b] = sides.as_slice() else {
        let kind = if sides.len() < 2 { SilhouetteKind::Boundary } else { SilhouetteKind::Crease };
        return Ok(vec![Silhouette { curve, kind, part }]);
    };
    let domain = curve.domain();
    let kind_at = |t: f64| kind(a, b, curve.point_at(t), domain.normalized(t), viewpoint, tolerance.angle);
    let count = (PLACES * curve.pieces().len()).clamp(PLACES, MOST);
    // Not at the very ends, where other faces are near.
    let places =
        (0..=count).map(|k| domain.at((k as f64 / count as f64).clamp(INSIDE_ENDS, 1.0 - INSIDE_ENDS)));
    let mut runs: Vec<(f64, SilhouetteKind)> = Vec::new();
    let mut before: Option<(f64, SilhouetteKind)> = None;
    for t in places {
        let now = kind_at(t);
        match before {
            None => runs.push((domain.start, now)),
            Some((last, was)) if was != now => {
                let (mut low, mut high) = (last, t);
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (low + high);
                    if kind_at(middle) == was { low = middle } else { high = middle }
                }
                runs.push((0.5 * (low + high), now));
            }
            _ => {}
        }
        before = Some((t, now));
    }
    // Where a silhouette crosses an edge without a crease, the edge is edge-on in one point, and not along a stretch.
    let ends: Vec<f64> = runs.iter().skip(1).map(|r| r.0).chain([domain.end]).collect();
    let mut kept: Vec<(f64, SilhouetteKind)> = Vec::with_capacity(runs.len());
    for ((start, kind), end) in runs.into_iter().zip(ends) {
        let [a, b] = [start, end].map(|t| curve.point_at(t));
        let middle = curve.point_at(0.5 * (start + end));
        let short = a.distance_to(middle) + middle.distance_to(b) <= 2.0 * tolerance.absolute;
        match kept.last() {
            Some((_, last)) if short || *last == kind => {}
            None if short && end < domain.end => {}
            None => kept.push((domain.start, kind)),
            _ => kept.push((start, kind)),
        }
    }
    let runs = kept;
    if let [(_, kind)] = runs.as_slice() {
        return Ok(vec![Silhouette { curve, kind: *kind, part }]);
    }
    let mut out = Vec::with_capacity(runs.len());
    for (i, (start, kind)) in runs.iter().enumerate() {
        let end = runs.get(i + 1).map_or(domain.end, |r| r.0);
        if let Ok(curve) = cut(&curve, *start, end) {
            out.push(Silhouette { curve, kind: *kind, part });
        }
    }
    Ok(out)
}

fn cut(curve: &Curve, start: f64, end: f64) -> Result<Curve> {
    curve.trimmed(Interval::new(start, end))
}

/// What an edge between two faces is at a point.
fn kind(a: &Beside, b: &Beside, p: Point3, share: f64, viewpoint: Viewpoint, angle: f64) -> SilhouetteKind {
    let [one, mut other] = [a, b].map(|side| side.seen(p, share, viewpoint));
    // Faces that look to opposite sides are turned to agree.
    let agree = (a.backwards != b.backwards) == (a.reversed == b.reversed);
    if !agree {
        other = Seen { sign: -other.sign, normal: other.normal.map(|n| -n) };
    }
    let smooth = match (one.normal, other.normal) {
        (Some(n), Some(m)) => n.angle_to(m).is_some_and(|x| x <= angle),
        _ => a.face == b.face,
    };
    match (one.sign, other.sign) {
        (0, s) | (s, 0) if s != 0 => SilhouetteKind::Projecting,
        (s, t) if s * t < 0 => {
            if smooth {
                SilhouetteKind::Tangent
            } else {
                SilhouetteKind::Crease
            }
        }
        _ if !smooth => SilhouetteKind::NonSilhouetteCrease,
        _ if a.face == b.face => SilhouetteKind::NonSilhouetteSeam,
        _ => SilhouetteKind::NonSilhouetteTangent,
    }
}
