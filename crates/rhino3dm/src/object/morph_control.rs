//! Class MorphControl (section 8): a curve, surface or cage that bends other objects along with it.

use katydid_geometry::{Interval, Point3, Vector3, Xform};
use uuid::Uuid;

use super::curve::{self, CurveForm};
use super::nurbs_cage::{self, NurbsCage};
use super::surface::{self, SurfaceForm};
use crate::chunk::{Reader, Writer};
use crate::{Error, Result, class_ids};

/// A curve, surface or cage that bends other objects along with it.
#[derive(Debug, Clone, PartialEq)]
pub struct MorphControl {
    /// What bends them.
    pub shape: MorphShape,
    /// The identifiers of the objects it bends.
    pub captives: Vec<Uuid>,
    /// Where it counts, and how much.
    pub localizers: Vec<Localizer>,
    /// How exactly the bent objects follow; 0 for the model's tolerance.
    pub tolerance: f64,
    /// Whether previews may be coarse.
    pub quick_preview: bool,
    /// Whether bent NURBS keep their knots and number of control points.
    pub preserve_structure: bool,
}

/// What bends other objects, before and after.
#[derive(Debug, Clone, PartialEq)]
pub enum MorphShape {
    /// A NURBS curve.
    Curve {
        /// Where it was at first.
        before: CurveForm,
        /// Where it is now.
        after: CurveForm,
    },
    /// A NURBS surface.
    Surface {
        /// Where it was at first.
        before: SurfaceForm,
        /// Where it is now.
        after: SurfaceForm,
    },
    /// A NURBS volume.
    Cage {
        /// From the model to the volume's parameters at first.
        before: Xform,
        /// Where it is now.
        after: NurbsCage,
    },
}

/// A part of space in which a morph counts, fading out beyond it.
#[derive(Debug, Clone, PartialEq)]
pub struct Localizer {
    /// 1 sphere, 2 plane, 3 cylinder, 4 curve, 5 surface, 6 distance; 0 for none.
    pub kind: i32,
    /// Its centre or origin.
    pub point: Point3,
    /// Its axis or normal.
    pub direction: Vector3,
    /// The distances at which it counts not at all and fully.
    pub range: Interval,
    /// The curve it keeps to.
    pub curve: Option<CurveForm>,
    /// The surface it keeps to.
    pub surface: Option<SurfaceForm>,
}

const WHAT: &str = "morph control";
const CURVE: i32 = 1;
const SURFACE: i32 = 2;
const CAGE: i32 = 3;
/// The shorter form of a chunk's header, versions and checksum.
const LEAST_LOCALIZER: usize = 20;

pub(super) fn read(body: &mut Reader<'_>) -> Result<MorphControl> {
    let offset = body.offset();
    let (mut body, major, minor) = body.versioned(WHAT)?;
    let control = match major {
        1 => read_1(&mut body)?,
        2 => read_2(&mut body, minor)?,
        other => return Err(Error::malformed(offset, WHAT, format!("major version {other} is not known"))),
    };
    body.finish();
    Ok(control)
}

/// The first form: cages only.
fn read_1(body: &mut Reader<'_>) -> Result<MorphControl> {
    let after = nurbs_cage::read(body)?;
    let captives = body.id_list(WHAT)?;
    let before = body.matrix(WHAT)?;
    Ok(MorphControl {
        shape: MorphShape::Cage { before, after },
        captives,
        localizers: Vec::new(),
        tolerance: 0.0,
        quick_preview: false,
        preserve_structure: false,
    })
}

fn read_2(body: &mut Reader<'_>, minor: i32) -> Result<MorphControl> {
    let shape = read_shape(body)?;
    let captives = body.id_list(WHAT)?;
    let (mut list, _) = body.versioned_1(WHAT)?;
    let count = list.count(LEAST_LOCALIZER, WHAT)?;
    let localizers = (0..count).map(|_| read_localizer(&mut list)).collect::<Result<_>>()?;
    list.finish();
    let newer = minor >= 1;
    Ok(MorphControl {
        shape,
        captives,
        localizers,
        tolerance: if newer { body.f64(WHAT)? } else { 0.0 },
        quick_preview: newer && body.bool(WHAT)?,
        preserve_structure: newer && body.bool(WHAT)?,
    })
}

