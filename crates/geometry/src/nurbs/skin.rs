//! Surfaces through compatible curves.

use super::curve::Controls;
use super::evaluate::basis;
use super::knots::MAX_DEGREE;
use super::surface_interpolate::Lines;
use super::surface_refine::transposed;
use super::uniform::{clamped_uniform_knots, periodic_uniform_knots};
use super::{KnotSpacing, NurbsCurve, NurbsSurface};
use crate::linear::Banded;
use crate::nurbs::thresholds::SKIN_STEP;
use crate::{Error, Point3, Result, cancellation};

/// How a surface runs across the curves that it is made from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Skinning {
    /// A cubic through them.
    Through,
    /// Straight from each to the next.
    Straight,
    /// The curves' control points are the surface's.
    Near,
}

/// The parameters of sections: means of the distances of their control points, each line of them by its own length.
/// When closed there is one more, of the first section again.
pub(crate) fn section_parameters(
    curves: &[NurbsCurve],
    closed: bool,
    spacing: KnotSpacing,
) -> Result<Vec<f64>> {
    let steps = if closed { curves.len() } else { curves.len().saturating_sub(1) };
    let mut out = vec![0.0];
    let mut t = 0.0;
    for i in 0..steps {
        let (Some(a), Some(b)) = (curves.get(i), curves.get((i + 1) % curves.len())) else { continue };
        let distances = a.control_points().into_iter().zip(b.control_points()).map(|(p, q)| p.distance_to(q));
        let mean = distances.sum::<f64>() / a.point_count().max(1) as f64;
        let step = match spacing {
            KnotSpacing::Uniform => 1.0,
            KnotSpacing::Chord => mean,
            KnotSpacing::SquareRootChord => mean.sqrt(),
        };
        if !(mean > 0.0 && t + step > t) {
            return Err(Error::degenerate("sections", "two neighbours coincide"));
        }
        t += step;
        out.push(t);
    }
    let least = SKIN_STEP * t;
    if out.windows(2).any(|w| !(w[1] - w[0] > least)) {
        return Err(Error::degenerate("sections", "two neighbours all but coincide"));
    }
    Ok(out)
}

/// The surface of compatible curves: u runs along them, v across, at `parameters`.
pub(crate) fn skinned(
    curves: &[NurbsCurve],
    style: Skinning,
    parameters: &[f64],
    closed: bool,
) -> Result<NurbsSurface> {
    let first = curves.first().ok_or(Error::degenerate("sections", "there are none"))?;
    let (count, rows) = (first.point_count(), curves.len());
    cancellation::room::<[f64; 4]>(4 * count * rows)?;
    // Column by column: the control points of the same number in all sections.
    let net: Vec<[f64; 4]> = curves.iter().flat_map(NurbsCurve::homogeneous_points).collect();
    let columns = transposed(&net, count);
    let rational = curves.iter().any(NurbsCurve::is_rational);
    let (degree, knots, columns) = match style {
        Skinning::Near => near(&columns, rows, closed)?,
        Skinning::Straight => straight(&columns, rows, parameters, closed),
        Skinning::Through if rows == 2 => straight(&columns, rows, parameters, false),
        Skinning::Through if closed => around(&columns, rows, parameters)?,
        Skinning::Through => through(&columns, rows, parameters, false)?,
    };
    let across = columns.len() / count;
    let knots = [first.knots().to_vec(), knots];
    let (degrees, counts) = ([first.degree(), degree], [count, across]);
    if !rational {
        let plain = columns.iter().map(|p| [p[0], p[1], p[2]]).collect();
        return NurbsSurface::from_controls(degrees, counts, Controls::Plain(plain), knots);
    }
    if !columns.iter().all(|p| p[3] > 0.0) {
        return Err(Error::degenerate(
            "sections",
            "their weights are too different for a surface between them",
        ));
    }
    NurbsSurface::from_controls(degrees, counts, Controls::Rational(columns), knots)
}

type Across = (usize, Vec<f64>, Vec<[f64; 4]>);

fn near(columns: &[[f64; 4]], rows: usize, closed: bool) -> Result<Across> {
    let degree = if closed { 3 } else { 3.min(rows - 1) };
    if !closed {
        return Ok((degree, clamped_uniform_knots(degree, rows)?, columns.to_vec()));
    }
    let knots = periodic_uniform_knots(degree, rows + degree)?;
    let repeated =
        |column: &[[f64; 4]]| column.iter().cycle().take(rows + degree).copied().collect::<Vec<_>>();
    Ok((degree, knots, columns.chunks(rows).flat_map(repeated).collect()))
}

