//! Whole columns at once, for components that millions of items go through.
//!
//! A component with `columns = function` in its attribute is asked this way first. The function gives `None` where
//! the data is not as plain as it needs, and the ordinary loop runs; the results are the same either way.

use std::borrow::Cow;
use std::ops::Range;

use katydid_data::{Item, Tree};

use crate::matching::{Matching, Ranges};
use crate::{Access, Call, Outcome};

/// A piece that is worth a thread.
const PIECE: usize = 16 * 1024;

/// Every item of input 0 through `f`, as output 0 at the same paths; empty trees on the other outputs. `None` when
/// the input is not plainly of type `A`, an item is null, `f` gives nothing for one, or the budget does not allow it.
pub fn map<A: Item, B: Item>(call: &Call<'_>, f: impl Fn(&A) -> Option<B> + Sync) -> Option<Outcome> {
    let tree = call.inputs.first()?;
    let column = tree.column();
    if column.has_nulls() || call.settings.i32("PrincipalIndex").is_some() {
        return None;
    }
    let items = A::slice(column)?;
    // The loop that runs instead says why.
    call.budget.check().ok()?;
    let results = collect(items, f)?;
    call.budget.items(results.len()).ok()?;
    let mut outputs = vec![Tree::empty(); call.output_count];
    *outputs.first_mut()? = tree.with_column(B::column(results, None));
    Some(Outcome { outputs, messages: Vec::new() })
}

#[cfg(feature = "parallel")]
fn collect<A: Item, B: Item>(items: &[A], f: impl Fn(&A) -> Option<B> + Sync) -> Option<Vec<B>> {
    use rayon::prelude::*;
    if items.len() < 2 * PIECE || rayon::current_num_threads() == 1 {
        return items.iter().map(f).collect();
    }
    let mut results = vec![B::placeholder(); items.len()];
    let pieces = results.par_chunks_mut(PIECE).zip(items.par_chunks(PIECE));
    let whole = pieces.map(|(results, items)| {
        results.iter_mut().zip(items).try_for_each(|(result, item)| {
            *result = f(item)?;
            Some(())
        })
    });
    whole.all(|piece| piece.is_some()).then_some(results)
}

#[cfg(not(feature = "parallel"))]
fn collect<A: Item, B: Item>(items: &[A], f: impl Fn(&A) -> Option<B> + Sync) -> Option<Vec<B>> {
    items.iter().map(f).collect()
}

/// Numbers of all inputs through `f`, as output 0: it takes a slice of each input and a count, and gives so many results;
/// a slice has as many numbers, or the one that serves for all. Inputs have the same branches, or a single item. `None`
/// when the data is not that plain, `f` gives `None` for a piece, or the budget does not allow it.
pub fn numbers(call: &Call<'_>, f: impl Fn(&[&[f64]], usize) -> Option<Vec<f64>> + Sync) -> Option<Outcome> {
    of_columns(call, call.inputs.iter().map(borrowed).collect::<Option<_>>()?, f)
}

/// The same where some of the inputs, but not all, may be integers: they count as numbers.
pub fn reals(call: &Call<'_>, f: impl Fn(&[&[f64]], usize) -> Option<Vec<f64>> + Sync) -> Option<Outcome> {
    call.inputs.iter().find(|tree| f64::slice(tree.column()).is_some())?;
    of_columns(
        call,
        call.inputs.iter().map(|tree| borrowed(tree).or_else(|| converted(tree))).collect::<Option<_>>()?,
        f,
    )
}

/// The numbers of a tree as they lie.
fn borrowed(tree: &Tree) -> Option<Cow<'_, [f64]>> {
    f64::slice(tree.column()).map(Cow::Borrowed)
}

/// The integers of a tree as numbers.
fn converted(tree: &Tree) -> Option<Cow<'_, [f64]>> {
    i32::slice(tree.column()).map(|all| all.iter().map(|&i| f64::from(i)).collect())
}

fn of_columns(
    call: &Call<'_>,
    columns: Vec<Cow<'_, [f64]>>,
    f: impl Fn(&[&[f64]], usize) -> Option<Vec<f64>> + Sync,
) -> Option<Outcome> {
    let lead = lead(call)?;
    let n = lead.item_count();
    let results = pieces(n, |range, results| {
        let slices: Option<Vec<&[f64]>> = columns.iter().map(|column| part(column, n, &range)).collect();
        let found = f(&slices?, results.len()).filter(|found| found.len() == results.len())?;
        results.copy_from_slice(&found);
        Some(())
    })?;
    let mut outputs = vec![Tree::empty(); call.output_count];
    *outputs.first_mut()? = lead.with_column(f64::column(results, None));
    Some(Outcome { outputs, messages: Vec::new() })
}

