//! Curves of all kinds.

use std::fmt;

use serde::de::{DeserializeSeed, EnumAccess, Error as _, MapAccess, SeqAccess, VariantAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::plain::increasing;
use super::{Form, structure, through_forms};
use crate::curve::MAX_NESTING;
use crate::nurbs::Controls;
use crate::{
    Arc, ArcCurve, Curve, Interval, Line, LineCurve, NurbsCurve, Point3, PolyCurve, PolylineCurve, Result,
};

structure!(LineCurve { line: Line, domain: Interval } | c | increasing("domain of a line", c.domain));
structure!(ArcCurve { arc: Arc, domain: Interval } | c | increasing("domain of an arc", c.domain));

/// A polyline by its vertices and their parameters.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(unreachable_pub, reason = "an associated type needs it")]
pub struct WrittenPolyline {
    points: Vec<Point3>,
    parameters: Vec<f64>,
}

impl Form for PolylineCurve {
    type Written = WrittenPolyline;
    fn written(&self) -> WrittenPolyline {
        WrittenPolyline { points: self.points().to_vec(), parameters: self.parameters().to_vec() }
    }
    fn read(w: WrittenPolyline) -> Result<Self> {
        Self::with_parameters(w.points, w.parameters)
    }
}

/// Control points in space, or homogeneous (wx, wy, wz, w).
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[allow(unreachable_pub, reason = "a field of an associated type needs it")]
pub enum WrittenControls {
    /// (x, y, z)
    Plain(Vec<[f64; 3]>),
    /// (wx, wy, wz, w)
    Rational(Vec<[f64; 4]>),
}

/// A NURBS curve; the knots in the openNURBS form.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(unreachable_pub, reason = "an associated type needs it")]
pub struct WrittenNurbs {
    degree: usize,
    knots: Vec<f64>,
    controls: WrittenControls,
}

impl Form for NurbsCurve {
    type Written = WrittenNurbs;
    fn written(&self) -> WrittenNurbs {
        let controls = match &self.controls {
            Controls::Plain(p) => WrittenControls::Plain(p.clone()),
            Controls::Rational(p) => WrittenControls::Rational(p.clone()),
        };
        WrittenNurbs { degree: self.degree(), knots: self.knots().to_vec(), controls }
    }
    fn read(w: WrittenNurbs) -> Result<Self> {
        match w.controls {
            WrittenControls::Plain(p) => {
                Self::new(w.degree, p.into_iter().map(Point3::from).collect(), w.knots)
            }
            WrittenControls::Rational(p) => Self::rational(w.degree, p, w.knots),
        }
    }
}

through_forms!(PolylineCurve, NurbsCurve);

const KINDS: &[&str] = &["line", "arc", "polyline", "nurbs", "poly"];
const POLY: &[&str] = &["segments", "parameters"];

impl Serialize for Curve {
    fn serialize<S: Serializer>(&self, s: S) -> std::result::Result<S::Ok, S::Error> {
        match self {
            Self::Line(c) => s.serialize_newtype_variant("Curve", 0, "line", c),
            Self::Arc(c) => s.serialize_newtype_variant("Curve", 1, "arc", c),
            Self::Polyline(c) => s.serialize_newtype_variant("Curve", 2, "polyline", c),
            Self::Nurbs(c) => s.serialize_newtype_variant("Curve", 3, "nurbs", c),
            Self::Poly(c) => s.serialize_newtype_variant("Curve", 4, "poly", c),
        }
    }
}

impl Serialize for PolyCurve {
    fn serialize<S: Serializer>(&self, s: S) -> std::result::Result<S::Ok, S::Error> {
        use serde::ser::SerializeStruct;
        let mut out = s.serialize_struct("PolyCurve", 2)?;
        out.serialize_field("segments", self.segments())?;
        out.serialize_field("parameters", self.parameters())?;
        out.end()
    }
}

impl<'de> Deserialize<'de> for Curve {
    fn deserialize<D: Deserializer<'de>>(d: D) -> std::result::Result<Self, D::Error> {
        CurveAt(0).deserialize(d)
    }
}

