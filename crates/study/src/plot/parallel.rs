//! Parallel coordinates (Inselberg 1985): an axis a column, a line a point.

use plotters::prelude::{Color, Rectangle, ShapeStyle};
use plotters::style::text_anchor::{HPos, VPos};

use super::axis::{Axis, LETTERS, short};
use super::style::{ERROR, GROUND, INK, LINE, SOFT, colour, legend, line, text, title, write};
use super::{Area, PlotOptions, SIZE, choice, failed as broken};
use crate::thresholds::MOST_AXES;
use crate::{Kind, Row, StudyError, StudyFolder};

const TOP: i32 = 120;
const LEFT: i32 = 60;

pub(super) fn draw(area: &Area<'_>, folder: &StudyFolder, options: &PlotOptions) -> Result<(), StudyError> {
    let mut axes = Vec::new();
    let mut without = Vec::new();
    for (at, column) in folder.columns().iter().enumerate() {
        match Axis::of(folder, at) {
            Ok(axis) if axes.len() < MOST_AXES => axes.push(axis),
            _ => without.push(column.name.clone()),
        }
    }
    if axes.is_empty() {
        return Err(StudyError::Unfit("the study has no column with numbers".to_owned()));
    }
    let colours = match &options.colour {
        Some(name) => Some(Axis::of(folder, choice::find(folder, name)?)?),
        None => axes
            .iter()
            .rev()
            .find(|axis| folder.columns().get(axis.column).is_some_and(|c| c.kind == Kind::Output))
            .cloned(),
    };
    let remark = if without.is_empty() {
        String::new()
    } else {
        format!("no axis: {}", short(&without.join(", "), 60))
    };
    title(area, folder, "Parallel coordinates", &remark)?;
    let has_gaps = folder.rows().iter().any(|row| axes.iter().any(|axis| axis.at(row).is_none()));
    let bottom = SIZE.1.cast_signed() - if has_gaps { 74 } else { 44 };
    let right = SIZE.0.cast_signed() - if colours.is_some() { 190 } else { 90 };
    let step = f64::from(right - LEFT) / (count(axes.len()) - 1.0).max(1.0);
    let place =
        |k: usize| if axes.len() < 2 { (LEFT + right) / 2 } else { LEFT + scaled(count(k) * step, 1) };
    // What has no results lies behind, and is dashed: it must be seen, and not hide the others.
    let (good, failed): (Vec<&Row>, Vec<&Row>) = folder.rows().iter().partition(|row| row.is_good());
    let strength = (1.0 / (count(good.len()) / 60.0).max(1.0).sqrt()).max(0.12);
    for row in failed {
        dashed(area, &path(&axes, row, &place, bottom))?;
    }
    for row in good {
        let style = ShapeStyle::from(colour(colours.as_ref(), row).mix(strength)).stroke_width(1);
        line(area, path(&axes, row, &place, bottom), style)?;
    }
    for (k, axis) in axes.iter().enumerate() {
        let x = place(k);
        line(area, vec![(x, TOP), (x, bottom)], ShapeStyle::from(INK).stroke_width(1))?;
        let kind = folder.columns().get(axis.column).map(|column| column.kind);
        let said = if kind == Some(Kind::Input) { "input" } else { "output" };
        // Names beside each other take turns, so that long ones have room.
        let y = TOP - 12 - if k % 2 == 1 && axes.len() > 7 { 16 } else { 0 };
        write(area, (x, y), &short(&axis.name, LETTERS), text(15, INK, HPos::Center, VPos::Bottom))?;
        write(
            area,
            (x, bottom + if has_gaps { 34 } else { 8 }),
            said,
            text(13, SOFT, HPos::Center, VPos::Top),
        )?;
        for (share, label) in axis.ticks(7) {
            let y = bottom - scaled(share, bottom - TOP);
            line(area, vec![(x - 4, y), (x, y)], ShapeStyle::from(INK).stroke_width(1))?;
            // Lines go through beneath.
            let wide = 8 * i32::try_from(label.chars().count()).unwrap_or(0);
            area.draw(&Rectangle::new([(x - 7 - wide, y - 8), (x - 5, y + 8)], GROUND.mix(0.8).filled()))
                .map_err(broken)?;
            write(area, (x - 6, y), &label, text(13, INK, HPos::Right, VPos::Center))?;
        }
    }
    if has_gaps {
        line(
            area,
            vec![(LEFT - 30, bottom + 20), (right + 30, bottom + 20)],
            ShapeStyle::from(LINE).stroke_width(1),
        )?;
        write(area, (right + 34, bottom + 20), "no value", text(13, SOFT, HPos::Left, VPos::Center))?;
    }
    colours.as_ref().map_or(Ok(()), |axis| legend(area, axis))
}

/// The line of a row. Where it has no value it goes below the axis.
fn path(axes: &[Axis], row: &Row, place: &impl Fn(usize) -> i32, bottom: i32) -> Vec<(i32, i32)> {
    let y = |axis: &Axis| axis.share(row).map_or(bottom + 20, |share| bottom - scaled(share, bottom - TOP));
    let mut points: Vec<(i32, i32)> = axes.iter().enumerate().map(|(k, axis)| (place(k), y(axis))).collect();
    if let [(x, y)] = points[..] {
        points = vec![(x - 30, y), (x + 30, y)];
    }
    points
}

#[allow(clippy::cast_precision_loss, reason = "it is small")]
fn count(n: usize) -> f64 {
    n as f64
}

#[allow(clippy::cast_possible_truncation, reason = "a place on the picture")]
fn scaled(share: f64, length: i32) -> i32 {
    (share * f64::from(length)).round() as i32
}

/// A dashed line.
fn dashed(area: &Area<'_>, points: &[(i32, i32)]) -> Result<(), StudyError> {
    /// Pixels of a dash with its gap.
    const DASH: f64 = 10.0;
    for pair in points.windows(2) {
        let [(x0, y0), (x1, y1)] = pair else { continue };
        let count = (f64::hypot(f64::from(x1 - x0), f64::from(y1 - y0)) / DASH).ceil().max(1.0);
        let at = |t: f64| (x0 + scaled(t, x1 - x0), y0 + scaled(t, y1 - y0));
        let mut k = 0.0;
        while k < count {
            line(
                area,
                vec![at(k / count), at((k + 0.55) / count)],
                ShapeStyle::from(ERROR.mix(0.7)).stroke_width(1),
            )?;
            k += 1.0;
        }
    }
    Ok(())
}
