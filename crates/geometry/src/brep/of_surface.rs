//! A whole surface as a brep.

use super::build::{Along, NewEdge, NewVertex, Path};
use super::{Brep, Builder, LoopKind};
use crate::{
    Curve, Direction, Error, Interval, Line, LineCurve, Point3, Result, Side, Surface, Tolerance,
    cancellation,
};

impl Brep {
    /// The brep of one face that is a whole surface. Sides where the surface closes become one edge with two trims,
    /// a seam; sides that are a single point become singular trims. Edges run the way of the loop: south, east,
    /// north, west, as openNURBS has it. A surface that encloses a volume is turned to have its normals outward.
    ///
    /// # Errors
    /// The surface has no area, or sides so short that no edges can lie there.
    pub fn from_surface(surface: Surface) -> Result<Self> {
        let cuts = Direction::BOTH.map(|d| vec![surface.domain(d).start, surface.domain(d).end]);
        patches(&surface, &cuts)
    }

    /// The brep of a surface cut along its kinks: one face for every smooth part. A kink is a line of constant
    /// parameter across which the tangent turns by more than `tolerance.angle`. Parts that are only a curve or a point
    /// are left out: those of a straight piece drawn along itself, or turned about itself. A kink that openNURBS does not
    /// tell from the one before it is no line of its own, so that a hair-thin piece goes with its neighbour.
    ///
    /// # Errors
    /// As [`Brep::from_surface`].
    pub fn from_kinked_surface(surface: &Surface, tolerance: &Tolerance) -> Result<Self> {
        let cuts = Direction::BOTH.map(|d| {
            let domain = surface.domain(d);
            let mut cuts = vec![domain.start];
            cuts.extend(surface.kinks(d, tolerance.angle));
            cuts.push(domain.end);
            without_hairs(surface, d, &mut cuts);
            cuts
        });
        patches(surface, &cuts)
    }
}

/// Drops inner cuts between which and the one before, or the end, the surface has no width.
fn without_hairs(surface: &Surface, direction: Direction, cuts: &mut Vec<f64>) {
    let across = surface.domain(direction.other());
    let at = |t: f64, x: f64| match direction {
        Direction::U => surface.point_at(t, across.at(x)),
        Direction::V => surface.point_at(across.at(x), t),
    };
    let thin = |a: f64, b: f64| {
        let middle = 0.5 * (a + b);
        [0.0, 0.41, 1.0].iter().all(|&x| at(a, x).coincides(at(b, x)) && at(a, x).coincides(at(middle, x)))
    };
    let Some(end) = cuts.pop() else { return };
    cuts.dedup_by(|b, a| thin(*a, *b));
    if cuts.len() > 1 && cuts.last().is_some_and(|last| thin(*last, end)) {
        cuts.pop();
    }
    cuts.push(end);
}

/// The nodes of a grid of patches, those in one place told as one.
struct Nodes {
    counts: [usize; 2],
    same: Vec<usize>,
}

impl Nodes {
    fn root(&self, mut node: usize) -> usize {
        while let Some(&next) = self.same.get(node).filter(|next| **next != node) {
            node = next;
        }
        node
    }

    fn at(&self, i: usize, j: usize) -> usize {
        i * self.counts[1] + j
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        if let Some(place) = self.same.get_mut(a.max(b)) {
            *place = a.min(b);
        }
    }
}

/// A grid of patches under construction.
struct Grid {
    cells: Vec<Surface>,
    counts: [usize; 2],
    closed: [bool; 2],
    nodes: Nodes,
    builder: Builder,
    vertices: Vec<Option<NewVertex>>,
    edges: Vec<((Direction, usize, usize), Option<NewEdge>)>,
}