impl<'de> Deserialize<'de> for PolyCurve {
    fn deserialize<D: Deserializer<'de>>(d: D) -> std::result::Result<Self, D::Error> {
        PolyAt(1).deserialize(d)
    }
}

/// A curve inside so many poly-curves. The count stops a file whose nesting would exhaust the stack.
#[derive(Clone, Copy)]
struct CurveAt(usize);

/// A poly-curve that is itself so deep.
#[derive(Clone, Copy)]
struct PolyAt(usize);

/// The segments of a poly-curve that deep.
struct SegmentsAt(usize);

/// Which kind of curve follows.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Kind {
    Line,
    Arc,
    Polyline,
    Nurbs,
    Poly,
}

impl<'de> DeserializeSeed<'de> for CurveAt {
    type Value = Curve;
    fn deserialize<D: Deserializer<'de>>(self, d: D) -> std::result::Result<Curve, D::Error> {
        d.deserialize_enum("Curve", KINDS, self)
    }
}

impl<'de> Visitor<'de> for CurveAt {
    type Value = Curve;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a curve")
    }

    fn visit_enum<A: EnumAccess<'de>>(self, data: A) -> std::result::Result<Curve, A::Error> {
        let (kind, content) = data.variant::<Kind>()?;
        Ok(match kind {
            Kind::Line => Curve::Line(content.newtype_variant()?),
            Kind::Arc => Curve::Arc(content.newtype_variant()?),
            Kind::Polyline => Curve::Polyline(content.newtype_variant()?),
            Kind::Nurbs => Curve::Nurbs(content.newtype_variant()?),
            Kind::Poly => Curve::Poly(content.newtype_variant_seed(PolyAt(self.0 + 1))?),
        })
    }
}

impl<'de> DeserializeSeed<'de> for PolyAt {
    type Value = PolyCurve;
    fn deserialize<D: Deserializer<'de>>(self, d: D) -> std::result::Result<PolyCurve, D::Error> {
        if self.0 > MAX_NESTING {
            return Err(D::Error::custom(format!("poly-curves are nested more than {MAX_NESTING} deep")));
        }
        d.deserialize_struct("PolyCurve", POLY, self)
    }
}

impl<'de> Visitor<'de> for PolyAt {
    type Value = PolyCurve;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a poly-curve with segments and parameters")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> std::result::Result<PolyCurve, A::Error> {
        let (mut segments, mut parameters) = (None, None);
        while let Some(key) = map.next_key::<String>()? {
            match key.as_str() {
                "segments" => segments = Some(map.next_value_seed(SegmentsAt(self.0))?),
                "parameters" => parameters = Some(map.next_value()?),
                other => return Err(A::Error::unknown_field(other, POLY)),
            }
        }
        let segments = segments.ok_or_else(|| A::Error::missing_field("segments"))?;
        let parameters = parameters.ok_or_else(|| A::Error::missing_field("parameters"))?;
        PolyCurve::with_parameters(segments, parameters).map_err(A::Error::custom)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> std::result::Result<PolyCurve, A::Error> {
        let segments = list.next_element_seed(SegmentsAt(self.0))?;
        let segments = segments.ok_or_else(|| A::Error::missing_field("segments"))?;
        let parameters = list.next_element()?.ok_or_else(|| A::Error::missing_field("parameters"))?;
        PolyCurve::with_parameters(segments, parameters).map_err(A::Error::custom)
    }
}

impl<'de> DeserializeSeed<'de> for SegmentsAt {
    type Value = Vec<Curve>;
    fn deserialize<D: Deserializer<'de>>(self, d: D) -> std::result::Result<Vec<Curve>, D::Error> {
        d.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for SegmentsAt {
    type Value = Vec<Curve>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of curves")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> std::result::Result<Vec<Curve>, A::Error> {
        let mut segments = Vec::new();
        while let Some(segment) = list.next_element_seed(CurveAt(self.0))? {
            segments.push(segment);
        }
        Ok(segments)
    }
}
