//! Geometry prepared for many questions, kept over a run: the same mesh, surface or Brep meets many points and rays.

use std::cell::{OnceCell, RefCell};
use std::rc::Rc;
use std::sync::Arc as Shared;

use katydid_component::{Context, List, ListKey, Message};
use katydid_data::Item;
use katydid_geometry::brep::{ClosestOnBrep, CurveProjection};
use katydid_geometry::cloud::PointTree;
use katydid_geometry::{Brep, ClosestOnSurface, Mesh, MeshTree, Point3, Surface, SurfaceProjection, Vector3};

/// Of each kind those asked for last.
const KEPT: usize = 32;

/// Things with what was made of them. They are held here, so that no other can come to lie in the same place.
struct Shelf<S, P>(RefCell<Vec<(Shared<S>, Rc<P>)>>);

impl<S, P> Default for Shelf<S, P> {
    fn default() -> Self {
        Self(RefCell::default())
    }
}

impl<S, P> Shelf<S, P> {
    /// What was made of a thing, made now when it is asked for the first time.
    fn of(
        &self,
        context: &Context<'_>,
        thing: &Shared<S>,
        is_same: impl Fn(&S) -> bool,
        make: impl FnOnce() -> Result<P, Message>,
    ) -> Result<Rc<P>, Message> {
        let same = |(kept, _): &&(Shared<S>, Rc<P>)| Shared::ptr_eq(kept, thing) || is_same(kept);
        if let Some((_, made)) = self.0.borrow().iter().find(same) {
            return Ok(made.clone());
        }
        context.check()?;
        let made = Rc::new(make()?);
        let mut kept = self.0.borrow_mut();
        if kept.len() >= KEPT {
            kept.remove(0);
        }
        kept.push((thing.clone(), made.clone()));
        Ok(made)
    }
}

/// All that a run has prepared.
#[derive(Default)]
struct Shelves {
    meshes: Shelf<Mesh, PreparedMesh>,
    surfaces: Shelf<Surface, ClosestOnSurface>,
    breps: Shelf<Brep, ClosestOnBrep>,
    projections: Along<Brep, CurveProjection>,
    surface_projections: Along<Surface, SurfaceProjection>,
    cloud: RefCell<Option<AskedCloud>>,
}

/// The list of points that was asked last, how often, and its tree once that is worth while.
struct AskedCloud {
    key: ListKey,
    times: usize,
    tree: Option<Rc<Cloud>>,
}

fn shelves<'a>(context: &'a Context<'_>) -> Result<&'a Shelves, Message> {
    context.prepared(|| Ok(Shelves::default()))
}

/// A mesh and its tree.
pub(crate) struct PreparedMesh {
    mesh: Shared<Mesh>,
    /// The tree over its faces.
    pub(crate) tree: MeshTree,
    closed: OnceCell<bool>,
}

impl PreparedMesh {
    /// Whether the mesh is closed.
    pub(crate) fn is_closed(&self) -> bool {
        *self.closed.get_or_init(|| self.mesh.is_closed())
    }
}

/// The tree over a mesh.
pub(crate) fn mesh(context: &Context<'_>, mesh: &Shared<Mesh>) -> Result<Rc<PreparedMesh>, Message> {
    let make = || Ok(PreparedMesh { mesh: mesh.clone(), tree: MeshTree::new(mesh), closed: OnceCell::new() });
    shelves(context)?.meshes.of(context, mesh, |_| false, make)
}

/// What finds nearest points of a surface.
pub(crate) fn surface(
    context: &Context<'_>,
    surface: &Shared<Surface>,
) -> Result<Rc<ClosestOnSurface>, Message> {
    shelves(context)?.surfaces.of(context, surface, |_| false, || Ok(ClosestOnSurface::new(surface)?))
}

/// What finds nearest points of a Brep and points inside. Breps that came from one object may be told apart by their
/// parts only.
pub(crate) fn brep(context: &Context<'_>, brep: &Shared<Brep>) -> Result<Rc<ClosestOnBrep>, Message> {
    let make = || Ok(ClosestOnBrep::new(brep.clone())?);
    shelves(context)?.breps.of(context, brep, |kept| *kept == **brep, make)
}

/// What projects curves onto a Brep along a direction.
pub(crate) fn projection(
    context: &Context<'_>,
    brep: &Shared<Brep>,
    direction: Vector3,
) -> Result<Rc<CurveProjection>, Message> {
    let make = || CurveProjection::new(brep.clone(), direction).map_err(warning);
    along(&shelves(context)?.projections, direction).of(context, brep, |kept| *kept == **brep, make)
}

/// What projects curves onto a surface along a direction.
pub(crate) fn projection_onto(
    context: &Context<'_>,
    surface: &Shared<Surface>,
    direction: Vector3,
) -> Result<Rc<SurfaceProjection>, Message> {
    let make = || SurfaceProjection::new(surface.clone(), direction).map_err(warning);
    along(&shelves(context)?.surface_projections, direction).of(context, surface, |_| false, make)
}

fn warning(error: katydid_geometry::Error) -> Message {
    Message::warning(error.to_string())
}

/// Shelves by direction.
type Along<S, P> = RefCell<Vec<(Vector3, Rc<Shelf<S, P>>)>>;

/// The shelf of what was made along a direction.
fn along<S, P>(shelves: &Along<S, P>, direction: Vector3) -> Rc<Shelf<S, P>> {
    let mut shelves = shelves.borrow_mut();
    if let Some((_, shelf)) = shelves.iter().find(|(other, _)| *other == direction) {
        return shelf.clone();
    }
    if shelves.len() >= KEPT {
        shelves.remove(0);
    }
    let shelf = Rc::new(Shelf::default());
    shelves.push((direction, shelf.clone()));
    shelf
}

/// The points of a list in a tree.
pub(crate) struct Cloud {
    tree: PointTree,
    /// The place in the list of each point of the tree.
    places: Vec<usize>,
}

impl Cloud {
    /// The place of the point nearest to a point, of equally near ones the first.
    pub(crate) fn closest(&self, point: Point3) -> Option<usize> {
        self.places.get(self.tree.closest(point)?).copied()
    }

    /// The places of the points nearest to a point, at most `count`, the nearest first, of equally near ones the first.
    pub(crate) fn nearest(&self, point: Point3, count: usize) -> Vec<usize> {
        let found = self.tree.nearest(point, count, [0.0, f64::INFINITY], None);
        found.into_iter().filter_map(|i| self.places.get(i).copied()).collect()
    }
}

/// So many questions are answered by looking at every point.
const FEW: usize = 8;

/// A list of points as a tree, once it was asked a few times; `None` before, and where a point is not finite.
///
/// # Errors
/// The solve was stopped.
pub(crate) fn cloud<T: Item>(
    context: &Context<'_>,
    list: &List<'_, T>,
    point: impl Fn(T) -> Option<Point3>,
) -> Result<Option<Rc<Cloud>>, Message> {
    let mut asked = shelves(context)?.cloud.borrow_mut();
    let key = list.key();
    match asked.as_mut().filter(|last| last.key == key) {
        None => *asked = Some(AskedCloud { key, times: 1, tree: None }),
        Some(last) => {
            last.times += 1;
            if last.times == FEW {
                context.check()?;
                let points = list.iter().enumerate().filter_map(|(i, item)| Some((i, point(item?)?)));
                let (places, points): (Vec<usize>, Vec<Point3>) = points.unzip();
                last.tree = PointTree::new(&points).ok().map(|tree| Rc::new(Cloud { tree, places }));
            }
            return Ok(last.tree.clone());
        }
    }
    Ok(None)
}
