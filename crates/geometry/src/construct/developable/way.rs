//! The cheapest way through the rectangle of two rails' parameters.

use super::rail::{Rail, twist};
use crate::construct::thresholds::WAY_COST;

/// How a ruling goes on to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Step {
    /// One rail goes on and the other waits.
    First,
    Second,
    /// Both go on.
    Both,
    /// Past a kink: to the other tangent in the same place.
    TurnFirst,
    TurnSecond,
    TurnBoth,
}

const STEPS: [Step; 6] =
    [Step::First, Step::Second, Step::Both, Step::TurnFirst, Step::TurnSecond, Step::TurnBoth];

impl Step {
    /// How many stations it goes on along each rail.
    fn delta(self) -> [usize; 2] {
        match self {
            Self::First | Self::TurnFirst => [1, 0],
            Self::Second | Self::TurnSecond => [0, 1],
            Self::Both | Self::TurnBoth => [1, 1],
        }
    }

    /// Which rail's tangent the surface keeps to. While one rail turns at a kink, that is the other's.
    fn keeps_to(self) -> Kept {
        match self {
            Self::First | Self::TurnSecond => Kept::First,
            Self::Second | Self::TurnFirst => Kept::Second,
            Self::Both | Self::TurnBoth => Kept::Both,
        }
    }

    /// Whether it is there where rails are at kinks.
    fn is_at(self, kinks: [bool; 2]) -> bool {
        match self {
            Self::First => !kinks[0],
            Self::Second => !kinks[1],
            Self::Both => !kinks[0] && !kinks[1],
            Self::TurnFirst => kinks[0],
            Self::TurnSecond => kinks[1],
            Self::TurnBoth => kinks[0] && kinks[1],
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kept {
    First,
    Second,
    Both,
}

/// The places of a ruling: a station of each rail.
pub(super) type Node = [usize; 2];

/// The rulings from one to another, of all sequences the one that twists and creases least (dynamic programming: the
/// cheapest way to a ruling goes on from a cheapest way to one before it). A strip costs its twist, squared. Where the
/// surface goes on from a cone over one rail to a cone over the other it has a crease, as large as the twist of the
/// ruling, which costs much more. A fold where both rails have a kink is theirs, and costs nothing.
pub(super) fn cheapest(rails: &[Rail; 2], from: Node, to: Node) -> Vec<Node> {
    let size = [to[0] - from[0] + 1, to[1] - from[1] + 1];
    let twists: Vec<f64> = (0..size[0] * size[1])
        .map(|k| {
            let (i, j) = (k / size[1], k % size[1]);
            twist(&rails[0].stations[from[0] + i], &rails[1].stations[from[1] + j])
        })
        .collect();
    let crease = 10.0 * (size[0] + size[1]) as f64;
    // Of ways that cost the same, the one that goes on along both rails, then that of shorter rulings.
    let span = rails.iter().map(|rail| rail.curve.bounding_box().diagonal().length()).sum::<f64>();
    let reach = |i: usize, j: usize| {
        let (a, b) = (&rails[0].stations[from[0] + i], &rails[1].stations[from[1] + j]);
        WAY_COST * (1.0 + 0.01 * a.point.distance_to(b.point) / span.max(f64::MIN_POSITIVE))
    };
    // For each ruling and each last step to it: the cost, and the step before.
    let mut best = vec![[(f64::INFINITY, None::<Step>); STEPS.len()]; twists.len()];
    let kink = |rail: usize, at: usize| at > 0 && rails[rail].is_kink(from[rail] + at);
    for i in 0..size[0] {
        for j in 0..size[1] {
            for (slot, step) in STEPS.into_iter().enumerate() {
                let [di, dj] = step.delta();
                if i < di || j < dj || !step.is_at([kink(0, i), kink(1, j)]) {
                    continue;
                }
                let before = (i - di) * size[1] + (j - dj);
                let this = i * size[1] + j;
                let pace = match step {
                    Step::Both => 0.5 * (twists[before].powi(2) + twists[this].powi(2)),
                    _ => 0.0,
                } + reach(i, j);
                let mut found = (f64::INFINITY, None);
                if before == 0 {
                    found = (pace, None);
                } else {
                    for (k, last) in STEPS.into_iter().enumerate() {
                        let turn = match (last.keeps_to(), step.keeps_to()) {
                            (a, b) if a == b => 0.0,
                            (Kept::Both, _) | (_, Kept::Both) => 0.25 * crease,
                            _ => crease,
                        };
                        let cost = best[before][k].0 + turn * twists[before].powi(2) + pace;
                        if cost < found.0 {
                            found = (cost, Some(last));
                        }
                    }
                }
                best[this][slot] = found;
            }
        }
    }
    back(&best, size, from)
}

/// The way that leads to the last ruling.
fn back(best: &[[(f64, Option<Step>); STEPS.len()]], size: Node, from: Node) -> Vec<Node> {
    let (mut i, mut j) = (size[0] - 1, size[1] - 1);
    let mut out = vec![[from[0] + i, from[1] + j]];
    let costs = best[i * size[1] + j];
    let mut step = (0..STEPS.len()).min_by(|&a, &b| costs[a].0.total_cmp(&costs[b].0)).map(|k| STEPS[k]);
    while let Some(this) = step {
        if i == 0 && j == 0 {
            break;
        }
        let slot = STEPS.iter().position(|s| *s == this).unwrap_or(0);
        step = best[i * size[1] + j][slot].1;
        let [di, dj] = this.delta();
        if i < di || j < dj {
            break;
        }
        (i, j) = (i - di, j - dj);
        out.push([from[0] + i, from[1] + j]);
    }
    out.reverse();
    out
}
