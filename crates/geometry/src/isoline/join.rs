use super::Isoline;
use crate::Point2;

/// Ways from crossing to crossing, each of which is left at most once and entered at most once.
pub(super) struct Links {
    /// For every crossing the next, or `u32::MAX`.
    pub(super) next: Vec<u32>,
    /// The crossings that are left, in the order found.
    pub(super) starts: Vec<u32>,
    /// For every crossing whether one leads to it.
    pub(super) entered: Vec<bool>,
}

impl Links {
    #[inline]
    pub(super) fn add(&mut self, from: u32, to: u32) {
        if let (Some(next), Some(entered)) =
            (self.next.get_mut(from as usize), self.entered.get_mut(to as usize))
        {
            (*next, *entered) = (to, true);
            self.starts.push(from);
        }
    }

    /// The lines that the ways make, those with ends first.
    pub(super) fn lines(mut self, place: impl Fn(u32) -> Point2) -> Vec<Isoline> {
        let starts = std::mem::take(&mut self.starts);
        let mut out = Vec::new();
        for &start in starts.iter().filter(|&&s| !self.entered.get(s as usize).copied().unwrap_or(true)) {
            follow(&mut self.next, start, &place, &mut out);
        }
        for &start in &starts {
            follow(&mut self.next, start, &place, &mut out);
        }
        out
    }
}

/// Follows the ways from a crossing on, and takes them out.
fn follow(next: &mut [u32], start: u32, place: &impl Fn(u32) -> Point2, out: &mut Vec<Isoline>) {
    let mut points: Vec<Point2> = Vec::new();
    let mut add = |p: Point2| {
        if points.last() != Some(&p) {
            points.push(p);
        }
    };
    let (mut at, mut closed) = (start, false);
    while let Some(to) = next.get_mut(at as usize).map(|n| std::mem::replace(n, u32::MAX)) {
        if to == u32::MAX {
            if at != start {
                add(place(at));
            }
            break;
        }
        add(place(at));
        at = to;
        if at == start {
            closed = true;
            break;
        }
    }
    if closed {
        while points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
    }
    if points.len() >= if closed { 3 } else { 2 } {
        out.push(Isoline { points, closed });
    }
}
