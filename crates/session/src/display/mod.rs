//! What objects show, as bytes for a viewport: the layout is that of [`PreviewHeader`](crate::protocol::PreviewHeader).
//!
//! An object's values become things of a scene as for pictures (`katydid-scene`); things become triangles, segments,
//! points and texts; those are gathered by look into parts and laid out. Equal bytes have equal hashes: what has not
//! changed need not be sent again.

mod collect;
mod count;
pub(crate) mod curves;
mod edges;
mod faces;
mod fewer;
pub(crate) mod layout;
mod model;
pub(crate) mod parts;
mod runs;

use katydid_data::Tree;
use katydid_data::cast::Rules;
use katydid_definition::document::Object;
use katydid_scene::{Look, Painter, Scene};
use uuid::Uuid;

use collect::Collector;

/// The triangles of all that is shown while something is dragged.
pub const DRAFT_TRIANGLES: usize = 50_000;

/// How fine curves and surfaces are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fineness {
    /// With so many triangles in all at most: while a slider is dragged.
    Draft {
        /// The triangles of all objects together.
        triangles: usize,
        /// Whether surfaces have their own normals and curvatures all the same, where they are not too large.
        exact: bool,
    },
    /// As a document asks for it that has coarse preview meshes.
    Coarse,
    /// As a document asks for it that has smooth ones.
    Smooth,
}

impl Fineness {
    /// That of a document's own number for it.
    pub fn of_document(mesh_type: Option<i32>) -> Self {
        match mesh_type {
            None | Some(0 | 1) => Self::Coarse,
            Some(_) => Self::Smooth,
        }
    }
}

/// An object with its data.
#[derive(Debug, Clone, Copy)]
pub struct Shown<'a> {
    /// The object.
    pub object: &'a Object,
    /// The data of its outputs.
    pub outputs: &'a [Tree],
    /// What it reads, where it draws that ([`draws_inputs`]); else nothing.
    pub inputs: &'a [Tree],
}

/// What an object shows.
#[derive(Debug, Clone)]
pub struct Preview {
    /// The object.
    pub object: Uuid,
    /// Its geometry; nothing where it shows none.
    pub geometry: Option<Geometry>,
    /// What could not be shown, in words.
    pub left_out: Vec<String>,
}

/// The geometry of an object.
#[derive(Debug, Clone)]
pub struct Geometry {
    /// The hash of the bytes, as 32 hexadecimal digits.
    pub hash: String,
    /// The bytes.
    pub bytes: Vec<u8>,
    /// Whether it could be finer.
    pub is_draft: bool,
    /// How many triangles it has.
    pub triangles: usize,
}

pub use katydid_scene::{draws_inputs, is_shown};
pub use model::{ModelPreview, encode_model};

/// Encodes what objects show, side by side on all cores. Objects come back in the same order; what `go_on` denies
/// does not come back at all.
pub fn encode(
    shown: &[Shown<'_>],
    rules: &Rules,
    fineness: Fineness,
    go_on: impl Fn() -> bool + Sync,
) -> Vec<Preview> {
    let scenes = each(shown, |one| go_on().then(|| scene(one, rules)));
    let counts: Vec<usize> =
        scenes.iter().map(|one| one.as_ref().map_or(0, |(scene, _)| count::triangles(scene))).collect();
    let shares = match fineness {
        Fineness::Draft { triangles, .. } => count::shares(&counts, triangles),
        Fineness::Coarse | Fineness::Smooth => vec![count::MOST; counts.len()],
    };
    let curves = scenes.iter().flatten().map(|(scene, _)| count::curves(scene)).sum();
    let jobs: Vec<_> = shown.iter().zip(scenes).zip(shares).collect();
    let previews = each(&jobs, |((one, scene), share)| {
        let (scene, left_out) = scene.as_ref().filter(|_| go_on())?;
        let collector = Collector::new(scene, fineness, *share, curves);
        Some(preview(one.object.id, scene, left_out, collector))
    });
    previews.into_iter().flatten().collect()
}

pub(crate) fn scene(shown: &Shown<'_>, rules: &Rules) -> (Scene, Vec<String>) {
    let mut painter = Painter::for_objects(rules, Look::of(parts::DOCUMENT));
    painter.object(shown.object, shown.outputs, || shown.inputs.to_vec());
    let left_out = painter.left_out().to_vec();
    (painter.scene, left_out)
}

fn preview(object: Uuid, scene: &Scene, left_out: &[String], mut collector: Collector) -> Preview {
    scene.things.iter().for_each(|thing| collector.thing(thing));
    let mut left_out = left_out.to_vec();
    left_out.extend(collector.complaint());
    let geometry = layout::bytes(object, &scene.branches, collector.parts, collector.is_draft);
    Preview { object, geometry, left_out }
}

/// Does something with each, on all cores where there are some to be had.
pub(crate) fn each<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        items.par_iter().map(work).collect()
    }
    #[cfg(not(feature = "parallel"))]
    items.iter().map(work).collect()
}
