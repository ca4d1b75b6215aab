use std::sync::Arc as Shared;

use katydid_3dm::RawObject;
use katydid_geometry::{
    Arc, Box3, Circle, Curve, Field, Interval, Line, LineCurve, Matrix, Mesh, MeshFace, Plane, Point3,
    Rectangle, TwistedBox, Vector3, Xform,
};
use uuid::Uuid;

use crate::run::{Run, ValueRun};
use crate::{
    Colour, Column, Complex, Compound, Content, DateTime, Domain2, Group, Items, Kind, Location, LoftOptions,
    Material, MeshSettings, ModelLayer, Path, Projection, QuadSettings, Symbol, Value,
};

/// A type that an item of data can have, and how it lies in a [`Column`].
///
/// Implemented for every type of [`Value`], for [`Value`] itself (any type), and for [`Geometry`].
pub trait Item: Clone + std::fmt::Debug + Send + Sync + Sized + 'static {
    /// The type of a port that takes these items.
    const KIND: Kind;

    /// What these items are collected in.
    type Run: Run<Self>;

    /// Item `i` of a column that has been cast to [`Self::KIND`]; `None` where it is null, where `i` is outside,
    /// and where the column holds another type.
    fn get(column: &Column, i: usize) -> Option<Self>;

    /// The items as they lie, when the column holds exactly this type; nulls have some value there too.
    fn slice(column: &Column) -> Option<&[Self]>;

    /// A column of these items; `nulls`, of the same length, tells which places hold none.
    fn column(items: Vec<Self>, nulls: Option<Vec<bool>>) -> Column;

    /// What stands in the place of a null; never looked at.
    fn placeholder() -> Self;
}

/// `item!(type, kind, run, placeholder)`, and what an item of a column of another type stands for, if anything.
macro_rules! item {
    ($type:ty, $variant:ident, $items:ident, $placeholder:expr) => {
        item!($type, $variant, $items, $placeholder, |_: &Column, _: usize| None);
    };
    ($type:ty, $variant:ident, $items:ident, $placeholder:expr, $standing_for:expr) => {
        impl Item for $type {
            const KIND: Kind = Kind::$variant;
            type Run = Vec<Self>;

            #[inline]
            fn get(column: &Column, i: usize) -> Option<Self> {
                if column.is_null(i) {
                    return None;
                }
                match column.items() {
                    Items::$items(items) => items.get(i).cloned(),
                    _ => $standing_for(column, i),
                }
            }

            fn slice(column: &Column) -> Option<&[Self]> {
                match column.items() {
                    Items::$items(items) => Some(items),
                    _ => None,
                }
            }

            fn column(items: Vec<Self>, nulls: Option<Vec<bool>>) -> Column {
                Column::new(Items::$items(Shared::new(items)), nulls)
            }

            fn placeholder() -> Self {
                $placeholder
            }
        }
    };
}
pub(crate) use item;

item!(bool, Boolean, Booleans, false);
item!(i32, Integer, Integers, 0);
item!(f64, Number, Numbers, 0.0);
item!(Complex, Complex, Complexes, Complex::default());
item!(Shared<str>, Text, Texts, Shared::from(""));
item!(Colour, Colour, Colours, Colour::default());
item!(DateTime, Time, Times, DateTime::default());
item!(Uuid, Guid, Guids, Uuid::nil());
item!(Interval, Domain, Domains, Interval::UNIT);
item!(Domain2, Domain2, Domains2, Domain2 { u: Interval::UNIT, v: Interval::UNIT });
item!(Path, Path, Paths, Path::default());
item!(Point3, Point, Points, Point3::ORIGIN);
item!(Vector3, Vector, Vectors, Vector3::ZERO);
item!(Plane, Plane, Planes, Plane::XY);
item!(Line, Line, Lines, Line::new(Point3::ORIGIN, Point3::ORIGIN));
item!(Circle, Circle, Circles, Circle { plane: Plane::XY, radius: 1.0 });
item!(Arc, Arc, Arcs, Arc { circle: Circle::placeholder(), angle: Interval::UNIT });
item!(Rectangle, Rectangle, Rectangles, Rectangle { plane: Plane::XY, x: Interval::UNIT, y: Interval::UNIT });
item!(Box3, Box, Boxes, Box3 { plane: Plane::XY, x: Interval::UNIT, y: Interval::UNIT, z: Interval::UNIT });
item!(TwistedBox, TwistedBox, TwistedBoxes, TwistedBox { corners: [Point3::ORIGIN; 8] });
item!(Shared<Curve>, Curve, Curves, Shared::new(Curve::Line(LineCurve::new(Line::placeholder()))));
item!(Shared<Mesh>, Mesh, Meshes, Shared::new(Mesh::default()));
item!(MeshFace, MeshFace, MeshFaces, MeshFace::Triangle([0, 0, 0]));
item!(Shared<Compound>, Compound, Compounds, Shared::new(Compound::default()));
item!(Shared<Matrix>, Matrix, Matrices, Shared::new(Matrix::default()));
item!(Shared<Field>, Field, Fields, Shared::new(Field::default()));
item!(Location, Location, Locations, Location::default());
item!(Shared<Symbol>, Symbol, Symbols, Shared::new(Symbol::default()));
item!(LoftOptions, LoftOptions, LoftOptions, LoftOptions::default());
item!(MeshSettings, MeshSettings, MeshSettings, MeshSettings::default());
item!(QuadSettings, QuadSettings, QuadSettings, QuadSettings::default());
item!(Projection, Projection, Projections, Projection::default());
item!(Material, Material, Materials, Material::from(Colour::default()));
item!(Shared<Group>, Group, Groups, Shared::new(Group { members: Vec::new() }));
item!(
    Shared<RawObject>,
    Kept,
    Kept,
    Shared::new(RawObject {
        class: Uuid::nil(),
        archive_version: 70,
        opennurbs_version: 0,
        bytes: Vec::new(),
        user_data: Vec::new(),
    })
);

item!(Shared<Content>, Content, Contents, Shared::new(Content::Layer(Shared::new(ModelLayer::default()))));

// A compound counts as the one transform that it comes to.
item!(Xform, Transform, Transforms, Self::IDENTITY, |column: &Column, i: usize| match column.items() {
    Items::Compounds(items) => items.get(i).map(|compound| compound.whole()),
    Items::Values(items) => items.get(i)?.as_transform(),
    _ => None,
});

impl Item for Value {
    const KIND: Kind = Kind::Generic;
    type Run = ValueRun;

    #[inline]
    fn get(column: &Column, i: usize) -> Option<Self> {
        column.get(i)
    }

    fn slice(column: &Column) -> Option<&[Self]> {
        match column.items() {
            Items::Values(items) => Some(items),
            _ => None,
        }
    }

    fn column(items: Vec<Self>, nulls: Option<Vec<bool>>) -> Column {
        Column::of_values(items, nulls)
    }

    fn placeholder() -> Self {
        Self::Boolean(false)
    }
}

/// An item of any geometric type.
#[derive(Debug, Clone, PartialEq)]
pub struct Geometry(pub Value);

impl Item for Geometry {
    const KIND: Kind = Kind::Geometry;
    type Run = ValueRun;

    #[inline]
    fn get(column: &Column, i: usize) -> Option<Self> {
        column.get(i).map(Self)
    }

    fn slice(_: &Column) -> Option<&[Self]> {
        None
    }

    fn column(items: Vec<Self>, nulls: Option<Vec<bool>>) -> Column {
        Column::of_values(items.into_iter().map(|Self(value)| value).collect(), nulls)
    }

    fn placeholder() -> Self {
        Self(Value::placeholder())
    }
}
