//! Waves and noise on terrains, slopes, and shortest ways.

use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_elementary::Elementary as _;
use katydid_geometry::{Curve, Point3, Vector3};

use super::path::Paths;
use super::{Terrain, length};
use crate::noise::kinds::perlin;

/// Adds a wave inside closed curves that fades towards them, or everywhere.
fn displaced(
    context: &Context<'_>,
    grid: &List<'_, f64>,
    curves: &List<'_, Shared<Curve>>,
    fade: f64,
    wave: impl Fn([f64; 2]) -> f64,
) -> Result<Vec<f64>, Message> {
    let mut terrain = Terrain::of(context, grid)?;
    let fade = length(fade, "The smoothing distance")?;
    let paths = match curves.is_empty() {
        true => None,
        false => Some(Paths::of_list(context, curves, terrain.cell)?),
    };
    terrain.change(context, |place, z| {
        let share = match &paths {
            None => 1.0,
            Some(paths) if !paths.surround(place) => 0.0,
            Some(_) if fade == 0.0 => 1.0,
            Some(paths) => paths.near(place, fade).map_or(1.0, |near| near.distance / fade),
        };
        z + share * wave(place)
    })?;
    Ok(terrain.list())
}

fn wavelength(value: f64) -> Result<f64, Message> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(Message::error("The wavelength must be greater than 0"))
    }
}

/// Moves heights by gradient noise inside closed curves, or everywhere. Stands for Docofossor's Noise; the noise itself is our own.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a14",
    name = "Noise",
    nick = "dfNoise",
    at = "Docofossor/Generative"
)]
#[output("df", "df", "The grid, as a list of numbers.")]
fn noise(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// Closed curves; everywhere when nothing is given.
    #[port("crv", "crv", optional)]
    curves: List<Shared<Curve>>,
    /// The size of the noise's waves, in units.
    #[port("wl", "wl", default = 16.0)]
    wave: f64,
    /// The greatest change of height, in units.
    #[port("a", "a", default = 4.0)]
    amplitude: f64,
    /// How far from the curves it has faded in, in units.
    #[port("s", "s", default = 8.0)]
    fade: f64,
) -> Result<Vec<f64>, Message> {
    let wave = wavelength(wave)?;
    displaced(context, &grid, &curves, fade, |[x, y]| amplitude * perlin(0, [x / wave, y / wave]))
}

/// Moves heights by sine waves along x and y inside closed curves, or everywhere. Stands for Docofossor's Sine Wave; that the
/// waves of x and y are multiplied is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a15",
    name = "Sine Wave",
    nick = "dfSineWave",
    at = "Docofossor/Generative"
)]
#[output("df", "df", "The grid, as a list of numbers.")]
fn sine_wave(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// Closed curves; everywhere when nothing is given.
    #[port("crv", "crv", optional)]
    curves: List<Shared<Curve>>,
    /// The length of a wave, in units.
    #[port("wl", "wl", default = 16.0)]
    wave: f64,
    /// The greatest change of height, in units.
    #[port("a", "a", default = 4.0)]
    amplitude: f64,
    /// How far from the curves it has faded in, in units.
    #[port("s", "s", default = 8.0)]
    fade: f64,
) -> Result<Vec<f64>, Message> {
    let turn = std::f64::consts::TAU / wavelength(wave)?;
    displaced(context, &grid, &curves, fade, |[x, y]| amplitude * (x * turn).sine() * (y * turn).sine())
}

/// The gradient at each height: it looks uphill, as long as the slope is steep; central differences. Stands for Docofossor's Slope
/// Vector.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a16",
    name = "Slope Vector",
    nick = "dfSlopeVector",
    at = "Docofossor/Analysis"
)]
#[output("a", "a", "A vector for each height, column by column.")]
fn slope_vector(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
) -> Result<Vec<Vector3>, Message> {
    let terrain = Terrain::of(context, &grid)?;
    let slope = |low: (usize, usize), high: (usize, usize), cell: f64| {
        let cells = (high.0 - low.0 + high.1 - low.1) as f64;
        let rise = terrain.height(high.0, high.1) - terrain.height(low.0, low.1);
        if cells > 0.0 { rise / (cells * cell) } else { 0.0 }
    };
    let [cx, cy] = terrain.cell;
    Ok((0..terrain.heights.len())
        .map(|i| {
            let (c, r) = (i / terrain.rows, i % terrain.rows);
            let x = slope((c.saturating_sub(1), r), ((c + 1).min(terrain.columns - 1), r), cx);
            let y = slope((c, r.saturating_sub(1)), (c, (r + 1).min(terrain.rows - 1)), cy);
            Vector3::new(x, y, 0.0)
        })
        .collect())
}

