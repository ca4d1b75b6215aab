//! Volumes put together as sets, moved outwards, and smoothed.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;

use super::volume::Volume;

/// How far two sizes of voxels may differ and count as the same: rounding, as a part.
const SAME_VOXEL: f64 = 1e-9;
/// The most steps of smoothing.
const MOST_STEPS: i32 = 1000;

/// Distances put together at the points of a grid over all volumes.
fn combined(
    context: &Context<'_>,
    volumes: &[&Volume],
    rule: impl Fn(f64, f64) -> f64,
) -> Result<Value, Message> {
    let Some((start, others)) = volumes.split_first() else {
        return Err(Message::error("There is no volume"));
    };
    let (mut first, mut last) = (start.first, [0_i64; 3]);
    let end = |volume: &Volume, axis: usize| {
        volume.first[axis].saturating_add(i64::try_from(volume.counts[axis]).unwrap_or(i64::MAX))
    };
    for axis in 0..3 {
        last[axis] = end(start, axis);
        for other in others {
            if (other.voxel - start.voxel).abs() > SAME_VOXEL * start.voxel {
                return Err(Message::error("Volumes of other voxel sizes cannot be put together"));
            }
            first[axis] = first[axis].min(other.first[axis]);
            last[axis] = last[axis].max(end(other, axis));
        }
    }
    let counts = [0, 1, 2].map(|axis| usize::try_from(last[axis] - first[axis]).unwrap_or(usize::MAX));
    let band = volumes.iter().map(|volume| volume.band).fold(f64::INFINITY, f64::min);
    let mut result = Volume::filled(context, start.voxel, first, counts, band)?;
    result.fill(context, |_, [j, k], row| {
        for (i, distance) in row.iter_mut().enumerate() {
            let place = |n: usize, axis: usize| first[axis] + i64::try_from(n).unwrap_or(0);
            let place = [place(i, 0), place(j, 1), place(k, 2)];
            *distance = others.iter().fold(start.at(place), |sum, other| rule(sum, other.at(place)));
        }
        Ok(())
    })?;
    Ok(result.item())
}

fn all(values: &List<Value>) -> Result<Vec<Value>, Message> {
    let values: Vec<Value> = values.iter().flatten().collect();
    if values.is_empty() { Err(Message::error("There is no volume")) } else { Ok(values) }
}

/// What is inside any of the volumes. Stands for Dendro's Volume Union.
#[component(
    "dc9d71b6-f859-4b95-ad2a-608bee0f6b23",
    name = "Volume Union",
    nick = "vUnion",
    at = "Dendro/Boolean"
)]
#[output("Result", "R", "The volume.", kind = Generic)]
fn union(
    context: &Context<'_>,
    /// The volumes, of one voxel size.
    #[port("Volumes", "V", kind = Generic)]
    volumes: List<Value>,
) -> Result<Value, Message> {
    let volumes = all(&volumes)?;
    let volumes: Vec<&Volume> = volumes.iter().map(Volume::of).collect::<Result<_, _>>()?;
    combined(context, &volumes, f64::min)
}

/// What is inside all of the volumes. Stands for Dendro's Volume Intersection; its id is not known, it is found by its name.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd002",
    name = "Volume Intersection",
    nick = "vInt",
    at = "Dendro/Boolean"
)]
#[output("Result", "R", "The volume.", kind = Generic)]
fn intersection(
    context: &Context<'_>,
    /// The volumes.
    #[port("Volumes", "V", kind = Generic)]
    volumes: List<Value>,
    /// More volumes, of the same voxel size.
    #[port("Intersectors", "I", optional, kind = Generic)]
    others: List<Value>,
) -> Result<Value, Message> {
    let mut volumes = all(&volumes)?;
    volumes.extend(others.iter().flatten());
    let volumes: Vec<&Volume> = volumes.iter().map(Volume::of).collect::<Result<_, _>>()?;
    combined(context, &volumes, f64::max)
}

/// What is inside a volume and outside all of others. Stands for Dendro's Volume Difference; its id is not known, it is found by
/// its name.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd003",
    name = "Volume Difference",
    nick = "vDiff",
    at = "Dendro/Boolean"
)]
#[output("Result", "R", "The volume.", kind = Generic)]
fn difference(
    context: &Context<'_>,
    /// The volume.
    #[port("Volume", "V", kind = Generic)]
    volume: List<Value>,
    /// What is taken away, of the same voxel size.
    #[port("Subtractors", "S", optional, kind = Generic)]
    others: List<Value>,
) -> Result<Value, Message> {
    let mut volumes = all(&volume)?;
    volumes.truncate(1);
    volumes.extend(others.iter().flatten());
    let volumes: Vec<&Volume> = volumes.iter().map(Volume::of).collect::<Result<_, _>>()?;
    combined(context, &volumes, |a, b| a.max(-b))
}

/// Mixes of the distances of two volumes. Stands for Dendro's Blend Volumes; its id is not known, it is found by its name.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd004",
    name = "Blend Volumes",
    nick = "vBlend",
    at = "Dendro/Filters"
)]
#[output("Volume", "V", "The volume.", kind = Generic)]
fn blend(
    context: &Context<'_>,
    /// The volume at 0.
    #[port("Volume A", "A", kind = Generic)]
    a: Value,
    /// The volume at 1.
    #[port("Volume B", "B", kind = Generic)]
    b: Value,
    /// From 0 to 1.
    #[port("Blend Position", "P", default = 0.5)]
    position: f64,
) -> Result<Value, Message> {
    if !(0.0..=1.0).contains(&position) {
        return Err(Message::error("The position must be from 0 to 1"));
    }
    combined(context, &[Volume::of(&a)?, Volume::of(&b)?], |a, b| a + (b - a) * position)
}

