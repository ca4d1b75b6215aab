//! How far a surface can leave the triangles over a rectangle of its parameters.
//!
//! A function whose second derivatives are bounded by a, b, c (by uu, uv, vv) differs from its linear interpolation on
//! any triangle with corners in a rectangle of sides h and k by at most (a h² + 2 b h k + c k²) / 8: by Taylor's formula
//! about a point of the triangle the difference is half the mean of the second-order terms at the corners, and the
//! variance of numbers in a range of length h is at most h²/4 (after D. Filip, R. Magedson, R. Markot, *Surface
//! algorithms using bounds on derivatives*, 1986, who have it for right triangles).
//!
//! Only what is along the normal takes a mesh off its surface; what is along the surface counts by the tangent of the
//! angle that normals turn by inside the rectangle.

use crate::meshing::thresholds::{NO_METRIC, PROBE_INSET};
use std::borrow::Cow;

use katydid_elementary::Elementary;

use super::patch::{Bases, Patch};
use crate::{NurbsSurface, Quadrant, Surface, Vector3};

/// Bounds over a rectangle of parameters.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Bend {
    /// The second derivatives by uu, uv and vv, as far as they take triangles off the surface.
    pub(super) off: [f64; 3],
    /// The same, as far as they shear triangles along the surface.
    pub(super) along: [f64; 3],
    /// The lengths of the first derivatives.
    pub(super) speed: [f64; 2],
    /// How fast the normal turns by u and by v.
    pub(super) turn: [f64; 2],
}

impl Bend {
    /// The greatest of both.
    pub(super) fn max(&self, other: &Self) -> Self {
        Self {
            off: std::array::from_fn(|k| self.off[k].max(other.off[k])),
            along: std::array::from_fn(|k| self.along[k].max(other.along[k])),
            speed: std::array::from_fn(|k| self.speed[k].max(other.speed[k])),
            turn: std::array::from_fn(|k| self.turn[k].max(other.turn[k])),
        }
    }

    /// How far the surface can be from a triangle with corners in a rectangle of these sides.
    pub(super) fn distance(&self, [h, k]: [f64; 2]) -> f64 {
        let [a, b, c] = self.off;
        0.125 * (a * h * h + 2.0 * b * h * k + c * k * k)
    }

    /// How far the triangles can be sheared along the surface.
    pub(super) fn shear(&self, [h, k]: [f64; 2]) -> f64 {
        let [a, b, c] = self.along;
        0.125 * (a * h * h + 2.0 * b * h * k + c * k * k)
    }

    /// How far the surface can be from one triangle in parameters: as [`Bend::distance`], but for a triangle that does
    /// not fill its rectangle the difference is at most half the greatest of λμ q₁ + μν q₂ + νλ q₃ over barycentric
    /// coordinates, with q the second-order term along each side.
    pub(super) fn triangle_distance(&self, corners: [[f64; 2]; 3]) -> f64 {
        let [p, q, r] = corners;
        let span = |d: usize| {
            let x = [p[d], q[d], r[d]];
            x.iter().copied().fold(f64::MIN, f64::max) - x.iter().copied().fold(f64::MAX, f64::min)
        };
        let filled = self.distance([span(0), span(1)]);
        let [a, b, c] = self.off;
        let with_sign = |sign: f64| {
            let side = |p: [f64; 2], q: [f64; 2]| {
                let (h, k) = (q[0] - p[0], q[1] - p[1]);
                a * h * h + 2.0 * sign * b * h * k + c * k * k
            };
            let mut s = [side(p, q), side(q, r), side(r, p)].map(|x| x.max(0.0));
            s.sort_by(f64::total_cmp);
            let [x, y, z] = s;
            if z >= x + y {
                return 0.125 * z;
            }
            let below = 2.0 * (x * y + y * z + z * x) - (x * x + y * y + z * z);
            if below > 0.0 { (0.5 * x * y * z / below).min(0.125 * (x + y + z)) } else { 0.125 * z }
        };
        filled.min(1.05 * with_sign(1.0).max(with_sign(-1.0)))
    }
}

/// The surface of a face with what bounds it.
pub(super) struct Bender<'a> {
    surface: &'a Surface,
    nurbs: Option<Nurbs>,
}

