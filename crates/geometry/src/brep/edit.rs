//! Breps moved, untrimmed, shrunk and thinned.

use super::Brep;
use crate::{Result, Xform};

impl Brep {
    /// The exact image under an affine map. A map that mirrors turns a solid's inside out, which is set right.
    ///
    /// # Errors
    /// A number overflows, the map flattens space, or it sends part of the brep to infinity.
    pub fn transformed(&self, xform: &Xform) -> Result<Self> {
        let mut parts = self.parts().clone();
        for curve in parts.curves_3d.iter_mut().flatten() {
            *curve = curve.transformed(xform)?;
        }
        for surface in parts.surfaces.iter_mut().flatten() {
            *surface = surface.transformed(xform)?;
        }
        let stretch = xform.vector(crate::Vector3::X).length().max(xform.vector(crate::Vector3::Y).length());
        let stretch = stretch.max(xform.vector(crate::Vector3::Z).length());
        for vertex in &mut parts.vertices {
            vertex.point = xform.point(vertex.point);
            vertex.tolerance *= stretch;
        }
        parts.edges.iter_mut().for_each(|edge| edge.tolerance *= stretch);
        if let Some(regions) = &mut parts.regions {
            regions.regions.iter_mut().for_each(|region| region.bounds = None);
        }
        let brep = Self::from_parts(parts)?;
        Ok(if xform.determinant() < 0.0 && brep.parts().solidity != super::Solidity::Unknown {
            let solidity = brep.parts().solidity;
            let mut turned = brep.flipped();
            turned.parts.solidity = solidity;
            turned
        } else {
            brep
        })
    }
}
