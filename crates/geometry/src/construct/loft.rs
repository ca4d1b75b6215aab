//! Surfaces through section curves.

use super::{DevelopableOptions, check, developable_loft};
use crate::nurbs::{Skinning, skinned};
use crate::thresholds;
use crate::{Brep, Curve, Error, KnotSpacing, NurbsCurve, NurbsSurface, Point3, Result, Tolerance};

/// How a loft runs from section to section.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum LoftStyle {
    /// A cubic through the sections, with parameters by their distance.
    #[default]
    Normal,
    /// The control points of the sections are those of the surface: it passes near the inner ones.
    Loose,
    /// A cubic through the sections, with parameters by the root of their distance.
    Tight,
    /// Straight from each section to the next.
    Straight,
    /// Straight from each section to the next, by rulings along which the surface does not turn, so that it can be
    /// unrolled, see [`developable_loft`](super::developable_loft).
    Developable,
    /// A cubic through the sections, with parameters 1 apart.
    Uniform,
}

/// What a loft heeds beside its sections.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LoftOptions {
    /// How it runs from section to section.
    pub style: LoftStyle,
    /// Whether it goes on from the last section to the first. At least three sections are needed.
    pub closed: bool,
    /// Whether seams of closed sections are moved, and directions turned round, to fit the section before.
    pub adjust: bool,
    /// The number of control points with which sections are rebuilt first as cubics.
    pub rebuild: Option<usize>,
    /// The tolerance within which sections are fitted first by cubics; not heeded beside `rebuild`.
    pub refit: Option<f64>,
    /// A point at which it begins, before the first section.
    pub start: Option<Point3>,
    /// A point at which it ends, after the last section.
    pub end: Option<Point3>,
}

/// The surface through section curves in their order: u runs along the sections, v from section to section. It has
/// one face for each part without a kink; sections keep their shape, and rational ones stay so.
///
/// Sections are brought to a common degree and knots first (P&T, *The NURBS Book*, §10.3). Unless [`LoftOptions::adjust`]
/// is set nothing is done about directions and seams.
///
/// # Errors
/// Fewer than two sections (a point at an end counts as one), fewer than three of a closed one, sections of which
/// some are closed and some not when they are adjusted, neighbours that coincide, a surface without area, or weights
/// so different that no surface lies between.
pub fn loft(sections: &[Curve], options: &LoftOptions, tolerance: &Tolerance) -> Result<Brep> {
    check(&sections.iter().collect::<Vec<_>>(), tolerance)?;
    let points = usize::from(options.start.is_some()) + usize::from(options.end.is_some());
    let least = if options.closed { 3 } else { 2 };
    if sections.is_empty() || sections.len() + points < least {
        return Err(Error::Invalid {
            what: "sections of a loft",
            why: format!("there must be at least {least}, got {}", sections.len() + points),
        });
    }
    if options.closed && points > 0 {
        return Err(Error::degenerate("loft", "a closed one does not end in a point"));
    }
    let mut prepared = Vec::with_capacity(sections.len());
    for section in sections {
        prepared.push(rebuilt(section, options)?);
    }
    if options.adjust {
        adjust(&mut prepared)?;
    }
    if options.style == LoftStyle::Developable {
        return unrollable(&prepared, options, tolerance);
    }
    let surface = between(&prepared, options)?;
    Brep::from_kinked_surface(&surface.into(), tolerance)
}

/// The developable surfaces from each section to the next.
fn unrollable(sections: &[Curve], options: &LoftOptions, tolerance: &Tolerance) -> Result<Brep> {
    let mut breps = Vec::with_capacity(sections.len() + 1);
    let end = |section: &Curve, point: Point3| -> Result<Brep> {
        let base = section.to_nurbs()?;
        let surface = NurbsSurface::ruled(&base, &collapsed(&base, point)?)?;
        Brep::from_kinked_surface(&surface.into(), tolerance)
    };
    if let (Some(point), Some(first)) = (options.start, sections.first()) {
        breps.push(end(first, point)?);
    }
    let around = sections.last().zip(sections.first()).filter(|_| options.closed);
    let pairs = sections.windows(2).map(|pair| (&pair[0], &pair[1])).chain(around);
    for (a, b) in pairs {
        breps.push(developable_loft(a, b, &DevelopableOptions::default(), tolerance)?.brep);
    }
    if let (Some(point), Some(last)) = (options.end, sections.last()) {
        breps.push(end(last, point)?);
    }
    let joined = Brep::join(&breps, tolerance)?.breps;
    Ok(match <[Brep; 1]>::try_from(joined) {
        Ok([brep]) => brep,
        Err(several) => Brep::merged(&several),
    })
}