fn straight(columns: &[[f64; 4]], rows: usize, parameters: &[f64], closed: bool) -> Across {
    let count = rows + usize::from(closed);
    let repeated = |column: &[[f64; 4]]| column.iter().cycle().take(count).copied().collect::<Vec<_>>();
    (1, parameters.to_vec(), columns.chunks(rows).flat_map(repeated).collect())
}

/// The curve through points at parameters that a surface through sections follows: a cubic with its knots there, a
/// line through two points.
pub(crate) fn curve_through(points: &[Point3], parameters: &[f64]) -> Result<NurbsCurve> {
    let columns: Vec<[f64; 4]> = points.iter().map(|p| [p.x, p.y, p.z, 1.0]).collect();
    let (degree, knots, controls) = line_through(&columns, points.len(), parameters)?;
    NurbsCurve::new(degree, controls.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect(), knots)
}

/// The surface through a grid of points, v running fastest, at parameters: cubic with its knots there, straight across
/// two rows of points.
pub(crate) fn surface_through(points: &[Point3], parameters: [&[f64]; 2]) -> Result<NurbsSurface> {
    surface_through_pieces(points, parameters, [&[], &[]])
}

/// As [`surface_through`], of pieces that end at those of the parameters that are breaks: what bends otherwise on the
/// other side of one has no say in how the surface runs on this side.
pub(crate) fn surface_through_pieces(
    points: &[Point3],
    parameters: [&[f64]; 2],
    breaks: [&[f64]; 2],
) -> Result<NurbsSurface> {
    let [us, vs] = parameters;
    if points.len() != us.len() * vs.len() {
        return Err(Error::degenerate("grid of points", "its parameters do not fit"));
    }
    let net: Vec<[f64; 4]> = points.iter().map(|p| [p.x, p.y, p.z, 1.0]).collect();
    let (degree_v, knots_v, net) = pieces_through(&net, vs.len(), vs, breaks[1])?;
    let across = net.len() / us.len();
    let (degree_u, knots_u, net) = pieces_through(&transposed(&net, across), us.len(), us, breaks[0])?;
    let along = net.len() / across;
    let net = transposed(&net, along).iter().map(|p| Point3::new(p[0], p[1], p[2])).collect();
    NurbsSurface::new([degree_u, degree_v], [along, across], net, [knots_u, knots_v])
}

/// Lines through all rows, each of pieces with three equal knots where they meet; pieces of two rows do not break.
fn pieces_through(columns: &[[f64; 4]], rows: usize, t: &[f64], breaks: &[f64]) -> Result<Across> {
    let inner = (1..rows.saturating_sub(1)).filter(|i| t.get(*i).is_some_and(|t| breaks.contains(t)));
    let mut ends = vec![0];
    for i in inner {
        if i >= ends.last().map_or(2, |e| e + 2) && i + 2 < rows {
            ends.push(i);
        }
    }
    if ends.len() == 1 {
        return line_through(columns, rows, t);
    }
    ends.push(rows - 1);
    let lines = columns.len() / rows;
    let (mut knots, mut out) = (Vec::new(), vec![Vec::new(); lines]);
    for piece in ends.windows(2) {
        let rows_here = piece[1] - piece[0] + 1;
        let own: Vec<[f64; 4]> =
            columns.chunks(rows).flat_map(|c| c[piece[0]..=piece[1]].iter().copied()).collect();
        let (_, own_knots, net) = through(&own, rows_here, &t[piece[0]..=piece[1]], true)?;
        let shared = usize::from(!knots.is_empty());
        for (line, more) in out.iter_mut().zip(net.chunks(net.len() / lines)) {
            line.extend_from_slice(&more[shared..]);
        }
        knots.extend_from_slice(&own_knots[3 * shared..]);
    }
    Ok((3, knots, out.concat()))
}

fn line_through(columns: &[[f64; 4]], rows: usize, parameters: &[f64]) -> Result<Across> {
    if rows < 2 || parameters.len() != rows || parameters.windows(2).any(|w| !(w[1] > w[0])) {
        return Err(Error::Invalid {
            what: "parameters of points",
            why: "they must increase, two or more".into(),
        });
    }
    if rows == 2 {
        Ok(straight(columns, rows, parameters, false))
    } else {
        through(columns, rows, parameters, false)
    }
}

