//! Surfaces made simpler or alike: rebuilt, brought to the same knots; how large they are.

use katydid_geometry::{
    Curve, Direction, Interval, LeastSquares, NurbsCurve, NurbsSurface, Point3, Side, Surface,
    clamped_uniform_knots,
};
use serde_json::Value as Json;

use super::answer::Outcome;
use super::argument::{Count, Positive, Waiting, Within, choice};
use super::table::Endpoints;
use crate::Fault;
use crate::wire::Read;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("surface/getsurfacesize-surface_double_double", |s: Surface| {
        let [width, height] = Direction::BOTH.map(|along| longest(&s, along));
        Ok((true, width?, height?))
    });
    table.add(
        "surface/rebuild-surface_int_int_int_int",
        |s: Surface, u: Degree, v: Degree, nu: Points, nv: Points| {
            rebuilt(&s, [u.0, v.0], [nu.0, nv.0]).map(Surface::from)
        },
    );
    table.add(
        "surface/fit-surface_int_int_double",
        |s: Surface, u: Smooth, v: Smooth, t: Within, w: Waiting| fitted(&s, [u.0, v.0], t.0, &w),
    );
    table.add(
        "surface/extend-surface_isostatus_double_bool",
        |s: Surface, side: Border, length: Positive, smooth: bool| extended(&s, side, length.0, smooth),
    );
    table.add(
        "nurbssurface/makecompatible-surface_surface_nurbssurface_nurbssurface",
        |a: Surface, b: Surface| {
            let [a, b] = compatible([a.to_nurbs()?, b.to_nurbs()?])?;
            Ok((true, Surface::from(a), Surface::from(b)))
        },
    );
}

type Degree = Count<1, 11>;
type Smooth = Count<2, 11>;
type Points = Count<2, 1_000>;

/// How often the range of an extension is corrected.
const CORRECTIONS: usize = 30;

/// The surface continued over one side by its own polynomials, so far that the line across the middle of the side grows
/// by a length; `None` where it closes there or comes to a point.
fn extended(surface: &Surface, Border(side): Border, length: f64, smooth: bool) -> Outcome<Option<Surface>> {
    let (along, at_end) = match side {
        Side::West => (Direction::U, false),
        Side::East => (Direction::U, true),
        Side::South => (Direction::V, false),
        Side::North => (Direction::V, true),
    };
    if surface.is_closed(along) || surface.is_singular(side) {
        return Ok(None);
    }
    let nurbs = surface.to_nurbs()?;
    if !smooth && nurbs.degree(along) > 1 {
        return Err(Fault::not_supported("ruled extensions of surfaces that are curved that way"));
    }
    let (domain, middle) = (nurbs.domain(along), nurbs.domain(along.other()).middle());
    let range = |by: f64| {
        if at_end {
            Interval::new(domain.start, domain.end + by)
        } else {
            Interval::new(domain.start - by, domain.end)
        }
    };
    let beyond = |made: &NurbsSurface, by: f64| -> Outcome<f64> {
        let line = Curve::from(made.isocurve(along, middle)?);
        let (from, to) =
            if at_end { (domain.end, domain.end + by) } else { (domain.start - by, domain.start) };
        Ok(line.length_between(Interval::new(from, to)))
    };
    let whole = Curve::from(nurbs.isocurve(along, middle)?).length();
    let mut by = domain.length() * length / whole.max(f64::MIN_POSITIVE);
    for _ in 0..CORRECTIONS {
        let Ok(made) = nurbs.extended(along, range(by)) else { return Ok(None) };
        let grown = beyond(&made, by)?;
        if (grown - length).abs() <= 1e-9 * length {
            return Ok(Some(made.into()));
        }
        if !(grown > 0.0 && grown.is_finite()) {
            return Ok(None);
        }
        // Twice as far at most: the speed changes on the way.
        by *= (length / grown).clamp(0.5, 2.0);
    }
    Ok(None)
}

