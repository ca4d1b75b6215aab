//! Shapes built step by step.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use katydid_geometry::brep::{FilletBlend, FilletRail, Fuse, Made};
use katydid_geometry::{
    Arc, Brep, Circle, Curve, Ellipse, Error, Interval, Line, Plane, PlaneSurface, Point3, Sphere, Surface,
    Tolerance, Xform, construct, join_curves,
};
use serde_json::Value;

use crate::compare::name;
use crate::read::{Read, frame, interval, list, names, number, numbers, point, text, vector};
use crate::solids;
use crate::variant::Variant;

/// Why a step gave no shape.
#[derive(Debug, Clone)]
pub(crate) enum Failure {
    /// The kernel gave an error.
    Refused(String),
    /// The step is not known here.
    NotBuilt(String),
}

impl From<String> for Failure {
    fn from(why: String) -> Self {
        Self::NotBuilt(why)
    }
}

impl From<Error> for Failure {
    fn from(why: Error) -> Self {
        match why {
            Error::Refused(why) => Self::Refused(format!("boolean refused: {why}")),
            other => Self::Refused(format!("kernel: {other}")),
        }
    }
}

/// A shape, or several as one.
#[derive(Debug, Clone)]
pub(crate) enum Shape {
    Vertex(Point3),
    Curves(Vec<Curve>),
    Breps(Vec<Brep>),
    /// An edge of a brep.
    EdgeOf(usize),
}

/// All shapes of a case.
#[derive(Default)]
pub(crate) struct Shapes {
    variant: Variant,
    made: BTreeMap<String, Shape>,
    measured: [f64; 2],
    fused: BTreeMap<String, Result<Fuse, Failure>>,
}

/// The parts of a result.
pub(crate) struct Parts<'a>(&'a Shape);

impl Parts<'_> {
    pub(crate) fn measure(&self, field: &str) -> Read<f64> {
        let Shape::Breps(breps) = self.0 else { return Ok(0.0) };
        let mut sum = 0.0;
        for brep in breps {
            sum += measure(brep, field)?;
        }
        Ok(sum)
    }

    pub(crate) fn length(&self) -> Option<f64> {
        match self.0 {
            Shape::Curves(curves) => Some(curves.iter().map(Curve::length).sum()),
            _ => None,
        }
    }

    /// How many different parts of a kind there are: what two solids share counts once.
    pub(crate) fn count(&self, what: &str) -> Option<usize> {
        let Shape::Breps(breps) = self.0 else { return None };
        let near = 1e-6 * size_of(breps);
        let mut places: Vec<[Point3; 2]> = Vec::new();
        for brep in breps {
            match what {
                "vertex" => places.extend(brep.vertices().iter().map(|v| [v.point; 2])),
                "edge" => {
                    for edge in 0..brep.edges().len() {
                        let curve = brep.edge_as_curve(edge).ok().flatten()?;
                        let ends = curve.start().lerp(curve.end(), 0.5);
                        places.push([curve.point_at(curve.domain().middle()), ends]);
                    }
                }
                "face" => {
                    for face in 0..brep.faces().len() {
                        let m = brep.face_area(face, 1e-9).ok()?;
                        places.push([m.centroid, Point3::new(m.amount.sqrt(), 0.0, 0.0)]);
                    }
                }
                "solid" => {}
                _ => return None,
            }
        }
        if what == "solid" {
            return Some(breps.iter().filter(|b| b.is_solid()).count());
        }
        let mut known: Vec<[Point3; 2]> = Vec::new();
        for place in places {
            let same = |k: &[Point3; 2]| (0..2).all(|i| k[i].distance_to(place[i]) <= near);
            if !known.iter().any(same) {
                known.push(place);
            }
        }
        Some(known.len())
    }
}

fn measure(brep: &Brep, field: &str) -> Read<f64> {
    let found = if field == "volume" {
        if !brep.is_solid() {
            return Ok(0.0);
        }
        brep.volume_properties(1e-9, || true)
    } else {
        brep.area_properties(1e-9, || true)
    };
    found.map(|m| m.amount).map_err(|e| format!("kernel: measure: {e}"))
}