/// The polynomial pieces of a NURBS surface.
struct Nurbs {
    spans: [Vec<f64>; 2],
    patches: Vec<Patch>,
    /// Those of the degrees in u and v.
    bases: [Bases; 2],
}

impl Nurbs {
    fn of(surface: &NurbsSurface) -> Option<Self> {
        use crate::Direction;
        let patches = surface.bezier_patches().ok()?;
        let degrees = surface.degrees();
        Some(Self {
            spans: Direction::BOTH.map(|d| surface.span_parameters(d)),
            patches: patches.iter().map(|p| Patch::new(degrees, p.homogeneous_points())).collect(),
            bases: degrees.map(Bases::new),
        })
    }

    /// The piece over part of a span.
    fn part(&self, rectangle: [[f64; 2]; 2]) -> Option<(Cow<'_, Patch>, [f64; 2])> {
        let mut place = [0; 2];
        let mut inside = [[0.0; 2]; 2];
        let mut lengths = [0.0; 2];
        for d in 0..2 {
            let spans = &self.spans[d];
            let [from, to] = rectangle[d];
            let middle = 0.5 * (from + to);
            let i = spans.partition_point(|&t| t <= middle).clamp(1, spans.len().checked_sub(1)?) - 1;
            let (start, end) = (*spans.get(i)?, *spans.get(i + 1)?);
            place[d] = i;
            lengths[d] = to - from;
            inside[d] = [(from - start) / (end - start), (to - start) / (end - start)];
        }
        let patch = self.patches.get(place[0] * (self.spans[1].len() - 1) + place[1])?;
        let whole = inside == [[0.0, 1.0]; 2];
        Some((if whole { Cow::Borrowed(patch) } else { Cow::Owned(patch.part(inside)) }, lengths))
    }
}

impl<'a> Bender<'a> {
    pub(super) fn new(surface: &'a Surface) -> Self {
        use crate::{Curve, Direction};
        // Where an arc is involved the NURBS form has other parameters.
        fn has_arc(curve: &Curve) -> bool {
            match curve {
                Curve::Arc(_) => true,
                Curve::Poly(c) => c.segments().iter().any(has_arc),
                _ => false,
            }
        }
        let nurbs = match surface {
            Surface::Nurbs(s) => Nurbs::of(s),
            Surface::Sum(s) if !s.curves().iter().any(has_arc) => {
                s.to_nurbs().ok().and_then(|s| Nurbs::of(&s)).filter(|n| {
                    // A polyline's or line's NURBS form keeps its parameters.
                    Direction::BOTH
                        .iter()
                        .all(|&d| n.spans[d.index()].len() == surface.span_parameters(d).len())
                })
            }
            _ => None,
        };
        Self { surface, nurbs }
    }

    /// The bounds over a rectangle inside one smooth piece.
    pub(super) fn over(&self, rectangle: [[f64; 2]; 2]) -> Bend {
        if let Surface::Plane(plane) = self.surface {
            let [du, dv] = plane.partials();
            return Bend { speed: [du.length(), dv.length()], ..Bend::default() };
        }
        let own = self.nurbs.as_ref().and_then(|nurbs| nurbs.part(rectangle));
        let [u, v] = rectangle;
        // A direction that vanishes at a pole has a limit, which the patch's own derivatives do not tell.
        let inside = own.as_ref().zip(self.nurbs.as_ref()).and_then(|((patch, lengths), nurbs)| {
            let partials = patch.partials(&nurbs.bases);
            let normals = partials.map(|[du, dv]| normal(du, dv));
            let [du, dv] = partials[0];
            let speeds = [du.length() / lengths[0], dv.length() / lengths[1]];
            normals.iter().all(Option::is_some).then_some((normals, speeds))
        });
        let (normals, shortest) =
            inside.unwrap_or_else(|| (self.normals(rectangle), self.middle_speeds([u, v])));
        let middle = normals[0];
        // The tangent of the greatest angle between normals; none when they are not known or turn too far.
        let slope = middle.and_then(|n| {
            let least = normals.iter().map(|m| m.map_or(-1.0, |m| m.dot(n))).fold(1.0, f64::min);
            // What lies between the places looked at.
            let least = 1.0 - 1.2 * (1.0 - least);
            (least > 0.5).then(|| (1.0 - least * least).max(0.0).sqrt() / least)
        });
        let n = middle.unwrap_or(Vector3::ZERO);
        let (first, second) = match &own {
            Some((patch, lengths)) => patch.bounds(n, *lengths),
            None => self.sampled(rectangle, n),
        };
        let off = second.map(|s| match slope {
            Some(slope) => (s.normal + s.tangent * slope).min(s.length),
            None => s.length,
        });
        let along = second.map(|s| if slope.is_some() { s.tangent } else { 0.0 });
        // The normal turns by the curvature along each parameter and by the twist.
        let per = |x: f64, by: f64| if by > 0.0 { x / by } else { 0.0 };
        let turn = [
            per(second[0].normal, shortest[0]).hypotenuse(per(second[1].normal, shortest[1])),
            per(second[2].normal, shortest[1]).hypotenuse(per(second[1].normal, shortest[0])),
        ];
        Bend { off, along, speed: first, turn }
    }

