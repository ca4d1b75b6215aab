//! Subdivision surfaces of Catmull and Clark (1978) by their control nets, with the tags, creases and sharpness of
//! Rhino's SubD, and their surface as a mesh.

mod cage;
mod consistency;
mod edge;
mod face;
mod limit;
mod net;
mod patches;
mod pipe;
mod sectors;
mod thresholds;
mod trace;
mod vertex;

#[cfg(test)]
mod tests;

pub use cage::FromMesh;
pub use edge::{SubDEdge, SubDEdgeTag};
pub use face::SubDFace;
pub use net::SubDNet;
pub use pipe::{MultiPipe, MultiPipeCap, MultiPipeNetwork};
pub use vertex::{SubDVertex, SubDVertexTag};

use crate::{Error, Result};

/// A place in a list of a net, seen in one of two directions: an edge runs from its first vertex to its second, and
/// reversed from its second to its first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct SubDSide {
    /// The index in the list.
    pub index: usize,
    /// Whether it is seen against its direction.
    pub reversed: bool,
}

impl SubDSide {
    /// Seen in its direction.
    pub fn forward(index: usize) -> Self {
        Self { index, reversed: false }
    }

    /// Seen against its direction.
    pub fn backward(index: usize) -> Self {
        Self { index, reversed: true }
    }
}

/// A subdivision surface: its control net, and nets of further subdivision if somebody made them.
///
/// Every net is consistent: what its vertices, edges and faces say of each other agrees.
#[derive(Debug, Clone, PartialEq)]
pub struct SubD {
    levels: Vec<SubDNet>,
}

impl SubD {
    /// The surface of one control net.
    pub fn new(net: SubDNet) -> Self {
        Self { levels: vec![net] }
    }

    /// The surface with nets of several levels, the coarsest first.
    ///
    /// # Errors
    /// There is no net.
    pub fn from_levels(levels: Vec<SubDNet>) -> Result<Self> {
        if levels.is_empty() {
            return Err(Error::Invalid { what: "SubD", why: "it has no control net".into() });
        }
        Ok(Self { levels })
    }

    /// The nets, the coarsest first.
    pub fn levels(&self) -> &[SubDNet] {
        &self.levels
    }

    /// The net that is edited and drawn: that of the finest level.
    ///
    /// ```
    /// use katydid_geometry::{Point3, subd::{SubD, SubDNet}};
    ///
    /// let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    /// let points = square.map(|(x, y)| Point3::new(x, y, 0.0)).to_vec();
    /// let subd = SubD::new(SubDNet::from_polygons(points, &[vec![0, 1, 2, 3]])?);
    /// assert_eq!(subd.net().edges().len(), 4);
    /// # Ok::<(), katydid_geometry::Error>(())
    /// ```
    pub fn net(&self) -> &SubDNet {
        // There is always one.
        &self.levels[self.levels.len() - 1]
    }
}
