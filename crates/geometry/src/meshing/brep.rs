//! From a brep to its mesh.

use super::bend::Bender;
use super::edges::{EdgePoints, Use, points_along};
use super::fill::{Filled, fill};
use super::grid::Grid;
use super::kinks::kink_lines;
use super::mend::{Sheet, mend};
use super::outline::{Corner, Outline};
use super::result::{BrepMesh, FaceMesh};
use super::settings::{Limits, MeshSettings};
use super::side::{Along, along, line_of, lines, narrow};
use super::track::{Source, Track};
use crate::brep::{Brep, Face, Trim, TrimKind};
use crate::meshing::thresholds::{AT_SIDE, FLAT_FACE, NO_EDGE, NO_NORMAL, ON_LINE, SAME_PLACE_ON_TRIM};
use crate::parallel::each;
use crate::{Direction, Error, Point2, Point3, Quadrant, Result, Surface, Vector3};

/// How often edges are made finer because they cross others.
const ATTEMPTS: u32 = 5;
/// How far trims may leave the domain of their surface, and edges that of their curve, in lengths of the domain.
const FAR_OUT: f64 = 2.0;
/// Trims that end and begin so near to each other, in lengths of the face's range, meet.
const SNAP: f64 = 2e-6;
/// The most points of a mesh.
const MOST_POINTS: usize = 50_000_000;

/// A face with its cells.
pub(super) struct FacePlan<'a> {
    place: usize,
    face: &'a Face,
    surface: &'a Surface,
    pub(super) grid: Grid,
    /// The trims of all loops.
    pub(super) trims: Vec<TrimPlan>,
}

/// A trim of a face.
pub(super) struct TrimPlan {
    pub(super) trim: usize,
    /// The direction that stays constant along it, and its value.
    aligned: Option<(usize, f64)>,
}

impl Brep {
    /// The mesh of all faces. Faces that share an edge share its points, so that a solid's mesh is closed; between
    /// edges it is no farther from the surfaces than the settings allow, and at edges no farther than that and the
    /// distance of the edge's curve from the surface, which no mesh can help.
    ///
    /// Cells along the parameters, as large as bounds of the second derivatives allow, are kept where they lie inside
    /// a face; between them and the edges is a Delaunay triangulation.
    ///
    /// Triangles that look backwards and edges with more than two triangles, which come where a side of a surface is a
    /// point or parameters run along each other, are mended afterwards.
    ///
    /// Known not to hold yet: where a surface folds back on itself within the tolerance, or edges lie far from the faces
    /// beside them, some small triangles look backwards; kinks inside trimmed faces are not followed. The example
    /// `mesh_breps` of `katydid-3dm` names them.
    ///
    /// # Errors
    /// A limit that is no number, a mesh with too many points, a face that has no surface or no loop, trims or edges
    /// far outside of the domains of their surfaces or curves, or an outline that crosses itself over and over.
    pub fn mesh(&self, settings: &MeshSettings) -> Result<BrepMesh> {
        self.mesh_unless(settings, &|| false)
    }

    /// [`Brep::mesh`], given up when `stop` says so: it is asked before every face and edge.
    ///
    /// # Errors
    /// As [`Brep::mesh`]; [`Error::Stopped`].
    pub fn mesh_unless(&self, settings: &MeshSettings, stop: &(dyn Fn() -> bool + Sync)) -> Result<BrepMesh> {
        self.mesh_plan(settings, stop)?.mesh()
    }
}

/// One meshing of one brep.
pub(super) struct Job<'a> {
    pub(super) brep: &'a Brep,
    pub(super) limits: Limits,
    pub(super) jagged: bool,
    pub(super) stop: &'a (dyn Fn() -> bool + Sync),
}

impl<'a> Job<'a> {
    fn check(&self) -> Result<()> {
        if (self.stop)() { Err(Error::Stopped) } else { Ok(()) }
    }