/// The closed cubic with its knots at the parameters.
fn around(columns: &[[f64; 4]], rows: usize, parameters: &[f64]) -> Result<Across> {
    let lines = Lines::new(3, true, rows, parameters.to_vec())?;
    let mut out = Vec::with_capacity(columns.len() + 3 * columns.len() / rows);
    for column in columns.chunks(rows) {
        cancellation::check()?;
        let places = lines.solve(&column.iter().map(|p| [p[0], p[1], p[2]]).collect::<Vec<_>>())?;
        let weights = lines.solve(&column.iter().map(|p| [p[3], 0.0, 0.0]).collect::<Vec<_>>())?;
        out.extend(places.iter().zip(&weights).map(|(p, w)| [p[0], p[1], p[2], w[0]]));
    }
    Ok((3, lines.knots, out))
}

/// The cubic with its knots at the parameters, whose derivatives at the ends are those of the parabolas through the
/// first and the last three sections (Bessel's rule), or, if `close` and there are so many, of the cubics through four:
/// linear in the sections, so that rational ones stay exact.
fn through(columns: &[[f64; 4]], rows: usize, t: &[f64], close: bool) -> Result<Across> {
    let n = rows;
    let mut knots = vec![t[0]; 2];
    knots.extend_from_slice(t);
    knots.extend([t[n - 1]; 2]);
    let mut out = Vec::with_capacity(columns.len() / n * (n + 2));
    for column in columns.chunks(n) {
        cancellation::check()?;
        let slope = |a: usize, b: usize, c: usize| -> [f64; 4] {
            let (h0, h1) = (t[b] - t[a], t[c] - t[b]);
            std::array::from_fn(|k| {
                let (v0, v1) = ((column[b][k] - column[a][k]) / h0, (column[c][k] - column[b][k]) / h1);
                v0 - (v1 - v0) * (h0 / (h0 + h1))
            })
        };
        let (first, last) = (column[0], column[n - 1]);
        let (start, end) = if close && n > 3 {
            let of = |rows: [usize; 4]| slope_of_cubic(rows.map(|i| t[i]), rows.map(|i| column[i]));
            (of([0, 1, 2, 3]), of([n - 1, n - 2, n - 3, n - 4]))
        } else {
            (slope(0, 1, 2), slope(n - 1, n - 2, n - 3))
        };
        let second: [f64; 4] = std::array::from_fn(|k| first[k] + start[k] * (t[1] - t[0]) / 3.0);
        let before: [f64; 4] = std::array::from_fn(|k| last[k] - end[k] * (t[n - 1] - t[n - 2]) / 3.0);
        let mut right = vec![first, second];
        right.extend_from_slice(&column[1..n - 1]);
        right.extend([before, last]);
        let places = solve(&knots, t, right.iter().map(|p| [p[0], p[1], p[2]]).collect())?;
        let weights = solve(&knots, t, right.iter().map(|p| [p[3], 0.0, 0.0]).collect())?;
        out.extend(places.iter().zip(&weights).map(|(p, w)| [p[0], p[1], p[2], w[0]]));
    }
    Ok((3, knots, out))
}

/// The derivative, at the first of four parameters, of the cubic through four points: Newton's divided differences.
fn slope_of_cubic(t: [f64; 4], points: [[f64; 4]; 4]) -> [f64; 4] {
    std::array::from_fn(|k| {
        let mut d = points.map(|p| p[k]);
        for level in 1..4 {
            for i in (level..4).rev() {
                d[i] = (d[i] - d[i - 1]) / (t[i] - t[i - level]);
            }
        }
        let h = [t[0] - t[1], t[0] - t[2]];
        d[1] + h[0] * d[2] + h[0] * h[1] * d[3]
    })
}

/// Control points of the cubic with knots at `t` whose first and last two are given and which passes the rest.
fn solve(knots: &[f64], t: &[f64], right: Vec<[f64; 3]>) -> Result<Vec<[f64; 3]>> {
    let n = t.len();
    let mut system = Banded::new(n + 2, 1, right)?;
    for i in [0, 1, n, n + 1] {
        system.add(i, i, 1.0);
    }
    let mut values = [0.0; MAX_DEGREE + 1];
    for (i, &u) in t.iter().enumerate().take(n - 1).skip(1) {
        basis(3, knots, i, u, &mut values);
        for (k, &value) in values.iter().enumerate().take(3) {
            system.add(i + 1, i + k, value);
        }
    }
    system.solve_totally_positive().ok_or(Error::degenerate("sections", "the interpolation has no solution"))
}
