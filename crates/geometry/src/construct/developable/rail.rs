//! A rail as places along it with their tangents, and how much a ruling between two rails twists.

use crate::thresholds;
use crate::{Curve, Error, Point3, Result, Tolerance, Vector3};

/// A place on a rail.
#[derive(Debug, Clone, Copy)]
pub(super) struct Station {
    /// The parameter of the rail.
    pub(super) t: f64,
    pub(super) point: Point3,
    /// The unit tangent; at a kink there are two stations, with the tangents before and after it.
    pub(super) tangent: Vector3,
}

/// A rail with its stations in order.
#[derive(Debug)]
pub(super) struct Rail {
    pub(super) curve: Curve,
    pub(super) stations: Vec<Station>,
}

impl Rail {
    /// About `count` stations: at even steps of the parameter, at the parameters that must be among them, and at the
    /// ends of straight parts, which are where cones begin.
    pub(super) fn of(curve: &Curve, count: usize, wanted: &[f64], tolerance: &Tolerance) -> Result<Self> {
        let domain = curve.domain();
        let step = domain.length() / count as f64;
        let pieces: Vec<f64> = curve.pieces().iter().map(|piece| piece.whole.start).collect();
        // Of very many pieces each is shorter than a step.
        let joints: &[f64] = if pieces.len() <= count { &pieces } else { &[] };
        let mut places: Vec<f64> = (0..count).map(|k| domain.at(k as f64 / count as f64)).collect();
        places.retain(|t| joints.iter().chain(wanted).all(|joint| (joint - t).abs() > 0.25 * step));
        places.extend(joints.iter().chain(wanted));
        places.extend([domain.start, domain.end]);
        places.retain(|t| domain.contains(*t));
        places.sort_by(f64::total_cmp);
        places.dedup();
        let mut stations: Vec<Station> = Vec::with_capacity(places.len() + 8);
        for t in places {
            let point = curve.point_at(t);
            for from_below in [true, false] {
                if t == if from_below { domain.start } else { domain.end } {
                    continue;
                }
                let Some(tangent) = curve.tangent_on_side(t, from_below) else { continue };
                let same = |s: &Station| s.t == t && !turned(s.tangent, tangent, tolerance.angle);
                if !stations.last().is_some_and(same) {
                    stations.push(Station { t, point, tangent });
                }
            }
        }
        if stations.len() < 2 {
            return Err(Error::degenerate("rail of a developable loft", "it has no direction"));
        }
        Ok(Self { curve: curve.clone(), stations })
    }

    pub(super) fn last(&self) -> usize {
        self.stations.len() - 1
    }

    /// Whether a station has the place of the one before it, and another tangent.
    pub(super) fn is_kink(&self, station: usize) -> bool {
        station.checked_sub(1).is_some_and(|before| self.stations[before].t == self.stations[station].t)
    }

    /// The station at a parameter that was asked for; nothing outside of the rail.
    pub(super) fn station_at(&self, t: f64) -> Option<usize> {
        let at = self.stations.partition_point(|s| s.t < t);
        self.stations.get(at).filter(|s| s.t == t).map(|_| at)
    }

    /// The place at a parameter inside a smooth piece.
    pub(super) fn at(&self, t: f64) -> Option<Station> {
        self.after(t)
    }

    /// The place at a parameter, as the rail leaves it.
    pub(super) fn after(&self, t: f64) -> Option<Station> {
        self.on_side(t, false)
    }

    /// The place at a parameter, as the rail comes to it.
    pub(super) fn before(&self, t: f64) -> Option<Station> {
        self.on_side(t, true)
    }

    fn on_side(&self, t: f64, from_below: bool) -> Option<Station> {
        let tangent = self.curve.tangent_on_side(t, from_below)?;
        Some(Station { t, point: self.curve.point_at(t), tangent })
    }
}

/// Whether two directions differ by more than an angle.
pub(super) fn turned(a: Vector3, b: Vector3, angle: f64) -> bool {
    a.angle_to(b).is_some_and(|between| between > angle)
}

/// The angle between the normals that a ruling has at its ends, in radians; 0 where it has no length, or runs along a
/// rail.
pub(super) fn twist(a: &Station, b: &Station) -> f64 {
    let ruling = b.point - a.point;
    let (n, m) = (a.tangent.cross(ruling), b.tangent.cross(ruling));
    let least = thresholds::SAME_PARAMETER * ruling.length();
    if n.length() <= least || m.length() <= least { 0.0 } else { n.angle_to(m).unwrap_or(0.0) }
}

/// How far the tangents and the ruling are from one plane: the sine of the twist, with its side.
pub(super) fn out_of_plane(a: &Station, b: &Station) -> f64 {
    let ruling = b.point - a.point;
    match ruling.unitized() {
        Some(ruling) => a.tangent.cross(b.tangent).dot(ruling),
        None => 0.0,
    }
}

/// A closed rail that begins where the ruling from the start of another does not twist: of such places the one nearest to
/// that start. It stays as it is when there is none.
pub(super) fn begun_at_flat_ruling(first: &Curve, second: &Curve, tolerance: &Tolerance) -> Result<Curve> {
    const PLACES: usize = 360;
    let rails = [Rail::of(first, 8, &[], tolerance)?, Rail::of(second, PLACES, &[], tolerance)?];
    let start = rails[0].stations[0];
    let along = &rails[1].stations;
    if twist(&start, &along[0]) <= thresholds::PARALLEL {
        return Ok(second.clone());
    }
    let mut best: Option<(f64, f64)> = None;
    for pair in along.windows(2) {
        let ends = [out_of_plane(&start, &pair[0]), out_of_plane(&start, &pair[1])];
        if ends[0] * ends[1] > 0.0 || twist(&start, &pair[0]) > 1.0 || pair[0].t == pair[1].t {
            continue;
        }
        let value = |t: f64| rails[1].at(t).map_or(0.0, |s| out_of_plane(&start, &s));
        let t = bisected([pair[0].t, pair[1].t], value);
        let far = second.point_at(t).distance_to(start.point);
        if best.is_none_or(|(least, _)| far < least) {
            best = Some((far, t));
        }
    }
    match best {
        Some((_, t)) if t > second.domain().start && t < second.domain().end => second.with_seam(t),
        _ => Ok(second.clone()),
    }
}

/// The root of a function between two parameters where it has different signs.
pub(super) fn bisected(range: [f64; 2], value: impl Fn(f64) -> f64) -> f64 {
    let [mut low, mut high] = range;
    let sign = value(low);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if value(middle) * sign > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}
