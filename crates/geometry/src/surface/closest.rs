//! The point of a surface nearest to a given one.

use crate::thresholds;
use std::sync::OnceLock;

use super::Surface;
use super::closest_patch::{Best, Patches, Work};
use super::closest_swept::Swept;
use crate::bernstein::BUDGET;
use crate::box_tree::BoxTree;
use crate::{Direction, Error, NurbsSurface, Point3, Quadrant, Result};

/// A point on a surface and how far it is from where one asked.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SurfacePoint {
    /// The first parameter.
    pub u: f64,
    /// The second parameter.
    pub v: f64,
    /// The point there.
    pub point: Point3,
    /// Its distance from the point asked for.
    pub distance: f64,
}

/// A surface prepared for many questions about its nearest point: its Bézier patches in a tree of boxes; where a plane
/// curve was turned about an axis in its plane, or moved square to it, the question is asked of that curve.
///
/// An answer is the global minimum over the whole untrimmed surface, sides and corners among them, proven by bounds:
/// no point of the surface is nearer by more than 2·10⁻¹³ of the distance, or, where rounding hides more, some 10⁻⁷
/// of the size of a patch for a point on the surface. (A search that has looked at 100,000 ranges stops with the best
/// found; ordinary ones look at some tens.) Of equally near points it gives one.
#[derive(Debug, Clone)]
pub struct ClosestOnSurface {
    nurbs: NurbsSurface,
    /// The surface asked about, where its parameters are not those of the NURBS form.
    exact: Option<Box<Surface>>,
    /// How the surface is swept by a plane curve, if it is.
    swept: Option<Box<Swept>>,
    /// Made when they are searched for the first time.
    patches: OnceLock<(BoxTree, Patches)>,
}

/// More ranges than this and a search is lost in a surface that is equally far almost everywhere.
const MOST_RANGES: u32 = 5 * BUDGET;

impl ClosestOnSurface {
    /// Prepares a surface of any kind.
    ///
    /// # Errors
    /// The surface has no NURBS form.
    pub fn new(surface: &Surface) -> Result<Self> {
        match surface {
            Surface::Nurbs(nurbs) => Ok(Self::of_nurbs(nurbs)),
            Surface::Plane(_) => Ok(Self::of_nurbs(&surface.to_nurbs()?)),
            _ => {
                let mut this = Self::of_nurbs(&surface.to_nurbs()?);
                this.exact = Some(Box::new(surface.clone()));
                this.swept = Swept::of(surface).map(Box::new);
                Ok(this)
            }
        }
    }

    /// Prepares a NURBS surface: about 1 µs a patch, and 2 kB for a bicubic one.
    pub fn of_nurbs(surface: &NurbsSurface) -> Self {
        Self { nurbs: surface.clone(), exact: None, swept: None, patches: OnceLock::new() }
    }

    fn patches(&self) -> &(BoxTree, Patches) {
        self.patches.get_or_init(|| {
            let (patches, bounds) = Patches::of(&self.nurbs);
            (BoxTree::by_place(&bounds), patches)
        })
    }

    /// The point of the surface nearest to `q`.
    ///
    /// # Errors
    /// `q` is not finite, or so far away that the square of the distance overflows.
    pub fn nearest(&self, q: Point3) -> Result<SurfacePoint> {
        self.search(q, f64::INFINITY)?.ok_or(Error::NotFinite("square of the distance to the surface"))
    }

    /// The point of the surface nearest to `q` if it is nearer than `limit`, or `None`. The smaller the limit, the
    /// faster the answer.
    ///
    /// # Errors
    /// `q` is not finite.
    pub fn nearest_within(&self, q: Point3, limit: f64) -> Result<Option<SurfacePoint>> {
        if !(limit > 0.0) {
            return Ok(None);
        }
        Ok(self.search(q, limit * limit)?.filter(|p| p.distance < limit))
    }

    /// The nearest points for many places, in their order. Long lists run in parallel with the `parallel` feature.
    ///
    /// # Errors
    /// As [`ClosestOnSurface::nearest`], for any of them.
    pub fn nearest_all(&self, points: &[Point3]) -> Result<Vec<SurfacePoint>> {
        #[cfg(feature = "parallel")]
        if points.len() >= 64 {
            use rayon::prelude::*;
            let own = crate::CancellationToken::now();
            let all = points.par_iter().with_min_len(8).map(|&q| own.during(|| self.nearest(q)));
            return crate::parallel::waiting(|| all.collect());
        }
        points.iter().map(|&q| self.nearest(q)).collect()
    }

