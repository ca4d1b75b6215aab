//! Breps prepared for many questions, kept over a run: the same Brep meets many points.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc as Shared;

use katydid_component::{Context, Message};
use katydid_geometry::Brep;
use katydid_geometry::brep::ClosestOnBrep;

use super::warning;

/// The Breps asked for last.
const KEPT: usize = 32;

struct Entry {
    brep: Shared<Brep>,
    search: Rc<ClosestOnBrep>,
}

/// What finds nearest points of a Brep and points inside, made when it is asked for the first time in this run.
pub(crate) fn prepared(context: &Context<'_>, brep: &Shared<Brep>) -> Result<Rc<ClosestOnBrep>, Message> {
    let kept = context.prepared(|| Ok(RefCell::<Vec<Entry>>::default()))?;
    // The entries hold their breps, so that no other can come to lie in the same place.
    let same = |entry: &&Entry| Shared::ptr_eq(&entry.brep, brep) || *entry.brep == **brep;
    if let Some(found) = kept.borrow().iter().find(same) {
        return Ok(found.search.clone());
    }
    context.check()?;
    let search = Rc::new(ClosestOnBrep::new(brep.clone()).map_err(warning)?);
    let mut kept = kept.borrow_mut();
    if kept.len() >= KEPT {
        kept.remove(0);
    }
    kept.push(Entry { brep: brep.clone(), search: search.clone() });
    Ok(search)
}
