//! A way of rulings parted into cones and strips, with rulings that do not twist.

use super::rail::{Rail, Station, bisected, out_of_plane, turned, twist};
use super::way::Node;

/// A part of the surface that is smooth along its rulings' ends.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Piece {
    /// One rail goes on from one parameter to another, while the other one waits at a parameter.
    Cone {
        /// The rail that goes on.
        rail: usize,
        range: [f64; 2],
        /// Where the other one waits.
        apex: f64,
    },
    /// Both go on: the parameters of the rulings, which increase on both rails.
    Strip(Vec<[f64; 2]>),
}

impl Piece {
    /// The largest twist of its rulings.
    pub(super) fn twist(&self, rails: &[Rail; 2]) -> f64 {
        let Self::Strip(rulings) = self else { return 0.0 };
        let of = |ruling: &[f64; 2]| match [rails[0].at(ruling[0]), rails[1].at(ruling[1])] {
            [Some(a), Some(b)] => twist(&a, &b),
            _ => 0.0,
        };
        // At its ends a strip may meet a kink, where a tangent is that of the next piece.
        let inner = rulings.get(1..rulings.len() - 1).unwrap_or_default();
        inner.iter().map(of).fold(0.0, f64::max)
    }
}

/// So many steps of one rail in a row are a cone when the rulings among them twist.
const WAIT: usize = 4;

/// The pieces of a way.
pub(super) fn of(rails: &[Rail; 2], way: &[Node]) -> Vec<Piece> {
    let mut out = Vec::new();
    let mut strip: Vec<Node> = Vec::new();
    let mut at = 0;
    while at + 1 < way.len() {
        match waiting(rails, way, at) {
            Some((rail, end)) => {
                finish(rails, &mut strip, &mut out);
                out.extend(cone(rails, way[at], way[end], rail));
                at = end;
            }
            None => {
                if strip.is_empty() {
                    strip.push(way[at]);
                }
                // A strip ends at a kink.
                let kink =
                    |rail: usize| way[at + 1][rail] > way[at][rail] && rails[rail].is_kink(way[at + 1][rail]);
                if kink(0) || kink(1) {
                    finish(rails, &mut strip, &mut out);
                }
                strip.push(way[at + 1]);
                at += 1;
            }
        }
    }
    finish(rails, &mut strip, &mut out);
    meet(rails, &mut out);
    out
}

/// Where a cone goes to that begins at a place of the way, and along which rail.
fn waiting(rails: &[Rail; 2], way: &[Node], at: usize) -> Option<(usize, usize)> {
    for rail in 0..2 {
        let waits = |node: &Node| rails[1 - rail].stations[node[1 - rail]].t;
        let still = waits(&way[at]);
        let count = way[at..].iter().take_while(|node| waits(node) == still).count();
        if count <= WAIT {
            continue;
        }
        let end = at + count - 1;
        let node = |k: usize| {
            let [i, j] = way[k];
            (rails[0].stations[i], rails[1].stations[j])
        };
        // A strip that goes on slowly along one rail waits at a station, too: its rulings hardly twist there, and
        // they do so to both sides.
        let sides = [at + 1, end - 1].map(|k| {
            let (a, b) = node(k);
            out_of_plane(&a, &b)
        });
        let at_end = at == 0 || end + 1 == way.len();
        let steady = sides[0] * sides[1] >= 0.0;
        if at_end || steady || count > 12 * WAIT {
            return Some((rail, end));
        }
    }
    None
}

/// The cone from a ruling to another; nothing where its rail does not move.
fn cone(rails: &[Rail; 2], from: Node, to: Node, rail: usize) -> Option<Piece> {
    let parameter = |node: Node, side: usize| rails[side].stations[node[side]].t;
    let range = [parameter(from, rail), parameter(to, rail)];
    (range[1] > range[0]).then(|| Piece::Cone { rail, range, apex: parameter(from, 1 - rail) })
}

/// Takes the rulings gathered as a strip.
fn finish(rails: &[Rail; 2], strip: &mut Vec<Node>, out: &mut Vec<Piece>) {
    let nodes = std::mem::take(strip);
    let (Some(first), Some(last)) = (nodes.first(), nodes.last()) else { return };
    let t = |node: &Node| [0, 1].map(|side| rails[side].stations[node[side]].t);
    let (start, end) = (t(first), t(last));
    let moves = [end[0] > start[0], end[1] > start[1]];
    match moves {
        [false, false] => return,
        [true, false] => return out.push(Piece::Cone { rail: 0, range: [start[0], end[0]], apex: start[1] }),
        [false, true] => return out.push(Piece::Cone { rail: 1, range: [start[1], end[1]], apex: start[0] }),
        [true, true] => {}
    }
    let mut rulings = vec![start];
    let inner = nodes.get(1..nodes.len() - 1).unwrap_or_default();
    for node in inner {
        rulings.push(flat(rails, *node));
    }
    rulings.push(end);
    out.push(Piece::Strip(rising(rulings)));
}

/// The ruling near a node that does not twist, by moving its end on one rail or the other; the node where there is none.
fn flat(rails: &[Rail; 2], node: Node) -> [f64; 2] {
    let here = [0, 1].map(|side| rails[side].stations[node[side]]);
    let found = (0..2).filter_map(|moved| {
        let t = untwisted(rails, moved, node[moved], &here[1 - moved])?;
        let shift = (t - here[moved].t).abs() / rails[moved].curve.domain().length();
        let mut ruling = here.map(|s| s.t);
        ruling[moved] = t;
        Some((shift, ruling))
    });
    found.min_by(|a, b| a.0.total_cmp(&b.0)).map_or(here.map(|s| s.t), |(_, ruling)| ruling)
}

