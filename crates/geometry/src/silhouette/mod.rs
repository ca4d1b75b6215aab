//! Silhouettes: the curves that bound what is seen of Breps and meshes, and the edges between.
//!
//! The names of the kinds are those of RhinoCommon's `SilhouetteType`.

mod edge;
mod face;
mod form;
mod mesh;
mod round;
mod thresholds;
mod viewpoint;

pub use viewpoint::Viewpoint;

use std::sync::Arc as Shared;

use crate::brep::ClosestOnBrep;
use crate::{Brep, Curve, Error, Mesh, Result, Tolerance};

/// What a curve is for the picture of its object.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum SilhouetteKind {
    /// The end of a region that is seen edge-on: the line of sight is tangent all over it.
    Projecting,
    /// A smooth surface turns away: the line of sight is tangent along the curve.
    Tangent,
    /// A crease of which one side is seen from the front and the other from behind.
    Crease,
    /// Where the object ends.
    Boundary,
    /// A crease both sides of which are seen from the front, or both from behind.
    NonSilhouetteCrease,
    /// An edge without a crease.
    NonSilhouetteTangent,
    /// An edge without a crease where one surface meets itself.
    NonSilhouetteSeam,
    /// Where a clipping plane cuts.
    SectionCut,
    /// A curve that is an object itself.
    MiscellaneousFeature,
}

impl SilhouetteKind {
    /// The name, as `SilhouetteType` has it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Projecting => "Projecting",
            Self::Tangent => "Tangent",
            Self::Crease => "Crease",
            Self::Boundary => "Boundary",
            Self::NonSilhouetteCrease => "NonSilhouetteCrease",
            Self::NonSilhouetteTangent => "NonSilhouetteTangent",
            Self::NonSilhouetteSeam => "NonSilhouetteSeam",
            Self::SectionCut => "SectionCut",
            Self::MiscellaneousFeature => "MiscellaneousFeature",
        }
    }

    /// Whether what is seen may end there.
    pub fn is_silhouette(self) -> bool {
        !matches!(
            self,
            Self::NonSilhouetteCrease
                | Self::NonSilhouetteTangent
                | Self::NonSilhouetteSeam
                | Self::MiscellaneousFeature
        )
    }
}

/// What a silhouette is a part of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SilhouettePart {
    /// It runs across a face.
    Face(usize),
    /// It is an edge of a Brep, or a part of it.
    Edge(usize),
    /// It is an edge of a mesh, by its place in [`Mesh::edges`].
    MeshEdge(usize),
}

/// A curve of the picture, in space.
#[derive(Debug, Clone, PartialEq)]
pub struct Silhouette {
    /// The curve.
    pub curve: Curve,
    /// What it is.
    pub kind: SilhouetteKind,
    /// What it is a part of.
    pub part: SilhouettePart,
}

/// The silhouettes and edges of an object.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Silhouettes {
    /// The curves: edges first, each in as many parts as it changes its kind, then the curves across faces.
    pub curves: Vec<Silhouette>,
    /// Whether the search came to its end on every face.
    pub complete: bool,
}

impl Brep {
    /// The silhouettes and all edges of the Brep as seen from a viewpoint.
    ///
    /// Across a face runs the zero set of N·(towards the viewer), a Bernstein polynomial over each Bézier patch, found as
    /// [`surface_plane`](crate::intersect::surface_plane) finds sections, clipped to the trims and fitted within
    /// `tolerance`: lines, arcs and circles where it is such to rounding. Those of spheres, cylinders and cones are
    /// written down. An edge is told by the sides from which the
    /// faces beside it are seen; normals that differ by no more than `tolerance.angle` make no crease. `go_on` is asked
    /// again and again; where it says no the work stops.
    ///
    /// # Errors
    /// The viewpoint or the tolerance is not finite, the tolerance not above 0, the Brep has no faces, the work was
    /// stopped, or a number overflows.
    pub fn silhouettes(
        &self,
        viewpoint: Viewpoint,
        tolerance: &Tolerance,
        go_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<Silhouettes> {
        silhouettes_of(&ClosestOnBrep::new(Shared::new(self.clone()))?, viewpoint, tolerance, go_on)
    }
}

/// [`Brep::silhouettes`] of a Brep that is prepared already.
///
/// # Errors
/// As there.
pub fn silhouettes_of(
    search: &ClosestOnBrep,
    viewpoint: Viewpoint,
    tolerance: &Tolerance,
    go_on: &(dyn Fn() -> bool + Sync),
) -> Result<Silhouettes> {
    tolerance.positive_distance()?;
    let viewpoint = viewpoint.checked()?;
    let mut out = Silhouettes { curves: Vec::new(), complete: true };
    let brep = search.brep();
    for edge in 0..brep.edges().len() {
        go_on_or_stop(go_on)?;
        out.curves.extend(edge::silhouettes(brep, edge, viewpoint, tolerance)?);
    }
    let faces: Vec<usize> = (0..brep.faces().len()).collect();
    for found in each(&faces, |&face| {
        go_on_or_stop(go_on)?;
        face::silhouettes(search, face, viewpoint, tolerance)
    })? {
        out.curves.extend(found.curves);
        out.complete &= found.complete;
    }
    Ok(out)
}

impl Mesh {
    /// The silhouettes, creases and naked edges of the mesh as seen from a viewpoint, each edge a line.
    ///
    /// An edge between a face that is seen from the front and one from behind is a silhouette: a crease where it is one,
    /// else tangent. A crease is an edge along which the faces use vertices of their own, and turn by more than
    /// `tolerance.angle`. Other edges are none of the picture.
    ///
    /// # Errors
    /// The viewpoint is not finite or has no direction.
    pub fn silhouettes(&self, viewpoint: Viewpoint, tolerance: &Tolerance) -> Result<Silhouettes> {
        Ok(Silhouettes { curves: mesh::silhouettes(self, viewpoint.checked()?, tolerance), complete: true })
    }
}

/// An answer for each item, in parallel where the kernel runs so.
pub(crate) fn each<T: Sync, R: Send>(
    items: &[T],
    work: impl Fn(&T) -> Result<R> + Sync + Send,
) -> Result<Vec<R>> {
    crate::parallel::each(items, work).into_iter().collect()
}

/// An error where the work is to stop.
pub(crate) fn go_on_or_stop(go_on: &(dyn Fn() -> bool + Sync)) -> Result<()> {
    if go_on() { Ok(()) } else { Err(Error::Stopped) }
}
