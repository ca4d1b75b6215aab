//! Small values that several tables share.

use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::{Result, colour};

/// A transform, row after row.
pub(crate) type Matrix = [f64; 16];

/// The transform that changes nothing.
pub(crate) const IDENTITY: Matrix =
    [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

/// The number of an entry that has none.
pub(crate) const NO_NUMBER: i32 = -2_147_483_647;

pub(crate) fn read_matrix(body: &mut Reader<'_>, what: &'static str) -> Result<Matrix> {
    let mut matrix = [0.0; 16];
    for x in &mut matrix {
        *x = body.f64(what)?;
    }
    Ok(matrix)
}

pub(crate) fn write_matrix(matrix: &Matrix, w: &mut Writer) {
    matrix.iter().for_each(|x| w.f64(*x));
}

/// A colour as red, green, blue, alpha.
pub(crate) fn read_colour(body: &mut Reader<'_>, what: &'static str) -> Result<[u8; 4]> {
    Ok(colour::from_archive(body.colour(what)?))
}

pub(crate) fn write_colour(rgba: [u8; 4], w: &mut Writer) {
    w.colour(colour::to_archive(rgba));
}

/// Two colours: for the screen and for print.
pub(crate) fn read_colours(body: &mut Reader<'_>, what: &'static str) -> Result<[[u8; 4]; 2]> {
    Ok([read_colour(body, what)?, read_colour(body, what)?])
}

pub(crate) fn read_pair(body: &mut Reader<'_>, what: &'static str) -> Result<[f64; 2]> {
    Ok([body.f64(what)?, body.f64(what)?])
}

pub(crate) fn write_pair(pair: [f64; 2], w: &mut Writer) {
    pair.iter().for_each(|x| w.f64(*x));
}

pub(crate) fn read_pairs(body: &mut Reader<'_>, what: &'static str) -> Result<Vec<[f64; 2]>> {
    let count = body.count(16, what)?;
    (0..count).map(|_| read_pair(body, what)).collect()
}

/// Six numbers: the least and the greatest corner of a box.
pub(crate) fn read_box(body: &mut Reader<'_>, what: &'static str) -> Result<[f64; 6]> {
    let mut corners = [0.0; 6];
    for x in &mut corners {
        *x = body.f64(what)?;
    }
    Ok(corners)
}

/// A count and as many identifiers.
pub(crate) fn read_ids(body: &mut Reader<'_>, what: &'static str) -> Result<Vec<Uuid>> {
    let count = body.count(16, what)?;
    (0..count).map(|_| body.uuid(what)).collect()
}

pub(crate) fn write_ids(ids: &[Uuid], w: &mut Writer) -> Result<()> {
    w.count(ids.len(), "identifiers")?;
    ids.iter().for_each(|id| w.uuid(*id));
    Ok(())
}

/// Pairs of identifiers behind a count: a viewport and what is shown in it, mostly.
pub(crate) fn read_id_pairs(body: &mut Reader<'_>, what: &'static str) -> Result<Vec<(Uuid, Uuid)>> {
    let count = body.count(32, what)?;
    (0..count).map(|_| Ok((body.uuid(what)?, body.uuid(what)?))).collect()
}

pub(crate) fn write_id_pairs(pairs: &[(Uuid, Uuid)], w: &mut Writer) -> Result<()> {
    w.count(pairs.len(), "pairs of identifiers")?;
    for (first, second) in pairs {
        w.uuid(*first);
        w.uuid(*second);
    }
    Ok(())
}

/// A list of identifiers in a chunk of its own.
pub(crate) fn read_id_list(body: &mut Reader<'_>, what: &'static str) -> Result<Vec<Uuid>> {
    let (mut list, _) = body.versioned_1(what)?;
    let ids = read_ids(&mut list, what)?;
    list.finish();
    Ok(ids)
}

pub(crate) fn write_id_list(ids: &[Uuid], w: &mut Writer) -> Result<()> {
    w.versioned(1, 0, |w| write_ids(ids, w))
}