/// A volume whose surface lies farther out, or in where the distance is negative. It must stay within the band. Stands for
/// Dendro's Offset Volume; its id is not known, it is found by its name. Masks are not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd005",
    name = "Offset Volume",
    nick = "vOffset",
    at = "Dendro/Filters"
)]
#[output("Volume", "V", "The volume.", kind = Generic)]
fn offset(
    context: &Context<'_>,
    /// The volume.
    #[port("Volume", "V", kind = Generic)]
    volume: Value,
    /// How far out.
    #[port("Distance", "D", default = 1.0)]
    distance: f64,
    /// Where the filter works; not supported.
    #[port("Mask", "M", optional, kind = Generic)]
    mask: Option<Value>,
) -> Result<Value, Message> {
    no_mask(mask.as_ref())?;
    let volume = Volume::of(&volume)?;
    if !(distance.abs() < volume.band) {
        let band = volume.band;
        return Err(Message::error(format!("The distance must be within the band of {band}")));
    }
    let mut result =
        Volume::filled(context, volume.voxel, volume.first, volume.counts, volume.band - distance.abs())?;
    result.distances.clone_from(&volume.distances);
    result.fill(context, |_, _, row| {
        row.iter_mut().for_each(|d| *d -= distance);
        Ok(())
    })?;
    Ok(result.item())
}

fn no_mask(mask: Option<&Value>) -> Result<(), Message> {
    match mask {
        None => Ok(()),
        Some(_) => Err(Message::error("Not supported: masks of filters")),
    }
}

/// A volume without its small bumps. Each step takes at each point the mean (0), a Gaussian mean (1), a step of mean
/// curvature or Laplacian flow, told by the mean over neighbours (2 and 4), or the median (3) of the distances around it.
/// Stands for Dendro's Smooth Volume; what the numbers of types mean is our reading. Masks are not supported.
#[component(
    "cc7da05b-aea7-47ce-b74d-6d84d25ebac3",
    name = "Smooth Volume",
    nick = "vSmooth",
    at = "Dendro/Filters"
)]
#[output("Volume", "V", "The volume.", kind = Generic)]
fn smooth(
    context: &Context<'_>,
    /// The volume.
    #[port("Volume", "V", kind = Generic)]
    volume: Value,
    /// How many voxels on each side are looked at, from 1 to 8.
    #[port("Width", "W", default = 1)]
    width: i32,
    /// 0 mean, 1 Gaussian, 2 Laplacian, 3 median, 4 mean curvature.
    #[port("Type", "T", default = 1)]
    kind: i32,
    /// The number of steps.
    #[port("Iterations", "I", default = 1)]
    iterations: i32,
    /// Where the filter works; not supported.
    #[port("Mask", "M", optional, kind = Generic)]
    mask: Option<Value>,
) -> Result<Value, Message> {
    no_mask(mask.as_ref())?;
    let volume = Volume::of(&volume)?;
    if !(0..=4).contains(&kind) {
        return Err(Message::error("The type is a number from 0 to 4"));
    }
    if !(0..=MOST_STEPS).contains(&iterations) {
        return Err(Message::error(format!("The iterations must be from 0 to {MOST_STEPS}")));
    }
    let width = match kind {
        2 | 4 => 1,
        _ => usize::try_from(width.clamp(1, 8)).unwrap_or(1),
    };
    let mut result = Volume::filled(context, volume.voxel, volume.first, volume.counts, volume.band)?;
    result.distances.clone_from(&volume.distances);
    // A Gaussian is four means one after another, as the central limit theorem has it.
    let passes = if kind == 1 { 4 } else { 1 };
    for _ in 0..iterations * passes {
        // Along each axis by itself: the mean over a box is that of means, and the median over a cross is near to it.
        for axis in 0..3 {
            along(context, &mut result, axis, width, kind == 3)?;
        }
    }
    Ok(result.item())
}

/// Takes at each point the mean or median of those along an axis; beyond the end stands the last one.
fn along(
    context: &Context<'_>,
    volume: &mut Volume,
    axis: usize,
    width: usize,
    median: bool,
) -> Result<(), Message> {
    let [nx, ny, _] = volume.counts;
    let stride = [1, nx, nx.saturating_mul(ny)][axis];
    let count = volume.counts[axis];
    let mut line = vec![0.0; count];
    let mut window = Vec::with_capacity(2 * width + 1);
    for start in 0..volume.distances.len() {
        if (start / stride) % count != 0 {
            continue;
        }
        if start % 1024 == 0 {
            context.check()?;
        }
        for (n, slot) in line.iter_mut().enumerate() {
            *slot = volume.distances.get(start + n * stride).copied().unwrap_or(volume.band);
        }
        for n in 0..count {
            window.clear();
            for m in 0..=2 * width {
                let place = (n + m).saturating_sub(width).min(count - 1);
                window.extend(line.get(place));
            }
            let value = if median {
                window.sort_by(f64::total_cmp);
                window.get(width).copied().unwrap_or(volume.band)
            } else {
                window.iter().sum::<f64>() / window.len().max(1) as f64
            };
            if let Some(slot) = volume.distances.get_mut(start + n * stride) {
                *slot = value;
            }
        }
    }
    Ok(())
}