/// The items of two inputs through `f`, as output 0, for each place where two of them meet.
pub fn two<A: Item + Copy, B: Item + Copy, R: Item>(
    call: &Call<'_>,
    f: impl Fn(A, B) -> R + Sync,
) -> Option<Outcome> {
    let [a, b] = call.inputs else { return None };
    let (a, b) = (A::slice(a.column())?, B::slice(b.column())?);
    each(call, |i| Some(f(at(a, i)?, at(b, i)?)))
        .or_else(|| matched(call, |[i, j]| Some(f(*a.get(i)?, *b.get(j)?))))
}

/// The items of three inputs through `f`, as output 0, for each place where three of them meet.
pub fn three<A: Item + Copy, B: Item + Copy, C: Item + Copy, R: Item>(
    call: &Call<'_>,
    f: impl Fn(A, B, C) -> R + Sync,
) -> Option<Outcome> {
    let [a, b, c] = call.inputs else { return None };
    let (a, b, c) = (A::slice(a.column())?, B::slice(b.column())?, C::slice(c.column())?);
    each(call, |i| Some(f(at(a, i)?, at(b, i)?, at(c, i)?)))
        .or_else(|| matched(call, |[i, j, k]| Some(f(*a.get(i)?, *b.get(j)?, *c.get(k)?))))
}

/// Item `i` of a column, or the one that serves for all.
fn at<T: Copy>(column: &[T], i: usize) -> Option<T> {
    column.get(i).or(column.first()).copied()
}

/// A result for each place of the input that leads.
fn each<R: Item>(call: &Call<'_>, f: impl Fn(usize) -> Option<R> + Sync) -> Option<Outcome> {
    let lead = lead(call)?;
    let results = filled(lead.item_count(), f)?;
    let mut outputs = vec![Tree::empty(); call.output_count];
    *outputs.first_mut()? = lead.with_column(R::column(results, None));
    Some(Outcome { outputs, messages: Vec::new() })
}

/// A result for each place where items of all inputs meet: `f` is given where they lie in their columns. `None` where an
/// input is empty or has nulls, the matching is another, or the budget does not allow it.
fn matched<const N: usize, R: Item>(
    call: &Call<'_>,
    f: impl Fn([usize; N]) -> Option<R> + Sync,
) -> Option<Outcome> {
    let is_plain = |tree: &Tree| tree.item_count() > 0 && !tree.column().has_nulls();
    if call.inputs.len() != N
        || call.settings.i32("PrincipalIndex").is_some()
        || !call.inputs.iter().all(is_plain)
    {
        return None;
    }
    call.budget.bytes(Matching::bytes(call.inputs)).ok()?;
    call.budget.check().ok()?;
    let matching = Matching::new(call.inputs, &[Access::Item; N], None);
    let total = matching.iterations();
    call.budget.items(total).ok()?;
    let results = matched_pieces(&matching, total, f)?;
    let mut outputs = vec![Tree::empty(); call.output_count];
    *outputs.first_mut()? =
        Tree::from_parts(matching.paths.clone(), matching.ends.clone(), R::column(results, None));
    Some(Outcome { outputs, messages: Vec::new() })
}

fn matched_pieces<const N: usize, R: Item>(
    matching: &Matching<'_>,
    total: usize,
    f: impl Fn([usize; N]) -> Option<R> + Sync,
) -> Option<Vec<R>> {
    #[cfg(feature = "parallel")]
    if total >= 2 * PIECE && rayon::current_num_threads() > 1 {
        use rayon::prelude::*;
        let mut results = vec![R::placeholder(); total];
        let fill = |(k, piece): (usize, &mut [R])| {
            let start = k * PIECE;
            let mut places = piece.iter_mut();
            for_each_meeting(matching, start..start + places.len(), |at| {
                *places.next()? = f(at)?;
                Some(())
            })
        };
        let filled = results.par_chunks_mut(PIECE).enumerate().map(fill);
        return filled.all(|piece| piece.is_some()).then_some(results);
    }
    let mut results = Vec::with_capacity(total);
    for_each_meeting(matching, 0..total, |at| {
        results.push(f(at)?);
        Some(())
    })?;
    Some(results)
}

