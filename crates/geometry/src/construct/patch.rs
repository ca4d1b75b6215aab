//! Surfaces near curves and points.

use katydid_elementary::Elementary;

use crate::linear::Banded;
use crate::nurbs::clamped_uniform_knots;
use crate::region::{FillRule, Region};
use crate::{Brep, Curve, Error, Interval, NurbsSurface, Plane, Point3, Result, Tolerance};

/// The most spans in a direction.
const MOST_SPANS: usize = 100;
/// Places at which a curve is taken, for each span of the patch.
const PLACES: usize = 8;
/// How much bending counts beside distances when the flexibility is 1, for a patch of size 1.
const STIFFNESS: f64 = 1e-8;
/// The degree of the patch in both directions.
const DEGREE: usize = 3;
/// How much larger than what is given a surface is that will be trimmed.
const MARGIN: f64 = 0.02;
/// Gauss's rule with four places in −1…1, exact for polynomials of degree 7: places and weights.
const GAUSS: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_8),
    (-0.339_981_043_584_856_3, 0.652_145_154_862_546_1),
    (0.339_981_043_584_856_3, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_8),
];

/// What a patch heeds beside its curves and points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatchOptions {
    /// The spans in both directions.
    pub spans: [usize; 2],
    /// How willingly the surface bends: 0.1 a tenth as willingly as 1.
    pub flexibility: f64,
    /// Whether the surface is trimmed along the outermost closed curve.
    pub trimmed: bool,
}

impl Default for PatchOptions {
    fn default() -> Self {
        Self { spans: [10, 10], flexibility: 1.0, trimmed: true }
    }
}

/// The bicubic surface that lies nearest to curves and points and bends least: the heights above the plane that fits
/// all of them best are those of least mean square distance plus the energy of a thin plate (G. Greiner, *Variational
/// design and fairing of spline surfaces*, 1994). The surface is a rectangle seen along the normal of that plane, just
/// as large as what is given; trimmed, it ends where the outermost closed curve is seen.
///
/// It does not go through the curves and points exactly, and cannot fold over: of what lies above each other it takes
/// the middle.
///
/// # Errors
/// Nothing given, places that all lie on one line, spans that are not from 1 to 100, or a flexibility that is not
/// above 0.
pub fn patch(
    curves: &[Curve],
    points: &[Point3],
    options: &PatchOptions,
    tolerance: &Tolerance,
) -> Result<Brep> {
    super::check(&curves.iter().collect::<Vec<_>>(), tolerance)?;
    if !points.iter().all(|p| p.is_finite()) {
        return Err(Error::NotFinite("point of the patch"));
    }
    if options.spans.iter().any(|n| !(1..=MOST_SPANS).contains(n)) {
        return Err(Error::OutOfRange {
            what: "spans of the patch",
            value: options.spans.iter().copied().max().unwrap_or(0) as f64,
            must: "from 1 to 100",
        });
    }
    if !(options.flexibility > 0.0 && options.flexibility.is_finite()) {
        return Err(Error::OutOfRange {
            what: "flexibility",
            value: options.flexibility,
            must: "finite and greater than 0",
        });
    }
    let samples = samples(curves, points, options);
    let places: Vec<Point3> = samples.iter().map(|s| s.0).collect();
    let (plane, _) = Plane::fit(&places)?;
    let local: Vec<([f64; 3], f64)> = samples.iter().map(|(p, w)| (plane.coordinates(*p), *w)).collect();
    let outline = if options.trimmed { outline(curves, &plane, tolerance)? } else { None };
    let mut domains = extents(curves, points, &plane);
    if domains.iter().any(|d| !(d.length() > tolerance.absolute)) {
        return Err(Error::degenerate("patch", "all that is given lies on one line"));
    }
    if outline.is_some() {
        domains = domains.map(|d| Interval::new(d.at(-MARGIN), d.at(1.0 + MARGIN)));
    }
    let surface = heights(&local, domains, options)?.over(&plane)?;
    if let Some(outline) = outline {
        let made = Brep::from_parameter_loops(&surface.clone().into(), &[outline], tolerance)?;
        if let Some(largest) = made.into_iter().next() {
            return Ok(largest);
        }
    }
    Brep::from_surface(surface.into())
}

