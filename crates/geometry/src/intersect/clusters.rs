//! Contacts that hang together.

use super::search::Contact;
use super::side::Side;

/// A place: contacts that hang together.
pub(super) struct Cluster {
    pub(super) a: [f64; 2],
    pub(super) b: [f64; 2],
    pub(super) reach: [f64; 2],
    pub(super) members: Vec<Contact>,
    /// For each curve the members by the start of their range, each with the furthest end so far.
    orders: [Vec<(u32, f64)>; 2],
}

/// A contact's range on the first or the second curve.
fn range(c: &Contact, side: usize) -> [f64; 2] {
    if side == 0 { c.a } else { c.b }
}

impl Cluster {
    fn of(c: Contact) -> Self {
        Self { a: c.a, b: c.b, reach: c.reach, members: vec![c], orders: Default::default() }
    }

    fn touches(&self, c: &Contact) -> bool {
        let near = |x: [f64; 2], y: [f64; 2], reach: f64| x[0] <= y[1] + reach && y[0] <= x[1] + reach;
        near(self.a, c.a, self.reach[0].max(c.reach[0])) && near(self.b, c.b, self.reach[1].max(c.reach[1]))
    }

    fn take(&mut self, mut other: Self) {
        self.a = [self.a[0].min(other.a[0]), self.a[1].max(other.a[1])];
        self.b = [self.b[0].min(other.b[0]), self.b[1].max(other.b[1])];
        self.reach = [self.reach[0].max(other.reach[0]), self.reach[1].max(other.reach[1])];
        // The few go to the many: a long contact grows by one part at a time.
        if other.members.len() > self.members.len() {
            std::mem::swap(&mut self.members, &mut other.members);
        }
        self.members.append(&mut other.members);
    }

    /// Makes ready for [`Cluster::at`].
    pub(super) fn sort(&mut self) {
        let members = &self.members;
        self.orders = [0, 1].map(|side| {
            let mut order: Vec<(u32, f64)> = (0..members.len() as u32).map(|i| (i, 0.0)).collect();
            let start = |i: u32| members.get(i as usize).map_or(0.0, |c| range(c, side)[0]);
            order.sort_by(|x, y| start(x.0).total_cmp(&start(y.0)));
            let mut furthest = f64::NEG_INFINITY;
            for (i, end) in &mut order {
                furthest = members.get(*i as usize).map_or(furthest, |c| furthest.max(range(c, side)[1]));
                *end = furthest;
            }
            order
        });
    }

    /// The member whose range on the first (0) or second (1) curve holds a parameter or is nearest to it; of several
    /// that in which the curves are nearest. With it comes how many were looked at.
    pub(super) fn at(&self, side: usize, t: f64) -> (Option<&Contact>, usize) {
        let order = self.orders.get(side).map_or(&[][..], |o| o);
        let member = |k: usize| order.get(k).and_then(|&(i, _)| self.members.get(i as usize));
        let split = order
            .partition_point(|&(i, _)| self.members.get(i as usize).is_some_and(|c| range(c, side)[0] <= t));
        let (mut best, mut looks): (Option<(f64, &Contact)>, usize) = (None, 0);
        let mut consider = |k: usize| -> f64 {
            looks += 1;
            if let Some(c) = member(k) {
                let [low, high] = range(c, side);
                let off = (low - t).max(t - high).max(0.0);
                if best.is_none_or(|(known, b)| off < known || (off == known && c.gap < b.gap)) {
                    best = Some((off, c));
                }
            }
            best.map_or(f64::INFINITY, |(off, _)| off)
        };
        let mut least = f64::INFINITY;
        for k in (0..split).rev() {
            if order.get(k).is_some_and(|&(_, end)| t - end > least) {
                break;
            }
            least = consider(k);
        }
        for k in split..order.len() {
            if member(k).is_some_and(|c| range(c, side)[0] - t > least) {
                break;
            }
            least = consider(k);
        }
        (best.map(|(_, c)| c), looks)
    }
}

/// Joins contacts that overlap or nearly do on both curves: one sweep along the first. Contacts beyond a turn of either
/// curve are others, for along a curve that turns back each point has several partners.
///
/// When the purse is empty the contacts that are left are not among them.
pub(super) fn gather(mut contacts: Vec<Contact>, a: &Side<'_>, b: &Side<'_>) -> Vec<Cluster> {
    contacts.sort_by(|x, y| {
        let key = |c: &Contact| (c.a[0] - c.reach[0], c.b[0]);
        key(x).0.total_cmp(&key(y).0).then(key(x).1.total_cmp(&key(y).1))
    });
    let stretches = |c: &Contact| {
        let middle = |x: [f64; 2]| 0.5 * (x[0] + x[1]);
        (a.stretch(middle(c.a)), b.stretch(middle(c.b)))
    };
    if !a.turns.is_empty() || !b.turns.is_empty() {
        contacts.sort_by_cached_key(stretches);
    }
    let mut done = Vec::new();
    for group in
        contacts.chunk_by(|x, y| (a.turns.is_empty() && b.turns.is_empty()) || stretches(x) == stretches(y))
    {
        let mut open: Vec<Cluster> = Vec::new();
        for &c in group {
            a.pay(open.len() / 16);
            if a.budget.get() == 0 {
                break;
            }
            let mut own = Cluster::of(c);
            let mut i = 0;
            while i < open.len() {
                if open[i].touches(&c) {
                    own.take(open.swap_remove(i));
                } else if open[i].a[1] + 2.0 * open[i].reach[0] < c.a[0] - c.reach[0] {
                    done.push(open.swap_remove(i));
                } else {
                    i += 1;
                }
            }
            open.push(own);
        }
        done.extend(open);
    }
    done
}
