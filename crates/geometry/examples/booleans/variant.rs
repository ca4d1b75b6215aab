//! The same case again in other places, sizes, orders and forms.

use katydid_geometry::{Brep, Error, Point3, Result, Vector3, Xform};

/// What is changed about the operands of a case before they meet; results are moved back.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) enum Variant {
    /// Nothing.
    #[default]
    Plain,
    /// The operands come in the other order.
    Swapped,
    /// All are turned about a skew axis.
    Rotated,
    /// All are scaled.
    Scaled(f64),
    /// All are moved by so much in each direction.
    Moved(f64),
    /// All surfaces are NURBS surfaces.
    Nurbs,
    /// The tools are moved by this length in model units, or by so many tolerances, in a skew direction.
    Nudged { length: f64, tolerances: f64 },
}

/// The variants that every case is looked at in.
pub(crate) const VARIANTS: [(&str, Variant); 10] = [
    ("swapped", Variant::Swapped),
    ("rotated", Variant::Rotated),
    ("scaled by 1e-3", Variant::Scaled(1e-3)),
    ("scaled by 1e4", Variant::Scaled(1e4)),
    ("moved by 1e6", Variant::Moved(1e6)),
    ("as NURBS", Variant::Nurbs),
    ("nudged by 1e-13", Variant::Nudged { length: 1e-13, tolerances: 0.0 }),
    ("nudged by 1e-9", Variant::Nudged { length: 1e-9, tolerances: 0.0 }),
    ("nudged by half the tolerance", Variant::Nudged { length: 0.0, tolerances: 0.5 }),
    ("nudged by twice the tolerance", Variant::Nudged { length: 0.0, tolerances: 2.0 }),
];

impl Variant {
    pub(crate) fn swaps(self) -> bool {
        self == Self::Swapped
    }

    /// Whether touching operands may part, so that areas and counts are others.
    pub(crate) fn parts(self) -> bool {
        matches!(self, Self::Nudged { tolerances, .. } if tolerances > 1.0)
    }

    fn xform(self) -> Result<Option<Xform>> {
        Ok(match self {
            Self::Rotated => {
                Some(Xform::rotation(0.7, Vector3::new(1.0, 2.0, 3.0), Point3::new(0.3, 0.2, 0.1))?)
            }
            Self::Scaled(by) => Some(Xform::scale(Point3::ORIGIN, by)),
            Self::Moved(by) => Some(Xform::translation(Vector3::new(by, by, by))),
            _ => None,
        })
    }

    /// The operands as the kernel gets them: the tools begin at `tools`, and `tolerance` is that of the plain case.
    pub(crate) fn operands(self, all: &[Brep], tools: usize, tolerance: f64) -> Result<Vec<Brep>> {
        match self {
            Self::Nurbs => all.iter().map(Brep::with_nurbs_surfaces).collect(),
            Self::Nudged { length, tolerances } => {
                let way = Vector3::new(2.0, 3.0, 6.0) * ((length + tolerances * tolerance) / 7.0);
                let x = Xform::translation(way);
                let moved =
                    |(k, b): (usize, &Brep)| if k < tools { Ok(b.clone()) } else { b.transformed(&x) };
                all.iter().enumerate().map(moved).collect()
            }
            _ => match self.xform()? {
                Some(x) => all.iter().map(|b| b.transformed(&x)).collect(),
                None => Ok(all.to_vec()),
            },
        }
    }

    /// A part of the result where it would be without the variant.
    pub(crate) fn back<T>(self, part: T, moved: impl Fn(&T, &Xform) -> Result<T>) -> Result<T> {
        match self.xform()? {
            Some(x) => moved(&part, &x.inverse().ok_or(Error::Unsupported("a variant without a way back"))?),
            None => Ok(part),
        }
    }
}
