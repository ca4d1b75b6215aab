//! Whole columns at once, for components that millions of items go through.
//!
//! A component with `columns = function` in its attribute is asked this way first. The function gives `None` where
//! the data is not as plain as it needs, and the ordinary loop runs; the results are the same either way.

use katydid_data::{Item, Tree};

use crate::{Call, Outcome};

/// A piece that is worth a thread.
#[cfg(feature = "parallel")]
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

/// The one item of input `k`, when it has just one and input 0 gives the paths.
pub fn constant<T: Item>(call: &Call<'_>, k: usize) -> Option<T> {
    let (first, tree) = (call.inputs.first()?, call.inputs.get(k)?);
    let length = |tree: &Tree| tree.paths().first().map_or(0, katydid_data::Path::len);
    let leads = first.branch_count() > 1 || length(first) >= length(tree);
    if tree.item_count() == 1 && tree.branch_count() == 1 && leads { T::get(tree.column(), 0) } else { None }
}
