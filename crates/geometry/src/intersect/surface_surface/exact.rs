//! Pairs of surfaces that meet in closed form: lines, conics and points, as far as both surfaces reach.

use super::sheet::Sheet;
use super::{BranchKind, SurfaceBranch, SurfaceContact, SurfaceContactKind, SurfaceMeeting, images, overlap};
use crate::chart::thresholds::{
    EXACT, EXACT_OF_NOISE, IMAGE, IMAGE_OF_TOLERANCE, ON_CARRIER, ONE_PLANE, noise,
};
use crate::chart::{Breaks, Chart, smooth_pieces};
use crate::intersect::{Carrier, CarrierCurve, CarrierMeeting, Conic, carrier_carrier, curve_curve};
use crate::{
    BoundingBox, Curve, Direction, NurbsSurface, Point3, Result, Surface, Tolerance, Xform, cancellation,
};

/// What the closed form of two surfaces says; `None` when they have none, or lie on their carriers in a way that has to be
/// followed (with kinks, or folded).
///
/// # Errors
/// The work was stopped, or a number is not finite.
pub(super) fn meeting(surfaces: [&Surface; 2], limit: f64) -> Result<Option<SurfaceMeeting>> {
    let boxes = [bounds(surfaces[0])?, bounds(surfaces[1])?];
    let sizes = boxes.map(|b| b.diagonal().length());
    let center = if sizes[0] < sizes[1] { boxes[0].center() } else { boxes[1].center() };
    let far = boxes.map(|b| b.min.to_vector().length().max(b.max.to_vector().length()));
    let size = sizes[0].min(sizes[1]);
    if !(size > 0.0 && size.is_finite()) {
        return Ok(None);
    }
    // Far from the origin what is equal is known to fewer digits.
    let absolute = (EXACT * size).max(EXACT_OF_NOISE * noise(sizes, far));
    let exact = Tolerance { absolute, angle: absolute / size };
    if ON_CARRIER * absolute > limit || surfaces.iter().any(|s| is_bent_polynomial(s, absolute)) {
        return Ok(None);
    }
    let shift = center.to_vector();
    let home = Xform::translation(-shift);
    let moved = [surfaces[0].transformed(&home)?, surfaces[1].transformed(&home)?];
    let Some(first) = told(&moved[0], &exact)? else { return Ok(None) };
    let Some(second) = told(&moved[1], &exact)? else { return Ok(None) };
    let Some(met) = carrier_carrier(&first, &second, &exact) else { return Ok(None) };
    let Some(mut out) = reached([&moved[0], &moved[1]], met, exact.absolute, limit)? else { return Ok(None) };
    let back = Xform::translation(shift);
    for branch in
        out.branches.iter_mut().chain(out.contacts.iter_mut().flat_map(SurfaceContact::branches_mut))
    {
        branch.curve = branch.curve.transformed(&back)?;
    }
    for contact in &mut out.contacts {
        contact.point += shift;
    }
    Ok(Some(out))
}

/// Lines go on beyond both surfaces by this part of the size.
const BEYOND: f64 = 0.01;

