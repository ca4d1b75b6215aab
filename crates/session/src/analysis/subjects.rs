//! What of an object can be looked at.

use std::sync::Arc as Shared;

use katydid_data::Path;
use katydid_data::cast::Rules;
use katydid_geometry::{Curve, NurbsSurface};
use katydid_scene::{Facets, Form, Origin};

use crate::display::{self, Shown};

/// The curves and surfaces that an object shows.
#[derive(Debug, Clone, Default)]
pub struct Subjects {
    /// The curves, with the items that they are.
    pub(super) curves: Vec<(Origin, Shared<Curve>)>,
    surfaces: Vec<(Origin, Shared<Facets>)>,
    /// The branches that origins count.
    pub(super) branches: Vec<Path>,
}

impl Subjects {
    /// Those of an object, as it is shown. What draws no curves and surfaces of its own, such as straight lines, meshes
    /// and solids that are drawn by their edges, is not among them.
    pub fn of(shown: &Shown<'_>, rules: &Rules) -> Self {
        let (scene, _) = display::scene(shown, rules);
        let mut subjects = Self { branches: scene.branches, ..Self::default() };
        for thing in scene.things {
            match thing.form {
                Form::Curve(curve) => subjects.curves.push((thing.origin, curve)),
                Form::Surface(facets) if facets.is_exact() => subjects.surfaces.push((thing.origin, facets)),
                _ => {}
            }
        }
        subjects
    }

    /// Whether there is nothing to look at.
    pub fn is_empty(&self) -> bool {
        self.curves.is_empty() && self.surfaces.is_empty()
    }

    /// The surfaces, with the items that they are.
    pub(super) fn surfaces(&self) -> impl Iterator<Item = (Origin, &NurbsSurface)> {
        self.surfaces.iter().filter_map(|(origin, facets)| Some((*origin, facets.nurbs()?)))
    }
}