/// The faces between cuts in both directions, joined.
fn patches(surface: &Surface, cuts: &[Vec<f64>; 2]) -> Result<Brep> {
    surface.check_area()?;
    let mut bare = Vec::new();
    let counts = [cuts[0].len() - 1, cuts[1].len() - 1];
    cancellation::room::<Surface>(counts[0].saturating_mul(counts[1]))?;
    let mut cells = Vec::with_capacity(counts[0] * counts[1]);
    for u in cuts[0].windows(2) {
        for v in cuts[1].windows(2) {
            cancellation::check()?;
            let ranges = [Interval::new(u[0], u[1]), Interval::new(v[0], v[1])];
            let cell = if counts == [1, 1] {
                surface.clone()
            } else {
                surface.sub_surface(ranges[0], ranges[1])?.with_segments_as_lines()
            };
            bare.push(cell.check_area().is_err());
            cells.push(cell);
        }
    }
    let nodes = Nodes {
        counts: [counts[0] + 1, counts[1] + 1],
        same: (0..(counts[0] + 1) * (counts[1] + 1)).collect(),
    };
    let closed = Direction::BOTH.map(|d| surface.is_closed(d));
    let mut grid = Grid {
        cells,
        counts,
        closed,
        vertices: vec![None; nodes.same.len()],
        nodes,
        builder: Builder::new(),
        edges: Vec::new(),
    };
    grid.join_nodes()?;
    for i in 0..counts[0] {
        for j in 0..counts[1] {
            if bare.get(i * counts[1] + j) == Some(&false) {
                grid.face(i, j)?;
            }
        }
    }
    grid.builder.finish(f64::INFINITY)
}

impl Grid {
    fn cell(&self, i: usize, j: usize) -> Result<&Surface> {
        self.cells.get(i * self.counts[1] + j).ok_or(Error::degenerate("surface", "it has no parts"))
    }

    /// Tells nodes that are one point: over seams, along singular sides, and at the ends of closed edges.
    fn join_nodes(&mut self) -> Result<()> {
        let [m, n] = self.counts;
        for j in 0..=n {
            if self.closed[0] {
                self.nodes.join(self.nodes.at(0, j), self.nodes.at(m, j));
            }
        }
        for i in 0..=m {
            if self.closed[1] {
                self.nodes.join(self.nodes.at(i, 0), self.nodes.at(i, n));
            }
        }
        for i in 0..m {
            for j in 0..n {
                for side in Side::ALL {
                    let cell = self.cell(i, j)?;
                    if cell.is_singular(side) || cell.side_curve(side)?.is_closed() {
                        let [a, b] = self.ends(i, j, side);
                        self.nodes.join(a, b);
                    }
                }
            }
        }
        Ok(())
    }

    /// The nodes at the ends of a side of a cell, by increasing parameter.
    fn ends(&self, i: usize, j: usize, side: Side) -> [usize; 2] {
        let at = |di: usize, dj: usize| self.nodes.at(i + di, j + dj);
        match side {
            Side::South => [at(0, 0), at(1, 0)],
            Side::East => [at(1, 0), at(1, 1)],
            Side::North => [at(0, 1), at(1, 1)],
            Side::West => [at(0, 0), at(0, 1)],
        }
    }

    fn vertex(&mut self, node: usize, point: Point3) -> NewVertex {
        let root = self.nodes.root(node);
        if let Some(Some(known)) = self.vertices.get(root) {
            return *known;
        }
        let new = self.builder.vertex(point);
        if let Some(place) = self.vertices.get_mut(root) {
            *place = Some(new);
        }
        new
    }

    /// One name for the sides of neighbouring cells, and of cells over a seam.
    fn name(&self, i: usize, j: usize, side: Side) -> (Direction, usize, usize) {
        let wrapped = |k: usize, d: usize| if self.closed[d] && k == self.counts[d] { 0 } else { k };
        match side {
            Side::South => (Direction::U, i, j),
            Side::North => (Direction::U, i, wrapped(j + 1, 1)),
            Side::West => (Direction::V, i, j),
            Side::East => (Direction::V, wrapped(i + 1, 0), j),
        }
    }