/// How far curves and points reach along the axes of a plane.
fn extents(curves: &[Curve], points: &[Point3], plane: &Plane) -> [Interval; 2] {
    let around = curves.iter().map(|curve| curve.bounding_box_in(plane)).map(|b| [b.x, b.y]);
    let single = points.iter().map(|p| {
        let [x, y, _] = plane.coordinates(*p);
        [Interval::new(x, x), Interval::new(y, y)]
    });
    let hull = |a: Interval, b: Interval| Interval::new(a.start.min(b.start), a.end.max(b.end));
    let nothing = Interval::new(0.0, 0.0);
    around.chain(single).reduce(|a, b| [hull(a[0], b[0]), hull(a[1], b[1])]).unwrap_or([nothing; 2])
}

/// Places with their weights: those of curves count by length, as much as the points together when there are both.
fn samples(curves: &[Curve], points: &[Point3], options: &PatchOptions) -> Vec<(Point3, f64)> {
    let lengths: Vec<f64> = curves.iter().map(Curve::length).collect();
    let whole: f64 = lengths.iter().sum();
    let spans = options.spans[0].max(options.spans[1]);
    let mut out = Vec::new();
    for (curve, length) in curves.iter().zip(&lengths).filter(|(_, length)| **length > 0.0) {
        let count = ((spans * PLACES * 4) as f64 * length / whole).ceil().max(8.0) as usize;
        let Ok(mut places) = curve.divide_by_count(count) else { continue };
        if !curve.is_closed() {
            places.truncate(count);
            places.push(curve.domain().end);
        }
        let weight = length / whole / places.len() as f64;
        out.extend(places.iter().map(|t| (curve.point_at(*t), weight)));
    }
    let each = 1.0 / points.len().max(1) as f64;
    out.extend(points.iter().map(|p| (*p, each)));
    out
}

/// Control heights over a rectangle of a plane.
struct Heights {
    counts: [usize; 2],
    knots: [Vec<f64>; 2],
    values: Vec<f64>,
}

impl Heights {
    /// The surface over the plane: its parameters are the plane's coordinates.
    fn over(&self, plane: &Plane) -> Result<NurbsSurface> {
        let greville = [0, 1].map(|k: usize| {
            let mean = |w: &[f64]| w.iter().sum::<f64>() / DEGREE as f64;
            self.knots[k].windows(DEGREE).map(mean).collect::<Vec<f64>>()
        });
        let mut points = Vec::with_capacity(self.values.len());
        for (i, x) in greville[0].iter().enumerate() {
            for (j, y) in greville[1].iter().enumerate() {
                let height = self.values.get(i * self.counts[1] + j).copied().unwrap_or_default();
                points.push(plane.at(*x, *y, height));
            }
        }
        NurbsSurface::new([DEGREE; 2], self.counts, points, self.knots.clone())
    }
}

fn heights(local: &[([f64; 3], f64)], domains: [Interval; 2], options: &PatchOptions) -> Result<Heights> {
    let counts = options.spans.map(|n| n + DEGREE);
    let knots = [knots(domains[0], counts[0])?, knots(domains[1], counts[1])?];
    let size = domains[0].length().hypotenuse(domains[1].length());
    // Heights in units of the size.
    let (rows, columns) = (counts[0], counts[1]);
    let mut system = Banded::new(rows * columns, DEGREE * columns + DEGREE, vec![[0.0; 3]; rows * columns])?;
    let mut right = vec![0.0; rows * columns];
    let total: f64 = local.iter().map(|(_, w)| w).sum();
    for ([x, y, z], weight) in local {
        let (i0, a) = acting(&knots[0], domains[0].clamp(*x));
        let (j0, b) = acting(&knots[1], domains[1].clamp(*y));
        for (i, p) in a.iter().enumerate() {
            for (j, q) in b.iter().enumerate() {
                let row = (i0 + i) * columns + j0 + j;
                right[row] += weight / total * p * q * z / size;
                for (k, r) in a.iter().enumerate() {
                    for (l, s) in b.iter().enumerate() {
                        system.add(row, (i0 + k) * columns + j0 + l, weight / total * p * q * r * s);
                    }
                }
            }
        }
    }
    let stiffness = STIFFNESS / options.flexibility;
    let [gx, gy] = [0, 1].map(|k: usize| gram(&knots[k], size));
    for i in 0..rows {
        for k in i.saturating_sub(DEGREE)..(i + DEGREE + 1).min(rows) {
            for j in 0..columns {
                for l in j.saturating_sub(DEGREE)..(j + DEGREE + 1).min(columns) {
                    let [x, y] = [gx[i][k + DEGREE - i], gy[j][l + DEGREE - j]];
                    let energy = x[2] * y[0] + 2.0 * x[1] * y[1] + x[0] * y[2];
                    system.add(i * columns + j, k * columns + l, stiffness * energy);
                }
            }
        }
    }
    for (row, value) in right.into_iter().enumerate() {
        system.set_right(row, [value, 0.0, 0.0]);
    }
    let solved = system.solve_totally_positive();
    let solved = solved.ok_or(Error::degenerate("patch", "what is given does not determine it"))?;
    Ok(Heights { counts, knots, values: solved.iter().map(|v| v[0] * size).collect() })
}