/// The ruled surface between two curves: u runs along both, straight lines in v go from the first, at 0, to the
/// second, at 1. Directions are not matched.
///
/// # Errors
/// A surface without area.
pub fn ruled(first: &Curve, second: &Curve, tolerance: &Tolerance) -> Result<Brep> {
    check(&[first, second], tolerance)?;
    let surface = NurbsSurface::ruled(&first.to_nurbs()?, &second.to_nurbs()?)?;
    Brep::from_kinked_surface(&surface.into(), tolerance)
}

fn rebuilt(section: &Curve, options: &LoftOptions) -> Result<Curve> {
    Ok(match (options.rebuild.filter(|n| *n > 0), options.refit.filter(|t| *t > 0.0)) {
        (Some(count), _) => section.rebuilt(3, count.max(4), false)?.curve.into(),
        (None, Some(tolerance)) => section.refitted(3, tolerance)?.curve.into(),
        (None, None) => section.clone(),
    })
}

/// Turns sections and moves seams so that each fits the one before.
fn adjust(sections: &mut [Curve]) -> Result<()> {
    for i in 1..sections.len() {
        let (done, rest) = sections.split_at_mut(i);
        let (Some(before), Some(this)) = (done.last(), rest.first_mut()) else { continue };
        if before.is_closed() && this.is_closed() {
            let (seam, domain) = (this.closest_point(before.start())?.parameter, this.domain());
            let at_end = [domain.start, domain.end]
                .iter()
                .any(|t| (seam - t).abs() <= thresholds::SAME_PARAMETER * domain.length());
            let turned = if at_end { this.clone() } else { this.with_seam(seam)? };
            // Of both directions the one whose points are nearer.
            let back = turned.reversed();
            *this = if apart(before, &back) < apart(before, &turned) { back } else { turned };
        } else if before.is_closed() == this.is_closed() {
            let back = this.reversed();
            if apart(before, &back) < apart(before, this) {
                *this = back;
            }
        } else {
            return Err(Error::degenerate("sections of a loft", "some are closed and some are open"));
        }
    }
    Ok(())
}

/// The sum of distances between points of equal share of both domains.
fn apart(a: &Curve, b: &Curve) -> f64 {
    const PLACES: usize = 12;
    (0..=PLACES)
        .map(|k| {
            let x = k as f64 / PLACES as f64;
            a.point_at(a.domain().at(x)).distance_to(b.point_at(b.domain().at(x)))
        })
        .sum()
}

fn between(sections: &[Curve], options: &LoftOptions) -> Result<NurbsSurface> {
    let mut curves: Vec<NurbsCurve> = sections.iter().map(Curve::to_nurbs).collect::<Result<_>>()?;
    curves = crate::compatible_curves(&curves)?;
    let Some(model) = curves.first().cloned() else {
        return Err(Error::degenerate("loft", "there are no sections"));
    };
    if let Some(p) = options.start {
        curves.insert(0, collapsed(&model, p)?);
    }
    if let Some(p) = options.end {
        curves.push(collapsed(&model, p)?);
    }
    let (style, spacing) = match options.style {
        LoftStyle::Normal => (Skinning::Through, KnotSpacing::Chord),
        LoftStyle::Tight => (Skinning::Through, KnotSpacing::SquareRootChord),
        LoftStyle::Uniform => (Skinning::Through, KnotSpacing::Uniform),
        LoftStyle::Straight | LoftStyle::Developable => (Skinning::Straight, KnotSpacing::Chord),
        LoftStyle::Loose => (Skinning::Near, KnotSpacing::Uniform),
    };
    let parameters = match style {
        Skinning::Near => Vec::new(),
        _ => crate::nurbs::section_parameters(&curves, options.closed, spacing)?,
    };
    skinned(&curves, style, &parameters, options.closed)
}

/// A curve with the weights and knots of another, all in one point.
pub(super) fn collapsed(model: &NurbsCurve, point: Point3) -> Result<NurbsCurve> {
    if !point.is_finite() {
        return Err(Error::NotFinite("end point of the loft"));
    }
    let points = vec![point; model.point_count()];
    let knots = model.knots().to_vec();
    if model.is_rational() {
        NurbsCurve::with_weights(model.degree(), &points, &model.weights(), knots)
    } else {
        NurbsCurve::new(model.degree(), points, knots)
    }
}