/// The side of a surface that an `IsoStatus` names: 3 west, 4 south, 5 east, 6 north.
#[derive(Clone, Copy)]
struct Border(Side);

impl Read for Border {
    fn read(json: &Json) -> Result<Self, Fault> {
        let names = ["None", "X", "Y", "West", "South", "East", "North"];
        let sides =
            [None, None, None, Some(Side::West), Some(Side::South), Some(Side::East), Some(Side::North)];
        let choices: Vec<(&str, Option<Side>)> = names.into_iter().zip(sides).collect();
        let side = choice(json, "side of a surface", &choices)?;
        side.map(Self).ok_or_else(|| Fault::bad_request("is no side: 3 west, 4 south, 5 east, 6 north"))
    }

    fn type_name() -> String {
        "IsoStatus".into()
    }
}

/// How many isocurves are measured.
const MEASURED: u32 = 9;

/// The length of the longest of some isocurves along a direction: what the surface would measure when it is unrolled.
fn longest(surface: &Surface, along: Direction) -> Outcome<f64> {
    let across = surface.domain(along.other());
    let mut most = 0.0_f64;
    for k in 0..MEASURED {
        let constant = across.at(f64::from(k) / f64::from(MEASURED - 1));
        most = most.max(surface.isocurve(along, constant)?.length());
    }
    Ok(most)
}

/// The surface of so many control points that goes through the old one at the Greville points of even knots over the
/// same domains: what was a polynomial of such a degree stays what it was, to its parameters.
fn rebuilt(surface: &Surface, degrees: [usize; 2], counts: [usize; 2]) -> Outcome<NurbsSurface> {
    // Where there are fewer points than a degree needs they count, as Rhino has it.
    let degrees = [0, 1].map(|k| degrees[k].min(counts[k] - 1));
    let knots = [0, 1].map(|k| even_knots(degrees[k], counts[k], surface.domain(Direction::BOTH[k])));
    let [us, vs] = knots;
    let (us, vs) = (us?, vs?);
    let places = [greville(degrees[0], &us), greville(degrees[1], &vs)];
    let columns = places[1].iter().map(|&v| {
        let points: Vec<Point3> = places[0].iter().map(|&u| surface.point_at(u, v)).collect();
        through(degrees[0], &us, &points, &places[0])
    });
    let columns = columns.collect::<Outcome<Vec<_>>>()?;
    let rows = (0..counts[0]).map(|i| {
        let points: Vec<Point3> = columns.iter().filter_map(|column| column.get(i).copied()).collect();
        through(degrees[1], &vs, &points, &places[1])
    });
    let net = rows.collect::<Outcome<Vec<_>>>()?.concat();
    Ok(NurbsSurface::new(degrees, counts, net, [us, vs])?)
}

/// The most control points in a direction of a fit, and places between two of them where it is compared.
const FINEST: usize = 600;
const COMPARED: usize = 3;

/// The surface of given degrees, rebuilt with more and more control points until it is within the tolerance of the old
/// one, parameter by parameter; `None` when it never is.
fn fitted(
    surface: &Surface,
    degrees: [usize; 2],
    tolerance: f64,
    waiting: &Waiting,
) -> Outcome<Option<Surface>> {
    let spans = Direction::BOTH.map(|along| surface.span_parameters(along).len().saturating_sub(1).max(1));
    let mut counts = [0, 1].map(|k| (degrees[k] + spans[k]).max(degrees[k] + 1));
    let domains = Direction::BOTH.map(|along| surface.domain(along));
    while counts.iter().all(|count| *count <= FINEST) {
        waiting.check()?;
        let made = rebuilt(surface, degrees, counts)?;
        // How far it is off along each direction's finer places.
        let places = |k: usize, per: usize| {
            let parts = counts[k] * per;
            (0..=parts).map(move |i| domains[k].at(i as f64 / parts as f64)).collect::<Vec<f64>>()
        };
        let off = |us: &[f64], vs: &[f64]| {
            let mut worst = 0.0_f64;
            for &u in us {
                for &v in vs {
                    worst = worst.max(made.point_at(u, v).distance_to(surface.point_at(u, v)));
                }
            }
            worst
        };
        let (fine, few) = ([places(0, COMPARED), places(1, COMPARED)], [domains[0], domains[1]]);
        let few = few.map(|domain| [0.13, 0.37, 0.5, 0.71, 0.93].map(|x| domain.at(x)));
        if off(&fine[0], &fine[1]) <= tolerance {
            return Ok(Some(made.into()));
        }
        let missed = [off(&fine[0], &few[1]), off(&few[0], &fine[1])];
        let larger = missed[0].max(missed[1]);
        for k in 0..2 {
            if missed[k] > 0.1 * larger {
                counts[k] *= 2;
            }
        }
    }
    Ok(None)
}