    fn middle_speeds(&self, [u, v]: [[f64; 2]; 2]) -> [f64; 2] {
        let d = self.surface.derivatives(0.5 * (u[0] + u[1]), 0.5 * (v[0] + v[1]), 1, Quadrant::NorthEast);
        [d.get(1, 0).length(), d.get(0, 1).length()]
    }

    /// The normals in the middle and around.
    fn normals(&self, [u, v]: [[f64; 2]; 2]) -> [Option<Vector3>; 9] {
        // Just inside, so that they are those of this piece.
        [
            (0.5, 0.5),
            (PROBE_INSET, PROBE_INSET),
            (1.0 - PROBE_INSET, PROBE_INSET),
            (1.0 - PROBE_INSET, 1.0 - PROBE_INSET),
            (PROBE_INSET, 1.0 - PROBE_INSET),
            (0.5, PROBE_INSET),
            (1.0 - PROBE_INSET, 0.5),
            (0.5, 1.0 - PROBE_INSET),
            (PROBE_INSET, 0.5),
        ]
        .map(|(x, y)| self.surface.normal_at(u[0] + (u[1] - u[0]) * x, v[0] + (v[1] - v[0]) * y))
    }

    /// The bounds by looking at 25 places, with a margin: for circles, whose derivatives change slowly.
    fn sampled(&self, [u, v]: [[f64; 2]; 2], n: Vector3) -> ([f64; 2], [Size; 3]) {
        const MARGIN: f64 = 1.05;
        let mut first = [0.0_f64; 2];
        let mut second = [Greatest::default(); 3];
        for i in 0..5 {
            for j in 0..5 {
                let inside = |x: [f64; 2], k: usize| x[0] + (x[1] - x[0]) * (0.001 + 0.2495 * k as f64);
                let d = self.surface.derivatives(inside(u, i), inside(v, j), 2, Quadrant::NorthEast);
                first[0] = first[0].max(MARGIN * d.get(1, 0).length());
                first[1] = first[1].max(MARGIN * d.get(0, 1).length());
                for (slot, d) in second.iter_mut().zip([d.get(2, 0), d.get(1, 1), d.get(0, 2)]) {
                    slot.include(d * MARGIN, n);
                }
            }
        }
        (first, second.map(Greatest::size))
    }
}

/// The direction across two; none where they are nearly parallel, or one vanishes.
fn normal(du: Vector3, dv: Vector3) -> Option<Vector3> {
    let across = du.cross(dv);
    let least = NO_METRIC * du.length_squared() * dv.length_squared();
    (across.length_squared() > least).then(|| across.unitized()).flatten()
}

/// Bounds of vectors: their parts along a normal and across it, and their lengths.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Size {
    pub(super) normal: f64,
    pub(super) tangent: f64,
    pub(super) length: f64,
}

/// The greatest of vectors so far: the same numbers with their squares, of which the roots are taken in the end.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Greatest {
    normal: f64,
    tangent: f64,
    length: f64,
}

/// The greater of two numbers; the first one where the second is none. One instruction, which [`f64::max`] is not.
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

impl Greatest {
    pub(super) fn include(&mut self, v: Vector3, n: Vector3) {
        let along = v.dot(n);
        self.normal = greater(self.normal, along.abs());
        self.tangent = greater(self.tangent, (v - n * along).length_squared());
        self.length = greater(self.length, v.length_squared());
    }

    pub(super) fn size(self) -> Size {
        Size { normal: self.normal, tangent: self.tangent.sqrt(), length: self.length.sqrt() }
    }
}
