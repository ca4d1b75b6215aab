//! The control net: rings, tubes, joints and caps.

use super::chain::{Chain, carried, chains, turned, twist};
use super::cube::{Cube, SIDES};
use super::network::MultiPipeNetwork;
use super::node::{Node, nodes};
use super::{CAGE, MultiPipe, MultiPipeCap, Ring};
use crate::cloud::convex_hull_3d;
use crate::subd::thresholds::BETTER;
use crate::subd::{SubDEdgeTag, SubDNet};
use crate::{Error, Mesh, MeshFace, Point3, Result, Vector3};

/// The most faces.
const MOST: usize = 1_000_000;
/// How far triangles of a joint may be from one plane to become a quad, in radians, and how unlike the diagonals.
const NEARLY_FLAT: (f64, f64) = (0.6, 0.5);

/// The net of a pipe.
pub(super) fn built(options: &MultiPipe, network: &MultiPipeNetwork) -> Result<SubDNet> {
    if network.struts.is_empty() {
        return Err(Error::degenerate("network", "it has no struts"));
    }
    let nodes = nodes(options, network)?;
    let mut pipe = Pipe {
        options,
        network,
        nodes: &nodes,
        points: Vec::new(),
        faces: Vec::new(),
        rings: vec![Vec::new(); nodes.len()],
        cubes: vec![None; nodes.len()],
        rims: Vec::new(),
    };
    for chain in chains(network, &nodes) {
        pipe.add_chain(&chain)?;
    }
    for node in 0..nodes.len() {
        pipe.close(node)?;
    }
    pipe.finish()
}

/// A pipe under construction.
struct Pipe<'a> {
    options: &'a MultiPipe,
    network: &'a MultiPipeNetwork,
    nodes: &'a [Node],
    points: Vec<Point3>,
    faces: Vec<Vec<usize>>,
    /// The rings at each node, seen from the node.
    rings: Vec<Vec<Ring>>,
    /// The first corner of the cube at each node that has one.
    cubes: Vec<Option<usize>>,
    /// Rings whose sides are sharp.
    rims: Vec<Ring>,
}

/// A ring walked the other way about.
fn backward([a, b, c, d]: Ring) -> Ring {
    [d, c, b, a]
}

