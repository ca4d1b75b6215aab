//! When two items count as the same member of a set.

use std::cell::RefCell;
use std::sync::Arc;

use indexmap::IndexMap;
use katydid_component::{Context, List, Message};
use katydid_data::{Content, Path, Value};
use uuid::Uuid;

/// The value of an item in a form that can be hashed: equal keys are equal items.
///
/// Values count, not types of numbers: the integer 1 is the number 1.0, and 0 is -0. There is no tolerance, and
/// case matters in texts. Curves, meshes and other large shapes are the same only when they are one object.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) enum Key {
    Null,
    Boolean(bool),
    /// Integers too: every integer of 32 bits is a number of its own.
    Number(u64),
    Text(Arc<str>),
    Guid(Uuid),
    Path(Path),
    /// Several numbers; the first field tells the type.
    Numbers(&'static str, [u64; 3]),
    /// A small shape, by all of its numbers.
    Shape(String),
    /// A large shape, by where it lies.
    Object(usize),
}

/// A value for each of some members. The hash of a member is kept: texts are read again only where hashes are the same.
pub(super) type KeyMap<V> = IndexMap<Key, V, foldhash::fast::RandomState>;

/// No members, with room for `n`.
pub(super) fn map_for<V>(n: usize) -> KeyMap<V> {
    KeyMap::with_capacity_and_hasher(n, foldhash::fast::RandomState::default())
}

/// The bits of a number, with one zero and one NaN.
pub(super) fn bits(x: f64) -> u64 {
    if x.is_nan() {
        f64::NAN.to_bits()
    } else if x == 0.0 {
        0
    } else {
        x.to_bits()
    }
}

fn object<T: ?Sized>(shared: &Arc<T>) -> Key {
    Key::Object(Arc::as_ptr(shared).cast::<u8>() as usize)
}

/// Layers, linetypes and blocks are the same when their path is; other content when it is one object.
fn content(shared: &Arc<Content>) -> Key {
    match &**shared {
        Content::Object(_)
        | Content::Instance(_)
        | Content::Filter(_)
        | Content::Atom(_)
        | Content::Token(_) => object(shared),
        named => match named.path() {
            Some(path) => Key::Shape(format!("{} {path}", named.type_name())),
            None => object(shared),
        },
    }
}

impl Key {
    /// The key of an item or of a null.
    pub(super) fn of(item: Option<&Value>) -> Self {
        let Some(value) = item else { return Self::Null };
        match value {
            Value::Boolean(x) => Self::Boolean(*x),
            Value::Integer(i) => Self::Number(bits(f64::from(*i))),
            Value::Number(x) => Self::Number(bits(*x)),
            Value::Text(text) => Self::Text(text.clone()),
            Value::Guid(id) => Self::Guid(*id),
            Value::Path(path) => Self::Path(path.clone()),
            Value::Complex(z) => Self::Numbers("complex", [bits(z.re), bits(z.im), 0]),
            Value::Colour(c) => {
                Self::Numbers("colour", [u64::from(u32::from_be_bytes([c.a, c.r, c.g, c.b])), 0, 0])
            }
            Value::Domain(d) => Self::Numbers("domain", [bits(d.start), bits(d.end), 0]),
            Value::Point(p) => Self::Numbers("point", [bits(p.x), bits(p.y), bits(p.z)]),
            Value::Vector(v) => Self::Numbers("vector", [bits(v.x), bits(v.y), bits(v.z)]),
            Value::Curve(shared) => object(shared),
            Value::Surface(shared) => object(shared),
            Value::Brep(shared) => object(shared),
            Value::Mesh(shared) => object(shared),
            Value::Material(shared) => object(shared),
            Value::Group(shared) => object(shared),
            Value::Kept(shared) => object(shared),
            Value::Content(shared) => content(shared),
            Value::Time(_)
            | Value::Domain2(_)
            | Value::Plane(_)
            | Value::Line(_)
            | Value::Circle(_)
            | Value::Arc(_)
            | Value::Rectangle(_)
            | Value::Box(_)
            | Value::TwistedBox(_)
            | Value::MeshFace(_)
            | Value::Transform(_)
            | Value::Compound(_)
            | Value::Field(_)
            | Value::Location(_)
            | Value::Symbol(_)
            | Value::LoftOptions(_)
            | Value::MeshSettings(_)
            | Value::QuadSettings(_)
            | Value::Projection(_)
            | Value::Matrix(_) => Self::Shape(format!("{value:?}")),
        }
    }
}

