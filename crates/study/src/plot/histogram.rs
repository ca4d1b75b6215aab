//! How many points there are in each part of a column's range.

use plotters::prelude::{ChartBuilder, Color, Rectangle, Text};
use plotters::style::text_anchor::{HPos, VPos};

use super::axis::Axis;
use super::style::{ACCENT, INK, LINE, text, title, words_below};
use super::{Area, PlotOptions, choice, failed};
use crate::{Kind, StudyError, StudyFolder};

/// Bars are at most so many.
const MOST: usize = 60;

pub(super) fn draw(area: &Area<'_>, folder: &StudyFolder, options: &PlotOptions) -> Result<(), StudyError> {
    let axis = Axis::of(folder, choice::chosen(folder, options.x.as_deref(), Kind::Output)?)?;
    let shares: Vec<f64> = folder.rows().iter().filter_map(|row| axis.share(row)).collect();
    let missing = folder.rows().len() - shares.len();
    let remark = if missing > 0 { format!("{missing} have no value here") } else { String::new() };
    title(area, folder, &axis.name, &remark)?;
    let counts = counted(&shares, bars(&axis, shares.len()));
    let most = counts.iter().copied().max().unwrap_or(0);
    #[allow(clippy::cast_precision_loss, reason = "a height")]
    let mut chart = ChartBuilder::on(area)
        .margin_top(84)
        .margin_left(20)
        .margin_right(30)
        .margin_bottom(16)
        .x_label_area_size(52)
        .y_label_area_size(76)
        .build_cartesian_2d(axis.range.clone(), 0.0..most.max(1) as f64 * 1.08)
        .map_err(failed)?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .light_line_style(LINE.mix(0.0))
        .bold_line_style(LINE.mix(0.6))
        .axis_style(INK)
        .label_style(("Inter, Arial, sans-serif", 15, &INK))
        .axis_desc_style(("Inter, Arial, sans-serif", 17, &INK))
        .x_label_formatter(&|at| axis.label(*at))
        .y_label_formatter(&|count| if count.fract() == 0.0 { format!("{count}") } else { String::new() })
        .x_desc(axis.name.as_str())
        .y_desc("points")
        .draw()
        .map_err(failed)?;
    words_below(area, &axis, |at| chart.backend_coord(&(at, 0.0)))?;
    #[allow(clippy::cast_precision_loss, reason = "few bars")]
    let at = |k: usize| {
        let t = k as f64 / counts.len() as f64;
        axis.range.start * (1.0 - t) + axis.range.end * t
    };
    for (k, count) in counts.iter().enumerate().filter(|(_, count)| **count > 0) {
        #[allow(clippy::cast_precision_loss, reason = "a height")]
        let height = *count as f64;
        let mut bar = Rectangle::new([(at(k), 0.0), (at(k + 1), height)], ACCENT.mix(0.85).filled());
        bar.set_margin(0, 0, 1, 1);
        chart.draw_series([bar]).map_err(failed)?;
        if counts.len() <= 30 {
            let style = text(13, INK, HPos::Center, VPos::Bottom);
            let label = Text::new(count.to_string(), (f64::midpoint(at(k), at(k + 1)), height), style);
            chart.draw_series([label]).map_err(failed)?;
        }
    }
    Ok(())
}

/// Twice the cube root of the number of points (Rice's rule); for words, one each.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "a small number"
)]
fn bars(axis: &Axis, points: usize) -> usize {
    if axis.has_words() {
        return ((axis.range.end - axis.range.start).round() as usize).max(1);
    }
    ((2.0 * (points as f64).cbrt()).ceil() as usize).clamp(1, MOST)
}

/// How many shares lie in each of so many equal parts from 0 to 1.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "a small number"
)]
fn counted(shares: &[f64], bars: usize) -> Vec<usize> {
    let mut counts = vec![0; bars];
    for share in shares {
        let at = ((share * bars as f64) as usize).min(bars - 1);
        if let Some(count) = counts.get_mut(at) {
            *count += 1;
        }
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_point_is_in_one_bar() {
        assert_eq!(counted(&[0.0, 0.24, 0.25, 0.5, 0.99, 1.0], 4), [2, 1, 1, 2]);
        assert_eq!(counted(&[], 3), [0, 0, 0]);
    }
}