fn knots(domain: Interval, count: usize) -> Result<Vec<f64>> {
    let unit = clamped_uniform_knots(DEGREE, count)?;
    let last = unit.last().copied().unwrap_or(1.0);
    Ok(unit.into_iter().map(|t| domain.at(t / last)).collect())
}

/// The basis functions that act at a parameter, and the first one's number.
fn acting(knots: &[f64], t: f64) -> (usize, [f64; DEGREE + 1]) {
    let last = knots.last().is_some_and(|end| t >= *end);
    let span = crate::span_index(knots, DEGREE, t, last);
    let mut values = [0.0; crate::MAX_DEGREE + 1];
    crate::nurbs::basis(DEGREE, knots, span, t, &mut values);
    (span, std::array::from_fn(|k| values[k]))
}

/// Integrals of products of the basis functions, of their first and of their second derivatives: of function i with
/// function i − 3 … i + 3. Lengths are in parts of `size`.
fn gram(knots: &[f64], size: f64) -> Vec<[[f64; 3]; 2 * DEGREE + 1]> {
    let count = knots.len() + 1 - DEGREE;
    // As books number them: with one more knot at either end.
    let full: Vec<f64> = knots.first().into_iter().chain(knots).chain(knots.last()).copied().collect();
    let mut out = vec![[[0.0; 3]; 2 * DEGREE + 1]; count];
    for first in 0..count - DEGREE {
        let [a, b] = [full[first + DEGREE], full[first + DEGREE + 1]];
        for (x, weight) in GAUSS {
            let t = a + (b - a) * 0.5 * (x + 1.0);
            let jets: [[f64; DEGREE + 1]; 3] = std::array::from_fn(|order| {
                std::array::from_fn(|i| function(&full, first + i, DEGREE, order, t))
            });
            for i in 0..=DEGREE {
                for k in 0..=DEGREE {
                    for (order, jet) in jets.iter().enumerate() {
                        // Every derivative is as much larger as lengths are smaller.
                        let unit = size.powi(2 * order as i32 - 1);
                        out[first + i][k + DEGREE - i][order] +=
                            weight * 0.5 * (b - a) * jet[i] * jet[k] * unit;
                    }
                }
            }
        }
    }
    out
}

/// A derivative of basis function `i` of a degree (P&T, *The NURBS Book*, eqs. 2.5 and 2.9).
fn function(knots: &[f64], i: usize, degree: usize, order: usize, t: f64) -> f64 {
    if degree == 0 {
        return if order == 0 && knots[i] <= t && t < knots[i + 1] { 1.0 } else { 0.0 };
    }
    let share = |i: usize, order: usize| {
        let width = knots[i + degree] - knots[i];
        if width > 0.0 { function(knots, i, degree - 1, order, t) / width } else { 0.0 }
    };
    if order > 0 {
        return degree as f64 * (share(i, order - 1) - share(i + 1, order - 1));
    }
    (t - knots[i]) * share(i, 0) + (knots[i + degree + 1] - t) * share(i + 1, 0)
}

