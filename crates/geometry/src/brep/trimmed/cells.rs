//! Faces on a surface from regions of its parameter plane.

use super::super::build::{Along, NewEdge, NewVertex, Path};
use super::super::{Brep, Builder, LoopKind};
use super::lift::lifted;
use crate::brep::thresholds::SAME_RANGE;
use crate::region::{Face as Cell, Region};
use crate::thresholds;
use crate::{Curve, Direction, Interval, Line, LineCurve, Point3, Result, Side, Surface, Tolerance};

/// Ends nearer than this part of the face's size are one vertex.
const SAME: f64 = 1e-7;

/// One brep of one face for each connected part of a region of a surface's parameter plane.
pub(super) fn of_region(
    surface: &Surface,
    reversed: bool,
    region: &Region,
    tolerance: &Tolerance,
) -> Result<Vec<Brep>> {
    region.faces().iter().map(|cell| of_cell(surface, reversed, cell, tolerance)).collect()
}

/// A piece of a loop in the parameter plane, and the side of the domain that it runs along, if any.
struct Piece {
    curve: Curve,
    side: Option<Side>,
}

fn of_cell(surface: &Surface, reversed: bool, cell: &Cell, tolerance: &Tolerance) -> Result<Brep> {
    let mut loops: Vec<Vec<Piece>> = Vec::new();
    for curve in cell.curves() {
        loops.push(pieces(surface, curve, tolerance)?);
    }
    cut_at_partners(surface, &mut loops)?;
    let mut maker = Maker::new(surface, &loops, tolerance)?;
    let mut bounds = Vec::with_capacity(loops.len());
    for chain in &loops {
        bounds.push(maker.paths(chain)?);
    }
    let face = maker.builder.face(surface.clone(), reversed);
    for (place, paths) in bounds.into_iter().enumerate() {
        maker.builder.bound(face, if place == 0 { LoopKind::Outer } else { LoopKind::Inner }, paths)?;
    }
    maker.builder.finish(2.0 * tolerance.absolute)
}

/// A loop as pieces without kinks; lines along sides of the domain lie exactly there.
fn pieces(surface: &Surface, curve: &Curve, tolerance: &Tolerance) -> Result<Vec<Piece>> {
    let mut out = Vec::new();
    for piece in curve.smooth_runs(tolerance)?.iter().flat_map(parts) {
        let piece = match piece.as_line(thresholds::ROUNDING * piece.bounding_box().diagonal().length()) {
            Some(line) => LineCurve { line, domain: piece.domain() }.into(),
            None => piece,
        };
        out.push(on_side(surface, piece));
    }
    Ok(out)
}

/// Straight chains as their segments, everything else whole.
fn parts(run: &Curve) -> Vec<Curve> {
    match run {
        Curve::Poly(chain)
            if chain.segments().iter().any(|s| matches!(s, Curve::Line(_) | Curve::Polyline(_))) =>
        {
            chain.segments().iter().flat_map(parts).collect()
        }
        Curve::Polyline(c) => {
            c.points().windows(2).filter(|w| w[0] != w[1]).map(|w| Line::new(w[0], w[1]).into()).collect()
        }
        other => vec![other.clone()],
    }
}

fn on_side(surface: &Surface, piece: Curve) -> Piece {
    let Curve::Line(LineCurve { line, domain }) = piece else { return Piece { curve: piece, side: None } };
    for side in Side::ALL {
        let (along, at_end) = side.along();
        let across = surface.domain(along.other());
        let value = if at_end { across.end } else { across.start };
        let least = thresholds::SAME_PARAMETER * across.length();
        let of = |p: Point3| if along == Direction::U { p.y } else { p.x };
        if (of(line.from) - value).abs() <= least && (of(line.to) - value).abs() <= least {
            let moved = |p: Point3| match along {
                Direction::U => Point3::new(p.x, value, 0.0),
                Direction::V => Point3::new(value, p.y, 0.0),
            };
            let line = Line::new(moved(line.from), moved(line.to));
            return Piece { curve: LineCurve { line, domain }.into(), side: Some(side) };
        }
    }
    Piece { curve: LineCurve { line, domain }.into(), side: None }
}

fn opposite(side: Side) -> Side {
    match side {
        Side::South => Side::North,
        Side::East => Side::West,
        Side::North => Side::South,
        Side::West => Side::East,
    }
}

/// The range of parameters that a piece covers along its side.
fn range_of(piece: &Piece) -> Option<(Side, Interval)> {
    let side = piece.side?;
    let (a, b) = (piece.curve.start(), piece.curve.end());
    let range =
        if side.along().0 == Direction::U { Interval::new(a.x, b.x) } else { Interval::new(a.y, b.y) };
    Some((side, range))
}