/// As far as both surfaces reach, what their carriers have in common.
fn reached(
    surfaces: [&Surface; 2],
    met: CarrierMeeting,
    exact: f64,
    limit: f64,
) -> Result<Option<SurfaceMeeting>> {
    let boxes = [bounds(surfaces[0])?, bounds(surfaces[1])?];
    let size = boxes[0].diagonal().length().min(boxes[1].diagonal().length());
    let near = ON_CARRIER * exact;
    let mut out = SurfaceMeeting { branches: Vec::new(), contacts: Vec::new(), complete: true };
    if boxes[0].distance_to_box(&boxes[1]) > near {
        return Ok(Some(out));
    }
    let mut sheets = [Sheet::new(surfaces[0])?, Sheet::new(surfaces[1])?];
    let target = (IMAGE_OF_TOLERANCE * limit).min(IMAGE * size).max(near);
    let CarrierMeeting::Parts { curves, points } = met else {
        let Some(found) = overlap::overlaps(&mut sheets, near, target)? else { return Ok(None) };
        out.complete = found.complete;
        out.contacts = found.contacts;
        return Ok(Some(out));
    };
    let Some(both) = boxes[0].inflated(near).intersection(&boxes[1].inflated(near)) else {
        return Ok(Some(out));
    };
    // Beyond what both have in common, so that no end of a piece is one of the curve.
    let both = both.inflated(BEYOND * size);
    for CarrierCurve { conic, tangent } in curves {
        let Some(whole) = conic.over(&both)? else { continue };
        let (parts, complete) = parts(&conic, &whole, &mut sheets, near)?;
        out.complete &= complete;
        for (curve, closed) in parts {
            let curve = if tangent { curve } else { images::oriented(curve, &mut sheets)? };
            let Some(branch) = images::branch(curve, kind(&conic), closed, &mut sheets, target)? else {
                return Ok(None);
            };
            if tangent {
                out.contacts.push(along(branch));
            } else {
                out.branches.push(branch);
            }
        }
    }
    let crossings = crossings(&out.branches, near, &mut out.complete)?;
    let touches = points.into_iter().map(|p| (p, SurfaceContactKind::Point));
    for (p, kind) in touches.chain(crossings.into_iter().map(|p| (p, SurfaceContactKind::Crossing))) {
        if let Some(contact) = contact(p, kind, &mut sheets, near)? {
            out.contacts.push(contact);
        }
    }
    Ok(Some(out))
}

/// A box around a surface, told cheaply.
fn bounds(surface: &Surface) -> Result<BoundingBox> {
    match surface {
        Surface::Nurbs(nurbs) => Ok(nurbs.hull_box()),
        _ => surface.bounding_box(),
    }
}

/// Whether a surface without weights is not flat: polynomials go round no circle.
fn is_bent_polynomial(surface: &Surface, exact: f64) -> bool {
    matches!(surface, Surface::Nurbs(nurbs) if !nurbs.is_rational() && nurbs.plane(exact).is_none())
}

/// The carrier of a surface that covers its part of it once, and smoothly.
fn told(surface: &Surface, exact: &Tolerance) -> Result<Option<Carrier>> {
    let Some(carrier) = Carrier::exactly(surface, exact.absolute) else { return Ok(None) };
    let plain = match surface {
        Surface::Plane(_) | Surface::Revolution(_) => true,
        Surface::Nurbs(nurbs) => is_plain(nurbs, &carrier)?,
        Surface::Sum(_) => is_plain(&surface.to_nurbs()?, &carrier)?,
    };
    Ok(plain.then_some(carrier))
}

/// The surface of two that lies on a carrier, and which; of two the one with a plane, else the second.
///
/// # Errors
/// The work was stopped.
pub(super) fn carrier(charts: &[Chart; 2]) -> Result<Option<(usize, Carrier)>> {
    let mut found = None;
    for (s, chart) in charts.iter().enumerate() {
        let surface = Surface::from(chart.nurbs().clone());
        let absolute = EXACT * chart.size();
        let exact = Tolerance { absolute, angle: EXACT };
        if is_bent_polynomial(&surface, absolute) || matches!(found, Some((_, Carrier::Plane(_)))) {
            continue;
        }
        found = told(&surface, &exact)?.map(|carrier| (s, carrier)).or(found);
    }
    Ok(found)
}

/// At most so many places a direction are looked at for folds.
const FOLDS: usize = 16;

/// Whether a surface has an area and no kinks, and its normal is on one side of its carrier wherever it is looked at.
fn is_plain(nurbs: &NurbsSurface, carrier: &Carrier) -> Result<bool> {
    if smooth_pieces(nurbs, Breaks::Turns, &|_| true)?.len() != 1 {
        return Ok(false);
    }
    let places = Direction::BOTH.map(|d| -> Vec<f64> {
        let spans = nurbs.span_parameters(d);
        let middles: Vec<f64> =
            spans.windows(2).flat_map(|w| [0.25, 0.75].map(|x| w[0] + x * (w[1] - w[0]))).collect();
        let step = middles.len().div_ceil(FOLDS).max(1);
        middles.into_iter().step_by(step).collect()
    });
    let mut side = 0.0;
    for &u in &places[0] {
        for &v in &places[1] {
            let [p, a, b] = nurbs.partials_at(u, v, crate::Quadrant::NorthEast);
            let turn = a.cross(b).dot(carrier.gradient(p.to_point()));
            if turn * side < 0.0 {
                return Ok(false);
            }
            if turn != 0.0 {
                side = turn.signum();
            }
        }
    }
    Ok(side != 0.0)
}

