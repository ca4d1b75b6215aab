//! What was decided within the tolerance.

use std::fmt;

use super::FaceName;
use super::cells::Beside;
use super::operands::Operands;
use super::pieces::Pieces;
use super::thresholds::ROUNDING;
use crate::error::refusal::write_where;
use crate::{BoundingBox, Point3};

/// What was taken as one, or apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum DecisionKind {
    /// Points.
    Points,
    /// Curves with the same ends.
    Curves,
    /// The surfaces of two faces.
    Surfaces,
    /// Not taken as one: a part of a face that lies within the tolerance of an operand's boundary, on one side of it.
    Sides,
}

/// A decision that rests on the tolerance: with exact numbers it would be another.
#[derive(Debug, Clone, PartialEq)]
pub struct Decision {
    /// What was taken as one.
    pub kind: DecisionKind,
    /// The faces that it is about; none where it is about all faces at the place.
    pub faces: Vec<FaceName>,
    /// A point where it is.
    pub place: Option<Point3>,
    /// The largest distance found between what was taken as one, in model units; for sides, that from the boundary.
    pub distance: f64,
}

impl fmt::Display for Decision {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let what = match self.kind {
            DecisionKind::Points => "points",
            DecisionKind::Curves => "curves",
            DecisionKind::Surfaces => "surfaces",
            DecisionKind::Sides => {
                write!(f, "a part {:e} from a boundary was told to lie on one side of it", self.distance)?;
                return write_where(f, &self.faces, self.place);
            }
        };
        write!(f, "{what} {:e} apart were taken as one", self.distance)?;
        write_where(f, &self.faces, self.place)
    }
}

/// All decisions about what is farther apart than rounding tells.
pub(super) fn decisions(all: &Operands, pieces: &Pieces, beside: &[Beside]) -> Vec<Decision> {
    let bounds: Option<BoundingBox> = all.solids.iter().map(|s| s.bounds).reduce(|a, b| a.union(&b));
    let extent = bounds.map_or(0.0, |b| {
        // Digits are lost far from the origin too.
        let far = [b.min, b.max].map(|p| p.distance_to(Point3::ORIGIN));
        far[0].max(far[1]).max(b.diagonal().length())
    });
    let least = ROUNDING * extent;
    let points = all.vertices.moved().map(|(place, distance)| Decision {
        kind: DecisionKind::Points,
        faces: Vec::new(),
        place: Some(place),
        distance,
    });
    let curves = pieces.list.iter().enumerate().map(|(k, piece)| Decision {
        kind: DecisionKind::Curves,
        faces: Vec::new(),
        place: pieces.middle(k),
        distance: piece.apart,
    });
    let surfaces = all.upon.iter().map(|(faces, place, distance)| Decision {
        kind: DecisionKind::Surfaces,
        faces: all.names(faces),
        place: *place,
        distance: *distance,
    });
    let sides = beside.iter().map(|part| Decision {
        kind: DecisionKind::Sides,
        faces: all.names(&[part.face]),
        place: part.place,
        distance: part.distance,
    });
    points.chain(curves).chain(surfaces).chain(sides).filter(|d| d.distance > least).collect()
}