fn size_of(breps: &[Brep]) -> f64 {
    let boxes = breps.iter().filter_map(Brep::bounds_of_faces).reduce(|a, b| a.union(&b));
    boxes.map_or(1.0, |b| b.diagonal().length())
}

/// The tolerance of a boolean, as a part of the size of the operands.
const TOLERANCE: f64 = 1e-7;

pub(crate) fn tolerance(breps: &[Brep]) -> Tolerance {
    Tolerance { absolute: TOLERANCE * size_of(breps), ..Tolerance::default() }
}

impl Shapes {
    /// No shapes yet; operands are varied before they meet.
    pub(crate) fn new(variant: Variant) -> Self {
        Self { variant, ..Self::default() }
    }

    /// A result by the id of its step.
    pub(crate) fn result(&self, id: &str) -> Option<Parts<'_>> {
        self.made.get(id).map(Parts)
    }

    /// The largest volume or area of an operand.
    pub(crate) fn largest(&self, field: &str) -> f64 {
        self.measured[usize::from(field == "area")]
    }

    /// Builds a step.
    pub(crate) fn build(&mut self, step: &Value) -> Result<(), Failure> {
        let id = name(step)?.to_owned();
        let shape = self.shape(step)?;
        self.made.insert(id, shape);
        Ok(())
    }

    fn get(&self, id: &Value) -> Result<&Shape, Failure> {
        let id = text(id)?;
        self.made.get(id).ok_or_else(|| Failure::NotBuilt(format!("there is no {id}")))
    }

    fn breps(&self, ids: &Value) -> Result<Vec<Brep>, Failure> {
        let mut out = Vec::new();
        for id in list(ids)? {
            let Shape::Breps(own) = self.get(id)? else {
                return Err(Failure::NotBuilt(format!("{id} has no faces")));
            };
            out.extend(own.iter().cloned());
        }
        Ok(out)
    }

    fn shape(&mut self, step: &Value) -> Result<Shape, Failure> {
        let one = |brep: Brep| Ok(Shape::Breps(vec![brep]));
        let angle = |key: &str| step[key].as_f64().map_or(TAU, f64::to_radians);
        let number = |key: &str| number(&step[key]);
        match text(&step["do"])? {
            "box" if step["min"].is_null() => {
                one(solids::cuboid(&frame(&step["frame"])?, numbers(&step["size"])?)?)
            }
            "box" => {
                let plane = Plane::XY.with_origin(point(&step["min"])?);
                one(solids::cuboid(&plane, numbers(&step["size"])?)?)
            }
            "wedge" => {
                let size: [f64; 3] = numbers(&step["size"])?;
                let top = match step["ltx"].as_f64() {
                    Some(x) => [0.0, 0.0, x, size[2]],
                    None => numbers(&step["top"])?,
                };
                one(solids::wedge(&frame(&step["frame"])?, size, top)?)
            }
            "sphere" => {
                let latitude = radians(&step["lat"])?;
                one(solids::ball(&frame(&step["frame"])?, number("r")?, latitude, angle("lon"))?)
            }
            "cylinder" => {
                one(solids::cylinder(&frame(&step["frame"])?, number("r")?, number("h")?, angle("angle"))?)
            }
            "cone" => {
                let radii = [number("r1")?, number("r2")?];
                one(solids::cone(&frame(&step["frame"])?, radii, number("h")?, angle("angle"))?)
            }
            "torus" => {
                let radii = [number("R")?, number("r")?];
                let tube = radians(&step["v"])?;
                one(solids::torus(&frame(&step["frame"])?, radii, tube, angle("angle"))?)
            }
            "vertex" => Ok(Shape::Vertex(point(&step["p"])?)),
            "edge" => {
                let (Shape::Vertex(a), Shape::Vertex(b)) = (self.get(&step["from"])?, self.get(&step["to"])?)
                else {
                    return Err(Failure::NotBuilt("an edge between other things".into()));
                };
                Ok(Shape::Curves(vec![Line::new(*a, *b).into()]))
            }
            "edge_on_curve" => self.edge_on_curve(step),
            "wire" => {
                let mut curves = Vec::new();
                for id in list(&step["of"])? {
                    let Shape::Curves(own) = self.get(id)? else {
                        return Err(Failure::NotBuilt("a wire of other things".into()));
                    };
                    curves.extend(own.iter().cloned());
                }
                Ok(Shape::Curves(curves))
            }
            "polyline" => {
                let points = list(&step["points"])?.iter().map(point).collect::<Read<Vec<_>>>()?;
                Ok(Shape::Curves(vec![katydid_geometry::PolylineCurve::new(points)?.into()]))
            }
            "profile" => profile(step),
            "face_from_wire" => {
                let Shape::Curves(curves) = self.get(&step["wire"])? else {
                    return Err(Failure::NotBuilt("a face of other things".into()));
                };
                planar(curves)
            }
            "face_on_surface" => self.face_on_surface(step),
            "prism" => self.prism(step),
            "revolve" => self.revolve(step),
            "translate" => self.moved(step, &Xform::translation(vector(&step["v"])?)),
            "rotate" => {
                let axis = vector(&step["dir"])?;
                self.moved(step, &Xform::rotation(angle("angle"), axis, point(&step["point"])?)?)
            }
            "scale" => {
                let center = if step["point"].is_null() { Point3::ORIGIN } else { point(&step["point"])? };
                self.moved(step, &Xform::scale(center, number("factor")?))
            }
            "mirror" => {
                let plane = Plane::from_normal(point(&step["point"])?, vector(&step["dir"])?)?;
                self.moved(step, &Xform::mirror(&plane))
            }
            "copy" => Ok(self.get(&step["of"])?.clone()),
            "nurbs" => {
                let Shape::Breps(own) = self.get(&step["of"])? else {
                    return Err(Failure::NotBuilt("NURBS of other things".into()));
                };
                Ok(Shape::Breps(own.iter().map(Brep::with_nurbs_surfaces).collect::<Result<_, _>>()?))
            }
            "subshape" => self.subshape(step),
            "assemble" => self.assemble(step),
            "halfspace" => self.halfspace(step),
            "fillet" => self.fillet(step),
            "boolean" => self.boolean(step),
            "cells" => self.cells(step),
            "make_volume" => self.make_volume(step),
            other => Err(Failure::NotBuilt(format!("step {other}"))),
        }
    }

    fn moved(&self, step: &Value, xform: &Xform) -> Result<Shape, Failure> {
        Ok(match self.get(&step["of"])? {
            Shape::Vertex(p) => Shape::Vertex(xform.point(*p)),
            Shape::Curves(own) => {
                Shape::Curves(own.iter().map(|c| c.transformed(xform)).collect::<Result<_, _>>()?)
            }
            Shape::Breps(own) => {
                Shape::Breps(own.iter().map(|b| b.transformed(xform)).collect::<Result<_, _>>()?)
            }
            Shape::EdgeOf(_) => return Err(Failure::NotBuilt("an edge moved".into())),
        })
    }

    fn edge_on_curve(&self, step: &Value) -> Result<Shape, Failure> {
        let own = &step["curve"];
        let range = if step["range"].is_null() { None } else { Some(interval(&step["range"])?) };
        if !step["from"].is_null() {
            return Err(Failure::NotBuilt("an edge between vertices on a curve".into()));
        }
        let curve: Curve = match text(&own["type"])? {
            "circle" => {
                let circle = Circle::new(frame(&own["frame"])?, number(&own["r"])?)?;
                match range {
                    Some(range) => Arc::new(circle, range)?.into(),
                    None => circle.into(),
                }
            }
            "ellipse" if range.is_none() => {
                let radii = [number(&own["r1"])?, number(&own["r2"])?];
                Ellipse::new(frame(&own["frame"])?, radii[0], radii[1])?.to_nurbs()?.into()
            }
            "line" => {
                let (o, d) = (point(&own["o"])?, vector(&own["d"])?);
                let range = range.ok_or("a line without ends".to_owned())?;
                Line::new(o + d * range.start, o + d * range.end).into()
            }
            other => return Err(Failure::NotBuilt(format!("an edge on a {other}"))),
        };
        Ok(Shape::Curves(vec![curve]))
    }

    fn face_on_surface(&self, step: &Value) -> Result<Shape, Failure> {
        let own = &step["surface"];
        let plane = frame(&own["frame"])?;
        if !step["wire"].is_null() {
            let Shape::Curves(curves) = self.get(&step["wire"])? else {
                return Err(Failure::NotBuilt("a wire of other things".into()));
            };
            return planar(curves);
        }
        let range = |key: &str| if step[key].is_null() { Ok(None) } else { interval(&step[key]).map(Some) };
        let (u, v) = (range("u")?, range("v")?);
        let axis = Line::new(plane.origin, plane.origin + plane.z_axis);
        let turn = u.unwrap_or(Interval::new(0.0, TAU));
        let t = Tolerance { absolute: 1e-6, ..Tolerance::default() };
        let brep = match (text(&own["type"])?, v) {
            ("plane", Some(v)) => Brep::from_surface(PlaneSurface::new(plane, turn, v)?.into())?,
            ("sphere", None) if u.is_none() => construct::sphere(&Sphere::new(plane, number(&own["r"])?)?)?,
            ("cylinder", Some(v)) => {
                let r = number(&own["r"])?;
                let line: Curve = Line::new(plane.at(r, 0.0, v.start), plane.at(r, 0.0, v.end)).into();
                construct::revolve(&line, axis, turn, &t)?
            }
            ("cone", Some(v)) => {
                let (r, a) = (number(&own["r"])?, number(&own["half_angle"])?.to_radians());
                let at = |s: f64| plane.at(r + s * a.sin(), 0.0, s * a.cos());
                let line: Curve = Line::new(at(v.start), at(v.end)).into();
                construct::revolve(&line, axis, turn, &t)?
            }
            (other, _) => return Err(Failure::NotBuilt(format!("a face on a {other}"))),
        };
        Ok(Shape::Breps(vec![brep]))
    }

    fn prism(&self, step: &Value) -> Result<Shape, Failure> {
        if !step["infinite"].is_null() {
            return Err(Failure::NotBuilt("an infinite prism".into()));
        }
        let way = vector(&step["v"])?;
        match self.get(&step["of"])? {
            Shape::Breps(faces) => {
                let t = Tolerance { absolute: 1e-9 * size_of(faces), ..Tolerance::default() };
                let made =
                    faces.iter().map(|f| construct::extrude_brep(f, way, &t)).collect::<Result<_, _>>()?;
                Ok(Shape::Breps(made))
            }
            Shape::Curves(curves) => {
                let t = Tolerance { absolute: 1e-9 * way.length(), ..Tolerance::default() };
                let joined = join_curves(curves, t.absolute, false);
                let made =
                    joined.iter().map(|c| construct::extrude(c, way, false, &t)).collect::<Result<_, _>>()?;
                Ok(Shape::Breps(made))
            }
            _ => Err(Failure::NotBuilt("a prism of other things".into())),
        }
    }

    fn revolve(&self, step: &Value) -> Result<Shape, Failure> {
        let mut border = Vec::new();
        match self.get(&step["of"])? {
            Shape::Curves(curves) => border.extend(curves.iter().cloned()),
            Shape::Breps(faces) => {
                let [face] = faces.as_slice() else {
                    return Err(Failure::NotBuilt("several faces turned".into()));
                };
                for edge in 0..face.edges().len() {
                    border.extend(face.edge_as_curve(edge)?);
                }
            }
            _ => return Err(Failure::NotBuilt("a revolution of other things".into())),
        }
        let start = point(&step["point"])?;
        let axis = Line::new(start, start + vector(&step["dir"])?);
        let angle = number(&step["angle"])?.to_radians();
        let size = border.iter().map(Curve::length).fold(0.0, f64::max);
        let t = Tolerance { absolute: 1e-9 * size, ..Tolerance::default() };
        let [profile] =
            join_curves(&border, t.absolute, false).try_into().map_err(|_| "a face with holes".to_owned())?;
        let made = construct::revolve(&profile, axis, Interval::new(0.0, angle), &t)?;
        let made = if made.is_solid() { made } else { made.capped(&t)?.0 };
        Ok(Shape::Breps(vec![made.turned_outward()]))
    }

    fn subshape(&self, step: &Value) -> Result<Shape, Failure> {
        let Shape::Breps(own) = self.get(&step["of"])? else {
            return Err(Failure::NotBuilt("a part of other things".into()));
        };
        let (near, size) = (point(&step["near"])?, number(&step["size"])?);
        let mut best: Option<(f64, Shape)> = None;
        let mut offer = |centre: Point3, amount: f64, shape: Shape| {
            let off = (amount - size).abs() / size.abs().max(1e-12) + centre.distance_to(near) / size_of(own);
            if best.as_ref().is_none_or(|b| off < b.0) {
                best = Some((off, shape));
            }
        };
        for brep in own {
            match text(&step["type"])? {
                "solid" => {
                    let m = brep.volume_properties(1e-9, || true)?;
                    offer(m.centroid, m.amount, Shape::Breps(vec![brep.clone()]));
                }
                "face" => {
                    for face in 0..brep.faces().len() {
                        let m = brep.face_area(face, 1e-9)?;
                        offer(m.centroid, m.amount, Shape::Breps(vec![brep.sub_brep(&[face])?]));
                    }
                }
                "edge" => {
                    for edge in 0..brep.edges().len() {
                        let Some(curve) = brep.edge_as_curve(edge)? else { continue };
                        let centre = curve.point_at(curve.domain().middle());
                        offer(centre, curve.length(), Shape::EdgeOf(edge));
                    }
                }
                other => return Err(Failure::NotBuilt(format!("a part of type {other}"))),
            }
        }
        best.map(|b| b.1).ok_or_else(|| Failure::NotBuilt("a part that is not there".into()))
    }

    fn assemble(&self, step: &Value) -> Result<Shape, Failure> {
        let parts = self.breps(&step["of"])?;
        if text(&step["type"])? == "compound" || parts.len() < 2 {
            return Ok(Shape::Breps(parts));
        }
        let t = Tolerance { absolute: 1e-9 * size_of(&parts), ..Tolerance::default() };
        Ok(Shape::Breps(Brep::join(&parts, &t)?.breps))
    }

    /// A box as large as a hundred times all shapes so far stands for it.
    fn halfspace(&self, step: &Value) -> Result<Shape, Failure> {
        let Shape::Breps(own) = self.get(&step["face"])? else {
            return Err(Failure::NotBuilt("a half space of other things".into()));
        };
        let plane = own.first().and_then(|b| b.face_surface(0)).and_then(|s: &Surface| s.plane(1e-9));
        let plane = plane.ok_or("a half space beside a curved face".to_owned())?;
        let all: Vec<Brep> = self
            .made
            .values()
            .filter_map(|s| if let Shape::Breps(b) = s { Some(b.clone()) } else { None })
            .flatten()
            .collect();
        let reach = 100.0 * size_of(&all);
        let inside = point(&step["inside_point"])?;
        let plane = if plane.signed_distance(inside) > 0.0 { plane } else { plane.flipped() };
        let corner = plane.at(-reach, -reach, 0.0);
        Ok(Shape::Breps(vec![solids::cuboid(&plane.with_origin(corner), [2.0 * reach, 2.0 * reach, reach])?]))
    }

    fn fillet(&self, step: &Value) -> Result<Shape, Failure> {
        let Shape::Breps(own) = self.get(&step["of"])? else {
            return Err(Failure::NotBuilt("a fillet of other things".into()));
        };
        let [brep] = own.as_slice() else { return Err(Failure::NotBuilt("several solids filleted".into())) };
        let mut edges = Vec::new();
        for pair in list(&step["edges"])? {
            let radius = number(&pair[0])?;
            let Shape::EdgeOf(edge) = self.get(&pair[1])? else {
                return Err(Failure::NotBuilt("a fillet along other things".into()));
            };
            edges.push((*edge, radius));
        }
        let t = Tolerance { absolute: 1e-9 * size_of(own), ..Tolerance::default() };
        Ok(Shape::Breps(vec![brep.filleted(&edges, FilletBlend::Arc, FilletRail::RollingBall, &t)?]))
    }

    fn note(&mut self, breps: &[Brep]) {
        for brep in breps {
            for (k, field) in ["volume", "area"].into_iter().enumerate() {
                self.measured[k] = self.measured[k].max(measure(brep, field).unwrap_or(0.0));
            }
        }
    }

    fn boolean(&mut self, step: &Value) -> Result<Shape, Failure> {
        let (objects, tools) = (self.breps(&step["objects"])?, self.breps(&step["tools"])?);
        let count = objects.len();
        let all: Vec<Brep> = objects.into_iter().chain(tools).collect();
        // The operations of a case share one fuse.
        let key = format!("{} {}", step["objects"], step["tools"]);
        if !self.fused.contains_key(&key) {
            self.note(&all);
            let mut varied = self.variant.operands(&all, count, TOLERANCE * size_of(&all))?;
            if self.variant.swaps() {
                varied.reverse();
            }
            let made = Fuse::new(&varied, &tolerance(&varied)).map_err(Failure::from);
            self.fused.insert(key.clone(), made);
        }
        let fuse = match self.fused.get(&key) {
            Some(Ok(fuse)) => fuse,
            Some(Err(why)) => return Err(why.clone()),
            None => return Err(Failure::NotBuilt("a fuse that was lost".into())),
        };
        let swaps = self.variant.swaps();
        let place = |k: usize| if swaps { all.len() - 1 - k } else { k };
        let one_of = |inside: &[bool], mut of: std::ops::Range<usize>| {
            of.any(|k| inside.get(place(k)).copied().unwrap_or(false))
        };
        let kind = text(&step["kind"])?;
        // Whether a point belongs to the result, by whether it is in an object and in a tool.
        let wanted = |i: &[bool]| {
            let (a, b) = (one_of(i, 0..count), one_of(i, count..all.len()));
            match kind {
                "fuse" | "general_fuse" => a || b,
                "common" => a && b,
                "cut" => a && !b,
                "cut21" => !a && b,
                _ => a,
            }
        };
        let breps = match kind {
            "section" => {
                let of =
                    |on: &[usize], of: std::ops::Range<usize>| on.iter().any(|k| of.contains(&place(*k)));
                let common = fuse.curves().into_iter();
                let both = common.filter(|c| of(&c.operands, 0..count) && of(&c.operands, count..all.len()));
                let curves = both.map(|c| self.variant.back(c.curve, |c, x| c.transformed(x)));
                return Ok(Shape::Curves(curves.collect::<Result<_, _>>()?));
            }
            "split" if !all.iter().take(count).all(Brep::is_solid) => {
                let mut parts = Vec::new();
                for object in 0..count {
                    parts.extend(fuse.faces_of(place(object))?.into_iter().map(|(_, made)| made.brep));
                }
                parts
            }
            "fuse" | "common" | "cut" | "cut21"
                if step["construction"] != "builder"
                    || (kind == "fuse" && all.iter().all(Brep::is_solid)) =>
            {
                breps_of(fuse.oriented(wanted)?)
            }
            // Parts that the operands divide stay divided.
            "split" | "general_fuse" => {
                let kept = fuse.volumes()?.into_iter();
                kept.filter(|(inside, _)| kind == "general_fuse" || wanted(inside))
                    .map(|(_, made)| made.brep)
                    .collect()
            }
            "fuse" | "common" | "cut" | "cut21" => {
                let kept = fuse.volumes()?.into_iter().filter(|(inside, _)| wanted(inside));
                kept.map(|(_, made)| made.brep).collect()
            }
            other => return Err(Failure::NotBuilt(format!("boolean {other}"))),
        };
        self.back(breps)
    }

    /// Results where they were before their operands were varied.
    fn back(&self, breps: Vec<Brep>) -> Result<Shape, Failure> {
        let own = breps.into_iter().map(|b| self.variant.back(b, |b, x| b.transformed(x)));
        Ok(Shape::Breps(own.collect::<Result<_, _>>()?))
    }

    fn cells(&mut self, step: &Value) -> Result<Shape, Failure> {
        let ids = names(&step["arguments"])?;
        let mut all = Vec::new();
        let mut groups: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
        for id in ids {
            let own = self.breps(&Value::Array(vec![Value::from(id)]))?;
            groups.insert(id, (all.len()..all.len() + own.len()).collect());
            all.extend(own);
        }
        self.note(&all);
        let all = self.variant.operands(&all, all.len(), TOLERANCE * size_of(&all))?;
        let fuse = Fuse::new(&all, &tolerance(&all))?;
        self.back(crate::cells::kept(step, &fuse, &all, &groups)?)
    }

    fn make_volume(&mut self, step: &Value) -> Result<Shape, Failure> {
        let all = self.breps(&step["of"])?;
        self.note(&all);
        let all = self.variant.operands(&all, all.len(), TOLERANCE * size_of(&all))?;
        // Faces are often far larger than what they enclose.
        let least = all.iter().filter_map(Brep::bounds_of_faces).map(|b| b.diagonal().length());
        let t =
            Tolerance { absolute: TOLERANCE * least.fold(f64::INFINITY, f64::min), ..Tolerance::default() };
        let made = Fuse::new(&all, &t)?.volumes()?;
        self.back(made.into_iter().map(|(_, m)| m.brep).collect())
    }
}