impl Pipe<'_> {
    fn add_points(&mut self, points: [Point3; 4]) -> Ring {
        let first = self.points.len();
        self.points.extend(points);
        [first, first + 1, first + 2, first + 3]
    }

    fn place(&self, ring: Ring) -> [Point3; 4] {
        ring.map(|k| self.points[k])
    }

    /// A circle's four corners about a direction, the first where the frame points.
    fn corners(middle: Point3, direction: Vector3, frame: Vector3, reach: f64) -> [Point3; 4] {
        let side = direction.cross(frame);
        [frame, side, -frame, -side].map(|way| middle + way * reach)
    }

    /// The ring of the cube at a node through which a direction passes, counter-clockwise about the direction.
    fn ring_of_cube(&mut self, node: usize, cube: &Cube, direction: Vector3) -> Ring {
        let first = *self.cubes[node].get_or_insert_with(|| {
            self.points.extend(cube.corners);
            self.points.len() - 8
        });
        SIDES[cube.side(direction)].map(|corner| first + corner)
    }

    fn add_chain(&mut self, chain: &Chain) -> Result<()> {
        let directions = chain.directions(self.network);
        let stations = chain.nodes(self.network);
        let (Some(&first), Some(&last)) = (directions.first(), directions.last()) else { return Ok(()) };
        let (start, end) = (stations[0], stations[stations.len() - 1]);
        // Cubes say where their rings stand; other rings stand anyhow.
        let wanted = |node: usize, direction: Vector3, outward: f64| match &self.nodes[node] {
            Node::Cube(cube) if !chain.closed => {
                let side = SIDES[cube.side(direction * outward)];
                let middle =
                    side.iter().fold(Vector3::ZERO, |sum, k| sum + cube.corners[*k].to_vector()) / 4.0;
                (cube.corners[side[0]].to_vector() - middle).rejected_from(direction)?.unitized()
            }
            _ => None,
        };
        let (head, tail) = (wanted(start, first, 1.0), wanted(end, last, -1.0));
        let free = first.perpendicular().unwrap_or(Vector3::X);
        let mut frames = carried(head.unwrap_or(free), &directions);
        let arrived = frames.last().copied().unwrap_or(free);
        // What is left over where the chain comes to something that stands already is spread along it.
        let over = if chain.closed {
            twist(turned(arrived, last, first), frames[0], first)
        } else {
            tail.map_or(0.0, |tail| twist(arrived, tail, last))
        };
        let share = |k: usize| {
            let full =
                if chain.closed || head.is_some() { over * k as f64 / directions.len() as f64 } else { over };
            if full.is_finite() { full } else { 0.0 }
        };
        for (k, frame) in frames.iter_mut().enumerate() {
            *frame = frame.rotated(share(k), directions[k]).unwrap_or(*frame);
        }
        let mut before = self.head(chain, &stations, &directions, &frames);
        let whole = before;
        for k in 0..directions.len() {
            let ring = match (k + 1 < directions.len(), chain.closed) {
                (true, _) => self.through(stations[k + 1], directions[k], directions[k + 1], frames[k + 1]),
                (false, true) => whole,
                (false, false) => self.tail(end, last, frames[k].rotated(share(k + 1) - share(k), last)),
            };
            self.tube(before, ring, k, chain)?;
            before = ring;
        }
        Ok(())
    }

    /// The first ring of a chain.
    fn head(
        &mut self,
        chain: &Chain,
        stations: &[usize],
        directions: &[Vector3],
        frames: &[Vector3],
    ) -> Ring {
        let (node, direction, frame) = (stations[0], directions[0], frames[0]);
        if chain.closed {
            return self.through(node, directions[directions.len() - 1], direction, frame);
        }
        let ring = self.at_node(node, direction, frame);
        self.rings[node].push(ring);
        ring
    }

    /// The last ring of a chain that comes to a node along a direction.
    fn tail(&mut self, node: usize, direction: Vector3, frame: Option<Vector3>) -> Ring {
        let frame = frame.unwrap_or(Vector3::X);
        // Seen from the node it runs the other way about.
        let ring = self.at_node(node, -direction, frame);
        self.rings[node].push(ring);
        backward(ring)
    }

    /// The ring about a strut that leaves a node in a direction.
    fn at_node(&mut self, node: usize, direction: Vector3, frame: Vector3) -> Ring {
        let middle = self.network.nodes[node];
        match &self.nodes[node] {
            Node::End { reach } | Node::Through { reach } => {
                self.add_points(Self::corners(middle, direction, frame, *reach))
            }
            Node::Joint { reach, distance } => {
                self.add_points(Self::corners(middle + direction * *distance, direction, frame, *reach))
            }
            Node::Cube(cube) => self.ring_of_cube(node, &cube.clone(), direction),
        }
    }

    /// The ring in the plane between two struts: that about the second, drawn along it.
    fn through(&mut self, node: usize, from: Vector3, to: Vector3, frame: Vector3) -> Ring {
        let (middle, normal) = (self.network.nodes[node], from + to);
        let reach = if let Node::Through { reach } = self.nodes[node] { reach } else { 0.0 };
        let across = normal.dot(to);
        let drawn = Self::corners(middle, to, frame, reach)
            .map(|p| if across > 0.0 { p - to * (normal.dot(p - middle) / across) } else { p });
        self.add_points(drawn)
    }

    /// Quads from one ring to the next, both counter-clockwise about the way between them.
    fn tube(&mut self, from: Ring, to: Ring, k: usize, chain: &Chain) -> Result<()> {
        let to = self.matched(from, to);
        let [a, b] = [from, to].map(|ring| self.place(ring));
        let middle = |ring: &[Point3; 4]| ring.iter().fold(Vector3::ZERO, |sum, p| sum + p.to_vector()) / 4.0;
        let strut = chain.struts.get(k).map_or(0.0, |(strut, _)| self.network.length(*strut));
        let free = (middle(&b) - middle(&a)).length().min(strut);
        let (segment, size) = (self.options.segment, self.options.strut_size);
        let mut parts = if segment > 0.0 { (free / segment).round().max(1.0) } else { 1.0 };
        if size != 1.0 {
            parts = parts.max(2.0);
        }
        if !(self.faces.len() as f64 + 4.0 * parts <= MOST as f64) {
            return Err(too_many());
        }
        let mut before = from;
        for n in 1..=parts as usize {
            let ring = if n as f64 == parts {
                to
            } else {
                let x = n as f64 / parts;
                let between: [Point3; 4] = std::array::from_fn(|k| a[k].lerp(b[k], x));
                let centre = middle(&between).to_point();
                self.add_points(between.map(|p| centre + (p - centre) * size))
            };
            for k in 0..4 {
                let next = (k + 1) % 4;
                self.faces.push(vec![before[k], before[next], ring[next], ring[k]]);
            }
            before = ring;
        }
        Ok(())
    }

    /// The second ring begun where it lies nearest to the first.
    fn matched(&self, from: Ring, to: Ring) -> Ring {
        let [a, b] = [from, to].map(|ring| self.place(ring));
        let middle = |ring: &[Point3; 4]| ring.iter().fold(Vector3::ZERO, |sum, p| sum + p.to_vector()) / 4.0;
        let (m, n) = (middle(&a), middle(&b));
        // How alike the arms are; the way between the middles says nothing.
        let fit = |shift: usize| -> f64 {
            (0..4).map(|k| (a[k].to_vector() - m).dot(b[(k + shift) % 4].to_vector() - n)).sum()
        };
        let best = (0..4).fold(0, |best, shift| if fit(shift) > fit(best) + BETTER { shift } else { best });
        std::array::from_fn(|k| to[(k + best) % 4])
    }

    /// What closes the pipe at a node, between its rings.
    fn close(&mut self, node: usize) -> Result<()> {
        let rings = std::mem::take(&mut self.rings[node]);
        match (&self.nodes[node], rings.as_slice()) {
            (Node::End { reach }, [ring]) => self.cap(node, *ring, *reach),
            (Node::Joint { .. }, rings) => self.joint(node, rings)?,
            (Node::Cube(_), rings) => {
                let Some(first) = self.cubes[node] else { return Ok(()) };
                for side in SIDES.map(|side| side.map(|corner| first + corner)) {
                    if !rings.contains(&side) {
                        self.faces.push(side.to_vec());
                    }
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Closes an end whose ring runs counter-clockwise about the strut that leaves it.
    fn cap(&mut self, node: usize, ring: Ring, reach: f64) {
        match self.options.caps {
            MultiPipeCap::Open => {}
            MultiPipeCap::Flat => {
                self.rims.push(ring);
                self.faces.push(backward(ring).to_vec());
            }
            MultiPipeCap::Round => {
                let corners = self.place(ring);
                let (x, y) = (corners[0] - corners[2], corners[1] - corners[3]);
                let Some(out) = y.cross(x).unitized() else { return };
                let centre = self.network.nodes[node];
                // Nearly the end of a rounded cube.
                let beyond = centre + out * (reach / CAGE);
                let cap = self.add_points(corners.map(|p| beyond + (p - centre) * 0.75));
                for k in 0..4 {
                    let next = (k + 1) % 4;
                    self.faces.push(vec![cap[k], cap[next], ring[next], ring[k]]);
                }
                self.faces.push(backward(cap).to_vec());
            }
        }
    }

    /// The hull of the rings around a node, without the rings themselves.
    fn joint(&mut self, node: usize, rings: &[Ring]) -> Result<()> {
        let close = || {
            let p = self.network.nodes[node];
            let why = format!("struts are too close to each other at ({}, {}, {})", p.x, p.y, p.z);
            Error::Invalid { what: "network", why }
        };
        let centre = self.network.nodes[node];
        let mut names: Vec<usize> = rings.iter().flatten().copied().collect();
        let mut points: Vec<Point3> = names.iter().map(|k| (self.points[*k] - centre).to_point()).collect();
        // Where all struts go to one side, a point on the other makes the hull pass round the node.
        let middles = rings.iter().map(|ring| {
            ring.iter()
                .fold(Vector3::ZERO, |sum, k| sum + (self.points[*k] - centre))
                .unitized()
                .unwrap_or(Vector3::Z)
        });
        let ways: Vec<Vector3> = middles.collect();
        let sum = ways.iter().fold(Vector3::ZERO, |sum, way| sum + *way);
        let reach = if let Node::Joint { reach, .. } = self.nodes[node] { reach } else { 0.0 };
        let one_sided = sum.unitized().filter(|side| ways.iter().all(|way| way.dot(*side) > 0.1));
        let back = one_sided.map(|side| centre - side * reach);
        if let Some(back) = back {
            names.push(self.points.len());
            points.push((back - centre).to_point());
        }
        let hull = convex_hull_3d(&points).map_err(|_| close())?;
        let of_ring = |corner: u32| corner / 4;
        let apart = |t: &[u32; 3]| {
            !(of_ring(t[0]) == of_ring(t[1])
                && of_ring(t[1]) == of_ring(t[2])
                && of_ring(t[0]) < rings.len() as u32)
        };
        let left: Vec<[u32; 3]> = hull.iter().copied().filter(apart).collect();
        // Two triangles for each ring are gone, unless a ring is no face of the hull.
        if left.len() + 2 * rings.len() != hull.len() {
            return Err(close());
        }
        self.points.extend(back);
        let between = Mesh::new(points, left.into_iter().map(MeshFace::Triangle).collect())?;
        let (between, _) = between.quadrangulated(NEARLY_FLAT.0, NEARLY_FLAT.1);
        for face in between.faces() {
            self.faces.push(face.indices().iter().filter_map(|k| names.get(*k as usize)).copied().collect());
        }
        if self.faces.len() > MOST { Err(too_many()) } else { Ok(()) }
    }

    fn finish(self) -> Result<SubDNet> {
        let net = SubDNet::from_polygons(self.points, &self.faces)?;
        if self.rims.is_empty() {
            return Ok(net);
        }
        let sides: std::collections::HashSet<[usize; 2]> = (self.rims.iter())
            .flat_map(|ring| (0..4).map(|k| [ring[k], ring[(k + 1) % 4]]))
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        let sharp: Vec<usize> = (net.edges().iter().enumerate())
            .filter(|(_, edge)| {
                let [a, b] = edge.vertices;
                sides.contains(&[a.min(b), a.max(b)])
            })
            .map(|(place, _)| place)
            .collect();
        net.with_edge_tag(&sharp, SubDEdgeTag::Crease)
    }
}

fn too_many() -> Error {
    Error::Invalid { what: "pipe", why: format!("it would have more than {MOST} faces") }
}
