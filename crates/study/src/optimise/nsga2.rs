//! NSGA-II: a population that spreads along the front of what cannot be better in one goal without being worse in another (Deb,
//! Pratap, Agarwal, Meyarivan 2002), with simulated binary crossover and polynomial mutation (Deb, Agrawal 1995).

use katydid_elementary::Elementary;

use super::search::{Random, Scored, Search};

/// How near children come to their parents by crossover; larger is nearer. As in the paper's experiments and pymoo.
const CROSSOVER_INDEX: f64 = 15.0;
/// How small mutations are.
const MUTATION_INDEX: f64 = 20.0;
/// How often two parents are crossed.
const CROSSOVER: f64 = 0.9;

/// The state of a search for the front of several goals, or the least of one.
#[derive(Debug, Clone)]
pub(super) struct Nsga2 {
    n: usize,
    size: usize,
    random: Random,
    start: Option<Vec<f64>>,
    population: Vec<Ranked>,
}

#[derive(Debug, Clone)]
struct Ranked {
    scored: Scored,
    rank: usize,
    /// How far its neighbours on the front are apart.
    crowding: f64,
}

impl Nsga2 {
    /// A search in `n` inputs with a population of `size`, whose first member is `start`.
    pub(super) fn new(start: Vec<f64>, size: usize, seed: u64) -> Self {
        let size = size.max(4).next_multiple_of(2);
        Self { n: start.len(), size, random: Random::new(seed), start: Some(start), population: Vec::new() }
    }

    /// The better of two members by chance: of the better front, or where fewer others are.
    fn parent(&mut self) -> Vec<f64> {
        let [a, b] = [0, 1].map(|_| self.random.below(self.population.len()));
        let (Some(first), Some(last)) = (self.population.get(a), self.population.get(b)) else {
            return vec![0.5; self.n];
        };
        let first_wins =
            first.rank < last.rank || (first.rank == last.rank && first.crowding >= last.crowding);
        if first_wins { first.scored.place.clone() } else { last.scored.place.clone() }
    }

    fn crossed(&mut self, a: &mut [f64], b: &mut [f64]) {
        if self.random.unit() >= CROSSOVER {
            return;
        }
        for (x, y) in a.iter_mut().zip(b) {
            let (half, swap, u) = (self.random.unit() < 0.5, self.random.unit() < 0.5, self.random.unit());
            if !half || (*x - *y).abs() < 1e-14 {
                continue;
            }
            let (low, high) = (x.min(*y), x.max(*y));
            let child = |room: f64, u: f64| {
                let beta = 1.0 + 2.0 * room / (high - low);
                let alpha = 2.0 - beta.raised_to(-(CROSSOVER_INDEX + 1.0));
                let power = 1.0 / (CROSSOVER_INDEX + 1.0);
                if u <= 1.0 / alpha {
                    (u * alpha).raised_to(power)
                } else {
                    (1.0 / (2.0 - u * alpha)).raised_to(power)
                }
            };
            let middle = 0.5 * (low + high);
            let first = (middle - 0.5 * child(low, u) * (high - low)).clamp(0.0, 1.0);
            let last = (middle + 0.5 * child(1.0 - high, u) * (high - low)).clamp(0.0, 1.0);
            (*x, *y) = if swap { (last, first) } else { (first, last) };
        }
    }

    #[allow(clippy::cast_precision_loss, reason = "few inputs")]
    fn mutated(&mut self, x: &mut [f64]) {
        let chance = 1.0 / x.len().max(1) as f64;
        for x in x {
            let (hit, u) = (self.random.unit() < chance, self.random.unit());
            if !hit {
                continue;
            }
            let power = 1.0 / (MUTATION_INDEX + 1.0);
            let index = MUTATION_INDEX + 1.0;
            let step = if u < 0.5 {
                (2.0 * u + (1.0 - 2.0 * u) * (1.0 - *x).raised_to(index)).raised_to(power) - 1.0
            } else {
                1.0 - (2.0 * (1.0 - u) + (2.0 * u - 1.0) * x.raised_to(index)).raised_to(power)
            };
            *x = (*x + step).clamp(0.0, 1.0);
        }
    }
}

