//! Cells over the parameters of a face: a grid of lines, and cells halved where the limits ask for it.

use katydid_elementary::Elementary;

use super::bend::{Bend, Bender};
use super::need;
use super::probes::Probes;
use super::settings::Limits;
use crate::meshing::thresholds::COUNT_SLACK;
use crate::{Error, Result, cancellation};

/// Places between two lines of the first grid: cells are halved at most ten times each way.
pub(super) const PLACES: u32 = 1 << 10;
/// Most cells of a face.
const MOST: usize = 8_000_000;
/// A quarter of a turn, as bounds tell it of the quarters of a tube.
const QUARTER: f64 = 1.1 * std::f64::consts::FRAC_PI_2;
/// So few parts are asked for by bounds that are wide, where one is enough.
const UNDIVIDED: f64 = 1.5;
/// Most rectangles over which bounds are computed.
const PROBES: f64 = 60_000.0;

/// A rectangle of the grid, in places; halved or a cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    /// The first and last place in u and in v.
    pub(super) range: [[u32; 2]; 2],
    /// Its first half; the second one follows it.
    pub(super) halves: Option<u32>,
}

/// Cells over a rectangle of parameters.
pub(super) struct Grid {
    /// The lines of the first grid, in u and v, where pieces of the surface meet among them.
    pub(super) lines: [Vec<f64>; 2],
    /// The rectangles between the lines, v running fastest, and then what they are halved into.
    pub(super) nodes: Vec<Node>,
    probes: Probes,
}

impl Grid {
    /// The cells over the rectangle that `breaks` span: their lines are those of the grid, whatever the limits. `pieces`
    /// are the breaks and all parameters at which pieces of the surface meet, however smoothly: bounds hold between
    /// them.
    ///
    /// # Errors
    /// The limits ask for more than eight million cells.
    pub(super) fn new(
        bender: &Bender<'_>,
        breaks: [Vec<f64>; 2],
        pieces: &[Vec<f64>; 2],
        limits: &Limits,
        flat: bool,
    ) -> Result<Self> {
        let flat = flat && limits.simple_planes;
        let probes = probes(bender, pieces, limits);
        let mut counts = [0, 1].map(|d| counts(&probes, &breaks, d, limits));
        adjust(&probes, &breaks, &mut counts, limits, flat);
        let lines = [0, 1].map(|d| divided(&breaks[d], &counts[d]));
        let cells = (lines[0].len() - 1).saturating_mul(lines[1].len() - 1);
        if cells > MOST || lines.iter().any(|l| l.len() > (u32::MAX / PLACES) as usize) {
            return Err(too_many(cells));
        }
        cancellation::room::<Node>(cells)?;
        let mut grid = Self { lines, nodes: Vec::with_capacity(cells), probes };
        for i in 0..grid.lines[0].len() as u32 - 1 {
            for j in 0..grid.lines[1].len() as u32 - 1 {
                let range = [i, j].map(|k| [k * PLACES, (k + 1) * PLACES]);
                grid.nodes.push(Node { range, halves: None });
            }
        }
        if limits.refine {
            grid.refine(limits)?;
        }
        Ok(grid)
    }

    fn refine(&mut self, limits: &Limits) -> Result<()> {
        let mut k = 0;
        while let Some(&node) = self.nodes.get(k) {
            cancellation::check()?;
            let rectangle = self.rectangle(&node);
            let size = rectangle.map(|[a, b]| b - a);
            let bend = self.probes.over(rectangle);
            if let Some(d) = need::halving(&bend, size, limits) {
                self.halve(k, d)?;
            }
            k += 1;
        }
        Ok(())
    }

    /// Halves a cell, unless it is as small as cells get.
    fn halve(&mut self, k: usize, d: usize) -> Result<()> {
        let first = self.nodes.len();
        if first > 2 * MOST {
            return Err(too_many(first));
        }
        let Some(node) = self.nodes.get_mut(k) else { return Ok(()) };
        let [from, to] = node.range[d];
        if to - from < 2 {
            return Ok(());
        }
        let middle = from + (to - from) / 2;
        let (mut low, mut high) = (*node, *node);
        low.range[d][1] = middle;
        high.range[d][0] = middle;
        node.halves = Some(first as u32);
        self.nodes.extend([low, high]);
        Ok(())
    }

    /// The number of cells.
    pub(super) fn cell_count(&self) -> usize {
        // Whatever is halved leaves two nodes more, and is no cell itself.
        let first = (self.lines[0].len().saturating_sub(1)) * (self.lines[1].len().saturating_sub(1));
        first + self.nodes.len().saturating_sub(first) / 2
    }

