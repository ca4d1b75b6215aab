use std::sync::Arc as Shared;

use katydid_3dm::RawObject;
use katydid_geometry::{
    Arc, Box3, Brep, Circle, Curve, Field, Interval, Line, Matrix, Mesh, MeshFace, Plane, Point3, Rectangle,
    Surface, TwistedBox, Vector3, Xform,
};
use uuid::Uuid;

use crate::{
    Colour, Complex, Compound, Content, DateTime, Domain2, Gather, Group, Item, Kind, Location, LoftOptions,
    Material, MeshSettings, Path, Projection, QuadSettings, Symbol, Value,
};

/// A run of items of one type, shared and never changed, with an optional mask of nulls.
#[derive(Debug, Clone)]
pub struct Column {
    items: Items,
    /// `true` where there is no item; absent when every place holds one.
    nulls: Option<Shared<Vec<bool>>>,
}

macro_rules! items {
    ($($variant:ident, $kind:ident, $type:ty, |$item:ident| $value:expr, $pattern:pat => $back:expr;)*) => {
        /// The items of a column, as one contiguous run of their own type.
        #[derive(Debug, Clone)]
        #[expect(missing_docs, reason = "each variant holds the Kind of the same name")]
        pub enum Items {
            $($variant(Shared<Vec<$type>>),)*
            /// The general case: items of several types.
            Values(Shared<Vec<Value>>),
        }

        impl Items {
            /// The number of places, nulls included.
            pub fn len(&self) -> usize {
                match self {
                    $(Self::$variant(items) => items.len(),)*
                    Self::Values(items) => items.len(),
                }
            }

            /// The type of all items; generic for a mixed run.
            pub fn kind(&self) -> Kind {
                match self {
                    $(Self::$variant(_) => Kind::$kind,)*
                    Self::Values(_) => Kind::Generic,
                }
            }

            fn get(&self, i: usize) -> Option<Value> {
                match self {
                    $(Self::$variant(items) => items.get(i).map(|$item| $value),)*
                    Self::Values(items) => items.get(i).cloned(),
                }
            }

            fn gather(&self, indices: &[usize]) -> Self {
                fn pick<T: Item>(items: &[T], indices: &[usize]) -> Shared<Vec<T>> {
                    Shared::new(indices.iter().map(|&i| items.get(i).cloned().unwrap_or_else(T::placeholder)).collect())
                }
                match self {
                    $(Self::$variant(items) => Self::$variant(pick(items, indices)),)*
                    Self::Values(items) => Self::Values(pick(items, indices)),
                }
            }

            /// One run of several runs of the same type; `None` when the types differ.
            fn concat(parts: &[&Self]) -> Option<Self> {
                match parts.first()? {
                    $(Self::$variant(_) => {
                        let mut all = Vec::with_capacity(parts.iter().map(|p| p.len()).sum());
                        for part in parts {
                            let Self::$variant(items) = part else { return None };
                            all.extend_from_slice(items);
                        }
                        Some(Self::$variant(Shared::new(all)))
                    })*
                    Self::Values(_) => None,
                }
            }

            /// The same values as one typed run when all that are not null have one type.
            fn of_values(values: Vec<Value>, nulls: Option<&[bool]>) -> Self {
                let is_null = |i: usize| nulls.is_some_and(|n| n.get(i).copied().unwrap_or(false));
                let mut kinds = values.iter().enumerate().filter(|&(i, _)| !is_null(i)).map(|(_, v)| v.kind());
                let Some(kind) = kinds.next() else { return Self::Values(Shared::new(values)) };
                if !kinds.all(|k| k == kind) {
                    return Self::Values(Shared::new(values));
                }
                match kind {
                    $(Kind::$kind => Self::$variant(Shared::new(
                        values
                            .into_iter()
                            .map(|value| match value {
                                $pattern => $back,
                                _ => <$type as Item>::placeholder(),
                            })
                            .collect(),
                    )),)*
                    _ => Self::Values(Shared::new(values)),
                }
            }
        }
    };
}

