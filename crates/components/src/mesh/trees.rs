//! Meshes prepared for many questions, kept over a run: the same mesh meets many points, rays and meshes.

use std::cell::{OnceCell, RefCell};
use std::rc::Rc;
use std::sync::Arc as Shared;

use katydid_component::{Context, Message};
use katydid_geometry::{Mesh, MeshTree};

/// The meshes asked for last.
const KEPT: usize = 32;

/// A mesh and its tree.
pub(crate) struct Prepared {
    mesh: Shared<Mesh>,
    /// The tree over its faces.
    pub(crate) tree: MeshTree,
    closed: OnceCell<bool>,
}

impl Prepared {
    /// Whether the mesh is closed.
    pub(crate) fn is_closed(&self) -> bool {
        *self.closed.get_or_init(|| self.mesh.is_closed())
    }
}

/// The tree over a mesh, made when it is asked for the first time in this run.
pub(crate) fn tree_of(context: &Context<'_>, mesh: &Shared<Mesh>) -> Result<Rc<Prepared>, Message> {
    let kept = context.prepared(|| Ok(RefCell::<Vec<Rc<Prepared>>>::default()))?;
    // The entries hold their meshes, so that no other can come to lie in the same place.
    if let Some(found) = kept.borrow().iter().find(|p| Shared::ptr_eq(&p.mesh, mesh)) {
        return Ok(found.clone());
    }
    context.check()?;
    let made = Rc::new(Prepared { mesh: mesh.clone(), tree: MeshTree::new(mesh), closed: OnceCell::new() });
    let mut kept = kept.borrow_mut();
    if kept.len() >= KEPT {
        kept.remove(0);
    }
    kept.push(made.clone());
    Ok(made)
}