/// A cell on its way out of the heap: the nearest first.
#[derive(PartialEq)]
struct Step(f64, usize);

impl Eq for Step {}

impl PartialOrd for Step {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Step {
    fn cmp(&self, other: &Self) -> Ordering {
        other.0.total_cmp(&self.0).then(other.1.cmp(&self.1))
    }
}

/// The shortest way over a terrain from cell to cell (E. W. Dijkstra, *A note on two problems in connexion with graphs*, 1959).
/// Stands for Docofossor's Shortest Path; the way comes as points, where the plug-in gives numbers of cells.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a17",
    name = "Shortest Path",
    nick = "dfShortestPath",
    at = "Docofossor/Analysis"
)]
#[output("dsts", "dsts", "The distance of each cell from the target; -1 where there is no way.", kind = Number)]
#[output("route", "route", "The points of the way, from start to target.", kind = Point)]
fn shortest_path(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// For each cell 1 where it is free, 0 where it is not; all are free when nothing is given.
    #[port("omap", "omap", optional)]
    free: List<f64>,
    /// The start.
    #[port("sp", "sp")]
    start: Point3,
    /// The target.
    #[port("tp", "tp")]
    target: Point3,
    /// 1 for steps over edges, 2 for steps over corners too.
    #[port("c", "c", default = 2)]
    kind: i32,
    /// What a height difference is multiplied by before it counts as a way.
    #[port("f", "f", default = 1.0)]
    factor: f64,
) -> Result<(Vec<f64>, Vec<Point3>), Message> {
    let terrain = Terrain::of(context, &grid)?;
    let (columns, rows) = (terrain.columns as i64, terrain.rows as i64);
    let cell_of = |p: Point3| {
        let number = |x: f64, axis: usize, count: i64| {
            let place = ((x - terrain.origin[axis]) / terrain.cell[axis]).round();
            place.clamp(0.0, count as f64 - 1.0) as usize
        };
        number(p.x, 0, columns) * terrain.rows + number(p.y, 1, rows)
    };
    let is_free = |i: usize| free.get(i).is_none_or(|x| x != 0.0);
    let steps: Vec<(i64, i64)> = (-1..=1)
        .flat_map(|a| (-1..=1).map(move |b| (a, b)))
        .filter(|&(a, b)| (a, b) != (0, 0) && (kind != 1 || a == 0 || b == 0))
        .collect();
    let (start, goal) = (cell_of(start), cell_of(target));
    let mut distances = vec![f64::INFINITY; terrain.heights.len()];
    let mut next = vec![usize::MAX; terrain.heights.len()];
    let mut heap = BinaryHeap::from([Step(0.0, goal)]);
    if let Some(slot) = distances.get_mut(goal) {
        *slot = 0.0;
    }
    let mut count = 0_usize;
    while let Some(Step(far, i)) = heap.pop() {
        count += 1;
        if count.is_multiple_of(4096) {
            context.check()?;
        }
        if distances.get(i).is_none_or(|known| far > *known) {
            continue;
        }
        let (c, r) = ((i / terrain.rows) as i64, (i % terrain.rows) as i64);
        for (a, b) in &steps {
            let (column, row) = (c + a, r + b);
            if !(0..columns).contains(&column) || !(0..rows).contains(&row) {
                continue;
            }
            let j = column as usize * terrain.rows + row as usize;
            if !is_free(j) {
                continue;
            }
            let flat = (*a as f64 * terrain.cell[0]).hypotenuse(*b as f64 * terrain.cell[1]);
            let rise = terrain.height(column as usize, row as usize)
                - terrain.heights.get(i).copied().unwrap_or(0.0);
            let new = far + flat.hypotenuse(rise * factor);
            if let (Some(known), Some(from)) = (distances.get_mut(j), next.get_mut(j))
                && new < *known
            {
                (*known, *from) = (new, i);
                heap.push(Step(new, j));
            }
        }
    }
    let mut route = Vec::new();
    let mut at = start;
    if distances.get(start).is_some_and(|far| far.is_finite()) {
        while route.len() <= distances.len() {
            route.push(terrain.point(at));
            match next.get(at) {
                Some(&j) if j != usize::MAX && at != goal => at = j,
                _ => break,
            }
        }
    } else {
        context.warn("There is no way from the start to the target");
    }
    let distances = distances.into_iter().map(|far| if far.is_finite() { far } else { -1.0 });
    Ok((distances.collect(), route))
}
