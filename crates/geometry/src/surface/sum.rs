use crate::{
    Curve, Direction, Error, Interval, LineCurve, NurbsSurface, Point3, Result, SurfaceDerivatives, Vector3,
};

/// Refuses a curve that holds what is no number, or whose domain does not increase.
pub(super) fn check_curve(what: &'static str, curve: &Curve) -> Result<()> {
    let domain = curve.domain();
    if !domain.is_increasing() {
        return Err(Error::Invalid {
            what: "domain of a surface's curve",
            why: format!("{} to {} does not increase", domain.start, domain.end),
        });
    }
    if curve.is_finite() { Ok(()) } else { Err(Error::NotFinite(what)) }
}

/// The sums of the points of two curves, moved: S(u, v) = A(u) + B(v) + shift. An extrusion is the sum of a curve
/// and a segment.
#[derive(Debug, Clone, PartialEq)]
pub struct SumSurface {
    curves: [Curve; 2],
    shift: Vector3,
}

impl SumSurface {
    /// The sum of two curves and a shift; u runs along the first curve, over its domain.
    ///
    /// # Errors
    /// The shift or a number of a curve is not finite.
    pub fn new(first: Curve, second: Curve, shift: Vector3) -> Result<Self> {
        check_curve("curve of the sum surface", &first)?;
        check_curve("curve of the sum surface", &second)?;
        if !shift.is_finite() {
            return Err(Error::NotFinite("shift of the sum surface"));
        }
        Ok(Self { curves: [first, second], shift })
    }

    /// The curve moved along a straight segment: u along the curve, v over 0…length of `direction`.
    ///
    /// # Errors
    /// The direction has no length or is not finite.
    pub fn extrusion(curve: Curve, direction: Vector3) -> Result<Self> {
        if direction.unitized().is_none() {
            return Err(Error::degenerate("extrusion", "its direction has no length"));
        }
        let line = crate::Line::new(Point3::ORIGIN, direction.to_point());
        Self::new(curve, LineCurve::new(line).into(), Vector3::ZERO)
    }

    /// The two curves, that along u first.
    pub fn curves(&self) -> &[Curve; 2] {
        &self.curves
    }

    /// What is added to the sum.
    pub fn shift(&self) -> Vector3 {
        self.shift
    }

    /// The range of one parameter.
    pub fn domain(&self, direction: Direction) -> Interval {
        self.curves[direction.index()].domain()
    }

    /// The point at (u, v).
    pub fn point_at(&self, u: f64, v: f64) -> Point3 {
        let [a, b] = &self.curves;
        a.point_at(u) + b.point_at(v).to_vector() + self.shift
    }

    pub(super) fn derivatives(&self, u: f64, v: f64, order: usize, below: [bool; 2]) -> SurfaceDerivatives {
        let (p, a) = self.curves[0].derivatives(u, order, below[0]);
        let (q, b) = self.curves[1].derivatives(v, order, below[1]);
        let of = |list: &[Vector3], k: usize| list.get(k - 1).copied().unwrap_or(Vector3::ZERO);
        SurfaceDerivatives::from_fn(order, |i, j| match (i, j) {
            (0, 0) => p.to_vector() + q.to_vector() + self.shift,
            (i, 0) => of(&a, i),
            (0, j) => of(&b, j),
            _ => Vector3::ZERO,
        })
    }

    /// The exact NURBS form over the same domains; where a curve is an arc, only the joints and middles of its spans
    /// keep their parameters.
    ///
    /// # Errors
    /// A degenerate arc, or a number overflows.
    pub fn to_nurbs(&self) -> Result<NurbsSurface> {
        NurbsSurface::sum(&self.curves[0].to_nurbs()?, &self.curves[1].to_nurbs()?, self.shift)
    }

    /// The same points with u and v exchanged.
    #[must_use]
    pub fn transposed(&self) -> Self {
        let [a, b] = self.curves.clone();
        Self { curves: [b, a], shift: self.shift }
    }

    /// The surface with the curve of one direction replaced.
    pub(super) fn with_curve(&self, direction: Direction, curve: Curve) -> Self {
        let mut out = self.clone();
        out.curves[direction.index()] = curve;
        out
    }
}