impl Search for Nsga2 {
    fn ask(&mut self) -> Vec<Vec<f64>> {
        let mut asked: Vec<Vec<f64>> = self.start.take().into_iter().collect();
        if self.population.is_empty() {
            while asked.len() < self.size {
                asked.push((0..self.n).map(|_| self.random.unit()).collect());
            }
            return asked;
        }
        while asked.len() < self.size {
            let (mut a, mut b) = (self.parent(), self.parent());
            self.crossed(&mut a, &mut b);
            self.mutated(&mut a);
            self.mutated(&mut b);
            asked.extend([a, b]);
        }
        asked
    }

    fn tell(&mut self, scored: Vec<Scored>) {
        let mut all: Vec<Scored> =
            std::mem::take(&mut self.population).into_iter().map(|m| m.scored).collect();
        // The same point twice would crowd out others.
        for new in scored {
            if !all.iter().any(|old| old.place == new.place) {
                all.push(new);
            }
        }
        for (rank, front) in fronts(&all).into_iter().enumerate() {
            let mut members: Vec<Ranked> = crowded(&all, &front)
                .into_iter()
                .filter_map(|(at, crowding)| Some(Ranked { scored: all.get(at)?.clone(), rank, crowding }))
                .collect();
            let room = self.size.saturating_sub(self.population.len());
            if members.len() > room {
                members.sort_by(|a, b| b.crowding.total_cmp(&a.crowding));
                members.truncate(room);
            }
            self.population.extend(members);
            if self.population.len() >= self.size {
                break;
            }
        }
    }
}

/// Whether `a` is in no goal worse than `b` and in one better; constraints go before goals.
pub(super) fn dominates(a: &Scored, b: &Scored) -> bool {
    if a.missed > 0.0 || b.missed > 0.0 {
        return a.missed < b.missed;
    }
    let pairs = || a.goals.iter().zip(&b.goals);
    pairs().all(|(a, b)| a <= b) && pairs().any(|(a, b)| a < b)
}

/// The places of the members front by front, the best first.
fn fronts(all: &[Scored]) -> Vec<Vec<usize>> {
    let mut better = vec![0_usize; all.len()];
    let mut worse: Vec<Vec<usize>> = vec![Vec::new(); all.len()];
    for (at, a) in all.iter().enumerate() {
        for (other, b) in all.iter().enumerate() {
            if dominates(a, b) {
                worse[at].push(other);
                better[other] += 1;
            }
        }
    }
    let mut fronts = Vec::new();
    let mut front: Vec<usize> = (0..all.len()).filter(|at| better[*at] == 0).collect();
    while !front.is_empty() {
        let mut next = Vec::new();
        for at in &front {
            for other in &worse[*at] {
                better[*other] -= 1;
                if better[*other] == 0 {
                    next.push(*other);
                }
            }
        }
        next.sort_unstable();
        fronts.push(std::mem::replace(&mut front, next));
    }
    fronts
}

/// The members of a front with the sum, over the goals, of how far their neighbours are apart; infinite at the ends.
fn crowded(all: &[Scored], front: &[usize]) -> Vec<(usize, f64)> {
    let goals = front.first().and_then(|at| all.get(*at)).map_or(0, |scored| scored.goals.len());
    let mut crowding = vec![0.0_f64; front.len()];
    for goal in 0..goals {
        let value = |k: usize| all[front[k]].goals[goal];
        let mut sorted: Vec<usize> = (0..front.len()).collect();
        sorted.sort_by(|a, b| value(*a).total_cmp(&value(*b)));
        let (Some(first), Some(last)) = (sorted.first(), sorted.last()) else { continue };
        let range = value(*last) - value(*first);
        (crowding[*first], crowding[*last]) = (f64::INFINITY, f64::INFINITY);
        if range > 0.0 && range.is_finite() {
            for w in sorted.windows(3) {
                crowding[w[1]] += (value(w[2]) - value(w[0])) / range;
            }
        }
    }
    front.iter().copied().zip(crowding).collect()
}