fn read_shape(body: &mut Reader<'_>) -> Result<MorphShape> {
    let offset = body.offset();
    let kind = body.i32(WHAT)?;
    let (mut first, _) = body.versioned_1(WHAT)?;
    let (mut second, _) = body.versioned_1(WHAT)?;
    let shape = match kind {
        CURVE => MorphShape::Curve { before: read_curve(&mut first)?, after: read_curve(&mut second)? },
        SURFACE => MorphShape::Surface {
            before: surface::read_nurbs(&mut first)?,
            after: surface::read_nurbs(&mut second)?,
        },
        CAGE => MorphShape::Cage { before: first.matrix(WHAT)?, after: nurbs_cage::read(&mut second)? },
        other => return Err(Error::malformed(offset, WHAT, format!("it is of kind {other}"))),
    };
    first.finish();
    second.finish();
    Ok(shape)
}

fn read_curve(body: &mut Reader<'_>) -> Result<CurveForm> {
    curve::read(class_ids::NURBS_CURVE, body)
}

fn read_localizer(body: &mut Reader<'_>) -> Result<Localizer> {
    let (mut body, _) = body.versioned_1(WHAT)?;
    let mut localizer = Localizer {
        kind: body.i32(WHAT)?,
        point: body.point(WHAT)?,
        direction: body.vector(WHAT)?,
        range: body.interval(WHAT)?,
        curve: None,
        surface: None,
    };
    let (mut inner, _) = body.versioned_1(WHAT)?;
    if inner.bool(WHAT)? {
        localizer.curve = Some(read_curve(&mut inner)?);
    }
    inner.finish();
    let (mut inner, _) = body.versioned_1(WHAT)?;
    if inner.bool(WHAT)? {
        localizer.surface = Some(surface::read_nurbs(&mut inner)?);
    }
    inner.finish();
    body.finish();
    Ok(localizer)
}

pub(super) fn write(control: &MorphControl, w: &mut Writer) -> Result<()> {
    w.versioned(2, 1, |w| {
        write_shape(&control.shape, w)?;
        w.id_list(&control.captives)?;
        w.versioned(1, 0, |w| {
            w.count(control.localizers.len(), "localizers")?;
            control.localizers.iter().try_for_each(|localizer| write_localizer(localizer, w))
        })?;
        w.f64(control.tolerance);
        w.bool(control.quick_preview);
        w.bool(control.preserve_structure);
        Ok(())
    })
}

fn write_shape(shape: &MorphShape, w: &mut Writer) -> Result<()> {
    match shape {
        MorphShape::Curve { before, after } => {
            w.i32(CURVE);
            w.versioned(1, 0, |w| curve::write(before, w))?;
            w.versioned(1, 0, |w| curve::write(after, w))
        }
        MorphShape::Surface { before, after } => {
            w.i32(SURFACE);
            w.versioned(1, 0, |w| surface::write(before, w))?;
            w.versioned(1, 0, |w| surface::write(after, w))
        }
        MorphShape::Cage { before, after } => {
            w.i32(CAGE);
            w.versioned(1, 0, |w| {
                w.matrix(before);
                Ok(())
            })?;
            w.versioned(1, 0, |w| nurbs_cage::write(after, w))
        }
    }
}

fn write_localizer(localizer: &Localizer, w: &mut Writer) -> Result<()> {
    w.versioned(1, 0, |w| {
        w.i32(localizer.kind);
        w.point(localizer.point);
        w.vector(localizer.direction);
        w.interval(localizer.range);
        w.versioned(1, 0, |w| {
            w.bool(localizer.curve.is_some());
            localizer.curve.iter().try_for_each(|form| curve::write(form, w))
        })?;
        w.versioned(1, 0, |w| {
            w.bool(localizer.surface.is_some());
            localizer.surface.iter().try_for_each(|form| surface::write(form, w))
        })
    })
}
