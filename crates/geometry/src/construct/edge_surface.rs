//! Surfaces that fill a frame of two, three or four curves.

use super::check;
use crate::{
    Brep, Curve, Direction, Error, Interval, NurbsCurve, NurbsSurface, Point3, Result, Tolerance,
    compatible_curves,
};

/// Gaps between curves up to this part of the frame's size are closed.
const LARGEST_GAP: f64 = 1e-3;

/// The surface whose sides are two, three or four curves, given in any order and direction: of four and three the
/// bilinearly blended surface (S. Coons, 1967; P&T, *The NURBS Book*, §10.6), with the point where the first and the
/// last of three meet as its fourth side; of two the ruled surface. Rational sides stay exact.
///
/// # Errors
/// Another number of curves, curves that do not meet end to end (gaps above the tolerance and a thousandth of the
/// frame's size), or a surface without area.
pub fn edge_surface(curves: &[Curve], tolerance: &Tolerance) -> Result<Brep> {
    let limit = check(&curves.iter().collect::<Vec<_>>(), tolerance)?;
    let surface = match curves {
        [a, b] => {
            let straight = a.start().distance_to(b.start()) + a.end().distance_to(b.end());
            let crossed = a.start().distance_to(b.end()) + a.end().distance_to(b.start());
            let b = if crossed < straight { b.reversed() } else { b.clone() };
            NurbsSurface::ruled(&a.to_nurbs()?, &b.to_nurbs()?)?
        }
        [_, _, _] | [_, _, _, _] => {
            let frame = chained(curves, limit)?;
            let point = |p: Point3| NurbsCurve::new(1, vec![p, p], vec![0.0, 1.0]);
            match frame.as_slice() {
                [a, b, c] => coons(a, &c.reversed(), &point(a.start())?.into(), b)?,
                [a, b, c, d] => coons(a, &c.reversed(), &d.reversed(), b)?,
                _ => return Err(Error::degenerate("edge surface", "its sides do not form a frame")),
            }
        }
        _ => {
            return Err(Error::Invalid {
                what: "edge surface",
                why: format!("it needs 2, 3 or 4 curves, got {}", curves.len()),
            });
        }
    };
    Brep::from_kinked_surface(&surface.into(), tolerance)
}

/// The bilinear surface through four corners, walked round; without the fourth a triangle with a singular side.
/// u runs from the first to the second, v from the first to the fourth; domains are 0…the longer of opposite sides.
///
/// # Errors
/// A corner is not finite, or the surface has no area.
pub fn four_point_surface(a: Point3, b: Point3, c: Point3, d: Option<Point3>) -> Result<Brep> {
    let surface = match d {
        Some(d) => NurbsSurface::from_corners(a, b, c, d)?,
        None => NurbsSurface::from_triangle(a, b, c)?,
    };
    Brep::from_surface(surface.into())
}

/// The curves end to end, each turned to run on from the one before, ends moved to meet exactly.
fn chained(curves: &[Curve], limit: f64) -> Result<Vec<Curve>> {
    let size = curves
        .iter()
        .map(Curve::bounding_box)
        .reduce(|a, b| a.union(&b))
        .map_or(0.0, |b| b.diagonal().length());
    let gap = limit.max(LARGEST_GAP * size);
    let apart = || Error::degenerate("edge surface", "its curves do not meet end to end");
    let mut left: Vec<Curve> = curves.to_vec();
    let first = left.remove(0);
    // The first keeps its direction unless nothing goes on at its end.
    let mut chain = vec![first];
    while !left.is_empty() {
        let end = chain.last().map(Curve::end).ok_or_else(apart)?;
        let near = |c: &Curve| c.start().distance_to(end).min(c.end().distance_to(end));
        let best =
            (0..left.len()).min_by(|a, b| near(&left[*a]).total_cmp(&near(&left[*b]))).ok_or_else(apart)?;
        if !(near(&left[best]) <= gap) {
            return Err(apart());
        }
        let next = left.remove(best);
        let turned = next.end().distance_to(end) < next.start().distance_to(end);
        chain.push(if turned { next.reversed() } else { next });
    }
    let count = chain.len();
    let mut corners = Vec::with_capacity(count);
    for i in 0..count {
        let (a, b) = (chain[i].end(), chain[(i + 1) % count].start());
        if !(a.distance_to(b) <= gap) {
            return Err(apart());
        }
        corners.push(if a == b { a } else { a.lerp(b, 0.5) });
    }
    for i in 0..count {
        let ends = [corners[(i + count - 1) % count], corners[i]];
        if [chain[i].start(), chain[i].end()] != ends {
            chain[i] = crate::brep::with_ends(&chain[i], ends)?;
        }
    }
    Ok(chain)
}