    /// The parameter at a place along one direction.
    pub(super) fn parameter(&self, d: usize, place: u32) -> f64 {
        let lines = &self.lines[d];
        let (line, part) = ((place / PLACES) as usize, place % PLACES);
        let at = |k: usize| lines.get(k).copied().unwrap_or(f64::NAN);
        if part == 0 {
            at(line)
        } else {
            at(line) + (at(line + 1) - at(line)) * (f64::from(part) / f64::from(PLACES))
        }
    }

    /// The place at a parameter, if there is one at exactly this parameter.
    pub(super) fn place(&self, d: usize, t: f64) -> Option<u32> {
        let lines = &self.lines[d];
        let line = lines.partition_point(|&x| x <= t).checked_sub(1)?;
        let start = *lines.get(line)?;
        let part = match lines.get(line + 1) {
            Some(&end) => ((t - start) / (end - start) * f64::from(PLACES)).round() as u32,
            None => 0,
        };
        let place = line as u32 * PLACES + part;
        (self.parameter(d, place) == t).then_some(place)
    }

    /// The parameters that a node covers.
    pub(super) fn rectangle(&self, node: &Node) -> [[f64; 2]; 2] {
        [0, 1].map(|d| node.range[d].map(|place| self.parameter(d, place)))
    }

    /// The parameters at which corners of cells lie on a line, strictly inside a range, in order. The line is at a
    /// place of direction `d`.
    pub(super) fn places_on(&self, d: usize, line: u32, range: [f64; 2]) -> Vec<f64> {
        let value = self.parameter(d, line);
        let mut found = Vec::new();
        let around = if d == 0 { [[value; 2], range] } else { [range, [value; 2]] };
        self.visit(
            around,
            |_| true,
            |_, node| {
                if node.range[d].contains(&line) {
                    found.extend(node.range[1 - d]);
                }
            },
        );
        found.sort_unstable();
        found.dedup();
        let parameters = found.into_iter().map(|place| self.parameter(1 - d, place));
        parameters.filter(|&t| t > range[0] && t < range[1]).collect()
    }

    /// The bounds over a rectangle.
    pub(super) fn bend(&self, rectangle: [[f64; 2]; 2]) -> Bend {
        self.probes.over(rectangle)
    }

    /// Calls for every cell that a closed rectangle touches and `wanted` lets through.
    pub(super) fn visit(
        &self,
        rectangle: [[f64; 2]; 2],
        mut wanted: impl FnMut([[f64; 2]; 2]) -> bool,
        mut visit: impl FnMut(usize, &Node),
    ) {
        let [u, v] = [0, 1].map(|d| {
            let lines = &self.lines[d];
            let last = lines.len().saturating_sub(2);
            let start = lines.partition_point(|&t| t < rectangle[d][0]).saturating_sub(1).min(last);
            let end = lines.partition_point(|&t| t <= rectangle[d][1]).saturating_sub(1).min(last);
            [start, end]
        });
        let columns = self.lines[1].len().saturating_sub(1);
        let mut stack = Vec::new();
        for i in u[0]..=u[1] {
            for j in v[0]..=v[1] {
                stack.push(i * columns + j);
                while let Some(k) = stack.pop() {
                    let Some(node) = self.nodes.get(k) else { continue };
                    let own = self.rectangle(node);
                    let apart = (0..2).any(|d| own[d][0] > rectangle[d][1] || own[d][1] < rectangle[d][0]);
                    if apart || !wanted(own) {
                        continue;
                    }
                    match node.halves {
                        Some(first) => stack.extend([first as usize, first as usize + 1]),
                        None => visit(k, node),
                    }
                }
            }
        }
    }
}

fn too_many(cells: usize) -> Error {
    Error::OutOfRange { what: "number of mesh cells", value: cells as f64, must: "at most 8 million a face" }
}

