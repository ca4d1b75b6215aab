//! The table of conversions, and how a row is found.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::way::Way;
use super::{curve, general, number, place, shape};
use crate::Kind;

/// All rows, by the type that they give.
static ROWS: LazyLock<Vec<&'static Way>> = LazyLock::new(|| {
    [general::WAYS, number::WAYS, place::WAYS, curve::WAYS, shape::WAYS].into_iter().flatten().collect()
});

static BY_TYPES: LazyLock<HashMap<(Kind, Kind), &'static Way>> = LazyLock::new(|| {
    ROWS.iter().flat_map(|way| way.from.iter().map(move |from| ((*from, way.to), *way))).collect()
});

/// All conversions.
pub fn all() -> impl Iterator<Item = &'static Way> {
    ROWS.iter().copied()
}

/// The conversions to a type: what a parameter of that type takes beside its own.
pub fn ways_to(kind: Kind) -> impl Iterator<Item = &'static Way> {
    all().filter(move |way| way.to == kind)
}

/// The conversion from one type to another: the row of that very type, else the one of all geometry, else the one of
/// all types.
pub fn way(from: Kind, to: Kind) -> Option<&'static Way> {
    let row = |from: Kind| BY_TYPES.get(&(from, to)).copied();
    let geometry = || from.is_geometry().then(|| row(Kind::Geometry)).flatten();
    row(from).or_else(geometry).or_else(|| row(Kind::Generic))
}
