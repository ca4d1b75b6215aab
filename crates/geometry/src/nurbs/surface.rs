use super::curve::{Controls, project};
use super::knots::check_knots;
use crate::{Error, Interval, Point3, Result, cancellation};

/// The most control points of a surface that is made of curves or of another surface: their counts multiply.
const MOST_POINTS: usize = 10_000_000;

/// Refuses a net that is too large, or that there is no memory for, before it is made.
pub(crate) fn check_net(counts: [usize; 2]) -> Result<()> {
    let points = counts[0].saturating_mul(counts[1]);
    if points <= MOST_POINTS {
        return cancellation::room::<[f64; 8]>(points);
    }
    let what = "count of control points of a surface";
    Err(Error::OutOfRange { what, value: points as f64, must: "at most 10,000,000" })
}

/// One of the two directions of a surface's parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Direction {
    /// The first parameter.
    U,
    /// The second parameter.
    V,
}

impl Direction {
    /// Both, u first.
    pub const BOTH: [Self; 2] = [Self::U, Self::V];

    /// 0 for u, 1 for v.
    #[inline]
    pub const fn index(self) -> usize {
        self as usize
    }

    /// The other direction.
    #[inline]
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::U => Self::V,
            Self::V => Self::U,
        }
    }
}

/// Which of the up to four pieces that meet at a pair of knots gives a derivative: the one that goes on from there
/// or the one that comes up to there, in each direction. East is towards larger u and north towards larger v.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Quadrant {
    /// Larger u, larger v.
    #[default]
    NorthEast,
    /// Smaller u, larger v.
    NorthWest,
    /// Smaller u, smaller v.
    SouthWest,
    /// Larger u, smaller v.
    SouthEast,
}

impl Quadrant {
    /// Whether u, and whether v, comes from below.
    #[inline]
    pub const fn from_below(self) -> [bool; 2] {
        match self {
            Self::NorthEast => [false, false],
            Self::NorthWest => [true, false],
            Self::SouthWest => [true, true],
            Self::SouthEast => [false, true],
        }
    }

    /// The quadrant whose parameters come from below or not.
    #[inline]
    pub const fn new(u_from_below: bool, v_from_below: bool) -> Self {
        match (u_from_below, v_from_below) {
            (false, false) => Self::NorthEast,
            (true, false) => Self::NorthWest,
            (true, true) => Self::SouthWest,
            (false, true) => Self::SouthEast,
        }
    }
}

/// A NURBS surface: in each of two directions a degree and knots in the openNURBS form, and a grid of control points.
///
/// The grid is stored with v running fastest. A rational surface stores its control points homogeneous,
/// (wx, wy, wz, w); accessors say which form they give. Every value of this type is valid: the constructors check
/// and say what is wrong.
#[derive(Debug, Clone, PartialEq)]
pub struct NurbsSurface {
    pub(crate) degrees: [usize; 2],
    pub(crate) knots: [Vec<f64>; 2],
    pub(crate) counts: [usize; 2],
    pub(crate) controls: Controls,
}

impl NurbsSurface {
    /// The non-rational surface over a grid of `counts[0]` by `counts[1]` control points, v running fastest.
    ///
    /// # Errors
    /// The knots of a direction do not fit (see [`crate::check_knots`]), the number of points is not the product of
    /// the counts, or a coordinate is not finite.
    pub fn new(
        degrees: [usize; 2],
        counts: [usize; 2],
        points: Vec<Point3>,
        knots: [Vec<f64>; 2],
    ) -> Result<Self> {
        let controls = Controls::Plain(points.into_iter().map(Into::into).collect());
        Self::from_controls(degrees, counts, controls, knots)
    }

    /// The rational surface with homogeneous control points (wx, wy, wz, w), v running fastest.
    ///
    /// # Errors
    /// As [`NurbsSurface::new`], and when a weight is not greater than 0.
    pub fn rational(
        degrees: [usize; 2],
        counts: [usize; 2],
        points: Vec<[f64; 4]>,
        knots: [Vec<f64>; 2],
    ) -> Result<Self> {
        Self::from_controls(degrees, counts, Controls::Rational(points), knots)
    }

    /// The rational surface with control points in space and their weights, both with v running fastest.
    ///
    /// # Errors
    /// As [`NurbsSurface::rational`], and when the numbers of points and weights differ.
    pub fn with_weights(
        degrees: [usize; 2],
        counts: [usize; 2],
        points: &[Point3],
        weights: &[f64],
        knots: [Vec<f64>; 2],
    ) -> Result<Self> {
        if points.len() != weights.len() {
            return Err(Error::Invalid {
                what: "NURBS surface",
                why: format!("{} control points but {} weights", points.len(), weights.len()),
            });
        }
        let points = points.iter().zip(weights).map(|(p, &w)| [p.x * w, p.y * w, p.z * w, w]).collect();
        Self::rational(degrees, counts, points, knots)
    }

