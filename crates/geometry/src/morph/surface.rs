//! Surfaces under a map.

use super::Morph;
use crate::intersect::curve_plane;
use crate::morph::thresholds::AT_SEAM;
use crate::{Direction, NurbsSurface, Plane, Point3, Result, Side, Surface, Tolerance};

/// No image has more control points than this.
const MOST: usize = 40_000;
/// A map is affine where mapped control points miss by no more than this part of the size: rounding.
const EXACT: f64 = 1e-12;
/// To what part of itself the error must come down for halving the spans of one direction alone to be worthwhile.
const WORTHWHILE: f64 = 0.25;
/// Parameters nearer than this part of the domain are one.
const SAME: f64 = 1e-9;

/// The surface with its control points mapped.
pub(super) fn by_controls(surface: &NurbsSurface, morph: &dyn Morph) -> Result<NurbsSurface> {
    let points = surface.control_points().into_iter().map(|p| morph.image(p)).collect::<Result<Vec<_>>>()?;
    let knots = Direction::BOTH.map(|d| surface.knots(d).to_vec());
    if surface.is_rational() {
        NurbsSurface::with_weights(surface.degrees(), surface.counts(), &points, &surface.weights(), knots)
    } else {
        NurbsSurface::new(surface.degrees(), surface.counts(), points, knots)
    }
}

impl Surface {
    /// The image of the surface within `tolerance.absolute` of the exact one, as far as places inside every patch and on
    /// its edges tell. Where the map is affine, the NURBS form with its control points mapped; else a bicubic one (or of
    /// the surface's own degrees, if higher) through the images of as many points as it has control points, with spans
    /// halved until that suffices and kinks where the map's seams run along parameter lines. The domains stay, and the
    /// parameters are those of [`Surface::to_nurbs`].
    ///
    /// With 40,000 control points it ends, near enough or not.
    ///
    /// # Errors
    /// As the map's, and when the surface has no NURBS form.
    pub fn morphed(&self, morph: &dyn Morph, tolerance: &Tolerance) -> Result<Self> {
        tolerance.positive_distance()?;
        let mut source = self.to_nurbs()?;
        let plain = by_controls(&source, morph)?;
        let size = source.hull_box().min.distance_to(source.hull_box().max);
        if miss(&source, &plain, morph)?.worst <= EXACT * size {
            // The map is affine where the surface is.
            return Ok(plain.into());
        }
        for direction in Direction::BOTH {
            source = source.clamped(direction)?;
            // Straight spans cannot bend.
            let degree = source.degree(direction);
            if degree < 3 {
                source = source.raised_to(direction, 3)?;
            }
        }
        for seam in morph.seams() {
            source = kinked(source, &seam)?;
        }
        let sides = Sides::of(self);
        let mut image = through(&source, morph, &sides)?;
        let mut worst = miss(&source, &image, morph)?;
        // What one direction alone did not mend once is not tried again.
        let mut first = 0;
        while !(worst.worst <= tolerance.absolute) {
            let mut best: Option<(Miss, NurbsSurface, NurbsSurface)> = None;
            let choices = [&Direction::BOTH[..1], &Direction::BOTH[1..], &Direction::BOTH[..]];
            // One direction where that alone brings it nearer, as for what is bent one way.
            for (choice, directions) in choices.into_iter().enumerate().skip(first) {
                let next = halved(&source, directions, &worst, tolerance.absolute)?;
                if next.point_count() > MOST {
                    continue;
                }
                let made = through(&next, morph, &sides)?;
                let left = miss(&next, &made, morph)?;
                let nearer = best.as_ref().is_none_or(|(least, ..)| left.worst < least.worst);
                let enough = left.worst <= tolerance.absolute || left.worst <= WORTHWHILE * worst.worst;
                if nearer {
                    best = Some((left, next, made));
                    first = choice;
                }
                if enough {
                    break;
                }
            }
            let Some((left, next, made)) = best else { break };
            (worst, source, image) = (left, next, made);
        }
        Ok(image.into())
    }
}