/// The parameter of a rail within two stations of one at which the ruling to a place of the other does not twist.
fn untwisted(rails: &[Rail; 2], rail: usize, station: usize, other: &Station) -> Option<f64> {
    let along = &rails[rail].stations;
    let value = |s: &Station| if rail == 0 { out_of_plane(s, other) } else { out_of_plane(other, s) };
    let near = |i: usize| (value(&along[i]), along[i]);
    let (low, high) = (station.saturating_sub(2), (station + 2).min(along.len() - 1));
    let mut best: Option<f64> = None;
    let t = along[station].t;
    for i in low..high {
        let ((f, a), (g, b)) = (near(i), near(i + 1));
        if a.t == b.t || f * g > 0.0 || turned(a.tangent, b.tangent, 1.0) {
            continue;
        }
        let root = if f == 0.0 {
            a.t
        } else if g == 0.0 {
            b.t
        } else {
            bisected([a.t, b.t], |t| rails[rail].at(t).map_or(0.0, |s| value(&s)))
        };
        if best.is_none_or(|known| (root - t).abs() < (known - t).abs()) {
            best = Some(root);
        }
    }
    best
}

/// Rulings of which each goes on along both rails, with the first and the last as they are.
fn rising(rulings: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let Some(&last) = rulings.last() else { return rulings };
    let count = rulings.len();
    let mut out: Vec<[f64; 2]> = Vec::with_capacity(count);
    for (k, ruling) in rulings.into_iter().enumerate() {
        let after = out.last().is_none_or(|before| ruling[0] > before[0] && ruling[1] > before[1]);
        let before = ruling[0] < last[0] && ruling[1] < last[1];
        if k + 1 == count || (after && before) {
            out.push(ruling);
        }
    }
    out
}

/// Moves the rulings between pieces to where they do not twist, as far as a station goes.
fn meet(rails: &[Rail; 2], pieces: &mut [Piece]) {
    // A flat part waits where the plane through its straight side touches the other rail.
    for k in 1..pieces.len().saturating_sub(1) {
        let Piece::Cone { rail, range, apex } = pieces[k] else { continue };
        let Some(t) = rails[rail].after(range[0]).and_then(|s| near(rails, 1 - rail, apex, &s)) else {
            continue;
        };
        if pieces[k - 1].reaches(1 - rail, t) && pieces[k + 1].leaves(1 - rail, t) {
            pieces[k - 1].set_end(1 - rail, t);
            pieces[k].set_apex(t);
            pieces[k + 1].set_start(1 - rail, t);
        }
    }
    for k in 1..pieces.len() {
        let (cone, strip, cone_first) = match (&pieces[k - 1], &pieces[k]) {
            (Piece::Cone { .. }, Piece::Strip(_)) => (k - 1, k, true),
            (Piece::Strip(_), Piece::Cone { .. }) => (k, k - 1, false),
            _ => continue,
        };
        let Piece::Cone { rail, range, apex } = pieces[cone] else { continue };
        let end = if cone_first { range[1] } else { range[0] };
        // The apex may be a kink: the tangent that counts is the strip's.
        let apex = if cone_first { rails[1 - rail].after(apex) } else { rails[1 - rail].before(apex) };
        let Some(t) = apex.and_then(|apex| near(rails, rail, end, &apex)) else { continue };
        if cone_first && pieces[cone].reaches(rail, t) && pieces[strip].leaves(rail, t) {
            pieces[cone].set_end(rail, t);
            pieces[strip].set_start(rail, t);
        } else if !cone_first && pieces[strip].reaches(rail, t) && pieces[cone].leaves(rail, t) {
            pieces[strip].set_end(rail, t);
            pieces[cone].set_start(rail, t);
        }
    }
}

/// The parameter of a rail near one of its stations at which the ruling to a place of the other does not twist. A kink
/// stays where it is.
fn near(rails: &[Rail; 2], rail: usize, t: f64, other: &Station) -> Option<f64> {
    let along = &rails[rail].stations;
    let station = along.partition_point(|s| s.t < t).min(along.len() - 1);
    let kink = along.get(station + 1).is_some_and(|next| next.t == along[station].t);
    if kink { None } else { untwisted(rails, rail, station, other) }
}

impl Piece {
    /// Whether it could end at a parameter of a rail.
    fn reaches(&self, rail: usize, t: f64) -> bool {
        match self {
            Self::Cone { rail: moved, range, .. } => rail == *moved && t > range[0],
            Self::Strip(rulings) => rulings.len() > 1 && t > rulings[rulings.len() - 2][rail],
        }
    }

    /// Whether it could begin at a parameter of a rail.
    fn leaves(&self, rail: usize, t: f64) -> bool {
        match self {
            Self::Cone { rail: moved, range, .. } => rail == *moved && t < range[1],
            Self::Strip(rulings) => rulings.len() > 1 && t < rulings[1][rail],
        }
    }

    fn set_start(&mut self, rail: usize, t: f64) {
        match self {
            Self::Cone { range, .. } => range[0] = t,
            Self::Strip(rulings) => {
                if let Some(first) = rulings.first_mut() {
                    first[rail] = t;
                }
            }
        }
    }

    fn set_end(&mut self, rail: usize, t: f64) {
        match self {
            Self::Cone { range, .. } => range[1] = t,
            Self::Strip(rulings) => {
                if let Some(last) = rulings.last_mut() {
                    last[rail] = t;
                }
            }
        }
    }

    fn set_apex(&mut self, t: f64) {
        if let Self::Cone { apex, .. } = self {
            *apex = t;
        }
    }
}
