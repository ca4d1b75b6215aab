use crate::box_tree::{BoxTree, bounds_of};
use crate::mesh::closest::closest_on_triangle;
use crate::{Error, Line, Mesh, Point3, Result};

/// The shape that vertices are pulled back to: a surface of triangles, and lines on it.
pub(super) struct Target {
    triangles: Vec<[Point3; 3]>,
    tree: BoxTree,
    lines: Vec<Line>,
    line_tree: BoxTree,
}

impl Target {
    pub(super) fn new(mesh: &Mesh, lines: Vec<Line>) -> Result<Self> {
        let triangles: Vec<[Point3; 3]> = mesh.triangles().collect();
        if triangles.is_empty() {
            return Err(Error::degenerate("mesh to remesh", "it has no faces"));
        }
        let boxes: Vec<_> = triangles.iter().map(|t| bounds_of(t.map(Into::into))).collect();
        let line_boxes: Vec<_> = lines.iter().map(|l| bounds_of([l.from, l.to].map(Into::into))).collect();
        Ok(Self {
            tree: BoxTree::by_place(&boxes),
            line_tree: BoxTree::by_place(&line_boxes),
            triangles,
            lines,
        })
    }

    /// The nearest point of the surface.
    pub(super) fn nearest(&self, p: Point3) -> Point3 {
        nearest(&self.tree, p, |i| self.triangles.get(i).map(|&t| closest_on_triangle(t, p).0))
    }

    /// The place of the nearest triangle.
    pub(super) fn nearest_triangle(&self, p: Point3) -> Option<usize> {
        let mut best = (f64::INFINITY, None);
        self.tree.visit_near(&p.into(), f64::INFINITY, |i| {
            if let Some(&t) = self.triangles.get(i) {
                let d = (closest_on_triangle(t, p).0 - p).length_squared();
                if d < best.0 {
                    best = (d, Some(i));
                }
            }
            best.0
        });
        best.1
    }

    /// With lines added to those that vertices are pulled to.
    pub(super) fn with_lines(mut self, more: impl IntoIterator<Item = Line>) -> Self {
        self.lines.extend(more);
        let boxes: Vec<_> = self.lines.iter().map(|l| bounds_of([l.from, l.to].map(Into::into))).collect();
        self.line_tree = BoxTree::by_place(&boxes);
        self
    }

    /// The nearest point of the lines.
    pub(super) fn nearest_on_line(&self, p: Point3) -> Point3 {
        nearest(&self.line_tree, p, |i| {
            let line = self.lines.get(i)?;
            Some(line.at(line.closest_parameter(p).clamp(0.0, 1.0)))
        })
    }
}

fn nearest(tree: &BoxTree, p: Point3, on: impl Fn(usize) -> Option<Point3>) -> Point3 {
    let mut best = (f64::INFINITY, p);
    tree.visit_near(&p.into(), f64::INFINITY, |i| {
        if let Some(q) = on(i) {
            let d = (q - p).length_squared();
            if d < best.0 {
                best = (d, q);
            }
        }
        best.0
    });
    best.1
}