pub(crate) fn breps_of(made: Vec<Made>) -> Vec<Brep> {
    made.into_iter().map(|m| m.brep).collect()
}

fn radians(v: &Value) -> Read<Option<Interval>> {
    if v.is_null() {
        return Ok(None);
    }
    let own = interval(v)?;
    Ok(Some(Interval::new(own.start.to_radians(), own.end.to_radians())))
}

/// The flat faces that curves bound.
fn planar(curves: &[Curve]) -> Result<Shape, Failure> {
    let size = curves.iter().map(Curve::length).fold(0.0, f64::max);
    let t = Tolerance { absolute: 1e-9 * size, ..Tolerance::default() };
    let made = Brep::planar_faces(&join_curves(curves, t.absolute, false), &t)?.breps;
    if made.is_empty() {
        Err(Failure::NotBuilt("a wire that bounds nothing".into()))
    } else {
        Ok(Shape::Breps(made))
    }
}

/// An outline in a frame.
fn profile(step: &Value) -> Result<Shape, Failure> {
    let plane = frame(&step["frame"])?;
    let lift = |[x, y]: [f64; 2]| plane.at(x, y, 0.0);
    let mut here: [f64; 2] = numbers(&step["start"])?;
    let mut curves: Vec<Curve> = Vec::new();
    for segment in list(&step["segments"])? {
        let to: [f64; 2] = numbers(&segment["to"])?;
        if segment["r"].is_null() {
            curves.push(Line::new(lift(here), lift(to)).into());
        } else {
            let center: [f64; 2] = numbers(&segment["centre"])?;
            let sweep = number(&segment["sweep"])?.to_radians();
            let start = (here[1] - center[1]).atan2(here[0] - center[0]);
            let circle = Circle::new(plane.with_origin(lift(center)), number(&segment["r"])?)?;
            let range = Interval::new(start.min(start + sweep), start.max(start + sweep));
            let arc: Curve = Arc::new(circle, range)?.into();
            curves.push(if sweep < 0.0 { arc.reversed() } else { arc });
        }
        here = to;
    }
    if step["result"] == "face" { planar(&curves) } else { Ok(Shape::Curves(curves)) }
}
