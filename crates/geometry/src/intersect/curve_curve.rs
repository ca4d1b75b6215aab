//! Curve with curve.

use std::cell::Cell;
use std::cmp::Ordering;

use super::fold::unfolded;
use super::reader::Reader;
use super::result::CurveIntersections;
use super::search::Search;
use super::side::{Side, is_closed};
use crate::curve::Piece;
use crate::{Curve, Error, Result, cancellation};

/// All points and stretches that two curves have in common within `tolerance`, in the plane or in space.
///
/// **Complete**: parts of the curves are discarded only when hulls of control points prove them further apart than
/// the tolerance, and settled when the hulls prove that they meet in at most one point and Newton's method finds it;
/// all else is halved. Crossings are polished until rounding stops them (parameters to about 10⁻¹³ of the domain
/// where the curves cross at an angle). A crossing is one that comes within the tolerance: a curve that misses by
/// more is a miss. Where curves touch, or cross twice so that between they part by no more than the tolerance, that
/// is one tangent contact. Curves that run within the tolerance of each other between joints of theirs give an
/// overlap; ends of overlaps are not listed as crossings again. At the seam of a closed curve the start counts.
///
/// For exact answers on exact geometry use a tolerance well below the size of its features, 10⁻⁹ say; below about
/// 10⁻¹⁴ of the largest coordinate it is taken as that. Swapping the curves swaps the answer, to the last bit.
///
/// The work is bounded; see [`CurveIntersections::complete`].
///
/// Source: recursive subdivision after T. Sederberg and R. Meyers (1988) and SISL's treatment of simple cases
/// (T. Dokken); overlaps by inclusion of ends (Patrikalakis and Maekawa, *Shape Interrogation*, 4.7).
///
/// # Errors
/// The tolerance is negative or not finite.
pub fn curve_curve(a: &Curve, b: &Curve, tolerance: f64) -> Result<CurveIntersections> {
    check(tolerance)?;
    cancellation::check()?;
    let (pa, pb) = (a.pieces(), b.pieces());
    if order(&pa, &pb) == Ordering::Greater {
        return Ok(meet(b, a, pb, pa, tolerance).swapped());
    }
    Ok(meet(a, b, pa, pb, tolerance))
}

pub(super) fn check(tolerance: f64) -> Result<()> {
    if !tolerance.is_finite() {
        return Err(Error::NotFinite("tolerance"));
    }
    if tolerance < 0.0 {
        return Err(Error::OutOfRange { what: "tolerance", value: tolerance, must: "at least 0" });
    }
    Ok(())
}

fn meet<'a>(
    a: &'a Curve,
    b: &'a Curve,
    pa: Vec<Piece<'a>>,
    pb: Vec<Piece<'a>>,
    tolerance: f64,
) -> CurveIntersections {
    let ((pa, turns_a), (pb, turns_b)) = (unfolded(pa, tolerance), unfolded(pb, tolerance));
    let mut search = Search::pair(pa, pb, tolerance);
    search.run();
    let mut out = search.summary();
    let contacts = std::mem::take(&mut search.contacts);
    let (pa, pb) = search.pieces();
    let tolerance = search.tolerance;
    let budget = Cell::new(budget(pa.len() + pb.len(), contacts.len()));
    let a = Side::new(pa, &turns_a, a.domain(), tolerance, &budget);
    let b = Side::new(pb, &turns_b, b.domain(), tolerance, &budget);
    Reader { a, b, tolerance, itself: false }.read(contacts, &mut out);
    out
}

/// How many places on the curves the reading of contacts may look at: some tenths of a second.
fn budget(pieces: usize, contacts: usize) -> u64 {
    3_000_000 + (200 * pieces as u64).min(4_000_000) + 4 * contacts as u64
}

/// All points and stretches in which a curve meets itself within `tolerance`: crossings with the smaller parameter
/// as `a` and the larger as `b`. That neighbouring parts meet at their joint, or a closed curve at its seam, does not
/// count. A curve that turns back along itself, at a corner or inside a span, overlaps itself up to the turn, the two
/// ranges meeting there; a cusp whose branches part is no crossing.
///
/// Complete in the sense of [`curve_curve`]: a part is free of crossings with itself when all differences of its
/// control points lead within 60° of one direction, and so are two neighbours.
///
/// # Errors
/// The tolerance is negative or not finite.
pub fn curve_self(curve: &Curve, tolerance: f64) -> Result<CurveIntersections> {
    check(tolerance)?;
    cancellation::check()?;
    let (pieces, turns) = unfolded(curve.pieces(), tolerance);
    let closed = is_closed(&pieces, tolerance);
    let mut search = Search::own(pieces, closed, tolerance);
    search.run();
    let mut out = search.summary();
    let mut contacts = std::mem::take(&mut search.contacts);
    for c in &mut contacts {
        if c.best.0 > c.best.1 {
            (c.a, c.b) = (c.b, c.a);
            c.best = (c.best.1, c.best.0);
            c.reach.reverse();
        }
    }
    let pieces = search.pieces().0;
    let budget = Cell::new(budget(pieces.len(), contacts.len()));
    let side = Side::new(pieces, &turns, curve.domain(), search.tolerance, &budget);
    Reader { a: side, b: side, tolerance: search.tolerance, itself: true }.read(contacts, &mut out);
    Ok(out)
}

/// An order of curves by their pieces, so that the result does not depend on which comes first.
fn order(a: &[Piece<'_>], b: &[Piece<'_>]) -> Ordering {
    let key = |p: &Piece<'_>| {
        let m = p.point(p.own.middle());
        let (s, e) = (p.start(), p.end());
        [s.x, s.y, s.z, m.x, m.y, m.z, e.x, e.y, e.z, p.whole.start, p.whole.end]
    };
    a.len().cmp(&b.len()).then_with(|| {
        for (x, y) in a.iter().zip(b) {
            for (x, y) in key(x).iter().zip(key(y)) {
                match x.total_cmp(&y) {
                    Ordering::Equal => {}
                    other => return other,
                }
            }
        }
        Ordering::Equal
    })
}
