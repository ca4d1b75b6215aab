//! About how much memory data takes, for caches that are bounded by it.

use katydid_geometry::{Brep, Curve, Mesh, Surface};

use crate::{Column, Content, Items, Tree, Value};

/// What an allocation with its counters takes besides its content.
const SHARED: usize = 32;

impl Tree {
    /// About how many bytes the tree takes. What it shares with others counts in full.
    pub fn weight(&self) -> usize {
        // Long paths have an allocation of their own.
        let path = |path: &crate::Path| size_of::<crate::Path>() + path.len().saturating_sub(4) * 4;
        let paths: usize = self.paths().iter().map(path).sum();
        paths + self.branch_count() * size_of::<usize>() + self.column().weight()
    }

    /// About how many bytes a copy takes: what items share with it is not copied.
    pub fn copied_weight(&self) -> usize {
        let places = size_of::<crate::Path>() + size_of::<usize>();
        let items = self.column().weight().min(self.item_count().saturating_mul(size_of::<Value>()));
        items.saturating_add(self.branch_count().saturating_mul(places))
    }
}

impl Column {
    /// About how many bytes the column takes. What it shares with others counts in full.
    pub fn weight(&self) -> usize {
        let plain = |size: usize| size * self.len();
        let items = match self.items() {
            Items::Booleans(_) => plain(1),
            Items::Integers(_) => plain(4),
            Items::Numbers(_) | Items::Times(_) => plain(8),
            Items::Complexes(_) | Items::Guids(_) | Items::Domains(_) => plain(16),
            Items::Points(_) | Items::Vectors(_) => plain(24),
            Items::Planes(_) => plain(96),
            Items::Lines(_) => plain(48),
            Items::Texts(texts) => texts.iter().map(|text| 2 * SHARED + text.len()).sum(),
            _ => self.iter().map(|item| size_of::<Value>() + item.as_ref().map_or(0, own)).sum(),
        };
        items + self.null_mask().map_or(0, <[bool]>::len)
    }
}

/// What a value takes besides its place.
fn own(value: &Value) -> usize {
    SHARED
        + match value {
            Value::Text(text) => text.len(),
            Value::Curve(c) => curve(c),
            Value::Surface(s) => surface(s),
            Value::Brep(b) => brep(b),
            Value::Mesh(m) => mesh(m),
            Value::Kept(raw) => raw.bytes.len(),
            Value::Matrix(m) => 8 * m.values().len(),
            Value::Group(group) => {
                group.members.iter().map(|m| size_of::<Value>() + m.as_ref().map_or(0, own)).sum()
            }
            Value::Content(content) => match &**content {
                Content::Object(object) => 512 + object.geometry.as_ref().map_or(0, own),
                Content::Block(block) => {
                    block.objects().iter().map(|object| 512 + object.geometry.as_ref().map_or(0, own)).sum()
                }
                _ => 512,
            },
            // A plane, a box, a transform: sixteen numbers at the most.
            _ => 128,
        }
}

fn curve(curve: &Curve) -> usize {
    256 + match curve {
        Curve::Line(_) | Curve::Arc(_) => 0,
        Curve::Polyline(c) => 32 * c.points().len(),
        Curve::Nurbs(c) => 40 * c.point_count(),
        Curve::Poly(c) => c.segments().iter().map(self::curve).sum(),
    }
}

fn surface(surface: &Surface) -> usize {
    512 + match surface {
        Surface::Nurbs(s) => 40 * s.point_count(),
        _ => 512,
    }
}

fn brep(brep: &Brep) -> usize {
    1024 + 3000 * brep.faces().len() + 1000 * brep.edges().len() + 64 * brep.vertices().len()
}

fn mesh(mesh: &Mesh) -> usize {
    // Vertices with normals and colours, faces, and their neighbours once they are asked for.
    512 + 64 * mesh.vertices().len() + 40 * mesh.faces().len()
}

#[cfg(test)]
mod tests {
    use crate::{Tree, Value};

    #[test]
    fn more_data_weighs_more() {
        assert_eq!(Tree::empty().weight(), 0);
        let numbers = Tree::list(vec![0.0; 1000]).weight();
        assert!((8000..9000).contains(&numbers), "{numbers}");
        let texts = Tree::item(Value::from("x".repeat(5000))).weight();
        assert!((5000..6000).contains(&texts), "{texts}");
        let mesh = katydid_geometry::Mesh::default();
        assert!(Tree::item(Value::from(mesh)).weight() > 500);
    }
}