/// The largest closed outline of the curves in the coordinates of a plane, counter-clockwise.
fn outline(curves: &[Curve], plane: &Plane, tolerance: &Tolerance) -> Result<Option<Curve>> {
    let mut flat = Vec::new();
    for curve in crate::join_curves(curves, tolerance.absolute, false) {
        if curve.is_closed() || curve.start().distance_to(curve.end()) <= tolerance.absolute {
            flat.push(crate::brep::flatten::flattened(&curve, plane)?);
        }
    }
    if flat.is_empty() {
        return Ok(None);
    }
    let region = Region::new(&flat, FillRule::Any, &Plane::XY, tolerance.absolute)?;
    let size = |curve: &Curve| curve.area_and_centroid(tolerance.absolute).map_or(0.0, |(area, _)| area);
    let outlines = region.faces().iter().map(|face| face.outline().clone());
    Ok(outlines.max_by(|a, b| size(a).total_cmp(&size(b))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Circle, Line, PolylineCurve, Surface};

    fn tolerance() -> Tolerance {
        Tolerance { absolute: 1e-3, ..Tolerance::default() }
    }

    fn surface(brep: &Brep) -> Surface {
        assert_eq!(brep.faults(), []);
        brep.face_surface(0).unwrap().clone()
    }

    #[test]
    fn flat_input_gives_a_flat_disc() {
        let plane =
            Plane::from_normal(Point3::new(1.0, 2.0, 3.0), crate::Vector3::new(1.0, 1.0, 2.0)).unwrap();
        let ring: Curve = Circle { plane, radius: 3.0 }.into();
        let disc = patch(&[ring], &[], &PatchOptions::default(), &tolerance()).unwrap();
        assert!(surface(&disc).is_planar(1e-9));
        let area = disc.mesh(&crate::MeshSettings::within(1e-4)).unwrap().to_mesh().unwrap().area();
        assert!((area - 9.0 * std::f64::consts::PI).abs() < 1e-2, "{area}");
    }

    #[test]
    fn a_saddle_is_met() {
        let at = |x: f64, y: f64| Point3::new(x, y, 0.1 * x * y);
        let points: Vec<Point3> =
            (0..121).map(|k| at(f64::from(k / 11) - 5.0, f64::from(k % 11) - 5.0)).collect();
        let made = patch(&[], &points, &PatchOptions::default(), &tolerance()).unwrap();
        let made = surface(&made);
        for p in &points {
            assert!(made.closest_point(*p).unwrap().distance < 5e-3);
        }
        let stiff = PatchOptions { flexibility: 1e-9, ..PatchOptions::default() };
        let stiff = surface(&patch(&[], &points, &stiff, &tolerance()).unwrap());
        assert!(stiff.is_planar(0.2), "a stiff patch is nearly flat");
    }

    #[test]
    fn frames_and_points() {
        let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 1.0], [4.0, 4.0, 0.0], [0.0, 4.0, 1.0], [0.0, 0.0, 0.0]];
        let frame: Curve = PolylineCurve::new(corners.map(Point3::from).to_vec()).unwrap().into();
        let peak = Point3::new(2.0, 2.0, 2.0);
        let options = PatchOptions { spans: [20, 20], ..PatchOptions::default() };
        let tent = patch(std::slice::from_ref(&frame), &[peak], &options, &tolerance()).unwrap();
        let made = surface(&tent);
        assert!(made.closest_point(peak).unwrap().distance < 0.05);
        for k in 0..40 {
            let p = frame.point_at(frame.domain().at(f64::from(k) / 40.0));
            assert!(made.closest_point(p).unwrap().distance < 0.05);
        }
        assert!(tent.as_surface().is_none(), "trimmed");
    }

    #[test]
    fn what_gives_no_patch() {
        let line: Curve = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)).into();
        assert!(patch(&[line], &[], &PatchOptions::default(), &tolerance()).is_err());
        assert!(patch(&[], &[], &PatchOptions::default(), &tolerance()).is_err());
        let spans = PatchOptions { spans: [0, 5], ..PatchOptions::default() };
        let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
        assert!(patch(&[], &square, &spans, &tolerance()).is_err());
        assert!(
            patch(&[], &[Point3::new(f64::NAN, 0.0, 0.0)], &PatchOptions::default(), &tolerance()).is_err()
        );
    }
}