fn kind(conic: &Conic) -> BranchKind {
    match conic {
        Conic::Line(_) => BranchKind::Line,
        Conic::Circle(_) => BranchKind::Circle,
        Conic::Ellipse(_) => BranchKind::Ellipse,
        Conic::Parabola { .. } => BranchKind::Parabola,
        Conic::Hyperbola { .. } => BranchKind::Hyperbola,
    }
}

/// A place where a conic is cut: its parameter on the conic, and whether pieces end there in any case.
#[derive(Debug, Clone, Copy)]
struct Cut {
    t: f64,
    ends: bool,
}

/// The parts of a conic that both surfaces reach, each with whether it is the whole closed one. They end on sides, and in poles,
/// at which the images leap.
fn parts(
    conic: &Conic,
    whole: &Curve,
    sheets: &mut [Sheet<'_>; 2],
    near: f64,
) -> Result<(Vec<(Curve, bool)>, bool)> {
    let mut complete = true;
    let mut cuts: Vec<Cut> = Vec::new();
    let mut add = |t: f64, ends: bool| cuts.push(Cut { t: conic.parameter(whole.point_at(t)), ends });
    let bounds = whole.bounding_box();
    for sheet in sheets.iter() {
        for border in &sheet.borders {
            if border.bounds.distance_to_box(&bounds) > near {
                continue;
            }
            let met = curve_curve(whole, &border.curve, near)?;
            complete &= met.complete;
            met.crossings.iter().for_each(|c| add(c.a, false));
            met.overlaps.iter().for_each(|o| {
                add(o.a.start, false);
                add(o.a.end, false);
            });
        }
        for pole in &sheet.poles {
            if let Some(at) = whole.closest_point_within(*pole, near)? {
                add(at.parameter, true);
            }
        }
    }
    if !conic.is_closed() {
        let domain = whole.domain();
        add(domain.start, true);
        add(domain.end, true);
    }
    let mut cuts = distinct(conic, cuts, near);
    let Some(first) = cuts.first().copied() else {
        let inside = holds(whole.point_at(whole.domain().at(images::MIDDLE)), sheets, near)?;
        return Ok((if inside { vec![(whole.clone(), true)] } else { Vec::new() }, complete));
    };
    if conic.is_closed() {
        cuts.push(Cut { t: first.t + std::f64::consts::TAU, ..first });
    }
    // Runs of pieces inside, between cuts that are no ends.
    let mut runs: Vec<[Cut; 2]> = Vec::new();
    for w in cuts.windows(2) {
        cancellation::check()?;
        let middle = conic.at(w[0].t + images::MIDDLE * (w[1].t - w[0].t));
        if !holds(middle, sheets, near)? {
            continue;
        }
        match runs.last_mut() {
            Some(run) if run[1].t == w[0].t && !w[0].ends => run[1] = w[1],
            _ => runs.push([w[0], w[1]]),
        }
    }
    if conic.is_closed() && !first.ends {
        let last = cuts.last().map_or(first.t, |c| c.t);
        if let [only] = runs[..]
            && only[0].t == first.t
            && only[1].t == last
        {
            return Ok((vec![(whole.clone(), true)], complete));
        }
        if runs.len() > 1 && runs[0][0].t == first.t && runs.last().is_some_and(|r| r[1].t == last) {
            let head = runs.remove(0);
            if let Some(tail) = runs.last_mut() {
                tail[1] = Cut { t: head[1].t + std::f64::consts::TAU, ..head[1] };
            }
        }
    }
    let mut out = Vec::with_capacity(runs.len());
    for [from, to] in runs {
        let around = conic.is_closed() && to.t - from.t >= std::f64::consts::TAU;
        out.push((conic.between(from.t, to.t)?, around));
    }
    Ok((out, complete))
}

/// The cuts in order, those that are in one place as one.
fn distinct(conic: &Conic, mut cuts: Vec<Cut>, near: f64) -> Vec<Cut> {
    cuts.sort_by(|a, b| a.t.total_cmp(&b.t));
    let mut out: Vec<Cut> = Vec::with_capacity(cuts.len());
    let same = |a: f64, b: f64| conic.at(a).distance_to(conic.at(b)) <= near;
    for cut in cuts {
        match out.last_mut() {
            Some(last) if same(last.t, cut.t) => last.ends |= cut.ends,
            _ => out.push(cut),
        }
    }
    if conic.is_closed()
        && out.len() > 1
        && let (Some(first), Some(last)) = (out.first().copied(), out.last().copied())
        && same(first.t, last.t)
    {
        out.pop();
        out[0].ends |= last.ends;
    }
    out
}

/// Whether a point lies on both surfaces.
fn holds(p: Point3, sheets: &mut [Sheet<'_>; 2], near: f64) -> Result<bool> {
    for sheet in sheets {
        if sheet.nearest(p, None)?.1 > near {
            return Ok(false);
        }
    }
    Ok(true)
}

/// The contact along a curve.
pub(super) fn along(branch: SurfaceBranch) -> SurfaceContact {
    let share = |c: &crate::NurbsCurve| c.point_at(c.domain().at(images::MIDDLE));
    let at = [0, 1].map(|s| share(&branch.parameters[s])).map(|p| [p.x, p.y]);
    SurfaceContact {
        kind: SurfaceContactKind::Curve,
        point: branch.curve.point_at(branch.curve.domain().at(images::MIDDLE)),
        at,
        gap: 0.0,
        ranges: ranges([&branch]),
        curve: Some(branch),
        border: Vec::new(),
    }
}

/// The ranges of the four parameters over branches.
pub(super) fn ranges<'a>(branches: impl IntoIterator<Item = &'a SurfaceBranch>) -> [[f64; 2]; 4] {
    let mut out = [[f64::INFINITY, f64::NEG_INFINITY]; 4];
    for branch in branches {
        for (s, image) in branch.parameters.iter().enumerate() {
            for p in image.control_points() {
                for (k, x) in [p.x, p.y].into_iter().enumerate() {
                    let range = &mut out[2 * s + k];
                    *range = [range[0].min(x), range[1].max(x)];
                }
            }
        }
    }
    out
}

/// Where branches cross each other, without the ends of both.
fn crossings(branches: &[SurfaceBranch], near: f64, complete: &mut bool) -> Result<Vec<Point3>> {
    let mut out: Vec<Point3> = Vec::new();
    for (i, a) in branches.iter().enumerate() {
        for b in &branches[i + 1..] {
            let met = curve_curve(&a.curve, &b.curve, near)?;
            *complete &= met.complete;
            for c in met.crossings {
                if !out.iter().any(|p| p.distance_to(c.point) <= near) {
                    out.push(c.point);
                }
            }
        }
    }
    Ok(out)
}

/// The contact at a point, if both surfaces reach it and do not meet there in a pole of one of them by crossing it only.
fn contact(
    p: Point3,
    kind: SurfaceContactKind,
    sheets: &mut [Sheet<'_>; 2],
    near: f64,
) -> Result<Option<SurfaceContact>> {
    let mut at = [[0.0; 2]; 2];
    let mut normals = [None; 2];
    for s in 0..2 {
        let (uv, off) = sheets[s].nearest(p, None)?;
        if off > near {
            return Ok(None);
        }
        (at[s], normals[s]) = (uv, sheets[s].normal(uv));
    }
    if kind == SurfaceContactKind::Crossing {
        let [Some(m), Some(n)] = normals else { return Ok(None) };
        if m.cross(n).length() > ONE_PLANE {
            return Ok(None);
        }
    }
    let [a, b] = [0, 1].map(|s| sheets[s].point(at[s]));
    let [[u, v], [s, t]] = at;
    Ok(Some(SurfaceContact {
        kind,
        point: a.lerp(b, 0.5),
        at,
        gap: a.distance_to(b),
        ranges: [[u, u], [v, v], [s, s], [t, t]],
        curve: None,
        border: Vec::new(),
    }))
}
