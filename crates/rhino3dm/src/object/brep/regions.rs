//! Regions: bare bodies before version 60, class objects from there on.

use katydid_geometry::brep::{FaceSide, Parts, Region, RegionKind, Regions};
use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::class_object::{ClassObject, write_class};
use crate::{Error, Result, class_ids};

const WHAT: &str = "brep regions";

/// The regions, when they fit the faces: openNURBS writes no others.
pub(super) fn to_write(parts: &Parts) -> Option<&Regions> {
    let regions = parts.regions.as_ref()?;
    (!parts.faces.is_empty() && regions.sides.len() == 2 * parts.faces.len()).then_some(regions)
}

pub(super) fn read(reader: &mut Reader<'_>) -> Result<Regions> {
    let (mut chunk, _) = reader.versioned_1(WHAT)?;
    let sides = read_items(&mut chunk, read_side)?;
    let regions = read_items(&mut chunk, read_region)?;
    chunk.finish();
    Ok(Regions { sides, regions })
}

fn read_items<T>(reader: &mut Reader<'_>, item: fn(&mut Reader<'_>) -> Result<T>) -> Result<Vec<T>> {
    let (mut list, _) = reader.versioned_1(WHAT)?;
    let count = list.count(16, WHAT)?;
    let are_objects = list.version().archive >= 60;
    let mut items = Vec::with_capacity(count);
    for _ in 0..count {
        if are_objects {
            let object = ClassObject::read(&mut list)?;
            let mut body =
                object.data.ok_or_else(|| Error::malformed(object.offset, WHAT, "it has no body"))?;
            items.push(item(&mut body)?);
        } else {
            items.push(item(&mut list)?);
        }
    }
    list.finish();
    Ok(items)
}

/// Each begins with its own place in the list.
fn read_side(reader: &mut Reader<'_>) -> Result<FaceSide> {
    let (mut body, _) = reader.versioned_1(WHAT)?;
    body.i32(WHAT)?;
    let region = usize::try_from(body.i32(WHAT)?).ok();
    let face = usize::try_from(body.i32(WHAT)?).ok();
    let direction = body.i32(WHAT)?;
    body.finish();
    Ok(FaceSide { face, region, direction })
}

fn read_region(reader: &mut Reader<'_>) -> Result<Region> {
    let (mut body, _) = reader.versioned_1(WHAT)?;
    body.i32(WHAT)?;
    let kind = match body.i32(WHAT)? {
        0 => RegionKind::Infinite,
        1 => RegionKind::Finite,
        _ => RegionKind::Unknown,
    };
    let offset = body.offset();
    let place =
        |i: i32| usize::try_from(i).map_err(|_| Error::malformed(offset, WHAT, format!("{i} is no place")));
    let sides = body.ints(WHAT)?.into_iter().map(place).collect::<Result<_>>()?;
    let bounds = body.bounds(WHAT)?;
    body.finish();
    Ok(Region { kind, sides, bounds })
}

pub(super) fn write(regions: &Regions, w: &mut Writer) -> Result<()> {
    w.versioned(1, 0, |w| {
        write_items(&regions.sides, class_ids::FACE_SIDE, w, |place, side, w| {
            w.versioned(1, 0, |w| {
                w.count(place, "sides")?;
                for index in [side.region, side.face] {
                    write_place(index, w)?;
                }
                w.i32(side.direction);
                Ok(())
            })
        })?;
        write_items(&regions.regions, class_ids::REGION, w, |place, region, w| {
            w.versioned(1, 0, |w| {
                w.count(place, "regions")?;
                w.i32(match region.kind {
                    RegionKind::Unknown => -1,
                    RegionKind::Infinite => 0,
                    RegionKind::Finite => 1,
                });
                w.count(region.sides.len(), "sides")?;
                region.sides.iter().try_for_each(|side| write_place(Some(*side), w))?;
                w.bounds(region.bounds);
                Ok(())
            })
        })
    })
}

fn write_place(place: Option<usize>, w: &mut Writer) -> Result<()> {
    match place {
        Some(place) => w.count(place, "parts of a brep"),
        None => {
            w.i32(-1);
            Ok(())
        }
    }
}

fn write_items<T>(
    items: &[T],
    class: Uuid,
    w: &mut Writer,
    item: fn(usize, &T, &mut Writer) -> Result<()>,
) -> Result<()> {
    let are_objects = w.version().archive >= 60;
    w.versioned(1, 0, |w| {
        w.count(items.len(), "parts of a brep")?;
        for (place, part) in items.iter().enumerate() {
            if are_objects {
                write_class(w, class, &[], |w| item(place, part, w))?;
            } else {
                item(place, part, w)?;
            }
        }
        Ok(())
    })
}
