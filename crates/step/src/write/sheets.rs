//! The connected pieces of a brep: solids with their voids, and sheets.

use katydid_geometry::Brep;
use katydid_geometry::brep::Solidity;

/// A solid.
pub(super) struct Piece {
    /// Its outside, normals outward.
    pub(super) outer: Brep,
    /// Its voids, normals into them.
    pub(super) voids: Vec<Brep>,
}

/// The solids and the sheets of a brep.
pub(super) fn pieces(brep: &Brep) -> (Vec<Piece>, Vec<Brep>) {
    let parts = match brep.connected_components() {
        Ok(parts) if parts.len() > 1 => parts,
        _ => vec![brep.clone()],
    };
    let (mut solids, mut voids, mut sheets) = (Vec::new(), Vec::new(), Vec::new());
    for part in parts {
        match part.solid_orientation() {
            Solidity::Outward => solids.push(Piece { outer: part, voids: Vec::new() }),
            Solidity::Inward => voids.push(part),
            Solidity::Unknown => sheets.push(part),
        }
    }
    for void in voids {
        match innermost(&mut solids, &void) {
            Some(solid) => solid.voids.push(void),
            // Nothing is around it: it is a solid seen from inside.
            None => solids.push(Piece { outer: void.flipped(), voids: Vec::new() }),
        }
    }
    (solids, sheets)
}

/// The smallest solid whose box holds that of the void.
fn innermost<'a>(solids: &'a mut [Piece], void: &Brep) -> Option<&'a mut Piece> {
    let inner = void.bounds_of_faces()?;
    let volume = |piece: &Piece| {
        let outer = piece.outer.bounds_of_faces()?;
        let size = outer.diagonal();
        (outer.union(&inner) == outer).then_some(size.x * size.y * size.z)
    };
    solids
        .iter_mut()
        .filter_map(|piece| Some((volume(piece)?, piece)))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, piece)| piece)
}
