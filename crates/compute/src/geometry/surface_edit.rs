//! Surfaces made simpler or alike: rebuilt, brought to the same knots; how large they are.

use katydid_geometry::{
    Direction, Interval, LeastSquares, NurbsCurve, NurbsSurface, Point3, Surface, clamped_uniform_knots,
};

use super::answer::Outcome;
use super::argument::Count;
use super::table::Endpoints;

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
        "nurbssurface/makecompatible-surface_surface_nurbssurface_nurbssurface",
        |a: Surface, b: Surface| {
            let [a, b] = compatible([a.to_nurbs()?, b.to_nurbs()?])?;
            Ok((true, Surface::from(a), Surface::from(b)))
        },
    );
}

type Degree = Count<1, 11>;
type Points = Count<2, 1_000>;

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