/// Cuts pieces along the sides where the surface closes at the ends of pieces on the other side.
fn cut_at_partners(surface: &Surface, loops: &mut [Vec<Piece>]) -> Result<()> {
    let known: Vec<(Side, Interval)> = loops.iter().flatten().filter_map(range_of).collect();
    for chain in loops.iter_mut() {
        let mut out = Vec::with_capacity(chain.len());
        for piece in chain.drain(..) {
            let Some((side, range)) =
                range_of(&piece).filter(|(side, _)| surface.is_closed(side.along().0.other()))
            else {
                out.push(piece);
                continue;
            };
            let least = thresholds::SAME_PARAMETER * range.length().abs();
            let (low, high) = (range.min(), range.max());
            let mut cuts: Vec<f64> = known
                .iter()
                .filter(|(other, _)| *other == opposite(side))
                .flat_map(|(_, r)| [r.start, r.end])
                .filter(|t| low + least < *t && *t < high - least)
                .collect();
            cuts.extend([range.start, range.end]);
            cuts.sort_by(f64::total_cmp);
            cuts.dedup_by(|b, a| *b - *a <= least);
            if range.start > range.end {
                cuts.reverse();
            }
            let constant = piece.curve.start();
            for w in cuts.windows(2) {
                let at = |t: f64| match side.along().0 {
                    Direction::U => Point3::new(t, constant.y, 0.0),
                    Direction::V => Point3::new(constant.x, t, 0.0),
                };
                out.push(Piece { curve: Line::new(at(w[0]), at(w[1])).into(), side: Some(side) });
            }
        }
        *chain = out;
    }
    Ok(())
}

/// Vertices and edges under construction.
struct Maker<'a> {
    surface: &'a Surface,
    builder: Builder,
    same: f64,
    limit: f64,
    vertices: Vec<(Point3, NewVertex)>,
    seams: Vec<(Side, Interval, NewEdge)>,
}

impl<'a> Maker<'a> {
    fn new(surface: &'a Surface, loops: &[Vec<Piece>], tolerance: &Tolerance) -> Result<Self> {
        let corners = loops.iter().flatten().flat_map(|p| {
            let (a, b) = (p.curve.start(), p.curve.point_at(p.curve.domain().middle()));
            [a, b].map(|uv| surface.point_at(uv.x, uv.y))
        });
        let size = crate::BoundingBox::from_points(corners).map_or(0.0, |b| b.diagonal().length());
        let same = (SAME * size).min(0.1 * tolerance.absolute);
        let limit = 0.2 * tolerance.absolute;
        Ok(Self { surface, builder: Builder::new(), same, limit, vertices: Vec::new(), seams: Vec::new() })
    }

    fn vertex(&mut self, uv: Point3) -> NewVertex {
        let point = self.surface.point_at(uv.x, uv.y);
        if let Some((_, known)) = self.vertices.iter().find(|(p, _)| p.distance_to(point) <= self.same) {
            return *known;
        }
        let new = self.builder.vertex(point);
        self.vertices.push((point, new));
        new
    }

    fn paths(&mut self, chain: &[Piece]) -> Result<Vec<Path>> {
        let mut out = Vec::with_capacity(chain.len());
        for piece in chain {
            let (start, end) = (piece.curve.start(), piece.curve.end());
            let ends = [self.vertex(start), self.vertex(end)];
            let along = match piece.side {
                Some(side) if self.surface.is_singular(side) => Along::Point(ends[0]),
                _ => self.edge(piece, ends)?,
            };
            out.push(Path { curve: piece.curve.clone(), along });
        }
        Ok(out)
    }

    fn edge(&mut self, piece: &Piece, ends: [NewVertex; 2]) -> Result<Along> {
        let seam = range_of(piece).filter(|(side, _)| self.surface.is_closed(side.along().0.other()));
        if let Some((side, range)) = seam {
            let near = |a: f64, b: f64| (a - b).abs() <= SAME_RANGE * range.length().abs();
            let partner = self.seams.iter().find(|(other, r, _)| {
                *other == opposite(side) && near(r.start, range.end) && near(r.end, range.start)
            });
            if let Some((_, _, edge)) = partner {
                return Ok(Along::Edge(*edge, true));
            }
        }
        let curve = lifted(self.surface, &piece.curve, self.limit)?;
        let edge = self.builder.edge(curve, ends);
        if let Some((side, range)) = seam {
            self.seams.push((side, range, edge));
        }
        Ok(Along::Edge(edge, false))
    }
}
