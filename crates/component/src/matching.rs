//! Which items meet in an iteration, and at which path its results go.
//!
//! A component runs once per branch set: as many as the input with the most branches has, and an input with
//! fewer gives its last branch again. Inside a set it runs once per item set, in the same manner. Branches are
//! matched by their order, not by their paths.

use std::ops::Range;
use std::sync::Arc;

use katydid_data::{Path, Tree};
use smallvec::SmallVec;

use crate::Access;

/// Where the branch of each input lies in its column.
pub type Ranges = SmallVec<[Range<usize>; 8]>;

/// The plan of all iterations of one run.
#[derive(Debug)]
pub struct Matching<'a> {
    /// The path of each branch set.
    pub(crate) paths: Arc<Vec<Path>>,
    /// Where the iterations of each branch set end, counted over all sets.
    pub(crate) ends: Arc<Vec<usize>>,
    /// Whether any input takes items, so that lists grow a path element.
    pub(crate) grows: bool,
    inputs: &'a [Tree],
}

/// Numbers that are mostly those of a tree that is there already: its own are shared as long as they agree.
struct Ends<'a> {
    shared: Option<&'a Arc<Vec<usize>>>,
    own: Vec<usize>,
    /// How many agree so far.
    agree: usize,
}

impl Ends<'_> {
    fn push(&mut self, end: usize, count: usize) {
        if let Some(shared) = self.shared {
            if shared.get(self.agree) == Some(&end) {
                self.agree += 1;
                return;
            }
            self.own.reserve_exact(count);
            self.own.extend(shared.iter().take(self.agree));
            self.shared = None;
        }
        self.own.push(end);
    }

    fn finish(self) -> Arc<Vec<usize>> {
        match self.shared {
            Some(shared) if shared.len() == self.agree => shared.clone(),
            Some(shared) => Arc::new(shared.iter().take(self.agree).copied().collect()),
            None => Arc::new(self.own),
        }
    }
}

impl<'a> Matching<'a> {
    /// The most bytes that the plan takes; to be asked for before it is made.
    pub(crate) fn bytes(inputs: &[Tree]) -> usize {
        let sets = inputs.iter().map(Tree::branch_count).max().unwrap_or(1);
        sets.saturating_mul(size_of::<usize>())
    }

    /// Matches the inputs that do not take whole trees. An input without any data is left out: the caller has
    /// made sure that it is optional. `principal` overrides the choice of the input that gives the paths.
    pub fn new(inputs: &'a [Tree], access: &[Access], principal: Option<usize>) -> Self {
        let takes_part = |k: usize| access.get(k).is_some_and(|a| *a != Access::Tree);
        let takes_items = |k: usize| access.get(k) == Some(&Access::Item);
        let matched: Vec<usize> =
            (0..inputs.len()).filter(|&k| takes_part(k) && !inputs[k].is_empty()).collect();
        let grows = (0..inputs.len()).any(takes_items);
        let sets = matched.iter().map(|&k| inputs[k].branch_count()).max().unwrap_or(1);
        let master = principal
            .filter(|k| matched.contains(k) && inputs[*k].branch_count() == sets)
            .or_else(|| Self::master(inputs, &matched));
        let paths = match master {
            Some(k) => inputs[k].shared_paths().clone(),
            None => Arc::new(vec![Path::zero()]),
        };
        let mut ends = Ends { shared: master.map(|k| inputs[k].shared_ends()), own: Vec::new(), agree: 0 };
        let mut total = 0;
        for set in 0..sets {
            let mut longest = 1;
            let mut starved = false;
            for (k, tree) in inputs.iter().enumerate() {
                if takes_items(k) && !tree.is_empty() {
                    let range = range(tree, set);
                    longest = longest.max(range.len());
                    starved |= range.is_empty();
                }
            }
            total += if starved { 0 } else { longest };
            ends.push(total, sets);
        }
        Self { paths, ends: ends.finish(), grows, inputs }
    }

    /// The input whose paths the results get: the most branches, then the longest paths, then the first.
    fn master(inputs: &[Tree], matched: &[usize]) -> Option<usize> {
        let rank = |k: usize| (inputs[k].branch_count(), inputs[k].paths().first().map_or(0, Path::len));
        let mut best: Option<usize> = None;
        for &k in matched {
            if best.is_none_or(|b| rank(k) > rank(b)) {
                best = Some(k);
            }
        }
        best
    }

    /// The path of each branch set.
    pub fn paths(&self) -> &[Path] {
        &self.paths
    }

    /// The number of iterations over all branch sets.
    pub fn iterations(&self) -> usize {
        self.ends.last().copied().unwrap_or(0)
    }

    /// Where the branches of branch set `set` lie, one for each input.
    pub fn ranges(&self, set: usize, ranges: &mut Ranges) {
        ranges.clear();
        ranges.extend(self.inputs.iter().map(|tree| range(tree, set)));
    }

    /// Where iterations of branch set `set` lie among all.
    pub fn set_range(&self, set: usize) -> Range<usize> {
        let start = if set == 0 { 0 } else { self.ends.get(set - 1).copied().unwrap_or(0) };
        start..self.ends.get(set).copied().unwrap_or(start)
    }

    /// The branch set that iteration `i` belongs to.
    pub fn set_of(&self, i: usize) -> usize {
        self.ends.partition_point(|&end| end <= i)
    }
}

/// Where the branch of a tree lies that meets branch set `set`: its last one again when it has fewer.
fn range(tree: &Tree, set: usize) -> Range<usize> {
    match tree.branch_count() {
        0 => 0..0,
        count => tree.range(set.min(count - 1)),
    }
}