/// Even knots over a domain, with full multiplicity at its ends.
fn even_knots(degree: usize, count: usize, domain: Interval) -> Outcome<Vec<f64>> {
    let own = clamped_uniform_knots(degree, count)?;
    let spans = (count - degree) as f64;
    Ok(own.iter().map(|t| domain.at(t / spans)).collect())
}

fn greville(degree: usize, knots: &[f64]) -> Vec<f64> {
    knots.windows(degree).map(|window| window.iter().sum::<f64>() / degree as f64).collect()
}

/// The control points with which a curve goes through as many points.
fn through(degree: usize, knots: &[f64], points: &[Point3], parameters: &[f64]) -> Outcome<Vec<Point3>> {
    let options = LeastSquares::default();
    Ok(NurbsCurve::least_squares(degree, knots, points, parameters, &options)?.control_points())
}

/// Both surfaces over the domains of the first, of one degree and with the same knots in either direction, both
/// rational when one of them is.
fn compatible(surfaces: [NurbsSurface; 2]) -> Outcome<[NurbsSurface; 2]> {
    let [mut a, mut b] = surfaces;
    let is_rational = a.is_rational() || b.is_rational();
    for direction in Direction::BOTH {
        let degree = a.degree(direction).max(b.degree(direction));
        a = a.raised_to(direction, degree)?.clamped(direction)?;
        b = b.raised_to(direction, degree)?.clamped(direction)?;
        let domain = a.domain(direction);
        b = Surface::from(b).with_domain(direction, domain)?.to_nurbs()?;
        let [of_a, of_b] = [a.knots(direction).to_vec(), b.knots(direction).to_vec()];
        a = a.refined(direction, &missing(&of_b, &of_a, domain))?;
        b = b.refined(direction, &missing(&of_a, &of_b, domain))?;
    }
    // The same to the last bit: what was mapped to another domain is off by roundings.
    let knots = Direction::BOTH.map(|direction| a.knots(direction).to_vec());
    b = if b.is_rational() {
        NurbsSurface::rational(b.degrees(), b.counts(), b.homogeneous_points(), knots)?
    } else {
        NurbsSurface::new(b.degrees(), b.counts(), b.control_points(), knots)?
    };
    Ok(if is_rational { [a.to_rational(), b.to_rational()] } else { [a, b] })
}

/// The knots inside a domain that one list has and another has not, each as often as it lacks them.
fn missing(from: &[f64], other: &[f64], domain: Interval) -> Vec<f64> {
    let near = 1e-9 * domain.length();
    let inside = |t: &f64| *t > domain.start + near && *t < domain.end - near;
    let (mut left, mut out) = (other.iter().copied().filter(inside).collect::<Vec<f64>>(), Vec::new());
    for t in from.iter().copied().filter(inside) {
        match left.iter().position(|own| (own - t).abs() <= near) {
            Some(at) => {
                left.remove(at);
            }
            None => out.push(t),
        }
    }
    out
}