/// The blend of south and north, which run along u, with west and east, which run along v.
fn coons(south: &Curve, north: &Curve, west: &Curve, east: &Curve) -> Result<NurbsSurface> {
    let rational = [south, north, west, east].iter().map(|c| c.to_nurbs()).collect::<Result<Vec<_>>>()?;
    let any = rational.iter().any(NurbsCurve::is_rational);
    let ready = |c: &NurbsCurve| if any { c.with_end_weights(1.0, 1.0) } else { Ok(c.clone()) };
    let sides = rational.iter().map(ready).collect::<Result<Vec<_>>>()?;
    let [south, north, west, east] = sides.as_slice() else {
        return Err(Error::degenerate("edge surface", "a side is missing"));
    };
    let length = |a: &NurbsCurve, b: &NurbsCurve| {
        let of = |c: &NurbsCurve| Curve::from(c.clone()).length();
        let longer = of(a).max(of(b));
        Interval::new(0.0, if longer > 0.0 { longer } else { 1.0 })
    };
    let [u, v] = [length(south, north), length(west, east)];
    let along = |a: &NurbsCurve, b: &NurbsCurve, domain: Interval| {
        compatible_curves(&[a.with_domain(domain)?, b.with_domain(domain)?])
    };
    let (across_v, across_u) = (along(south, north, u)?, along(west, east, v)?);
    let ([s, n], [w, e]) = (across_v.as_slice(), across_u.as_slice()) else {
        return Err(Error::degenerate("edge surface", "a side is missing"));
    };
    let first = NurbsSurface::ruled(s, n)?.with_domain(Direction::V, v)?;
    let second = NurbsSurface::ruled(w, e)?.transposed().with_domain(Direction::U, u)?;
    let corner = |c: &NurbsCurve, t: f64| c.point_at(t);
    let corners = vec![corner(s, u.start), corner(n, u.start), corner(s, u.end), corner(n, u.end)];
    let flat = NurbsSurface::new([1, 1], [2, 2], corners, [vec![u.start, u.end], vec![v.start, v.end]])?;
    summed(&[first, second, flat], &[1.0, 1.0, -1.0])
}

/// The sum of surfaces over the same domains with factors whose sum is 1, in homogeneous coordinates.
pub(super) fn summed(surfaces: &[NurbsSurface], factors: &[f64]) -> Result<NurbsSurface> {
    let mut same = surfaces.to_vec();
    for direction in Direction::BOTH {
        let degree = same.iter().map(|s| s.degree(direction)).max().unwrap_or(1);
        for surface in &mut same {
            *surface = surface.clamped(direction)?.raised_to(direction, degree)?;
        }
        let all: Vec<Vec<f64>> = same.iter().map(|s| s.knots(direction).to_vec()).collect();
        for (k, surface) in same.iter_mut().enumerate() {
            let missing = missing_knots(&all, k);
            if !missing.is_empty() {
                *surface = surface.refined(direction, &missing)?;
            }
        }
    }
    let Some(first) = same.first() else {
        return Err(Error::degenerate("sum of surfaces", "there are none"));
    };
    let any = same.iter().any(NurbsSurface::is_rational);
    let mut net = vec![[0.0; 4]; first.point_count()];
    for (surface, factor) in same.iter().zip(factors) {
        if surface.counts() != first.counts() {
            return Err(Error::degenerate("sum of surfaces", "their knots do not fit each other"));
        }
        for (sum, p) in net.iter_mut().zip(surface.homogeneous_points()) {
            *sum = std::array::from_fn(|k| sum[k] + factor * p[k]);
        }
    }
    let knots = Direction::BOTH.map(|d| first.knots(d).to_vec());
    if any {
        return NurbsSurface::rational(first.degrees(), first.counts(), net, knots);
    }
    let plain = net.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect();
    NurbsSurface::new(first.degrees(), first.counts(), plain, knots)
}

/// The knots that other lists, all sorted, have more often than the k-th.
fn missing_knots(all: &[Vec<f64>], k: usize) -> Vec<f64> {
    let times = |list: &[f64], t: f64| list.partition_point(|x| *x <= t) - list.partition_point(|x| *x < t);
    let mut values: Vec<f64> = all.iter().flatten().copied().collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    let mut out = Vec::new();
    for t in values {
        let most = all.iter().map(|list| times(list, t)).max().unwrap_or(0);
        out.extend(std::iter::repeat_n(t, most - times(&all[k], t)));
    }
    out
}
