//! Curvature combs: teeth from a curve away from the centre of curvature, as long as the curvature is large, and the line
//! over their tips.

use std::sync::Arc as Shared;

use katydid_elementary::Elementary;
use katydid_geometry::{BoundingBox, CurvatureSample, Curve, Point3};
use katydid_scene::Origin;

use super::isocurves::isocurves;
use super::{Measure, Sheet, Subjects, size};
use crate::protocol::{CombMeasure, CombView, PartKind};

/// Steps a span to find how sharp curves are.
const SURVEY: usize = 8;
/// So many spans are searched for their sharpest place to all digits.
const MOST_SEARCHED: usize = 400;
/// Of so many curvatures of an object the ordinary one is found.
const MOST_KEPT: usize = 256;
/// A place so many times as sharp as nine tenths of all may have a longer tooth than was asked for.
const UNUSUAL: f64 = 4.0;
/// The widths of teeth and of the line over them, in pixels.
const TEETH: f64 = 1.0;
const TIPS: f64 = 1.6;
/// Places of the line over the tips from one tooth to the next.
const BETWEEN: usize = 4;

/// How many places of the line over the tips there are a tooth.
pub(super) fn places(is_draft: bool) -> usize {
    if is_draft { 1 } else { BETWEEN }
}

/// The curves of an object that have combs.
fn curves(subjects: &Subjects, view: &CombView, between: usize) -> Vec<(Origin, Shared<Curve>)> {
    let mut all = subjects.curves.clone();
    if view.surfaces {
        for (origin, surface) in subjects.surfaces() {
            all.extend(isocurves(surface, between).map(|line| (origin, Shared::new(line.curve.into()))));
        }
    }
    all
}

/// How sharply everything bends.
#[derive(Debug, Default)]
pub(super) struct Survey {
    pub(super) spans: usize,
    curvatures: Vec<f64>,
    greatest: f64,
    at: Point3,
    bounds: Option<BoundingBox>,
}

impl Survey {
    pub(super) fn of(all: &[&Subjects], view: &CombView, between: usize) -> Self {
        let mut survey = Self::default();
        let curves: Vec<_> = all.iter().flat_map(|subjects| curves(subjects, view, between)).collect();
        survey.spans = curves.iter().map(|(_, curve)| curve.bending_spans()).sum();
        let is_searched = survey.spans <= MOST_SEARCHED;
        let every = (survey.spans * SURVEY).div_ceil(MOST_KEPT * all.len().max(1)).max(1);
        let mut count = 0_usize;
        for (_, curve) in &curves {
            for sample in curve.curvature_samples(SURVEY).iter().flatten() {
                let curvature = survey.note(sample);
                count += 1;
                if count.is_multiple_of(every) {
                    survey.curvatures.push(curvature);
                }
            }
            let extrema = if is_searched { curve.curvature_extrema() } else { Vec::new() };
            for extremum in extrema.iter().filter(|extremum| extremum.is_maximum) {
                if extremum.curvature.is_finite() && extremum.curvature > survey.greatest {
                    (survey.greatest, survey.at) = (extremum.curvature, curve.point_at(extremum.parameter));
                }
            }
        }
        survey.curvatures.sort_by(f64::total_cmp);
        survey
    }

    fn note(&mut self, sample: &CurvatureSample) -> f64 {
        let curvature = sample.curvature.length();
        if !(curvature.is_finite() && sample.point.is_finite()) {
            return 0.0;
        }
        if curvature > self.greatest {
            (self.greatest, self.at) = (curvature, sample.point);
        }
        let one = BoundingBox { min: sample.point, max: sample.point };
        self.bounds = Some(self.bounds.map_or(one, |bounds| bounds.union(&one)));
        curvature
    }

    /// How large all that bends is.
    pub(super) fn size(&self) -> f64 {
        size(self.bounds.as_ref())
    }

    /// The scale that gives the longest tooth its share of the size: 1, 2 or 5 times a power of ten, so that it stays
    /// where it is while curves move a little. 0 where nothing bends.
    pub(super) fn scale(&self, share: f64) -> f64 {
        let ordinary = self.curvatures.get(self.curvatures.len() * 9 / 10).copied().unwrap_or(self.greatest);
        let usual = if ordinary > 0.0 { self.greatest.min(UNUSUAL * ordinary) } else { self.greatest };
        let scale = share.clamp(1e-3, 10.0) * self.size() / usual;
        if !(scale.is_finite() && scale > 0.0) {
            return 0.0;
        }
        let power = 10.0_f64.raised_to(scale.logarithm_10().floor());
        let step = [5.0, 2.0].into_iter().find(|step| step * power <= scale * (1.0 + 1e-12)).unwrap_or(1.0);
        step * power
    }

    /// The sharpest place.
    pub(super) fn sharpest(&self, scale: f64) -> Option<CombMeasure> {
        let at = [self.at.x, self.at.y, self.at.z];
        (self.greatest > 0.0).then_some(CombMeasure { scale, sharpest: self.greatest, at })
    }
}

/// Draws the combs of an object.
pub(super) fn draw(sheet: &mut Sheet, subjects: &Subjects, view: &CombView, measure: &Measure) {
    let places = places(measure.is_draft);
    for (origin, curve) in curves(subjects, view, measure.between) {
        if sheet.is_full() {
            return;
        }
        for span in curve.curvature_samples(measure.teeth * places) {
            let tips: Vec<Point3> = span.iter().map(|sample| tip(sample, measure)).collect();
            for (sample, tip) in span.iter().zip(&tips).step_by(places) {
                if sample.point != *tip {
                    sheet.line(PartKind::Comb, TEETH, &[sample.point, *tip], origin);
                }
            }
            if span.iter().zip(&tips).any(|(sample, tip)| sample.point != *tip) {
                sheet.line(PartKind::Comb, TIPS, &tips, origin);
            }
        }
    }
}

fn tip(sample: &CurvatureSample, measure: &Measure) -> Point3 {
    let curvature = sample.curvature.length();
    let length = (curvature * measure.scale).min(measure.longest);
    match sample.curvature.unitized() {
        Some(towards) if length.is_finite() => sample.point - towards * length,
        _ => sample.point,
    }
}
