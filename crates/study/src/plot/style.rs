//! Colours, texts and what stands around a plot.

use std::fmt::Write as _;

use plotters::prelude::{
    Color, ColorMap, IntoFont, PathElement, RGBColor, Rectangle, ShapeStyle, Text, TextStyle, ViridisRGB,
};
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::axis::{Axis, LETTERS, printable, short};
use super::{Area, SIZE, failed};
use crate::{Row, StudyError, StudyFolder};

pub(super) const GROUND: RGBColor = RGBColor(255, 255, 255);
pub(super) const INK: RGBColor = RGBColor(27, 28, 27);
pub(super) const SOFT: RGBColor = RGBColor(86, 88, 83);
pub(super) const LINE: RGBColor = RGBColor(200, 200, 196);
pub(super) const ACCENT: RGBColor = RGBColor(11, 107, 58);
pub(super) const ERROR: RGBColor = RGBColor(163, 0, 0);
/// The largest share of the colours that is used: yellow is not seen on white.
const BRIGHTEST: f64 = 0.86;
/// The typeface; programs that have it not take one of theirs.
const FONT: &str = "Inter, Arial, sans-serif";

/// A text of so many pixels.
pub(super) fn text(size: u32, colour: RGBColor, horizontal: HPos, vertical: VPos) -> TextStyle<'static> {
    (FONT, size).into_font().color(&colour).pos(Pos::new(horizontal, vertical))
}

/// Draws a text.
///
/// # Errors
/// It cannot be drawn.
pub(super) fn write(
    area: &Area<'_>,
    at: (i32, i32),
    what: &str,
    style: TextStyle<'_>,
) -> Result<(), StudyError> {
    area.draw(&Text::new(printable(what), at, style)).map_err(failed)
}

/// Draws a line.
///
/// # Errors
/// It cannot be drawn.
pub(super) fn line(
    area: &Area<'_>,
    points: Vec<(i32, i32)>,
    style: impl Into<ShapeStyle>,
) -> Result<(), StudyError> {
    area.draw(&PathElement::new(points, style)).map_err(failed)
}

/// The title, and below it how many points there are and what is left out.
///
/// # Errors
/// It cannot be drawn.
pub(super) fn title(
    area: &Area<'_>,
    folder: &StudyFolder,
    what: &str,
    remark: &str,
) -> Result<(), StudyError> {
    let rows = folder.rows();
    let failures = rows.iter().filter(|row| !row.is_good()).count();
    let mut said = format!("{} points", folder.row_count());
    let left_out = folder.row_count().saturating_sub(rows.len() as u64);
    if left_out > 0 {
        let _ = write!(said, ", {} of them drawn, evenly chosen", rows.len());
    }
    if failures > 0 {
        let _ = write!(said, ", {failures} of these without results");
    }
    if !remark.is_empty() {
        said.push_str("; ");
        said.push_str(remark);
    }
    write(area, (24, 16), what, text(24, INK, HPos::Left, VPos::Top))?;
    write(area, (24, 46), &said, text(16, SOFT, HPos::Left, VPos::Top))
}

/// The colour of a row by a column; of one without a colour column, or without a value in it.
pub(super) fn colour(axis: Option<&Axis>, row: &Row) -> RGBColor {
    match axis {
        None => ACCENT,
        Some(axis) => axis.share(row).map_or(SOFT, ramp),
    }
}

/// From dark to bright.
fn ramp(share: f64) -> RGBColor {
    ViridisRGB.get_color(share * BRIGHTEST)
}

/// What the colours tell, at the right side.
///
/// # Errors
/// It cannot be drawn.
pub(super) fn legend(area: &Area<'_>, axis: &Axis) -> Result<(), StudyError> {
    /// Steps of the bar.
    const STEPS: i32 = 48;
    let (left, top, bottom) = (SIZE.0.cast_signed() - 96, 110, SIZE.1.cast_signed() - 70);
    let height = bottom - top;
    for step in 0..STEPS {
        let (low, high) = (bottom - height * step / STEPS, bottom - height * (step + 1) / STEPS);
        let fill = ramp((f64::from(step) + 0.5) / f64::from(STEPS)).filled();
        area.draw(&Rectangle::new([(left, high), (left + 14, low)], fill)).map_err(failed)?;
    }
    for (share, label) in axis.ticks(6) {
        #[allow(clippy::cast_possible_truncation, reason = "a place on the picture")]
        let y = bottom - (share * f64::from(height)).round() as i32;
        write(area, (left + 20, y), &label, text(14, INK, HPos::Left, VPos::Center))?;
    }
    write(area, (left + 84, top - 12), &short(&axis.name, LETTERS), text(15, INK, HPos::Right, VPos::Bottom))
}

/// The words of an axis below a chart, at the places that `place` gives in pixels.
///
/// # Errors
/// They cannot be drawn.
pub(super) fn words_below(
    area: &Area<'_>,
    axis: &Axis,
    place: impl Fn(f64) -> (i32, i32),
) -> Result<(), StudyError> {
    /// Letters that have room below the chart, all together.
    const ROOM: usize = 90;
    let count = axis.words(0).len().max(1);
    for (at, word) in axis.words((ROOM / count).clamp(2, LETTERS)) {
        let (x, y) = place(at);
        write(area, (x, y + 8), &word, text(15, INK, HPos::Center, VPos::Top))?;
    }
    Ok(())
}
