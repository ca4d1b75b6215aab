//! Regions cut into pieces along curves.

use super::combine::{Walked, arranged, checked, faces, ladder, too_close};
use super::loops::{Step, loops};
use super::meetings::Meetings;
use super::sides::Sides;
use super::sources::Sources;
use super::{Face, Region, assemble};
use crate::{Curve, Result};

impl Region {
    /// The pieces into which curves, projected into the plane, cut the region, each a region of one face. Curves may be
    /// open or closed, and cross each other; stretches that separate nothing, because an end of them lies inside a
    /// piece, leave no trace.
    ///
    /// # Errors
    /// The tolerance is not finite and above 0; or the curves meet too often, or are too tangled, as in [`Region::new`].
    pub fn split(&self, cutters: &[Curve], tolerance: f64) -> Result<Vec<Self>> {
        checked(&self.plane, tolerance)?;
        let borders = self.curves();
        let sources = Sources::with_open(borders.iter().chain(cutters), &self.plane, tolerance)?;
        let steps = ladder(tolerance, sources.scale);
        let mut meetings = Meetings::default();
        for (k, &reach) in steps.iter().enumerate() {
            let Some((nodes, strands, sides)) =
                arranged(&sources, &mut meetings, reach, k + 1 == steps.len())?
            else {
                continue;
            };
            let walls: Vec<Step> = (sides.iter().enumerate())
                .flat_map(|(strand, all)| walks(strand, all, borders.len()))
                .collect();
            let Some(loops) = loops(&sources, &nodes, &strands, &walls)? else { continue };
            let mut walked = Vec::with_capacity(loops.len());
            for steps in loops.into_iter().filter(|steps| !is_there_and_back(steps)) {
                let curve = assemble::curve(&sources, &nodes, &strands, &steps, reach)?;
                walked.extend(curve.map(|curve| Walked { curve, steps }));
            }
            let alone = |face: Face| Self { plane: self.plane, faces: vec![face] };
            return Ok(faces(walked, &sources.plane).into_iter().map(alone).collect());
        }
        Err(too_close())
    }
}

/// How a strand is walked: with the region on the left along its border, both ways inside, and not at all outside.
/// The first sources are the border; outlines run one way and holes the other, so that their turns add up.
fn walks(strand: usize, sides: &[Sides], borders: usize) -> impl Iterator<Item = Step> {
    let own = sides.iter().filter(|s| s.source < borders);
    let (left, right) = own.fold((0, 0), |(left, right), s| (left + s.left, right + s.right));
    let ways = [(left != 0).then_some(true), (right != 0).then_some(false)];
    ways.into_iter().flatten().map(move |forward| Step { strand, forward })
}

/// Whether a loop is one strand walked both ways: a dead end, or a bridge between two loops of one piece.
fn is_there_and_back(steps: &[Step]) -> bool {
    matches!(steps, [a, b] if a.strand == b.strand)
}
