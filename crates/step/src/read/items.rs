//! Items of representations as parts.

use std::collections::HashMap;
use std::sync::Arc;

use super::build::{self, Built};
use super::entity::{DEEPEST, Record};
use super::graph::Graph;
use super::place::Space;
use super::style::Styles;
use super::{Limits, spline};
use crate::{Document, Error, LeftOut, Part, Result, Shape};
use katydid_geometry::{Brep, Curve, Point3, Xform};

/// Parts on their way into a document.
pub(super) struct Items<'a> {
    pub(super) graph: &'a Graph,
    pub(super) styles: &'a Styles,
    pub(super) limits: &'a Limits,
    pub(super) document: Document,
    /// Breps that were made before, or could not be.
    pub(super) known: HashMap<u64, std::result::Result<Arc<Brep>, ()>>,
}

/// Where an item stands.
#[derive(Clone, Copy)]
pub(super) struct Standing<'a> {
    pub(super) motion: &'a Xform,
    /// The name for what has none.
    pub(super) name: &'a str,
    /// The set that holds the item.
    pub(super) holder: Option<u64>,
    pub(super) depth: usize,
}

/// Items that are there for other reasons than to be seen.
const SILENT: [&str; 5] =
    ["AXIS2_PLACEMENT_3D", "AXIS1_PLACEMENT", "AXIS2_PLACEMENT_2D", "PLACEMENT", "DIRECTION"];