    /// The cells of all faces.
    pub(super) fn plans(&self) -> Result<Vec<FacePlan<'a>>> {
        let live: Vec<usize> = (0..self.brep.faces().len())
            .filter(|&k| self.brep.faces().get(k).is_some_and(|f| !f.deleted))
            .collect();
        each(&live, |&place| self.plan(place)).into_iter().collect()
    }

    pub(super) fn run(&self, plans: &[FacePlan<'a>]) -> Result<BrepMesh> {
        self.check_edges()?;
        let edges = self.edges(plans);
        let mut finer = vec![0_u32; edges.len()];
        let mut points: Vec<EdgePoints> = each(&edges, |edge| {
            self.check().map(|()| points_along(&edge.track, &edge.uses, &self.limits, 0))
        })
        .into_iter()
        .collect::<Result<_>>()?;
        let mut attempt = 0;
        loop {
            let shared = Shared::new(self.brep, &edges, &points)?;
            let filled: Vec<Filled> = each(plans, |plan| {
                self.check()?;
                let outline = Outline::new(&shared.polygons(self.brep, plan));
                fill(plan.surface, &plan.grid, &outline, &self.limits)
            })
            .into_iter()
            .collect::<Result<_>>()?;
            attempt += 1;
            let mut again: Vec<usize> = (filled.iter())
                .flat_map(|f| &f.crossing)
                .filter_map(|&trim| shared.edge_of(trim as usize))
                .collect();
            again.sort_unstable();
            again.dedup();
            if again.is_empty() || attempt >= ATTEMPTS {
                return Ok(self.gathered(plans, shared, filled));
            }
            for k in again {
                let (Some(level), Some(edge)) = (finer.get_mut(k), edges.get(k)) else { continue };
                *level += 1;
                let fine = points_along(&edge.track, &edge.uses, &self.limits, *level + 1);
                if let Some(slot) = points.get_mut(k) {
                    *slot = fine;
                }
            }
        }
    }

    /// Refuses edges that lie far beyond the ends of their curves.
    fn check_edges(&self) -> Result<()> {
        for (place, edge) in self.brep.edges().iter().enumerate().filter(|(_, edge)| !edge.deleted) {
            let Some(domain) = self.brep.edge_curve(place).map(crate::Curve::domain) else { continue };
            let reach = FAR_OUT * domain.length();
            let range = edge.part.range;
            if range.min() < domain.start - reach || range.max() > domain.end + reach {
                return Err(Error::degenerate(
                    "edge of the brep",
                    "it lies far beyond the ends of its curve",
                ));
            }
        }
        Ok(())
    }

    /// The cells of a face.
    fn plan(&self, place: usize) -> Result<FacePlan<'a>> {
        self.check()?;
        let no = |why: &'static str| Error::degenerate("face of the brep", why);
        let face = self.brep.faces().get(place).ok_or(no("it does not exist"))?;
        let surface = self.brep.face_surface(place).ok_or(no("it has no surface"))?;
        let loops = face.loops.iter().filter_map(|l| self.brep.loops().get(*l));
        let names: Vec<usize> = loops.flat_map(|chain| chain.trims.iter().copied()).collect();
        if names.is_empty() {
            return Err(no("it has no loop"));
        }
        let domain = Direction::BOTH.map(|d| surface.domain(d));
        let narrow = narrow(surface, domain, self.limits.distance);
        let mut reach = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        let mut trims = Vec::with_capacity(names.len());
        for trim in names {
            let Along { aligned, bounds } = self
                .brep
                .trims()
                .get(trim)
                .and_then(|t| along(self.brep.trim_curve(trim)?, t.part, domain, narrow))
                .ok_or(no("a trim has no curve"))?;
            for d in 0..2 {
                reach[d] = [reach[d][0].min(bounds[d][0]), reach[d][1].max(bounds[d][1])];
            }
            trims.push(TrimPlan { trim, aligned });
        }
        // A surface goes on beyond its domain by its formula, but what a file means is never far out there.
        let far = (0..2).any(|d| {
            let length = domain[d].length();
            reach[d][0] < domain[d].start - FAR_OUT * length || reach[d][1] > domain[d].end + FAR_OUT * length
        });
        if far {
            return Err(no("a trim lies far outside of the domain of its surface"));
        }
        let lines_with = |extra: &dyn Fn(Direction) -> Vec<f64>| {
            [0, 1].map(|d| {
                let [from, to] = reach[d];
                let near =
                    |t: f64, end: f64| if (t - end).abs() < AT_SIDE * domain[d].length() { end } else { t };
                let [from, to] = [near(from, domain[d].start), near(to, domain[d].end)];
                let values: Vec<f64> =
                    (trims.iter()).filter_map(|t| t.aligned.filter(|a| a.0 == d).map(|a| a.1)).collect();
                lines([from, to], &values, &extra(Direction::BOTH[d]), narrow[d])
            })
        };
        let breaks = lines_with(&|d| kink_lines(surface, d));
        let pieces = lines_with(&|d| surface.span_parameters(d));
        if breaks.iter().any(|list| list.len() < 2) {
            return Err(no("its loops have no extent"));
        }
        for (d, value) in trims.iter_mut().filter_map(|t| t.aligned.as_mut()) {
            *value = line_of(&breaks[*d], *value, narrow[*d]);
        }
        let flat = self.limits.simple_planes && surface.is_planar(FLAT_FACE * self.limits.distance);
        let grid = Grid::new(&Bender::new(surface), breaks, &pieces, &self.limits, flat)?;
        Ok(FacePlan { place, face, surface, grid, trims })
    }

    /// All edges with the trims along them, and trims without an edge of their own.
    fn edges<'b>(&self, plans: &'b [FacePlan<'a>]) -> Vec<EdgePlan<'b>>
    where
        'a: 'b,
    {
        let brep = self.brep;
        let mut out: Vec<EdgePlan<'b>> = Vec::new();
        // For every edge of the brep its plan.
        let mut known: Vec<Option<usize>> = vec![None; brep.edges().len()];
        for plan in plans {
            for trim_plan in &plan.trims {
                let Some(trim) = brep.trims().get(trim_plan.trim) else { continue };
                let Some(curve) = brep.trim_curve(trim_plan.trim) else { continue };
                let lifted =
                    |backwards| Track::new(Source::Lifted(curve, trim.part, plan.surface), backwards);
                let is_point = trim.edge.is_none()
                    && (trim.kind == TrimKind::Singular
                        || lifted(false).length <= NO_EDGE * self.limits.distance);
                let own = trim
                    .edge
                    .filter(|_| !self.jagged)
                    .and_then(|e| Some((e, brep.edges().get(e)?.part, brep.edge_curve(e)?)));
                let used = |backwards: bool| Use {
                    trim: trim_plan.trim,
                    track: lifted(backwards),
                    grid: &plan.grid,
                    aligned: trim_plan.aligned,
                    wanted: wanted(&plan.grid, &lifted(backwards), trim_plan.aligned),
                };
                match own {
                    Some((e, part, curve)) if !is_point => {
                        let k = known.get(e).copied().flatten().unwrap_or_else(|| {
                            out.push(EdgePlan {
                                edge: Some(e),
                                track: Track::new(Source::Space(curve, part), false),
                                uses: Vec::new(),
                                point: false,
                            });
                            out.len() - 1
                        });
                        if let Some(slot) = known.get_mut(e) {
                            *slot = Some(k);
                        }
                        if let Some(edge) = out.get_mut(k) {
                            edge.uses.push(used(trim.reversed));
                        }
                    }
                    _ => out.push(EdgePlan {
                        edge: None,
                        track: lifted(false),
                        uses: vec![used(false)],
                        point: is_point,
                    }),
                }
            }
        }
        out
    }

    fn gathered(&self, plans: &[FacePlan<'a>], shared: Shared, filled: Vec<Filled>) -> BrepMesh {
        let mut points = shared.points;
        let mut faces = Vec::with_capacity(plans.len());
        let work: Vec<(&FacePlan<'a>, &Filled)> = plans.iter().zip(&filled).collect();
        let placed = each(&work, |(plan, filled)| {
            let mut sheet = placed(plan, filled, &points);
            mend(plan.surface, &plan.grid, &self.limits, filled, &mut sheet, self.stop);
            sheet
        });
        let mut welds: Vec<[u32; 2]> = Vec::new();
        for ((plan, filled), sheet) in plans.iter().zip(filled).zip(placed) {
            let places = (sheet.vertices.iter().zip(&sheet.points))
                .map(|(v, &p)| {
                    v.id.unwrap_or_else(|| {
                        points.push(p);
                        points.len() as u32 - 1
                    })
                })
                .collect();
            let polygons = sheet.faces.unwrap_or(filled.faces);
            welds.extend(filled.welds);
            let turned = plan.face.reversed;
            faces.push(FaceMesh {
                face: plan.place,
                places,
                parameters: sheet.vertices.iter().map(|v| v.uv).collect(),
                normals: sheet.normals.into_iter().map(|n| if turned { -n } else { n }).collect(),
                faces: polygons.into_iter().map(|f| if turned { f.flipped() } else { f }).collect(),
            });
        }
        BrepMesh::new(points, faces, &welds)
    }
}

/// An edge to be, with the trims along it.
struct EdgePlan<'b> {
    /// The brep's edge; none for a trim without one.
    edge: Option<usize>,
    track: Track<'b>,
    uses: Vec<Use<'b>>,
    /// Whether all of it is one point.
    point: bool,
}

/// The places of a trim where lines of cells meet it: those of the line that it runs along.
fn wanted(grid: &Grid, track: &Track<'_>, aligned: Option<(usize, f64)>) -> Vec<(f64, Point2)> {
    let Some((d, value)) = aligned else { return Vec::new() };
    let (start, end) = (track.flat(0.0), track.flat(1.0));
    let along = |p: Point2| if d == 0 { p.y } else { p.x };
    let (from, to) = (along(start), along(end));
    let Some(line) = grid.place(d, value) else { return Vec::new() };
    grid.places_on(d, line, [from.min(to), from.max(to)])
        .into_iter()
        .filter_map(|t| {
            let x = (t - from) / (to - from);
            // The trim need not run evenly.
            let (mut low, mut high, mut y) = (0.0, 1.0, x);
            for _ in 0..60 {
                let here = along(track.flat(y));
                if (here - t).abs() <= SAME_PLACE_ON_TRIM * (to - from).abs() {
                    break;
                }
                if (here < t) == (to > from) {
                    low = y;
                } else {
                    high = y;
                }
                let next = y + (t - here) / (to - from);
                y = if next > low && next < high { next } else { 0.5 * (low + high) };
            }
            let uv = if d == 0 { Point2::new(value, t) } else { Point2::new(t, value) };
            (y > 0.0 && y < 1.0).then_some((y, uv))
        })
        .collect()
}

/// The points and normals of a face's vertices; `shared` are the points of edges.
fn placed(plan: &FacePlan<'_>, filled: &Filled, shared: &[Point3]) -> Sheet {
    let mut points = Vec::with_capacity(filled.vertices.len());
    let mut normals = Vec::with_capacity(filled.vertices.len());
    for vertex in &filled.vertices {
        let (u, v) = (vertex.uv.x, vertex.uv.y);
        let (point, normal) = point_and_normal(plan.surface, u, v);
        points.push(vertex.id.and_then(|id| shared.get(id as usize).copied()).unwrap_or(point));
        normals.push(normal.unwrap_or(Vector3::ZERO));
    }
    Sheet { vertices: filled.vertices.clone(), points, normals, faces: None }
}

/// The point and the unit normal.
fn point_and_normal(surface: &Surface, u: f64, v: f64) -> (Point3, Option<Vector3>) {
    if let Surface::Nurbs(nurbs) = surface {
        let east = u >= nurbs.domain(Direction::U).end;
        let north = v >= nurbs.domain(Direction::V).end;
        let [p, by_u, by_v] = nurbs.partials_at(u, v, Quadrant::new(east, north));
        let normal = by_u.cross(by_v);
        // Where one derivative is lost in the other the normal is a limit.
        if normal.length() > NO_NORMAL * by_u.dot(by_u).max(by_v.dot(by_v)) {
            return (p.to_point(), normal.unitized());
        }
    }
    (surface.point_at(u, v), surface.normal_at(u, v))
}

/// The edge plan along a trim, and the trim's points as (place, parameters), in its own sense.
type TrimPoints = (usize, Vec<(u32, Point2)>);

/// The points that faces share, and where those of every trim are.
struct Shared {
    points: Vec<Point3>,
    /// For every trim of the brep.
    trims: Vec<Option<TrimPoints>>,
}

impl Shared {
    fn new(brep: &Brep, edges: &[EdgePlan<'_>], found: &[EdgePoints]) -> Result<Self> {
        let mut points: Vec<Point3> = brep.vertices().iter().map(|v| v.point).collect();
        let mut trims: Vec<Option<TrimPoints>> = vec![None; brep.trims().len()];
        for (k, (edge, found)) in edges.iter().zip(found).enumerate() {
            if points.len() + found.points.len() > MOST_POINTS {
                return Err(Error::OutOfRange {
                    what: "number of mesh points",
                    value: (points.len() + found.points.len()) as f64,
                    must: "at most 50 million",
                });
            }
            let single = edge.uses.first().and_then(|u| brep.trims().get(u.trim));
            let ends = match (edge.edge.and_then(|e| brep.edges().get(e)), single) {
                (Some(own), _) => own.vertices,
                (None, Some(trim)) => ends_of(brep, trim),
                (None, None) => [None; 2],
            };
            let last = found.points.len().saturating_sub(1);
            let mut names: Vec<u32> = Vec::with_capacity(found.points.len());
            for (i, &p) in found.points.iter().enumerate() {
                let known = if i == 0 {
                    ends[0]
                } else if i == last {
                    ends[1]
                } else if edge.point {
                    ends[0]
                } else {
                    None
                };
                names.push(match known {
                    Some(v) if v < brep.vertices().len() => v as u32,
                    _ if edge.point && i > 0 => names.first().copied().unwrap_or(0),
                    _ => {
                        points.push(p);
                        points.len() as u32 - 1
                    }
                });
            }
            for (trim, flat) in &found.uses {
                let mut list: Vec<(u32, Point2)> = names.iter().copied().zip(flat.iter().copied()).collect();
                let backwards =
                    edge.edge.is_some() && brep.trims().get(*trim).is_some_and(|trim| trim.reversed);
                if backwards {
                    list.reverse();
                }
                if let Some(slot) = trims.get_mut(*trim) {
                    *slot = Some((k, list));
                }
            }
        }
        Ok(Self { points, trims })
    }

    /// The plan of the edge along a trim.
    fn edge_of(&self, trim: usize) -> Option<usize> {
        self.trims.get(trim)?.as_ref().map(|t| t.0)
    }

    /// The loops of a face as polygons.
    fn polygons(&self, brep: &Brep, plan: &FacePlan<'_>) -> Vec<Vec<Corner>> {
        let aligned = |trim: usize| plan.trims.iter().find(|t| t.trim == trim).and_then(|t| t.aligned);
        let size = [0, 1].map(|d| match plan.grid.lines[d].as_slice() {
            [first, .., last] => last - first,
            _ => 1.0,
        });
        let loops = plan.face.loops.iter().filter_map(|l| brep.loops().get(*l));
        loops
            .map(|chain| {
                let mut out: Vec<Corner> = Vec::new();
                let n = chain.trims.len();
                for (i, &trim) in chain.trims.iter().enumerate() {
                    let Some(Some((_, list))) = self.trims.get(trim) else { continue };
                    let next = chain.trims.get((i + 1) % n).copied().unwrap_or(trim);
                    let corner = |&(id, uv): &(u32, Point2)| Corner { uv, id, trim: trim as u32 };
                    let start = out.len();
                    out.extend(list.iter().map(corner));
                    // The corner with the next trim: exactly on the lines that both run along.
                    let meets = self.trims.get(next).and_then(|t| t.as_ref()).and_then(|t| t.1.first());
                    let (Some(&(id, uv)), Some(last)) = (meets, out.last().copied()) else { continue };
                    let gap = ((last.uv.x - uv.x) / size[0]).abs().max(((last.uv.y - uv.y) / size[1]).abs());
                    if gap > SNAP || id != last.id {
                        if id == last.id && start + 1 == out.len() {
                            out.pop();
                        }
                        continue;
                    }
                    out.pop();
                }
                snap_corners(&mut out, &aligned, size);
                out.dedup_by(|b, a| a.id == b.id && a.uv == b.uv);
                while out.len() > 1 && out.first().map(|c| (c.id, c.uv)) == out.last().map(|c| (c.id, c.uv)) {
                    out.pop();
                }
                out
            })
            .collect()
    }
}

/// Puts the corner where an aligned trim ends exactly on its line, although the next trim begins there.
fn snap_corners(polygon: &mut [Corner], aligned: &impl Fn(usize) -> Option<(usize, f64)>, size: [f64; 2]) {
    let near = |d: usize, x: f64, value: f64| {
        (x - value).abs() <= (ON_LINE * value.abs().max(1.0)).max(SNAP * size[d])
    };
    let n = polygon.len();
    for k in 0..n {
        let (Some(before), Some(here)) = (polygon.get((k + n - 1) % n).copied(), polygon.get_mut(k)) else {
            continue;
        };
        if before.trim == here.trim {
            continue;
        }
        match aligned(before.trim as usize) {
            Some((0, value)) if near(0, here.uv.x, value) => here.uv.x = value,
            Some((1, value)) if near(1, here.uv.y, value) => here.uv.y = value,
            _ => {}
        }
    }
}

/// The vertices at the ends of a trim: its own, else those of its edge.
fn ends_of(brep: &Brep, trim: &Trim) -> [Option<usize>; 2] {
    if trim.vertices.iter().all(Option::is_some) {
        return trim.vertices;
    }
    let Some(edge) = trim.edge.and_then(|e| brep.edges().get(e)) else { return trim.vertices };
    let [a, b] = edge.vertices;
    if trim.reversed { [b, a] } else { [a, b] }
}
