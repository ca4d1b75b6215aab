//! A brep that is nothing but one surface: a single face whose only loop runs along the four sides of its surface.

use katydid_geometry::Surface;

use super::BrepObject;
use crate::object::{Object, RawObject};
use crate::{Limits, Result, class_ids};

/// What a brep of one untrimmed face consists of.
#[derive(Debug, Clone, PartialEq)]
pub struct BareSurface {
    /// The surface, with the parameters that the face has.
    pub surface: Surface,
    /// Whether the face is turned over: its normal is opposite to the surface's.
    pub is_reversed: bool,
}

impl BrepObject {
    /// The surface that the brep consists of, when it has one face whose trims run along the four sides of the
    /// surface's domain.
    pub fn bare_surface(&self) -> Option<BareSurface> {
        let (surface, is_reversed) = self.brep.as_surface()?;
        Some(BareSurface { surface: surface.clone(), is_reversed })
    }
}

impl RawObject {
    /// The surface that a kept brep consists of, when it has one face, not turned over, whose trims run
    /// along the four sides of the surface's domain; nothing for other breps and other classes.
    ///
    /// # Errors
    /// The bytes are broken, or the kernel refuses the brep.
    pub fn untrimmed_surface(&self) -> Result<Option<Surface>> {
        Ok(self.bare_surface()?.filter(|bare| !bare.is_reversed).map(|bare| bare.surface))
    }

    /// The same for a face that may be turned over.
    ///
    /// # Errors
    /// As above.
    pub fn bare_surface(&self) -> Result<Option<BareSurface>> {
        if class_ids::canonical(self.class) != class_ids::BREP {
            return Ok(None);
        }
        Ok(match self.parse(&Limits::default())? {
            Object::Brep(object) => object.bare_surface(),
            _ => None,
        })
    }
}
