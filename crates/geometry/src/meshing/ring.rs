//! Triangles between the cells of a face that lie inside whole and its outline: a Delaunay triangulation that holds
//! both borders (spade's, with exact predicates), with more points inside where the limits ask for them.

use crate::meshing::thresholds::VANISHING;
use katydid_elementary::Elementary;
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Triangulation};

use super::fill::{Filling, PlaceMap, State};
use super::settings::Limits;
use crate::{Error, MeshFace, Point2, Result};

/// How often points are added.
const ROUNDS: usize = 16;
/// How many points are added at most: so many, and so many more for each point of the borders. A ring is thin, and needs
/// no more where the borders are those of a sound face.
const ADDED: [usize; 2] = [20_000, 24];
/// The most looks at segments of an outline that crosses itself.
const MOST_LOOKS: usize = 1_000_000_000;

/// A vertex in comparable parameters.
#[derive(Debug, Clone, Copy)]
struct Site {
    position: spade::Point2<f64>,
    vertex: u32,
}

impl HasPosition for Site {
    type Scalar = f64;

    fn position(&self) -> spade::Point2<f64> {
        self.position
    }
}

type Net = ConstrainedDelaunayTriangulation<Site>;

/// What is to be triangulated.
pub(super) struct Ring<'a, 'b> {
    pub(super) filling: &'a mut Filling<'b>,
    /// The borders: pairs of vertices, the smaller first, in order.
    pub(super) sides: Vec<[u32; 2]>,
    pub(super) limits: &'a Limits,
}

/// Adds the triangles; says which trims cross others, so that not all of the borders could be held.
///
/// # Errors
/// Numbers beyond what a triangulation takes, or an outline that crosses itself over and over.
pub(super) fn fill(ring: Ring<'_, '_>, faces: &mut Vec<MeshFace>) -> Result<Vec<u32>> {
    if ring.sides.is_empty() {
        return Ok(Vec::new());
    }
    let mut names: Vec<u32> = ring.sides.iter().flatten().chain(&ring.filling.loose).copied().collect();
    names.sort_unstable();
    names.dedup();
    let mut places: PlaceMap<u64, usize> = PlaceMap::default();
    let mut known: PlaceMap<[u64; 2], usize> = PlaceMap::default();
    let mut sites = Vec::with_capacity(names.len());
    for &vertex in &names {
        let site = ring.site(vertex);
        let bits = [site.position.x.to_bits(), site.position.y.to_bits()];
        let place = *known.entry(bits).or_insert_with(|| {
            sites.push(site);
            sites.len() - 1
        });
        places.insert(u64::from(vertex), place);
    }
    let place = |v: u32| places.get(&u64::from(v)).copied().unwrap_or(0);
    let edges: Vec<[usize; 2]> =
        ring.sides.iter().map(|&[a, b]| [place(a), place(b)]).filter(|[a, b]| a != b).collect();
    let vertices: Vec<u32> = sites.iter().map(|s| s.vertex).collect();
    let mut conflicts = Vec::new();
    let mut net = Net::try_bulk_load_cdt(sites, edges, |pair| conflicts.push(pair))
        .map_err(|why| Error::Invalid { what: "outline of a face", why: why.to_string() })?;
    let crossing = ring.trims_of(&conflicts, &vertices);
    let mut inside = ring.inside(&net)?;
    let most = ADDED[0] + net.num_vertices().saturating_mul(1 + ADDED[1]);
    for _ in 0..ROUNDS {
        let wanted = ring.wanted(&net, &inside);
        if wanted.is_empty() || net.num_vertices() + wanted.len() > most {
            break;
        }
        for [x, y] in wanted {
            let uv = Point2::new(x / ring.filling.scale[0], y / ring.filling.scale[1]);
            let uv = Point2::new(uv.x + ring.origin().x, uv.y + ring.origin().y);
            let vertex = ring.filling.add(uv, None);
            let site = Site { position: spade::Point2::new(x, y), vertex };
            net.insert(site)
                .map_err(|why| Error::Invalid { what: "outline of a face", why: why.to_string() })?;
        }
        inside = ring.inside(&net)?;
    }
    for face in net.inner_faces() {
        if inside.get(face.index()) != Some(&true) {
            continue;
        }
        let corners = face.vertices().map(|v| v.data().vertex);
        let ids = corners.map(|v| ring.filling.vertices.get(v as usize).and_then(|v| v.id));
        let same = |i: usize, j: usize| ids[i].is_some() && ids[i] == ids[j];
        if !(same(0, 1) || same(1, 2) || same(2, 0)) {
            faces.push(MeshFace::Triangle(corners));
        }
    }
    Ok(crossing)
}

impl Ring<'_, '_> {
    /// Where comparable parameters are 0.
    fn origin(&self) -> Point2 {
        self.filling.outline.corners.first().map_or(Point2::new(0.0, 0.0), |c| c.uv)
    }

    fn site(&self, vertex: u32) -> Site {
        let uv = self.uv(vertex);
        let origin = self.origin();
        let flushed = |x: f64| if x.abs() < VANISHING { 0.0 } else { x };
        let position = spade::Point2::new(
            flushed((uv.x - origin.x) * self.filling.scale[0]),
            flushed((uv.y - origin.y) * self.filling.scale[1]),
        );
        Site { position, vertex }
    }

    fn uv(&self, vertex: u32) -> Point2 {
        self.filling.vertices.get(vertex as usize).map_or(Point2::new(0.0, 0.0), |v| v.uv)
    }

    fn is_side(&self, a: u32, b: u32) -> bool {
        self.sides.binary_search(&[a.min(b), a.max(b)]).is_ok()
    }