    fn face(&mut self, i: usize, j: usize) -> Result<()> {
        let cell = self.cell(i, j)?.clone();
        let [u, v] = Direction::BOTH.map(|d| cell.domain(d));
        let corners = [(u.start, v.start), (u.end, v.start), (u.end, v.end), (u.start, v.end)];
        let flat = corners.map(|(u, v)| Point3::new(u, v, 0.0));
        let places = corners.map(|(u, v)| cell.point_at(u, v));
        let nodes = [self.ends(i, j, Side::South), self.ends(i, j, Side::North)];
        let nodes = [nodes[0][0], nodes[0][1], nodes[1][1], nodes[1][0]];
        let vertices: Vec<NewVertex> = nodes.iter().zip(places).map(|(n, p)| self.vertex(*n, p)).collect();
        let mut paths = Vec::with_capacity(4);
        for (k, side) in Side::ALL.into_iter().enumerate() {
            let (from, to) = (flat[k], flat[(k + 1) % 4]);
            let (along, _) = side.along();
            let ends = [vertices[k], vertices[(k + 1) % 4]];
            let domain = cell.domain(along);
            let backwards = matches!(side, Side::North | Side::West);
            let domain = if backwards { Interval::new(-domain.end, -domain.start) } else { domain };
            let curve: Curve = LineCurve { line: Line::new(from, to), domain }.into();
            let along = if cell.is_singular(side) {
                Along::Point(ends[0])
            } else {
                self.side(&cell, (i, j, side), ends, backwards)?
            };
            paths.push(Path { curve, along });
        }
        let face = self.builder.face(cell, false);
        self.builder.bound(face, LoopKind::Outer, paths)
    }

    /// The edge along a side of a cell: a known one, or a new one that runs the way of the loop.
    fn side(
        &mut self,
        cell: &Surface,
        (i, j, side): (usize, usize, Side),
        ends: [NewVertex; 2],
        backwards: bool,
    ) -> Result<Along> {
        let name = self.name(i, j, side);
        if let Some((_, Some(known))) = self.edges.iter().find(|(other, _)| *other == name) {
            // The first of two trims along an edge runs with it; that of the neighbour against it.
            return Ok(Along::Edge(*known, true));
        }
        let curve = cell.side_curve(side)?;
        let curve = if backwards { curve.reversed() } else { curve };
        let edge = self.builder.edge(curve, ends);
        self.edges.push((name, Some(edge)));
        Ok(Along::Edge(edge, false))
    }
}

impl Surface {
    /// The parameters of one direction inside the domain at which the surface has a kink: a line of constant parameter
    /// across which its tangent turns by more than `angle` somewhere, as far as samples along it tell.
    pub fn kinks(&self, direction: Direction, angle: f64) -> Vec<f64> {
        let tolerance = Tolerance { absolute: f64::INFINITY, angle };
        let domain = self.domain(direction);
        let inner = |curve: &Curve| -> Vec<f64> {
            let mut kinks = curve.discontinuities(crate::Continuity::G1, &tolerance);
            kinks.retain(|t| domain.start < *t && *t < domain.end);
            kinks
        };
        match self {
            Self::Plane(_) => Vec::new(),
            Self::Sum(s) => inner(&s.curves()[direction.index()]),
            Self::Revolution(s) if direction == s.angle_direction() => Vec::new(),
            Self::Revolution(s) => inner(s.profile()),
            Self::Nurbs(s) => {
                let knots = s.knots(direction);
                let spans = s.span_parameters(direction);
                let full = |t: &&f64| knots.iter().filter(|k| *k == *t).count() >= s.degree(direction);
                let inside = |t: &&f64| domain.start < **t && **t < domain.end;
                spans
                    .iter()
                    .filter(inside)
                    .filter(full)
                    .copied()
                    .filter(|t| self.turns_at(direction, *t, angle))
                    .collect()
            }
        }
    }

    /// Whether the tangent across a line of constant parameter turns there by more than an angle.
    fn turns_at(&self, direction: Direction, t: f64, angle: f64) -> bool {
        let along = direction.other();
        let spans = self.span_parameters(along);
        let samples =
            spans.windows(2).flat_map(|w| [0.0, 0.25, 0.5, 0.75, 1.0].map(|x| w[0] + (w[1] - w[0]) * x));
        samples.into_iter().any(|s| {
            let tangent = |below: bool| {
                let (u, v) = if direction == Direction::U { (t, s) } else { (s, t) };
                let inner = self.inner_quadrant(u, v).from_below();
                let sides = if direction == Direction::U { [below, inner[1]] } else { [inner[0], below] };
                let d = self.derivatives(u, v, 1, crate::Quadrant::new(sides[0], sides[1]));
                if direction == Direction::U { d.get(1, 0) } else { d.get(0, 1) }
            };
            tangent(true).angle_to(tangent(false)).is_some_and(|turn| turn > angle)
        })
    }
}