    fn search(&self, q: Point3, limit: f64) -> Result<Option<SurfacePoint>> {
        if !q.is_finite() {
            return Err(Error::NotFinite("point to project on the surface"));
        }
        crate::cancellation::check()?;
        if let Some(swept) = &self.swept {
            let found = swept.nearest(q)?;
            return Ok(Some(found).filter(|p| p.distance.is_finite() && p.distance * p.distance < limit));
        }
        let place: [f64; 3] = q.into();
        let (tree, patches) = self.patches();
        let mut best = Best { squared: limit, uv: None };
        let (mut plain, mut rational) = (Work::<1>::default(), Work::<2>::default());
        (plain.budget, rational.budget) = (MOST_RANGES, MOST_RANGES);
        tree.visit_near(&place, limit, |i| {
            patches.search(i, place, &mut best, &mut plain, &mut rational);
            best.squared
        });
        let Some([u, v]) = best.uv else { return Ok(None) };
        Ok(Some(self.place(u, v, q)))
    }

    /// The place at two parameters of the NURBS form, by those of the surface itself.
    pub(super) fn place(&self, u: f64, v: f64, q: Point3) -> SurfacePoint {
        let point = self.nurbs.point_at(u, v);
        let [u, v] = match &self.exact {
            Some(surface) => parameters_of(surface, point, [u, v]),
            None => [u, v],
        };
        SurfacePoint { u, v, point, distance: point.distance_to(q) }
    }

    /// The form that is searched.
    pub(super) fn nurbs(&self) -> &NurbsSurface {
        &self.nurbs
    }
}

/// The parameters of a point that lies on a surface, near a first guess: Gauss–Newton steps on the difference, which
/// vanishes at the answer.
fn parameters_of(surface: &Surface, point: Point3, guess: [f64; 2]) -> [f64; 2] {
    let domains = Direction::BOTH.map(|d| surface.domain(d));
    let mut x = guess;
    let mut miss = surface.point_at(x[0], x[1]).distance_to(point);
    for _ in 0..30 {
        let jet = surface.derivatives(x[0], x[1], 1, Quadrant::NorthEast);
        let (d, su, sv) = (jet.point() - point, jet.get(1, 0), jet.get(0, 1));
        let (a, b, c) = (su.dot(su), su.dot(sv), sv.dot(sv));
        let (f, g) = (d.dot(su), d.dot(sv));
        let det = a * c - b * b;
        let step = if det > thresholds::ROUNDING * a * c {
            [(b * g - c * f) / det, (b * f - a * g) / det]
        } else if a >= c {
            [-f / a, 0.0]
        } else {
            [0.0, -g / c]
        };
        let mut share = 1.0;
        let mut better = None;
        for _ in 0..8 {
            let next: [f64; 2] = std::array::from_fn(|d| domains[d].clamp(x[d] + share * step[d]));
            let there = surface.point_at(next[0], next[1]).distance_to(point);
            if there < miss {
                better = Some((next, there));
                break;
            }
            share *= 0.5;
        }
        let Some((next, there)) = better else { break };
        (x, miss) = (next, there);
    }
    x
}

impl NurbsSurface {
    /// The point of the surface nearest to `q`: always the global one. For many questions about one surface use
    /// [`ClosestOnSurface`], which this builds.
    ///
    /// Branch and bound on the Bernstein coefficients of the squared distance over Bézier patches in a tree of boxes
    /// (after Y. Ma & W. Hewitt, CAGD 20, 2003, with proofs of convexity in place of their elimination criteria).
    ///
    /// # Errors
    /// `q` is not finite, or so far away that the square of the distance overflows.
    pub fn closest_point(&self, q: Point3) -> Result<SurfacePoint> {
        ClosestOnSurface::of_nurbs(self).nearest(q)
    }
}

impl Surface {
    /// The point of the surface nearest to `q`: always the global one. For many questions about one surface use
    /// [`ClosestOnSurface`], which this builds.
    ///
    /// # Errors
    /// `q` is not finite, or so far away that the square of the distance overflows.
    pub fn closest_point(&self, q: Point3) -> Result<SurfacePoint> {
        ClosestOnSurface::new(self)?.nearest(q)
    }

    /// The nearest points for many places, in their order. Long lists run in parallel with the `parallel` feature.
    ///
    /// # Errors
    /// As [`Surface::closest_point`], for any of them.
    pub fn closest_points(&self, points: &[Point3]) -> Result<Vec<SurfacePoint>> {
        ClosestOnSurface::new(self)?.nearest_all(points)
    }
}
