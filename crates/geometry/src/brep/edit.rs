//! Breps moved, untrimmed, shrunk and thinned.

use super::parameters::{ParameterMap, ParameterMaps};
use super::{Brep, CurvePart, Parts};
use crate::{Curve, Result, Xform};

impl Brep {
    /// The image under an affine map: surfaces, edges and vertices exactly. Where a surface takes another form on the way
    /// (a ball that is stretched), trims go along with its parameters. A map that mirrors turns a solid's inside out,
    /// which is set right.
    ///
    /// # Errors
    /// A number overflows, the map flattens space, or it sends part of the brep to infinity.
    pub fn transformed(&self, xform: &Xform) -> Result<Self> {
        crate::cancellation::check_now()?;
        let mut parts = self.parts().clone();
        let mut maps = Vec::with_capacity(parts.surfaces.len());
        for surface in &mut parts.surfaces {
            crate::cancellation::check()?;
            maps.push(match surface {
                Some(surface) => {
                    let image = surface.transformed(xform)?;
                    let map = ParameterMaps::to_image(surface, &image);
                    *surface = image;
                    Some(map)
                }
                None => None,
            });
        }
        self.move_trims(&mut parts, &maps)?;
        self.image_edges(&mut parts, xform)?;
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

    /// The same with every surface in its NURBS form, which is exact; trims go along with its parameters.
    ///
    /// # Errors
    /// A number overflows.
    pub fn with_nurbs_surfaces(&self) -> Result<Self> {
        let mut parts = self.parts().clone();
        let mut maps = Vec::with_capacity(parts.surfaces.len());
        for surface in &mut parts.surfaces {
            crate::cancellation::check()?;
            maps.push(match surface {
                Some(surface) => {
                    let map = ParameterMaps::to_nurbs(surface);
                    *surface = surface.to_nurbs()?.into();
                    Some(map)
                }
                None => None,
            });
        }
        self.move_trims(&mut parts, &maps)?;
        Self::from_parts(parts)
    }

    /// Gives the trims of surfaces whose parameters moved curves of their own.
    fn move_trims(&self, parts: &mut Parts, maps: &[Option<ParameterMaps>]) -> Result<()> {
        for (place, trim) in self.trims().iter().enumerate() {
            let face = trim.in_loop.and_then(|l| self.loops().get(l)).and_then(|chain| chain.face);
            let surface = face.and_then(|f| self.faces().get(f)).and_then(|face| face.surface);
            let map = surface.and_then(|s| maps.get(s)?.as_ref()).filter(|map| !map.is_identity());
            let (Some(map), Some(flat)) = (map, self.trim_as_curve(place)?) else { continue };
            let moved = map.moved(&flat)?;
            let part = CurvePart::whole(parts.curves_2d.len(), moved.domain());
            parts.curves_2d.push(Some(moved));
            if let Some(trim) = parts.trims.get_mut(place) {
                trim.part = part;
            }
        }
        Ok(())
    }

    /// Maps the curves of edges. An edge that takes a part of a curve whose parameters move gets one of its own.
    fn image_edges(&self, parts: &mut Parts, xform: &Xform) -> Result<()> {
        let mut moved = Vec::with_capacity(parts.curves_3d.len());
        for curve in &mut parts.curves_3d {
            let Some(own) = curve else {
                moved.push(false);
                continue;
            };
            let image = own.transformed(xform)?;
            moved.push(!ParameterMap::of_image(own, &image).is_identity());
            *own = image;
        }
        for (place, edge) in self.edges().iter().enumerate() {
            let Some(curve) = edge.part.curve.filter(|c| moved.get(*c) == Some(&true)) else { continue };
            let whole = parts.curves_3d.get(curve).and_then(Option::as_ref).map(Curve::domain);
            if whole == Some(edge.part.range) {
                continue;
            }
            let Some(own) = self.edge_as_curve(place)? else { continue };
            let image = own.transformed(xform)?;
            let part = CurvePart::whole(parts.curves_3d.len(), image.domain());
            parts.curves_3d.push(Some(image));
            if let Some(edge) = parts.edges.get_mut(place) {
                edge.part = part;
            }
        }
        Ok(())
    }
}
