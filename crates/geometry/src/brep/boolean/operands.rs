//! The faces and edges of all operands in common tables. The operands themselves are never changed.

use std::cell::OnceCell;
use std::collections::BTreeSet;
use std::sync::{Arc as Shared, Mutex, OnceLock, PoisonError};

use super::FaceName;
use super::refusal::{Refusal, RefusalClass};
use super::thresholds::{EXACT, MOST_FACES};
use super::vertices::Vertices;
use crate::brep::inside::ClosestOnBrep;
use crate::intersect::Carrier;
use crate::region::Outline;
use crate::surface::Round;
use crate::{
    BoundingBox, Brep, ClosestOnCurve, ClosestOnSurface, Curve, Error, Plane, PlaneSurface, Point3, Result,
    Surface, Vector3, cancellation,
};

/// An edge of an operand.
#[derive(Debug)]
pub(super) struct Edge {
    /// The operand.
    pub(super) solid: usize,
    pub(super) curve: Curve,
    /// The vertices at its start and end.
    pub(super) ends: [usize; 2],
    pub(super) bounds: BoundingBox,
}

impl Edge {
    /// The parameter of the place nearest to a point, if it is nearer than a distance.
    pub(super) fn parameter_near(&self, p: Point3, reach: f64) -> Result<Option<f64>> {
        near(&self.curve, p, reach)
    }
}

/// The parameter of a curve's place nearest to a point, if it is nearer than a distance.
pub(super) fn near(curve: &Curve, p: Point3, reach: f64) -> Result<Option<f64>> {
    Near::of(curve).parameter(p, reach)
}

/// The points in which segments of a curve meet: curves upon each other may part there.
fn joints(curve: &Curve) -> Vec<Point3> {
    match curve {
        Curve::Poly(c) => c.segments().iter().skip(1).map(Curve::start).collect(),
        Curve::Polyline(c) => {
            let inner = c.points().len().saturating_sub(1);
            c.points().iter().take(inner).skip(1).copied().collect()
        }
        _ => Vec::new(),
    }
}

/// A curve that is asked several times for its place nearest to a point; prepared when it is asked first.
pub(super) struct Near<'a> {
    curve: &'a Curve,
    search: OnceCell<ClosestOnCurve<'a>>,
}

impl<'a> Near<'a> {
    pub(super) fn of(curve: &'a Curve) -> Self {
        Self { curve, search: OnceCell::new() }
    }

    /// The parameter of the place nearest to a point, if it is nearer than a distance.
    pub(super) fn parameter(&self, p: Point3, reach: f64) -> Result<Option<f64>> {
        if let Curve::Line(c) = self.curve {
            let t = c.line.closest_parameter(p).clamp(0.0, 1.0);
            return Ok((c.line.at(t).distance_to(p) <= reach).then(|| c.domain.at(t)));
        }
        let search = self.search.get_or_init(|| ClosestOnCurve::new(self.curve));
        // Within the domain also to the last digit: curves are trimmed at it.
        Ok(search.nearest_within(p, reach)?.map(|near| self.curve.domain().clamp(near.parameter)))
    }
}

/// A piece of the boundary of a face in the parameter plane.
#[derive(Debug)]
pub(super) struct Bound {
    /// The edge and whether it is run backwards; none where the surface is a point.
    pub(super) edge: Option<(usize, bool)>,
    /// The vertex at which it starts.
    pub(super) start: usize,
    pub(super) curve: Curve,
}

/// How parameters of points are found.
#[derive(Debug)]
enum Form {
    Plane(PlaneSurface),
    Round(Box<Round>),
    Other,
}

/// Where a point lies on a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Place {
    Inside([f64; 2]),
    Border,
    Outside,
}

/// A face of an operand.
#[derive(Debug)]
pub(super) struct Face {
    pub(super) solid: usize,
    /// Its place in the operand.
    pub(super) place: usize,
    pub(super) surface: Surface,
    /// Whether its normal is opposite to the surface's.
    pub(super) reversed: bool,
    pub(super) loops: Vec<Vec<Bound>>,
    /// The edges around it.
    pub(super) border: BTreeSet<usize>,
    pub(super) bounds: BoundingBox,
    pub(super) size: f64,
    outlines: Vec<Outline>,
    form: Form,
    closest: OnceLock<ClosestOnSurface>,
    carrier: OnceLock<Option<Carrier>>,
}

impl Face {
    /// The plane, sphere, cylinder, cone or torus that it lies on, told once.
    pub(super) fn carrier(&self) -> Option<&Carrier> {
        self.carrier.get_or_init(|| Carrier::of(&self.surface, EXACT * self.size)).as_ref()
    }

    /// The plane that it lies on.
    pub(super) fn plane(&self) -> Option<&Plane> {
        match (&self.form, self.carrier()) {
            (Form::Plane(flat), _) => Some(flat.plane()),
            (_, Some(Carrier::Plane(plane))) => Some(plane),
            _ => None,
        }
    }

