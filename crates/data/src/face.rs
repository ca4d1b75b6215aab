//! Surfaces as items, and surfaces with the side that a brep gives them.

use std::sync::Arc as Shared;

use katydid_geometry::{Brep, Plane, Point3, Sphere, Surface, Vector3};

use crate::item::item;
use crate::{Column, Item, Items, Kind, Value};

/// A surface, and whether its normals are turned over: those of a face that a brep has turned, as the faces of solids
/// that look outward against their surfaces.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// The surface, without regard to trims.
    pub surface: Shared<Surface>,
    /// Whether the face looks to the other side than the surface.
    pub reversed: bool,
}

impl Face {
    /// The only face of a brep.
    fn of(brep: &Brep) -> Option<Self> {
        let ([face], Some(surface)) = (brep.faces(), brep.face_surface(0)) else { return None };
        Some(Self { surface: Shared::new(surface.clone()), reversed: face.reversed })
    }

    /// The unit normal at a pair of parameters, on the side to which the face looks; `None` where there is none.
    pub fn normal_at(&self, u: f64, v: f64) -> Option<Vector3> {
        self.surface.normal_at(u, v).map(|n| if self.reversed { -n } else { n })
    }

    /// The tangent plane at a pair of parameters, its z axis along the normal. On a face that is turned over x and y
    /// change places, as RhinoCommon's `FrameAt` has it for such faces.
    pub fn frame_at(&self, u: f64, v: f64) -> Option<Plane> {
        let frame = self.surface.frame_at(u, v)?;
        let turned = Plane { x_axis: frame.y_axis, y_axis: frame.x_axis, z_axis: -frame.z_axis, ..frame };
        Some(if self.reversed { turned } else { frame })
    }

    /// The point at a pair of parameters.
    pub fn point_at(&self, u: f64, v: f64) -> Point3 {
        self.surface.point_at(u, v)
    }
}

/// A brep of one face counts as that face.
impl Item for Face {
    const KIND: Kind = Kind::Surface;
    type Run = Vec<Self>;

    fn get(column: &Column, i: usize) -> Option<Self> {
        if column.is_null(i) {
            return None;
        }
        match column.items() {
            Items::Surfaces(items) => {
                items.get(i).map(|surface| Self { surface: surface.clone(), reversed: false })
            }
            Items::Breps(items) => Self::of(items.get(i)?),
            _ => match column.get(i)? {
                Value::Surface(surface) => Some(Self { surface, reversed: false }),
                Value::Brep(brep) => Self::of(&brep),
                _ => None,
            },
        }
    }

    fn slice(_: &Column) -> Option<&[Self]> {
        None
    }

    fn column(items: Vec<Self>, nulls: Option<Vec<bool>>) -> Column {
        <Shared<Surface> as Item>::column(items.into_iter().map(|face| face.surface).collect(), nulls)
    }

    fn placeholder() -> Self {
        Self { surface: <Shared<Surface> as Item>::placeholder(), reversed: false }
    }
}

// A brep of one face counts as the surface of that face, whichever way that looks.
item!(
    Shared<Surface>,
    Surface,
    Surfaces,
    Self::new(Sphere { plane: Plane::XY, radius: 1.0 }.into()),
    |column: &Column, i: usize| Face::get(column, i).map(|face| face.surface)
);