    /// The trims of borders that could not be held.
    fn trims_of(&self, conflicts: &[[usize; 2]], vertices: &[u32]) -> Vec<u32> {
        if conflicts.is_empty() {
            return Vec::new();
        }
        let outline = self.filling.outline;
        let pairs: Vec<[u32; 2]> = (conflicts.iter())
            .map(|pair| pair.map(|k| vertices.get(k).copied().unwrap_or(0)))
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        let mut out: Vec<u32> = (0..outline.corners.len())
            .filter(|&k| {
                let (a, b) = (self.filling.corner(k), self.filling.corner(outline.next(k)));
                pairs.contains(&[a.min(b), a.max(b)])
            })
            .filter_map(|k| outline.corners.get(k).map(|c| c.trim))
            .collect();
        out.sort_unstable();
        out.dedup();
        out
    }

    /// Which triangles lie between the borders: those that a way from outside crosses borders an odd number of times
    /// to; by their middles when a border is not among the edges.
    fn inside(&self, net: &Net) -> Result<Vec<bool>> {
        let count = net.num_all_faces();
        let mut across: Vec<Vec<(u32, bool)>> = vec![Vec::new(); count];
        let mut held = 0;
        for edge in net.undirected_edges() {
            let edge = edge.as_directed();
            let [a, b] = edge.vertices().map(|v| v.data().vertex);
            let (f, g) = (edge.face().index(), edge.rev().face().index());
            let border = self.is_side(a, b);
            held += usize::from(border);
            for (f, g) in [(f, g), (g, f)] {
                if let Some(list) = across.get_mut(f) {
                    list.push((g as u32, border));
                }
            }
        }
        if held < self.sides.len() {
            if count.saturating_mul(self.filling.outline.effort()) > MOST_LOOKS {
                let why = "it crosses itself too often to tell its inside";
                return Err(Error::degenerate("outline of a face", why));
            }
            return Ok(self.inside_by_middles(net, count));
        }
        let mut inside = vec![false; count];
        let mut known = vec![false; count];
        let outer = net.outer_face().index();
        let mut stack = vec![outer];
        if let Some(slot) = known.get_mut(outer) {
            *slot = true;
        }
        while let Some(f) = stack.pop() {
            let here = inside.get(f).copied().unwrap_or(false);
            for &(g, border) in across.get(f).map_or(&[] as &[_], Vec::as_slice) {
                let g = g as usize;
                if let (Some(known), Some(slot)) = (known.get_mut(g), inside.get_mut(g))
                    && !*known
                {
                    *known = true;
                    *slot = here != border;
                    stack.push(g);
                }
            }
        }
        Ok(inside)
    }

    fn inside_by_middles(&self, net: &Net, count: usize) -> Vec<bool> {
        let mut out = vec![false; count];
        for face in net.inner_faces() {
            let corners = face.vertices().map(|v| self.uv(v.data().vertex));
            let mean = |x: [f64; 3]| (x[0] + x[1] + x[2]) / 3.0;
            let middle = Point2::new(mean(corners.map(|p| p.x)), mean(corners.map(|p| p.y)));
            let mut clean = false;
            self.filling.grid.visit(
                [[middle.x, middle.x], [middle.y, middle.y]],
                |_| true,
                |k, _| clean |= self.filling.states.get(k) == Some(&State::Clean),
            );
            if let Some(slot) = out.get_mut(face.index()) {
                *slot = !clean && self.filling.outline.contains(middle);
            }
        }
        out
    }

    /// The middles of edges that the limits ask to be divided.
    fn wanted(&self, net: &Net, inside: &[bool]) -> Vec<[f64; 2]> {
        let mut out: Vec<(usize, [f64; 2])> = Vec::new();
        for face in net.inner_faces() {
            if inside.get(face.index()) != Some(&true) {
                continue;
            }
            let corners = face.vertices().map(|v| self.uv(v.data().vertex));
            if !self.is_coarse(corners) {
                continue;
            }
            let (mut held, mut free) = (0.0_f64, None::<(f64, usize, [f64; 2])>);
            for edge in face.adjacent_edges() {
                let [a, b] = edge.positions();
                let square = (b.x - a.x).powi(2) + (b.y - a.y).powi(2);
                if edge.is_constraint_edge() {
                    held = held.max(square);
                } else if free.is_none_or(|f| square > f.0) {
                    let middle = [0.5 * (a.x + b.x), 0.5 * (a.y + b.y)];
                    free = Some((square, edge.as_undirected().index(), middle));
                }
            }
            if let Some((square, edge, middle)) = free
                && square > 0.5 * held
            {
                out.push((edge, middle));
            }
        }
        out.sort_by_key(|x| x.0);
        out.dedup_by_key(|x| x.0);
        out.into_iter().map(|x| x.1).collect()
    }

    fn is_coarse(&self, corners: [Point2; 3]) -> bool {
        let range = |x: [f64; 3]| {
            [
                x.iter().copied().fold(f64::INFINITY, f64::min),
                x.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            ]
        };
        let own = [range(corners.map(|p| p.x)), range(corners.map(|p| p.y))];
        let bend = self.filling.grid.bend(own);
        let [h, k] = own.map(|[a, b]| b - a);
        let long = (h * bend.speed[0]).hypotenuse(k * bend.speed[1]);
        if long < 2.0 * self.limits.min_edge {
            return false;
        }
        bend.triangle_distance(corners.map(|p| [p.x, p.y])) > self.limits.distance
            || h * bend.turn[0] + k * bend.turn[1] > 1.5 * self.limits.angle
            || long > 1.5 * self.limits.max_edge
    }
}
