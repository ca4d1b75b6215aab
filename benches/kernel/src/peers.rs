//! The same curves and surfaces in the other kernels' types.

use curvo::prelude as curvo;
use nalgebra::{Point3, Point4};
use truck_geometry::prelude as truck;

use crate::inputs::{CurveRecord, SurfaceRecord};

/// A curve of curvo, which is always rational.
pub type CurvoCurve = curvo::NurbsCurve3D<f64>;
/// A surface of curvo, which is always rational.
pub type CurvoSurface = curvo::NurbsSurface3D<f64>;

/// A curve of truck: plain and rational ones are two types.
#[derive(Debug)]
pub enum TruckCurve {
    /// Without weights.
    Plain(truck::BSplineCurve<truck::Point3>),
    /// With weights.
    Rational(truck::NurbsCurve<truck::Vector4>),
}

/// A surface of truck.
#[derive(Debug)]
pub enum TruckSurface {
    /// Without weights.
    Plain(truck::BSplineSurface<truck::Point3>),
    /// With weights.
    Rational(truck::NurbsSurface<truck::Vector4>),
}

fn homogeneous(p: &[f64; 4]) -> [f64; 4] {
    [p[0] * p[3], p[1] * p[3], p[2] * p[3], p[3]]
}

impl CurveRecord {
    /// The curve in curvo.
    ///
    /// # Errors
    /// Whatever curvo says.
    pub fn curvo(&self) -> Result<CurvoCurve, Box<dyn std::error::Error>> {
        let points = self.points.iter().map(|p| Point4::from(homogeneous(p))).collect();
        Ok(CurvoCurve::try_new(self.degree, points, self.knots.clone())?)
    }

    /// The curve in the plane z = 0, in curvo.
    ///
    /// # Errors
    /// Whatever curvo says.
    pub fn curvo_flat(&self) -> Result<curvo::NurbsCurve2D<f64>, Box<dyn std::error::Error>> {
        let points = self.points.iter().map(|p| Point3::new(p[0] * p[3], p[1] * p[3], p[3])).collect();
        Ok(curvo::NurbsCurve2D::try_new(self.degree, points, self.knots.clone())?)
    }

    /// The curve in truck.
    pub fn truck(&self) -> TruckCurve {
        let knots = truck::KnotVec::from(self.knots.clone());
        if self.rational {
            let points = self.points.iter().map(|p| truck::Vector4::from(homogeneous(p))).collect();
            return TruckCurve::Rational(truck::NurbsCurve::new(truck::BSplineCurve::new(knots, points)));
        }
        let points = self.points.iter().map(|p| truck::Point3::new(p[0], p[1], p[2])).collect();
        TruckCurve::Plain(truck::BSplineCurve::new(knots, points))
    }
}

impl SurfaceRecord {
    /// The surface in curvo.
    pub fn curvo(&self) -> CurvoSurface {
        let rows = self.points.chunks(self.counts[1].max(1));
        let points = rows.map(|r| r.iter().map(|p| Point4::from(homogeneous(p))).collect()).collect();
        let [u, v] = self.knots.clone();
        CurvoSurface::new(self.degrees[0], self.degrees[1], u, v, points)
    }

    /// The surface in truck.
    pub fn truck(&self) -> TruckSurface {
        let [u, v] = self.knots.clone();
        let knots = (truck::KnotVec::from(u), truck::KnotVec::from(v));
        let rows = self.points.chunks(self.counts[1].max(1));
        if self.rational {
            let points =
                rows.map(|r| r.iter().map(|p| truck::Vector4::from(homogeneous(p))).collect()).collect();
            return TruckSurface::Rational(truck::NurbsSurface::new(truck::BSplineSurface::new(
                knots, points,
            )));
        }
        let points = rows.map(|r| r.iter().map(|p| truck::Point3::new(p[0], p[1], p[2])).collect()).collect();
        TruckSurface::Plain(truck::BSplineSurface::new(knots, points))
    }
}

impl TruckCurve {
    /// The point at `t`.
    #[inline]
    pub fn point(&self, t: f64) -> truck::Point3 {
        use truck_geotrait::ParametricCurve;
        match self {
            Self::Plain(c) => c.subs(t),
            Self::Rational(c) => c.subs(t),
        }
    }

    /// The point at `t` and two derivatives.
    #[inline]
    pub fn jet(&self, t: f64) -> (truck::Point3, truck::Vector3, truck::Vector3) {
        use truck_geotrait::ParametricCurve;
        match self {
            Self::Plain(c) => (c.subs(t), c.der(t), c.der2(t)),
            Self::Rational(c) => (c.subs(t), c.der(t), c.der2(t)),
        }
    }
}

impl TruckSurface {
    /// The point at (u, v).
    #[inline]
    pub fn point(&self, u: f64, v: f64) -> truck::Point3 {
        use truck_geotrait::ParametricSurface;
        match self {
            Self::Plain(s) => s.subs(u, v),
            Self::Rational(s) => s.subs(u, v),
        }
    }

    /// The point at (u, v) and the first partial derivatives.
    #[inline]
    pub fn partials(&self, u: f64, v: f64) -> (truck::Point3, truck::Vector3, truck::Vector3) {
        use truck_geotrait::ParametricSurface;
        match self {
            Self::Plain(s) => (s.subs(u, v), s.uder(u, v), s.vder(u, v)),
            Self::Rational(s) => (s.subs(u, v), s.uder(u, v), s.vder(u, v)),
        }
    }
}