items! {
    Booleans, Boolean, bool, |x| Value::Boolean(*x), Value::Boolean(x) => x;
    Integers, Integer, i32, |x| Value::Integer(*x), Value::Integer(x) => x;
    Numbers, Number, f64, |x| Value::Number(*x), Value::Number(x) => x;
    Complexes, Complex, Complex, |x| Value::Complex(*x), Value::Complex(x) => x;
    Texts, Text, Shared<str>, |x| Value::Text(x.clone()), Value::Text(x) => x;
    Colours, Colour, Colour, |x| Value::Colour(*x), Value::Colour(x) => x;
    Times, Time, DateTime, |x| Value::Time(*x), Value::Time(x) => x;
    Guids, Guid, Uuid, |x| Value::Guid(*x), Value::Guid(x) => x;
    Domains, Domain, Interval, |x| Value::Domain(*x), Value::Domain(x) => x;
    Domains2, Domain2, Domain2, |x| Value::Domain2(Shared::new(*x)), Value::Domain2(x) => *x;
    Paths, Path, Path, |x| Value::Path(x.clone()), Value::Path(x) => x;
    Points, Point, Point3, |x| Value::Point(*x), Value::Point(x) => x;
    Vectors, Vector, Vector3, |x| Value::Vector(*x), Value::Vector(x) => x;
    Planes, Plane, Plane, |x| Value::Plane(Shared::new(*x)), Value::Plane(x) => *x;
    Lines, Line, Line, |x| Value::Line(Shared::new(*x)), Value::Line(x) => *x;
    Circles, Circle, Circle, |x| Value::Circle(Shared::new(*x)), Value::Circle(x) => *x;
    Arcs, Arc, Arc, |x| Value::Arc(Shared::new(*x)), Value::Arc(x) => *x;
    Rectangles, Rectangle, Rectangle, |x| Value::Rectangle(Shared::new(*x)), Value::Rectangle(x) => *x;
    Boxes, Box, Box3, |x| Value::Box(Shared::new(*x)), Value::Box(x) => *x;
    TwistedBoxes, TwistedBox, TwistedBox, |x| Value::TwistedBox(Shared::new(*x)), Value::TwistedBox(x) => *x;
    Curves, Curve, Shared<Curve>, |x| Value::Curve(x.clone()), Value::Curve(x) => x;
    Surfaces, Surface, Shared<Surface>, |x| Value::Surface(x.clone()), Value::Surface(x) => x;
    Breps, Brep, Shared<Brep>, |x| Value::Brep(x.clone()), Value::Brep(x) => x;
    Meshes, Mesh, Shared<Mesh>, |x| Value::Mesh(x.clone()), Value::Mesh(x) => x;
    MeshFaces, MeshFace, MeshFace, |x| Value::MeshFace(*x), Value::MeshFace(x) => x;
    Transforms, Transform, Xform, |x| Value::Transform(Shared::new(*x)), Value::Transform(x) => *x;
    Matrices, Matrix, Shared<Matrix>, |x| Value::Matrix(x.clone()), Value::Matrix(x) => x;
    Compounds, Compound, Shared<Compound>, |x| Value::Compound(x.clone()), Value::Compound(x) => x;
    Fields, Field, Shared<Field>, |x| Value::Field(x.clone()), Value::Field(x) => x;
    Locations, Location, Location, |x| Value::Location(*x), Value::Location(x) => x;
    Symbols, Symbol, Shared<Symbol>, |x| Value::Symbol(x.clone()), Value::Symbol(x) => x;
    Materials, Material, Material, |x| Value::Material(Shared::new(*x)), Value::Material(x) => *x;
    LoftOptions, LoftOptions, LoftOptions, |x| Value::LoftOptions(Shared::new(*x)), Value::LoftOptions(x) => *x;
    QuadSettings, QuadSettings, QuadSettings, |x| Value::QuadSettings(Shared::new(*x)), Value::QuadSettings(x) => *x;
    MeshSettings, MeshSettings, MeshSettings, |x| Value::MeshSettings(Shared::new(*x)), Value::MeshSettings(x) => *x;
    Projections, Projection, Projection, |x| Value::Projection(Shared::new(*x)), Value::Projection(x) => *x;
    Groups, Group, Shared<Group>, |x| Value::Group(x.clone()), Value::Group(x) => x;
    Kept, Kept, Shared<RawObject>, |x| Value::Kept(x.clone()), Value::Kept(x) => x;
    Contents, Content, Shared<Content>, |x| Value::Content(x.clone()), Value::Content(x) => x;
}

impl Items {
    /// Whether there are no places at all.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Column {
    /// A column of `items`; a mask without a single null, or of another length, is dropped.
    pub fn new(items: Items, nulls: Option<Vec<bool>>) -> Self {
        let nulls = nulls.filter(|n| n.len() == items.len() && n.contains(&true)).map(Shared::new);
        Self { items, nulls }
    }

    /// A column of values of any types: typed when all agree.
    pub fn of_values(values: Vec<Value>, nulls: Option<Vec<bool>>) -> Self {
        let items = Items::of_values(values, nulls.as_deref());
        Self::new(items, nulls)
    }