    /// The parameters of the surface's place nearest to a point, as far as that is told without a doubt.
    pub(super) fn parameters(&self, p: Point3) -> Result<[f64; 2]> {
        if let Form::Plane(flat) = &self.form {
            return Ok(flat.parameters_of(p));
        }
        if let Form::Round(round) = &self.form
            && let Some(uv) = round.parameters(p)
        {
            return Ok(uv);
        }
        let near = self.closest()?.nearest(p)?;
        Ok([near.u, near.v])
    }

    /// Whether parameters follow from points by a formula.
    pub(super) fn is_round(&self) -> bool {
        matches!(self.form, Form::Round(_))
    }

    fn closest(&self) -> Result<&ClosestOnSurface> {
        if let Some(made) = self.closest.get() {
            return Ok(made);
        }
        let made = ClosestOnSurface::new(&self.surface)?;
        Ok(self.closest.get_or_init(|| made))
    }

    /// Whether parameters lie on the face; anything at its border.
    pub(super) fn covers(&self, uv: [f64; 2]) -> bool {
        self.outlines.iter().map(|outline| outline.winding(uv)).sum::<i32>() != 0
    }

    /// Lets go of what tells which parameters lie on the face.
    pub(super) fn forget_outlines(&mut self) {
        self.outlines = Vec::new();
    }

    /// The normal of the face at parameters, away from the material.
    pub(super) fn normal(&self, [u, v]: [f64; 2]) -> Option<Vector3> {
        let normal = self.surface.normal_at(u, v)?;
        Some(if self.reversed { -normal } else { normal })
    }
}

/// An operand as a whole.
#[derive(Debug)]
pub(super) struct Solid {
    brep: Shared<Brep>,
    search: Mutex<Option<Shared<ClosestOnBrep>>>,
    pub(super) bounds: BoundingBox,
    /// Whether it encloses a volume.
    pub(super) closed: bool,
}

impl Solid {
    /// The operand itself, turned outward.
    pub(super) fn brep(&self) -> &Brep {
        &self.brep
    }

    /// The operand, prepared for questions about its inside when it is asked first.
    pub(super) fn search(&self) -> Result<Shared<ClosestOnBrep>> {
        let mut known = self.search.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(made) = known.as_ref() {
            return Ok(Shared::clone(made));
        }
        let made = Shared::new(ClosestOnBrep::new(Shared::clone(&self.brep))?);
        *known = Some(Shared::clone(&made));
        Ok(made)
    }

    /// Lets go of what was prepared for questions: of many operands it is more than the operands themselves.
    pub(super) fn forget_search(&self) {
        *self.search.lock().unwrap_or_else(PoisonError::into_inner) = None;
    }
}

/// All operands together.
#[derive(Debug)]
pub(super) struct Operands {
    pub(super) solids: Vec<Solid>,
    pub(super) edges: Vec<Edge>,
    pub(super) faces: Vec<Face>,
    pub(super) vertices: Vertices,
    /// Faces that were taken to lie on one surface: the largest distance found, and where it is.
    pub(super) upon: Vec<([usize; 2], Option<Point3>, f64)>,
    /// The tolerance of the call.
    pub(super) limit: f64,
}

impl Operands {
    /// Takes the faces and edges of operands over. Solids are turned outward.
    pub(super) fn new(breps: &[&Brep], limit: f64) -> Result<Self> {
        let count: usize = breps.iter().map(|b| b.faces().len()).sum();
        if count > MOST_FACES {
            return Err(Refusal::at(RefusalClass::TooLarge, &[], None));
        }
        let mut all = Self {
            solids: Vec::with_capacity(breps.len()),
            edges: Vec::new(),
            faces: Vec::with_capacity(count),
            vertices: Vertices::new(limit),
            upon: Vec::new(),
            limit,
        };
        for brep in breps {
            cancellation::check()?;
            all.add(brep)?;
        }
        Ok(all)
    }

