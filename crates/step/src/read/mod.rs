//! Files as documents.

mod build;
mod curve;
mod entity;
mod graph;
mod items;
mod layout;
mod place;
mod pull;
mod spline;
mod style;
mod support;
mod topology;
mod unit;

use std::cell::Cell;
use std::collections::HashMap;

use crate::part21::{Bounds, parse};
use crate::{Document, LeftOut, Result};
use entity::File;
use graph::Graph;
use items::{Items, Standing};
use katydid_geometry::Xform;
use place::Space;
use style::Styles;
use unit::Units;

/// Lists in lists of entities; the standard's own entities need three.
const DEPTH: usize = 16;

/// What is read at most of a file that nobody vouches for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Entities of the file.
    pub entities: usize,
    /// Parts of the document, those of assemblies counted wherever they stand.
    pub parts: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self { entities: 20_000_000, parts: 1_000_000 }
    }
}

/// Reads a STEP file. Parts that cannot be read are left out by name, with the entity and the reason.
///
/// # Errors
/// The bytes are no exchange structure, a limit is passed, or assemblies hold each other in a circle.
pub fn read(bytes: &[u8]) -> Result<Document> {
    read_with(bytes, &Limits::default())
}

/// As [`read`], within other limits.
///
/// # Errors
/// As [`read`].
pub fn read_with(bytes: &[u8], limits: &Limits) -> Result<Document> {
    let file = File::new(parse(bytes, Bounds { entities: limits.entities, depth: DEPTH })?);
    let main = Graph::units_of(&file)?;
    let usual = 1e-6 / main.metres;
    let tolerance = main.tolerance.unwrap_or(usual);
    let budget = Cell::new(file.count().saturating_mul(16).saturating_add(1000));
    let space = |context: u64| -> Result<Space<'_>> {
        let units = Units::of(&file, context)?;
        Ok(Space { file: &file, scale: units.metres / main.metres, units, tolerance, budget: &budget })
    };
    let graph = Graph::of(&file, &space);
    let styles = Styles::of(&file);
    let placed = graph.placed(limits.parts)?;
    let document = Document { metres: main.metres, tolerance, ..Document::default() };
    let mut items = Items { graph: &graph, styles: &styles, limits, document, known: HashMap::new() };
    for error in placed.errors {
        items.document.left_out.push(LeftOut::new("assembly", error.to_string()));
    }
    for (id, group, motion) in &placed.representations {
        let Some(representation) = graph.representations.get(id) else { continue };
        let space = match space(representation.context) {
            Ok(space) => space,
            Err(error) => {
                items.document.left_out.push(LeftOut::new("representation", error.to_string()));
                continue;
            }
        };
        let name = graph.names.get(group).map_or(representation.name.as_str(), String::as_str);
        for item in &representation.items {
            items.add(&space, *item, Standing { motion, name, holder: None, depth: 0 })?;
        }
    }
    if placed.representations.is_empty() {
        add_loose(&mut items, &Space { file: &file, scale: 1.0, units: main, tolerance, budget: &budget })?;
    }
    let mut document = items.document;
    document.name = graph.names.values().min().cloned().unwrap_or_default();
    Ok(document)
}

/// The solids and sheets of a file without representations.
fn add_loose(items: &mut Items<'_>, space: &Space<'_>) -> Result<()> {
    for keyword in ["MANIFOLD_SOLID_BREP", "BREP_WITH_VOIDS", "SHELL_BASED_SURFACE_MODEL"] {
        for record in space.file.all(keyword) {
            let standing = Standing { motion: &Xform::IDENTITY, name: "", holder: None, depth: 0 };
            items.add(space, record.id, standing)?;
        }
    }
    Ok(())
}