/// Bounds over rectangles of some three by three cells each.
fn probes(bender: &Bender<'_>, breaks: &[Vec<f64>; 2], limits: &Limits) -> Probes {
    let coarse = Probes::new(bender, breaks.clone());
    let mut finest = [0, 1].map(|d| vec![1.0_f64; breaks[d].len().saturating_sub(1)]);
    let columns = finest[1].len();
    for (i, u) in breaks[0].windows(2).enumerate() {
        for (j, v) in breaks[1].windows(2).enumerate() {
            let Some(bend) = coarse.bends().get(i * columns + j) else { continue };
            let n = need::parts(bend, [u[1] - u[0], v[1] - v[0]], limits);
            // Normals should not turn far inside one either, where the limits ask for parts: else by a quarter.
            let turned = |d: usize, wide: f64| {
                let most = if n[d] > UNDIVIDED { 0.6 } else { QUARTER };
                (bend.turn[d] * wide / most).min(16.0) * 3.0
            };
            finest[0][i] = finest[0][i].max(n[0]).max(turned(0, u[1] - u[0]));
            finest[1][j] = finest[1][j].max(n[1]).max(turned(1, v[1] - v[0]));
        }
    }
    if finest.iter().flatten().all(|&n| n <= 3.0) {
        return coarse;
    }
    let mut each =
        finest.map(|list| list.iter().map(|n| (n / 3.0).ceil().clamp(1.0, 64.0)).collect::<Vec<_>>());
    let total = |each: &[Vec<f64>; 2]| each[0].iter().sum::<f64>() * each[1].iter().sum::<f64>();
    while total(&each) > PROBES && each.iter().flatten().any(|&n| n > 1.0) {
        each.iter_mut().flatten().for_each(|n| *n = (*n / 1.3).ceil().min(*n - 1.0).max(1.0));
    }
    let lines = [0, 1].map(|d| {
        let counts: Vec<u32> = each[d].iter().map(|&n| n as u32).collect();
        divided(&breaks[d], &counts)
    });
    Probes::new(bender, lines)
}

/// For every stretch between breaks the number of parts of the first grid: that of the place that asks for the most,
/// halved as often as the place that asks for the least allows.
fn counts(probes: &Probes, breaks: &[Vec<f64>; 2], d: usize, limits: &Limits) -> Vec<u32> {
    let columns = probes.lines[1].len().saturating_sub(1);
    let mut out = Vec::with_capacity(breaks[d].len());
    for own in breaks[d].windows(2) {
        let wide = own[1] - own[0];
        let [first, last] = probes.reached(d, [own[0], own[1]]);
        let (mut most, mut least) = (1.0_f64, f64::INFINITY);
        for other in breaks[1 - d].windows(2) {
            let across = other[1] - other[0];
            let size = if d == 0 { [wide, across] } else { [across, wide] };
            let [from, to] = probes.reached(1 - d, [other[0], other[1]]);
            for i in first..=last {
                for j in from..=to {
                    let place = if d == 0 { i * columns + j } else { j * columns + i };
                    let Some(bend) = probes.bends().get(place) else { continue };
                    // What the whole rectangle between breaks would take if it bent as much everywhere.
                    let n = need::parts(bend, size, limits)[d];
                    most = most.max(n);
                    least = least.min(n);
                }
            }
        }
        let most = (most - COUNT_SLACK).ceil().max(1.0);
        let halvings = (most / least.max(1.0)).logarithm_2().floor().clamp(0.0, 9.0);
        out.push((most / halvings.power_of_two()).ceil().clamp(1.0, 1e6) as u32);
    }
    out
}

/// Brings the number of cells of the first grid between its bounds.
fn adjust(probes: &Probes, breaks: &[Vec<f64>; 2], counts: &mut [Vec<u32>; 2], limits: &Limits, flat: bool) {
    let whole = |counts: &[Vec<u32>; 2]| {
        counts.each_ref().map(|list| list.iter().map(|&n| f64::from(n)).sum::<f64>().max(1.0))
    };
    if !flat {
        let mean = probes.bends().iter().fold([0.0; 2], |s, b| [s[0] + b.speed[0], s[1] + b.speed[1]]);
        let sides = [0, 1].map(|d| match breaks[d].as_slice() {
            [first, .., last] => (last - first) * mean[d],
            _ => 0.0,
        });
        for _ in 0..64 {
            let [n, m] = whole(counts);
            if n * m >= limits.min_count as f64 {
                break;
            }
            let long = usize::from(sides[1] / m > sides[0] / n);
            counts[long].iter_mut().for_each(|n| *n += 1);
        }
    }
    while whole(counts).iter().product::<f64>() > limits.max_count as f64 {
        let long = usize::from(whole(counts)[1] > whole(counts)[0]);
        if counts[long].iter().all(|&n| n == 1) {
            break;
        }
        counts[long].iter_mut().for_each(|n| *n = (*n * 7 / 8).max(1));
    }
}

/// Each stretch in so many equal parts.
fn divided(breaks: &[f64], counts: &[u32]) -> Vec<f64> {
    let mut out = Vec::with_capacity(counts.iter().map(|&n| n as usize).sum::<usize>() + 1);
    for (w, &n) in breaks.windows(2).zip(counts) {
        out.extend((0..n).map(|k| w[0] + (w[1] - w[0]) * (f64::from(k) / f64::from(n))));
    }
    out.extend(breaks.last());
    out
}