    fn add(&mut self, brep: &Brep) -> Result<()> {
        let brep = if brep.is_solid() { brep.clone().turned_outward() } else { brep.clone() };
        let solid = self.solids.len();
        let parts = brep.parts();
        let vertices: Vec<usize> = parts.vertices.iter().map(|v| self.vertices.at(v.point)).collect();
        let vertex = |place: Option<usize>| place.and_then(|p| vertices.get(p).copied());
        let missing = || Error::degenerate("brep", "an edge or trim has no vertex or curve");
        let mut edges: Vec<Option<usize>> = Vec::with_capacity(parts.edges.len());
        for (place, own) in parts.edges.iter().enumerate() {
            if own.deleted || own.trims.is_empty() {
                edges.push(None);
                continue;
            }
            let curve = brep.edge_as_curve(place)?.ok_or_else(missing)?;
            let ends =
                [vertex(own.vertices[0]).ok_or_else(missing)?, vertex(own.vertices[1]).ok_or_else(missing)?];
            for joint in joints(&curve) {
                self.vertices.at(joint);
            }
            edges.push(Some(self.edges.len()));
            self.edges.push(Edge { solid, bounds: curve.bounding_box(), curve, ends });
        }
        let mut bounds: Option<BoundingBox> = None;
        for (place, own) in parts.faces.iter().enumerate().filter(|(_, f)| !f.deleted) {
            let surface = brep.face_surface(place).ok_or_else(missing)?.clone();
            let mut loops = Vec::with_capacity(own.loops.len());
            let mut border = BTreeSet::new();
            for chain in own.loops.iter().filter_map(|l| parts.loops.get(*l)) {
                let mut bound = Vec::with_capacity(chain.trims.len());
                for &trim in &chain.trims {
                    let curve = brep.trim_as_curve(trim)?.ok_or_else(missing)?;
                    let trim = parts.trims.get(trim).ok_or_else(missing)?;
                    let edge = match trim.edge {
                        Some(edge) => Some(edges.get(edge).copied().flatten().ok_or_else(missing)?),
                        None => None,
                    };
                    border.extend(edge);
                    let start = vertex(trim.vertices[0]).ok_or_else(missing)?;
                    bound.push(Bound { edge: edge.map(|e| (e, trim.reversed)), start, curve });
                }
                loops.push(bound);
            }
            let face = self.face(solid, place, surface, own.reversed, loops, border, &brep)?;
            bounds = Some(bounds.map_or(face.bounds, |b| b.union(&face.bounds)));
            self.faces.push(face);
        }
        let bounds = bounds.ok_or(Error::degenerate("brep", "it has no faces"))?;
        let closed = brep.is_solid();
        self.solids.push(Solid { brep: Shared::new(brep), search: Mutex::new(None), bounds, closed });
        Ok(())
    }

    #[allow(clippy::too_many_arguments, reason = "each is one fact of a face")]
    fn face(
        &self,
        solid: usize,
        place: usize,
        surface: Surface,
        reversed: bool,
        loops: Vec<Vec<Bound>>,
        border: BTreeSet<usize>,
        brep: &Brep,
    ) -> Result<Face> {
        let outlines = loops
            .iter()
            .map(|chain| {
                let curves = chain.iter().map(|b| b.curve.clone()).collect();
                Outline::new(&crate::curve::chained(curves, 0.0), &Plane::XY)
            })
            .collect();
        let form = match &surface {
            Surface::Plane(flat) => Form::Plane(*flat),
            other => Round::of(other).map_or(Form::Other, |round| Form::Round(Box::new(round))),
        };
        let around = border.iter().filter_map(|e| self.edges.get(*e)).map(|e| e.bounds);
        let bounds = match (&form, around.reduce(|a, b| a.union(&b))) {
            (Form::Plane(_), Some(bounds)) => bounds,
            _ => brep.bounds_of_face(place).ok_or(Error::degenerate("brep", "a face has no surface"))?,
        };
        let size = surface.bounding_box()?.diagonal().length();
        Ok(Face {
            solid,
            place,
            surface,
            reversed,
            loops,
            border,
            bounds,
            size,
            outlines,
            form,
            closest: OnceLock::new(),
            carrier: OnceLock::new(),
        })
    }

    /// The names of faces, as refusals tell them.
    pub(super) fn names(&self, faces: &[usize]) -> Vec<FaceName> {
        let own = faces.iter().filter_map(|f| self.faces.get(*f));
        own.map(|f| FaceName { operand: f.solid, face: f.place }).collect()
    }

    /// A refusal about faces.
    pub(super) fn refuse(&self, class: RefusalClass, faces: &[usize], place: Option<Point3>) -> Error {
        Refusal::at(class, &self.names(faces), place)
    }

    /// Where a point lies on a face: within a distance of the border counts as there.
    pub(super) fn place(&self, face: &Face, p: Point3, reach: f64) -> Result<Place> {
        self.place_beside(face, p, reach, reach)
    }

    /// As [`Self::place`] with another distance from the border, `beside`, than from the surface.
    pub(super) fn place_beside(&self, face: &Face, p: Point3, reach: f64, beside: f64) -> Result<Place> {
        let uv = face.parameters(p)?;
        if face.surface.point_at(uv[0], uv[1]).distance_to(p) > reach {
            return Ok(Place::Outside);
        }
        for edge in face.border.iter().filter_map(|e| self.edges.get(*e)) {
            if edge.bounds.distance_to(p) <= beside && edge.parameter_near(p, beside)?.is_some() {
                return Ok(Place::Border);
            }
        }
        Ok(if face.covers(uv) { Place::Inside(uv) } else { Place::Outside })
    }
}