impl Items<'_> {
    fn leave_out(&mut self, what: &str, why: &Error) {
        self.document.left_out.push(LeftOut::new(what, why.to_string()));
    }

    /// Adds an item, or tells why not.
    pub(super) fn add(&mut self, space: &Space<'_>, id: u64, standing: Standing<'_>) -> Result<()> {
        let record = match space.file.record(id) {
            Ok(record) => record,
            Err(error) => {
                self.leave_out("item", &error);
                return Ok(());
            }
        };
        match self.try_add(space, &record, standing) {
            Err(error @ Error::TooLarge(_)) => Err(error),
            Err(error) => {
                self.leave_out(record.keyword, &error);
                Ok(())
            }
            Ok(()) => Ok(()),
        }
    }

    fn try_add(&mut self, space: &Space<'_>, record: &Record<'_>, standing: Standing<'_>) -> Result<()> {
        match record.keyword {
            "MAPPED_ITEM" => self.mapped(space, record, standing),
            "GEOMETRIC_SET" | "GEOMETRIC_CURVE_SET" => self.set(space, record, standing),
            keyword if SILENT.contains(&keyword) => Ok(()),
            "CARTESIAN_POINT" => {
                self.push(record, Shape::Points(vec![space.point(record.id)?]), standing, &[])
            }
            _ => {
                if let Some(brep) = self.brep(space, record)? {
                    let shells = space.file.references(record.id);
                    return self.push(record, Shape::Brep(brep), standing, &shells);
                }
                let curve = space.carrier(record.id, 0)?.whole().map_err(|error| record.refuse(error))?;
                if !is_finite(&curve) {
                    return Err(record.refuse("it is not finite everywhere"));
                }
                self.push(record, Shape::Curve(curve), standing, &[])
            }
        }
    }

    /// The brep of an item that is one; nothing for a curve.
    fn brep(&mut self, space: &Space<'_>, record: &Record<'_>) -> Result<Option<Arc<Brep>>> {
        match self.known.get(&record.id) {
            Some(Ok(brep)) => return Ok(Some(brep.clone())),
            Some(Err(())) => return Err(record.refuse("it could not be read, as told before")),
            None => {}
        }
        let id = record.id;
        let shells = |place: usize| {
            record.references(place).map(|ids| ids.into_iter().map(|s| (s, false)).collect::<Vec<_>>())
        };
        let built = match record.keyword {
            "MANIFOLD_SOLID_BREP" | "FACETED_BREP" => {
                build::brep(space, id, &[(record.reference(1)?, false)])
            }
            "BREP_WITH_VOIDS" => {
                let mut all = vec![(record.reference(1)?, false)];
                all.extend(shells(2)?);
                build::brep(space, id, &all)
            }
            "SHELL_BASED_SURFACE_MODEL" | "FACE_BASED_SURFACE_MODEL" => build::brep(space, id, &shells(1)?),
            "OPEN_SHELL" | "CLOSED_SHELL" | "CONNECTED_FACE_SET" => build::brep(space, id, &[(id, false)]),
            "ADVANCED_FACE" | "FACE_SURFACE" => build::of_faces(space, id, &[id]),
            keyword if spline::is_surface(keyword) || space.file.is(id, "B_SPLINE_SURFACE") => {
                let surface = spline::surface(space, id)?;
                let brep = Brep::from_surface(surface.into()).map_err(|error| record.refuse(error))?;
                Ok(Built { brep, faces: vec![id] })
            }
            _ => return Ok(None),
        };
        let made = built.and_then(|built| self.coloured(built));
        self.known.insert(id, made.as_ref().map(Arc::clone).map_err(|_| ()));
        made.map(Some)
    }

    /// Faces with colours of their own.
    fn coloured(&self, built: Built) -> Result<Arc<Brep>> {
        let colours: Vec<_> = built.faces.iter().map(|id| self.styles.colour(&[*id])).collect();
        if colours.iter().all(Option::is_none) {
            return Ok(built.brep.into());
        }
        let mut parts = built.brep.into_parts();
        for (face, colour) in parts.faces.iter_mut().zip(colours) {
            face.colour = colour;
        }
        Ok(Brep::from_parts(parts)?.into())
    }

    fn push(
        &mut self,
        record: &Record<'_>,
        shape: Shape,
        standing: Standing<'_>,
        inner: &[u64],
    ) -> Result<()> {
        if self.document.parts.len() >= self.limits.parts {
            return Err(Error::TooLarge(format!("more than {} parts", self.limits.parts)));
        }
        let mut ids = vec![record.id];
        ids.extend(standing.holder);
        let layer = self.styles.layer(&ids);
        ids.extend(inner);
        let colour = self.styles.colour(&ids).or_else(|| common_colour(&shape));
        let own = if space_name(record) { record.text(0) } else { "" };
        let name = if own.is_empty() { standing.name } else { own }.to_owned();
        let shape = moved(shape, standing.motion).map_err(|error| record.refuse(error))?;
        self.document.parts.push(Part { name, layer, colour, shape });
        Ok(())
    }

    /// The elements of a set; points beside each other become one part.
    fn set(&mut self, space: &Space<'_>, record: &Record<'_>, standing: Standing<'_>) -> Result<()> {
        let own = record.text(0);
        let name = if own.is_empty() { standing.name } else { own };
        let inner = Standing { name, holder: Some(record.id), ..standing };
        let mut points = Vec::new();
        let mut first = None;
        for element in record.references(1)? {
            let is_point = space.file.record(element).is_ok_and(|r| r.keyword == "CARTESIAN_POINT");
            if is_point {
                points.push(space.point(element)?);
                first.get_or_insert(element);
            } else {
                self.add(space, element, inner)?;
            }
        }
        match first {
            Some(first) => self.push(&space.file.record(first)?, Shape::Points(points), inner, &[]),
            None => Ok(()),
        }
    }

    /// A representation used at another place.
    fn mapped(&mut self, space: &Space<'_>, record: &Record<'_>, standing: Standing<'_>) -> Result<()> {
        if standing.depth >= DEEPEST {
            return Err(record.refuse("it holds itself, or lies too deep"));
        }
        space.spend()?;
        let map = space.file.record(record.reference(1)?)?;
        let origin = space.frame(map.reference(0)?)?;
        let target = space.frame(record.reference(2)?)?;
        let motion = *standing.motion * Xform::plane_to_plane(&origin, &target);
        let used = map.reference(1)?;
        let graph = self.graph;
        let Some(representation) = graph.representations.get(&used) else {
            return Err(map.refuse("what it maps is no representation of shape"));
        };
        let name = if record.text(0).is_empty() { standing.name } else { record.text(0) };
        for item in &representation.items {
            let inner =
                Standing { motion: &motion, name, holder: Some(record.id), depth: standing.depth + 1 };
            self.add(space, *item, inner)?;
        }
        Ok(())
    }
}

/// Whether the first attribute of an entity is its name.
fn space_name(record: &Record<'_>) -> bool {
    !matches!(record.text(0), "NONE" | "None")
}

/// Whether no place of a curve is infinite or no number: sums of finite numbers of the file may be.
fn is_finite(curve: &Curve) -> bool {
    let domain = curve.domain();
    domain.length().is_finite() && curve.hull_points().into_iter().all(Point3::is_finite)
}

/// The colour that all faces have.
fn common_colour(shape: &Shape) -> Option<[u8; 4]> {
    let Shape::Brep(brep) = shape else { return None };
    let first = brep.faces().first()?.colour;
    first.filter(|_| brep.faces().iter().all(|face| face.colour == first))
}

fn moved(shape: Shape, motion: &Xform) -> katydid_geometry::Result<Shape> {
    if *motion == Xform::IDENTITY {
        return Ok(shape);
    }
    Ok(match shape {
        Shape::Points(mut points) => {
            motion.transform_points(&mut points);
            Shape::Points(points)
        }
        Shape::Curve(curve) => Shape::Curve(curve.transformed(motion)?),
        Shape::Brep(brep) => Shape::Brep(brep.transformed(motion)?.into()),
    })
}