/// Every span in some directions that misses by more than it may cut in two.
fn halved(surface: &NurbsSurface, directions: &[Direction], by: &Miss, most: f64) -> Result<NurbsSurface> {
    let mut next = surface.clone();
    for direction in directions {
        let spans = surface.span_parameters(*direction);
        let far = spans.windows(2).zip(&by.spans[direction.index()]).filter(|(_, miss)| !(**miss <= most));
        let middles: Vec<f64> = far.map(|(w, _)| 0.5 * (w[0] + w[1])).collect();
        next = next.refined(*direction, &middles)?;
    }
    Ok(next)
}

/// The surface with full knots where a plane cuts it along a parameter line.
fn kinked(surface: NurbsSurface, seam: &Plane) -> Result<NurbsSurface> {
    let mut out = surface;
    for direction in Direction::BOTH {
        let (domain, across) = (out.domain(direction), out.domain(direction.other()));
        let near = SAME * domain.length();
        let mut common: Option<Vec<f64>> = None;
        for x in [0.0, 0.37, 1.0] {
            let Ok(curve) = Surface::from(out.clone()).isocurve(direction, across.at(x)) else { continue };
            let found = curve_plane(&curve, seam, AT_SEAM)?.crossings;
            common = Some(match common {
                None => found,
                Some(before) => {
                    before.into_iter().filter(|t| found.iter().any(|s| (s - t).abs() <= near)).collect()
                }
            });
        }
        let degree = out.degree(direction);
        for t in common.unwrap_or_default() {
            if t <= domain.start + near || t >= domain.end - near {
                continue;
            }
            let have = out.knots(direction).iter().filter(|k| (*k - t).abs() <= near).count();
            let exact = out.knots(direction).iter().copied().find(|k| (k - t).abs() <= near).unwrap_or(t);
            out = out.refined(direction, &vec![exact; degree.saturating_sub(have)])?;
        }
    }
    Ok(out)
}

/// Where a surface closes, and where it is a single point.
struct Sides {
    closed: [bool; 2],
    singular: [[bool; 2]; 2],
}

impl Sides {
    fn of(surface: &Surface) -> Self {
        Self {
            closed: Direction::BOTH.map(|d| surface.is_closed(d)),
            singular: [[Side::West, Side::East], [Side::South, Side::North]]
                .map(|pair| pair.map(|side| surface.is_singular(side))),
        }
    }

    /// Makes what is one on the surface one among the images, which rounding has parted.
    fn settle(&self, points: &mut [Point3], [rows, columns]: [usize; 2]) {
        let at = |i: usize, j: usize| i * columns + j;
        let mut copy = |from: usize, to: usize| {
            if let (Some(&p), true) = (points.get(from), to < points.len())
                && let Some(place) = points.get_mut(to)
            {
                *place = p;
            }
        };
        let (last_row, last_column) = (rows.saturating_sub(1), columns.saturating_sub(1));
        if self.singular[0][0] {
            (1..columns).for_each(|j| copy(at(0, 0), at(0, j)));
        }
        if self.singular[0][1] {
            (1..columns).for_each(|j| copy(at(last_row, 0), at(last_row, j)));
        }
        if self.singular[1][0] {
            (1..rows).for_each(|i| copy(at(0, 0), at(i, 0)));
        }
        if self.singular[1][1] {
            (1..rows).for_each(|i| copy(at(0, last_column), at(i, last_column)));
        }
        if self.closed[0] {
            (0..columns).for_each(|j| copy(at(0, j), at(last_row, j)));
        }
        if self.closed[1] {
            (0..rows).for_each(|i| copy(at(i, 0), at(i, last_column)));
        }
    }
}

/// The surface with the source's knots through the images of its points.
fn through(source: &NurbsSurface, morph: &dyn Morph, sides: &Sides) -> Result<NurbsSurface> {
    let [us, vs] = Direction::BOTH.map(|d| {
        let domain = source.domain(d);
        source.greville_abscissae(d).into_iter().map(|t| domain.clamp(t)).collect::<Vec<_>>()
    });
    let mut points = Vec::with_capacity(us.len() * vs.len());
    for &u in &us {
        for &v in &vs {
            points.push(morph.image(source.point_at(u, v))?);
        }
    }
    sides.settle(&mut points, [us.len(), vs.len()]);
    source.through(&points)
}