    /// A column of values with gaps.
    pub fn of_options(values: Vec<Option<Value>>) -> Self {
        let mut gather = Gather::with_capacity(values.len());
        for value in values {
            gather.push(value);
        }
        gather.finish()
    }

    /// A column without places.
    pub fn empty() -> Self {
        Self::new(Items::Values(Shared::default()), None)
    }

    /// A column of `n` nulls.
    pub fn nulls(n: usize) -> Self {
        Self::new(Items::Booleans(Shared::new(vec![false; n])), Some(vec![true; n]))
    }

    /// The items as they lie.
    pub fn items(&self) -> &Items {
        &self.items
    }

    /// The number of places, nulls included.
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Whether there are no places.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// The type of all items; generic for a mixed column.
    pub fn kind(&self) -> Kind {
        self.items.kind()
    }

    /// Whether place `i` holds no item.
    #[inline]
    pub fn is_null(&self, i: usize) -> bool {
        self.nulls.as_ref().is_some_and(|nulls| nulls.get(i).copied().unwrap_or(false))
    }

    /// Whether any place holds no item.
    #[inline]
    pub fn has_nulls(&self) -> bool {
        self.nulls.is_some()
    }

    /// The mask of nulls, when there are any.
    pub fn null_mask(&self) -> Option<&[bool]> {
        self.nulls.as_deref().map(Vec::as_slice)
    }

    /// Item `i`; `None` where it is null and outside the column.
    #[inline]
    pub fn get(&self, i: usize) -> Option<Value> {
        if self.is_null(i) { None } else { self.items.get(i) }
    }

    /// All items in order, nulls as `None`.
    pub fn iter(&self) -> impl Iterator<Item = Option<Value>> + '_ {
        (0..self.len()).map(|i| self.get(i))
    }

    /// The items at `indices`, in that order; an index outside the column gives a null.
    #[must_use]
    pub fn gather(&self, indices: &[usize]) -> Self {
        let n = self.len();
        let outside = indices.iter().any(|&i| i >= n);
        let nulls = (outside || self.has_nulls())
            .then(|| indices.iter().map(|&i| i >= n || self.is_null(i)).collect());
        Self::new(self.items.gather(indices), nulls)
    }

    /// The items of several columns, one behind the other; shared, not copied, when only one has any.
    pub fn concat(parts: &[&Self]) -> Self {
        let parts: Vec<&Self> = parts.iter().copied().filter(|p| !p.is_empty()).collect();
        match parts.as_slice() {
            [] => return Self::empty(),
            [one] => return (*one).clone(),
            _ => {}
        }
        let nulls = parts
            .iter()
            .any(|p| p.has_nulls())
            .then(|| parts.iter().flat_map(|p| (0..p.len()).map(|i| p.is_null(i))).collect::<Vec<bool>>());
        let runs: Vec<&Items> = parts.iter().map(|p| &p.items).collect();
        match Items::concat(&runs) {
            Some(items) => Self::new(items, nulls),
            None => Self::of_options(parts.iter().flat_map(|p| p.iter()).collect()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_one_type_lie_as_that_type() {
        let column = Column::of_options(vec![None, Some(Value::Number(2.0)), Some(Value::Number(3.0))]);
        assert!(matches!(column.items(), Items::Numbers(_)));
        assert_eq!(column.get(0), None);
        assert_eq!(column.get(2), Some(Value::Number(3.0)));
        let mixed = Column::of_options(vec![Some(Value::Number(2.0)), Some(Value::Integer(3))]);
        assert_eq!(mixed.kind(), Kind::Generic);
    }

    #[test]
    fn joining_keeps_types_and_nulls() {
        let a = Column::of_options(vec![Some(Value::Number(1.0)), None]);
        let b = Column::of_options(vec![Some(Value::Number(2.0))]);
        let c = Column::of_options(vec![Some(Value::text("x"))]);
        let ab = Column::concat(&[&a, &b]);
        assert_eq!(ab.kind(), Kind::Number);
        assert_eq!(ab.iter().collect::<Vec<_>>(), [Some(Value::Number(1.0)), None, Some(Value::Number(2.0))]);
        assert_eq!(Column::concat(&[&ab, &c]).get(3), Some(Value::text("x")));
    }

    #[test]
    fn an_index_outside_gathers_a_null() {
        let a = Column::of_options(vec![Some(Value::Integer(1)), Some(Value::Integer(2))]);
        let g = a.gather(&[1, 7, 0]);
        assert_eq!(g.iter().collect::<Vec<_>>(), [Some(Value::Integer(2)), None, Some(Value::Integer(1))]);
    }
}