/// Whether two items are the same member, without making keys of the common types.
pub(super) fn same(a: Option<&Value>, b: Option<&Value>) -> bool {
    match (a, b) {
        (None, None) => true,
        (Some(Value::Number(a)), Some(Value::Number(b))) => bits(*a) == bits(*b),
        (Some(Value::Text(a)), Some(Value::Text(b))) => a == b,
        (Some(a), Some(b)) if a.kind() == b.kind() || (is_number(a) && is_number(b)) => {
            Key::of(Some(a)) == Key::of(Some(b))
        }
        _ => false,
    }
}

fn is_number(value: &Value) -> bool {
    matches!(value, Value::Integer(_) | Value::Number(_))
}

/// Where each member of a list stands.
struct Index {
    first: KeyMap<usize>,
    /// For each place the next one with the same member; past the end when there is none.
    next: Vec<usize>,
}

impl Index {
    fn new(list: &List<'_, Value>) -> Self {
        let mut first = map_for(list.len());
        let mut next = vec![usize::MAX; list.len()];
        for (i, (item, next)) in list.iter().zip(&mut next).enumerate().rev() {
            if let Some(later) = first.insert(Key::of(item.as_ref()), i) {
                *next = later;
            }
        }
        Self { first, next }
    }

    fn places(&self, item: &Value) -> impl Iterator<Item = usize> {
        let first = self.first.get(&Key::of(Some(item))).copied();
        std::iter::successors(first, |&i| self.next.get(i).copied().filter(|&next| next != usize::MAX))
    }
}

/// The searches in one list from which on an index is worth its making.
const FEW: usize = 8;

/// The first `most` places of an item in a list, in order. The list must be that of the branch that is worked
/// on: for many searches in it an index is kept.
pub(super) fn places(
    context: &Context<'_>,
    list: &List<'_, Value>,
    item: &Value,
    most: usize,
) -> Result<Vec<usize>, Message> {
    if context.iteration() < FEW {
        let found = list.iter().enumerate().filter(|(_, other)| same(other.as_ref(), Some(item)));
        return Ok(found.map(|(i, _)| i).take(most).collect());
    }
    let kept = context.prepared(|| Ok(RefCell::new(None::<(Path, Index)>)))?;
    let mut kept = kept.borrow_mut();
    let path = context.path();
    if kept.as_ref().is_none_or(|(branch, _)| *branch != path) {
        context.check()?;
        *kept = Some((path, Index::new(list)));
    }
    Ok(kept.iter().flat_map(|(_, index)| index.places(item)).take(most).collect())
}

#[cfg(test)]
mod tests {
    use katydid_geometry::{Line, Point3, Vector3};

    use super::*;

    #[test]
    fn values_count_and_types_of_numbers_do_not() {
        let key = |v: Value| Key::of(Some(&v));
        assert_eq!(key(1.into()), key(1.0.into()));
        assert_eq!(key(0.0.into()), key((-0.0).into()));
        assert_eq!(key(f64::NAN.into()), key((-f64::NAN).into()));
        assert_ne!(key((0.1 + 0.2).into()), key(0.3.into()));
        assert_ne!(key(1.into()), key(true.into()));
        assert_ne!(key(1.into()), key("1".into()));
        assert_ne!(key("a".into()), key("A".into()));
        let p = Point3::new(1.0, 2.0, 3.0);
        assert_ne!(key(p.into()), key(Vector3::new(1.0, 2.0, 3.0).into()));
        assert_eq!(key(Line::new(p, p).into()), key(Line::new(p, p).into()));
        assert_ne!(Key::of(None), key("".into()));
    }

    #[test]
    fn comparing_two_agrees_with_their_keys() {
        let values: Vec<Option<Value>> = vec![
            None,
            Some(1.into()),
            Some(1.0.into()),
            Some((-0.0).into()),
            Some(0.into()),
            Some("1".into()),
            Some(true.into()),
        ];
        for a in &values {
            for b in &values {
                assert_eq!(same(a.as_ref(), b.as_ref()), Key::of(a.as_ref()) == Key::of(b.as_ref()));
            }
        }
    }
}