/// How far an image is from what the map makes of the source.
struct Miss {
    worst: f64,
    /// The same over each span of u, and of v.
    spans: [Vec<f64>; 2],
}

/// How far the image is off, at places in all patches, of few patches in more.
fn miss(source: &NurbsSurface, image: &NurbsSurface, morph: &dyn Morph) -> Result<Miss> {
    let spans = Direction::BOTH.map(|d| source.span_parameters(d));
    let counts = spans.each_ref().map(|spans| spans.len().saturating_sub(1));
    let parts = match counts[0] * counts[1] {
        few if few <= 100 => 8,
        some if some <= 1000 => 4,
        _ => 2,
    };
    // Each place with its span; the ends of spans count for the one before too.
    let [us, vs] = spans.map(|spans| {
        let part = |w: &[f64], k: usize| w[0] + (w[1] - w[0]) * (k as f64 / parts as f64);
        let within = |(span, w): (usize, &[f64])| (0..parts).map(|k| (part(w, k), span)).collect::<Vec<_>>();
        let mut out: Vec<(f64, usize)> = spans.windows(2).enumerate().flat_map(within).collect();
        out.extend(spans.last().map(|end| (*end, spans.len().saturating_sub(2))));
        out
    });
    let mut found = Miss { worst: 0.0, spans: counts.map(|n| vec![0.0; n]) };
    for (i, &(u, in_u)) in us.iter().enumerate() {
        for (j, &(v, in_v)) in vs.iter().enumerate() {
            let wanted: Point3 = morph.image(source.point_at(u, v))?;
            let apart = wanted.distance_to(image.point_at(u, v));
            let apart = if apart.is_nan() { f64::INFINITY } else { apart };
            found.worst = found.worst.max(apart);
            for (spans, place, span) in [(0, i, in_u), (1, j, in_v)] {
                let before = if place % parts == 0 { span.saturating_sub(1) } else { span };
                for k in [before, span] {
                    if let Some(worst) = found.spans[spans].get_mut(k) {
                        *worst = worst.max(apart);
                    }
                }
            }
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::super::curve::By;
    use super::*;
    use crate::{Interval, Plane, PlaneSurface, Sphere, Vector3};

    #[test]
    fn surfaces_follow_the_map() {
        let map = |p: Point3| Point3::new(p.x, p.y + 0.05 * p.x * p.x, p.z + 0.3 * (0.5 * p.x).sin());
        let ball: Surface = Sphere::around(Point3::new(1.0, 0.0, 0.0), 1.0).unwrap().into();
        let sheet: Surface =
            PlaneSurface::new(Plane::XY, Interval::new(0.0, 6.0), Interval::new(0.0, 3.0)).unwrap().into();
        let tolerance = Tolerance::default();
        for surface in [ball, sheet] {
            let image = surface.morphed(&By(map), &tolerance).unwrap();
            let nurbs = surface.to_nurbs().unwrap();
            let [du, dv] = Direction::BOTH.map(|d| nurbs.domain(d));
            for i in 0..=17 {
                for j in 0..=13 {
                    let (u, v) = (du.at(f64::from(i) / 17.0), dv.at(f64::from(j) / 13.0));
                    let miss = map(nurbs.point_at(u, v)).distance_to(image.point_at(u, v));
                    assert!(miss <= 1.5 * tolerance.absolute, "{miss}");
                }
            }
        }
    }

    #[test]
    fn an_affine_map_keeps_degree_and_count() {
        let sheet: Surface = PlaneSurface::new(Plane::XY, Interval::UNIT, Interval::UNIT).unwrap().into();
        let image = sheet.morphed(&By(|p: Point3| p + Vector3::Z * p.x), &Tolerance::default()).unwrap();
        let Surface::Nurbs(image) = image else { panic!("a NURBS surface") };
        assert_eq!((image.degrees(), image.counts()), ([1, 1], [2, 2]));
    }
}