/// Calls `f` for a run of iterations with the places of their items in the columns of the inputs; ends where it gives
/// `None`.
fn for_each_meeting<const N: usize>(
    matching: &Matching<'_>,
    run: Range<usize>,
    mut f: impl FnMut([usize; N]) -> Option<()>,
) -> Option<()> {
    let mut ranges = Ranges::new();
    let mut set = matching.set_of(run.start);
    let mut at = run.start;
    while at < run.end {
        let iterations = matching.set_range(set);
        matching.ranges(set, &mut ranges);
        let mut first = [0; N];
        let mut last = [0; N];
        for ((first, last), range) in first.iter_mut().zip(&mut last).zip(&ranges) {
            (*first, *last) = (range.start, range.end.saturating_sub(1));
        }
        for i in at..iterations.end.min(run.end) {
            let step = i - iterations.start;
            // The last one again where a list is shorter than the others.
            f(std::array::from_fn(|k| (first[k] + step).min(last[k])))?;
        }
        at = iterations.end.max(at);
        set += 1;
    }
    Some(())
}

fn filled<R: Item>(n: usize, f: impl Fn(usize) -> Option<R> + Sync) -> Option<Vec<R>> {
    #[cfg(feature = "parallel")]
    if n >= 2 * PIECE && rayon::current_num_threads() > 1 {
        use rayon::prelude::*;
        let mut results = vec![R::placeholder(); n];
        let fill = |(k, piece): (usize, &mut [R])| {
            piece.iter_mut().enumerate().try_for_each(|(i, result)| {
                *result = f(k * PIECE + i)?;
                Some(())
            })
        };
        let filled = results.par_chunks_mut(PIECE).enumerate().map(fill);
        return filled.all(|piece| piece.is_some()).then_some(results);
    }
    let mut results = Vec::with_capacity(n);
    for i in 0..n {
        results.push(f(i)?);
    }
    Some(results)
}

/// The input that gives the paths and the number of results, where the others have the same branches or a single item
/// that serves for all. `None` where there are nulls, the matching is another, or the budget does not allow it: the loop
/// that runs instead says why.
fn lead<'a>(call: &Call<'a>) -> Option<&'a Tree> {
    if call.settings.i32("PrincipalIndex").is_some()
        || call.inputs.iter().any(|tree| tree.column().has_nulls())
    {
        return None;
    }
    let lead = call.inputs.iter().max_by_key(|tree| (tree.item_count(), tree.branch_count()))?;
    let same = |tree: &Tree| {
        tree.paths() == lead.paths() && (0..tree.branch_count()).all(|b| tree.range(b) == lead.range(b))
    };
    // A single item does not give the paths: there are fewer branches of it, or its path is as long at most.
    let serves = |tree: &Tree| {
        let path = |tree: &Tree| tree.paths().first().cloned();
        let (own, leading) = (path(tree), path(lead));
        tree.item_count() == 1
            && tree.branch_count() == 1
            && (lead.branch_count() > 1 || own == leading || own.map(|p| p.len()) < leading.map(|p| p.len()))
    };
    if !call.inputs.iter().all(|tree| same(tree) || serves(tree)) {
        return None;
    }
    call.budget.check().ok()?;
    call.budget.items(lead.item_count()).ok()?;
    Some(lead)
}

/// The numbers of a column that belong to a range of the results; all of one that serves for all.
fn part<'a>(column: &'a [f64], n: usize, range: &Range<usize>) -> Option<&'a [f64]> {
    if column.len() == n { column.get(range.clone()) } else { Some(column) }
}

/// Fills `n` numbers piece by piece; `None` when a piece gives `None`.
fn pieces(n: usize, fill: impl Fn(Range<usize>, &mut [f64]) -> Option<()> + Sync) -> Option<Vec<f64>> {
    let mut results = vec![0.0; n];
    let fill = |(k, piece): (usize, &mut [f64])| fill(k * PIECE..k * PIECE + piece.len(), piece);
    #[cfg(feature = "parallel")]
    if n >= 2 * PIECE && rayon::current_num_threads() > 1 {
        use rayon::prelude::*;
        let filled = results.par_chunks_mut(PIECE).enumerate().map(fill);
        return filled.all(|piece| piece.is_some()).then_some(results);
    }
    results.chunks_mut(PIECE).enumerate().try_for_each(fill)?;
    Some(results)
}

/// The one item of input `k`, when it has just one and input 0 gives the paths.
pub fn constant<T: Item>(call: &Call<'_>, k: usize) -> Option<T> {
    let (first, tree) = (call.inputs.first()?, call.inputs.get(k)?);
    let length = |tree: &Tree| tree.paths().first().map_or(0, katydid_data::Path::len);
    let leads = first.branch_count() > 1 || length(first) >= length(tree);
    if tree.item_count() == 1 && tree.branch_count() == 1 && leads { T::get(tree.column(), 0) } else { None }
}
