//! What is to be written: geometry with names, colours and layers.

mod drawn;
mod facets;
mod from_model;
mod label;
mod left_out;
mod shape;
mod to_model;
mod tree;

use std::sync::Arc;

use katydid_geometry::{BoundingBox, Brep, Curve, Mesh, Point3, Units, Vector3};

pub use from_model::Conversion;
pub use label::{Fill, Label, LabelSize, Region};
pub use left_out::LeftOut;

use crate::{Error, Format, Result};

/// Geometry with names, colours and layers.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// The length unit.
    pub units: Units,
    /// The length of the unit in metres; 1 where there is no unit.
    pub metres: f64,
    /// How far a polyline or a mesh may be from what it stands for, in units.
    pub tolerance: f64,
    /// The layers.
    pub layers: Vec<Layer>,
    /// What is in it, in order.
    pub things: Vec<Thing>,
    /// What could not become part of the scene.
    pub left_out: Vec<LeftOut>,
}

impl Default for Scene {
    /// Empty, in millimetres.
    fn default() -> Self {
        Self {
            units: Units::Millimeters,
            metres: 1e-3,
            tolerance: 1e-3,
            layers: Vec::new(),
            things: Vec::new(),
            left_out: Vec::new(),
        }
    }
}

/// A layer of a scene.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Layer {
    /// The name, without those of its parents.
    pub name: String,
    /// The layer it lies under, an index into [`Scene::layers`].
    pub parent: Option<usize>,
}

/// One piece of geometry.
#[derive(Debug, Clone, PartialEq)]
pub struct Thing {
    /// Its name; may be empty.
    pub name: String,
    /// Its layer, an index into [`Scene::layers`].
    pub layer: Option<usize>,
    /// Its colour as red, green, blue, alpha, as a screen shows them; nothing when it has none to show.
    pub colour: Option<[u8; 4]>,
    /// Its form.
    pub shape: Shape,
}

impl Thing {
    /// A thing with a name, on no layer, without a colour.
    pub fn named(name: impl Into<String>, shape: Shape) -> Self {
        Self { name: name.into(), layer: None, colour: None, shape }
    }

    /// Its name, or what it is and its place among the things of the scene.
    pub(crate) fn title(&self, place: usize) -> String {
        if self.name.is_empty() { format!("{} {}", self.shape.kind(), place + 1) } else { self.name.clone() }
    }
}

/// The forms of geometry that are written.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// One point or many.
    Points(PointSet),
    /// A curve.
    Curve(Curve),
    /// A mesh.
    Mesh(Mesh),
    /// A filled region of a plane. Formats without areas take its boundaries.
    Region(Region),
    /// Text, which drawings show.
    Text(Label),
    /// The faces of a surface or a solid: formats of meshes take the facets, drawings take the edges.
    Faces {
        /// The faces as a mesh; nothing where nobody made one.
        facets: Option<Mesh>,
        /// The edges, exactly.
        edges: Vec<Curve>,
    },
    /// A surface or a solid exactly. Formats of meshes and drawings take its facets and edges.
    Brep(Arc<Brep>),
}

impl Shape {
    /// What it is in a few words, for messages.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Self::Points(set) if set.points.len() == 1 => "point",
            Self::Points(_) => "point cloud",
            Self::Curve(_) => "curve",
            Self::Mesh(_) => "mesh",
            Self::Region(_) => "hatch",
            Self::Text(_) => "text",
            Self::Brep(_) => "brep",
            Self::Faces { facets: Some(_), .. } => "surface",
            Self::Faces { facets: None, .. } => "brep without a mesh",
        }
    }
}

/// Points, with a normal and a colour each where they have them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PointSet {
    /// The points.
    pub points: Vec<Point3>,
    /// One normal a point, or none at all.
    pub normals: Vec<Vector3>,
    /// One colour a point as red, green, blue, alpha, or none at all.
    pub colours: Vec<[u8; 4]>,
}

impl From<Vec<Point3>> for PointSet {
    fn from(points: Vec<Point3>) -> Self {
        Self { points, ..Self::default() }
    }
}

impl Scene {
    /// The parent of each layer, such that all come to the top.
    pub(crate) fn parents(&self) -> Vec<Option<usize>> {
        let parents: Vec<Option<usize>> = self.layers.iter().map(|layer| layer.parent).collect();
        tree::rooted(&parents)
    }

    /// The names of a layer and of all layers above it, from the top down, joined by `::`.
    pub(crate) fn layer_path(&self, layer: usize) -> String {
        let mut names = Vec::new();
        let mut next = Some(layer);
        // Parents that run in a circle end after as many steps as there are layers.
        while let Some(layer) =
            next.and_then(|i| self.layers.get(i)).filter(|_| names.len() < self.layers.len())
        {
            names.push(layer.name.as_str());
            next = layer.parent;
        }
        names.reverse();
        names.join("::")
    }

    /// How far a polyline or mesh may be from a shape of that extent, unless the caller says.
    pub(crate) fn tolerance_for(&self, wanted: Option<f64>, bounds: &BoundingBox) -> f64 {
        const SHARE: f64 = 1e-4;
        let usable = |t: &f64| *t > 0.0 && t.is_finite();
        let own = if usable(&self.tolerance) { self.tolerance } else { 0.0 };
        let shared = own.max(SHARE * bounds.diagonal().length());
        wanted.filter(usable).unwrap_or(if usable(&shared) { shared } else { 1e-3 })
    }

    /// Refuses coordinates that are not finite: the kernel keeps them out of curves and meshes, points are anyone's.
    pub(crate) fn check_finite(&self, format: Format) -> Result<()> {
        for (place, thing) in self.things.iter().enumerate() {
            let points: &[Point3] = match &thing.shape {
                Shape::Points(set) => &set.points,
                Shape::Text(label) => std::slice::from_ref(&label.point),
                _ => continue,
            };
            let numbers = points.iter().flat_map(|p| [p.x, p.y, p.z]);
            if let Some(value) = numbers.into_iter().find(|x| !x.is_finite()) {
                return Err(Error::Coordinate {
                    what: thing.title(place),
                    format: format.extension(),
                    value,
                });
            }
        }
        Ok(())
    }
}