    pub(crate) fn from_controls(
        degrees: [usize; 2],
        counts: [usize; 2],
        controls: Controls,
        knots: [Vec<f64>; 2],
    ) -> Result<Self> {
        crate::cancellation::worked(counts[0].saturating_mul(counts[1]) / 8);
        crate::cancellation::check()?;
        let (given, finite) = match &controls {
            Controls::Plain(p) => (p.len(), p.iter().flatten().all(|x| x.is_finite())),
            Controls::Rational(p) => (p.len(), p.iter().flatten().all(|x| x.is_finite())),
        };
        if !finite {
            return Err(Error::NotFinite("NURBS control point"));
        }
        if counts[0].checked_mul(counts[1]) != Some(given) {
            return Err(Error::Invalid {
                what: "NURBS surface",
                why: format!("a grid of {} by {} control points, but {given} given", counts[0], counts[1]),
            });
        }
        check_knots(degrees[0], counts[0], &knots[0])?;
        check_knots(degrees[1], counts[1], &knots[1])?;
        if let Controls::Rational(points) = &controls
            && let Some((i, p)) = points.iter().enumerate().find(|(_, p)| p[3] <= 0.0)
        {
            let (row, column) = (i / counts[1], i % counts[1]);
            return Err(Error::Invalid {
                what: "NURBS surface",
                why: format!("weight ({row}, {column}) is {}, which must be greater than 0", p[3]),
            });
        }
        Ok(Self { degrees, knots, counts, controls })
    }

    /// The degree in one direction, at least 1.
    #[inline]
    pub fn degree(&self, direction: Direction) -> usize {
        self.degrees[direction.index()]
    }

    /// The degrees in u and v.
    #[inline]
    pub fn degrees(&self) -> [usize; 2] {
        self.degrees
    }

    /// The order in one direction, degree + 1.
    #[inline]
    pub fn order(&self, direction: Direction) -> usize {
        self.degree(direction) + 1
    }

    /// The knots of one direction in the openNURBS form: control points + degree − 1.
    #[inline]
    pub fn knots(&self, direction: Direction) -> &[f64] {
        &self.knots[direction.index()]
    }

    /// The number of control points in one direction.
    #[inline]
    pub fn count(&self, direction: Direction) -> usize {
        self.counts[direction.index()]
    }

    /// The numbers of control points in u and v.
    #[inline]
    pub fn counts(&self) -> [usize; 2] {
        self.counts
    }

    /// The number of all control points.
    #[inline]
    pub fn point_count(&self) -> usize {
        self.counts[0] * self.counts[1]
    }

    /// Whether the surface carries weights. They may still all be equal.
    #[inline]
    pub fn is_rational(&self) -> bool {
        matches!(self.controls, Controls::Rational(_))
    }

    #[inline]
    pub(crate) fn slot(&self, i: usize, j: usize) -> Option<usize> {
        (i < self.counts[0] && j < self.counts[1]).then(|| i * self.counts[1] + j)
    }

    /// Control point (i, j) in space: divided by its weight.
    pub fn control_point(&self, i: usize, j: usize) -> Option<Point3> {
        let slot = self.slot(i, j)?;
        match &self.controls {
            Controls::Plain(p) => p.get(slot).map(|&p| p.into()),
            Controls::Rational(p) => p.get(slot).map(|&p| project(p)),
        }
    }

    /// The control points in space, v running fastest.
    pub fn control_points(&self) -> Vec<Point3> {
        match &self.controls {
            Controls::Plain(p) => p.iter().map(|&p| p.into()).collect(),
            Controls::Rational(p) => p.iter().map(|&p| project(p)).collect(),
        }
    }

    /// Control point (i, j) in homogeneous form, (wx, wy, wz, w).
    pub fn homogeneous_point(&self, i: usize, j: usize) -> Option<[f64; 4]> {
        let slot = self.slot(i, j)?;
        match &self.controls {
            Controls::Plain(p) => p.get(slot).map(|&[x, y, z]| [x, y, z, 1.0]),
            Controls::Rational(p) => p.get(slot).copied(),
        }
    }

    /// The control points in homogeneous form, v running fastest.
    pub fn homogeneous_points(&self) -> Vec<[f64; 4]> {
        match &self.controls {
            Controls::Plain(p) => p.iter().map(|&[x, y, z]| [x, y, z, 1.0]).collect(),
            Controls::Rational(p) => p.clone(),
        }
    }

    /// The weight of control point (i, j), 1 in a non-rational surface.
    pub fn weight(&self, i: usize, j: usize) -> Option<f64> {
        self.homogeneous_point(i, j).map(|p| p[3])
    }

    /// The weights of all control points, v running fastest.
    pub fn weights(&self) -> Vec<f64> {
        match &self.controls {
            Controls::Plain(p) => vec![1.0; p.len()],
            Controls::Rational(p) => p.iter().map(|p| p[3]).collect(),
        }
    }

    /// The range of one parameter.
    pub fn domain(&self, direction: Direction) -> Interval {
        let (knots, degree) = (self.knots(direction), self.degree(direction));
        let at = |i: usize| knots.get(i).copied().unwrap_or(0.0);
        Interval::new(at(degree - 1), at(knots.len() - degree))
    }

    /// The distinct knots of the domain of one direction, both ends among them: where polynomial pieces meet.
    pub fn span_parameters(&self, direction: Direction) -> Vec<f64> {
        let (knots, degree) = (self.knots(direction), self.degree(direction));
        let mut spans = knots.get(degree - 1..=knots.len() - degree).unwrap_or(&[]).to_vec();
        spans.dedup();
        spans
    }

    /// The Greville abscissae of one direction, one a row of control points: means of `degree` consecutive knots.
    pub fn greville_abscissae(&self, direction: Direction) -> Vec<f64> {
        let degree = self.degree(direction);
        let mean = |w: &[f64]| match (w.first(), w.last()) {
            // Equal knots give themselves, not a rounded mean.
            (Some(first), Some(last)) if first == last => *first,
            _ => w.iter().sum::<f64>() / degree as f64,
        };
        self.knots(direction).windows(degree).map(mean).collect()
    }
}
