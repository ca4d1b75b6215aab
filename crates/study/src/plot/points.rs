//! Points: a column over another, and the front of two goals.

use plotters::coord::types::RangedCoordf64;
use plotters::prelude::{
    Cartesian2d, ChartBuilder, ChartContext, Circle, Color, Cross, PathElement, SVGBackend, ShapeStyle,
    TriangleMarker,
};
use plotters::style::text_anchor::{HPos, VPos};

use super::axis::{Axis, LETTERS};
use super::style::{ERROR, INK, LINE, SOFT, colour, legend, text, title, words_below, write};
use super::{Area, PlotOptions, choice, failed};
use crate::optimise::front as best;
use crate::{Goal, Kind, StudyError, StudyFolder};

type Chart<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

pub(super) fn scatter<'a>(
    area: &Area<'a>,
    folder: &StudyFolder,
    options: &PlotOptions,
) -> Result<(), StudyError> {
    let x = Axis::of(folder, choice::chosen(folder, options.x.as_deref(), Kind::Input)?)?;
    let y = Axis::of(folder, choice::chosen(folder, options.y.as_deref(), Kind::Output)?)?;
    let colours =
        options.colour.as_deref().map(|name| Axis::of(folder, choice::find(folder, name)?)).transpose()?;
    let missing = folder.rows().iter().filter(|row| x.at(row).is_none() || y.at(row).is_none()).count();
    let remark =
        if missing > 0 { format!("{missing} have no value here and are not drawn") } else { String::new() };
    title(area, folder, &format!("{} over {}", y.name, x.name), &remark)?;
    let mut chart = chart(area, &x, &y, colours.is_some())?;
    let seen = |row: &crate::Row| Some((x.at(row)?, y.at(row)?));
    let good = folder.rows().iter().filter(|row| row.is_good());
    let good = good
        .filter_map(|row| Some(Circle::new(seen(row)?, 4, colour(colours.as_ref(), row).mix(0.75).filled())));
    chart.draw_series(good).map_err(failed)?;
    let bad = folder.rows().iter().filter(|row| !row.is_good()).filter_map(seen);
    chart
        .draw_series(bad.map(|at| Cross::new(at, 5, ShapeStyle::from(ERROR).stroke_width(2))))
        .map_err(failed)?;
    colours.as_ref().map_or(Ok(()), |axis| legend(area, axis))
}

pub(super) fn front<'a>(
    area: &Area<'a>,
    folder: &StudyFolder,
    options: &PlotOptions,
) -> Result<(), StudyError> {
    let goals = goals(folder, options)?;
    let [(first, _), (second, _)] =
        [goals.first(), goals.get(1)].map(|goal| goal.copied().unwrap_or((0, Goal::Least)));
    let wished =
        |name: &Option<String>, usual| name.as_deref().map_or(Ok(usual), |name| choice::find(folder, name));
    let x = Axis::of(folder, wished(&options.x, first)?)?;
    let y = Axis::of(folder, wished(&options.y, second)?)?;
    let colours =
        options.colour.as_deref().map(|name| Axis::of(folder, choice::find(folder, name)?)).transpose()?;
    let bounds = folder.about().map(|about| about.bounds.as_slice()).unwrap_or_default();
    let bounded: Vec<usize> =
        bounds.iter().map(|bound| choice::find(folder, &bound.output)).collect::<Result<_, _>>()?;
    let numbers = |row: &crate::Row, columns: &mut dyn Iterator<Item = usize>| -> Option<Vec<f64>> {
        columns.map(|column| row.number(column)).collect()
    };
    let points: Vec<_> = folder
        .rows()
        .iter()
        .map(|row| {
            let goals = numbers(row, &mut goals.iter().map(|(column, _)| *column))?;
            row.is_good().then_some((goals, numbers(row, &mut bounded.iter().copied())?))
        })
        .collect();
    let wanted: Vec<Goal> = goals.iter().map(|(_, goal)| *goal).collect();
    let found = best(&points, &wanted, &bounds.iter().map(|bound| bound.bound).collect::<Vec<_>>());
    let said: Vec<String> = goals.iter().map(|(column, goal)| said(folder, *column, *goal)).collect();
    title(
        area,
        folder,
        &format!("Front: {}", said.join(", ")),
        &format!("{} that no other is better than", found.len()),
    )?;
    let mut chart = chart(area, &x, &y, colours.is_some())?;
    let seen = |row: &crate::Row| Some((x.at(row)?, y.at(row)?));
    let others = folder.rows().iter().enumerate().filter(|(at, row)| row.is_good() && !found.contains(at));
    let others = others.filter_map(|(_, row)| {
        let fill = if colours.is_some() { colour(colours.as_ref(), row).mix(0.5) } else { SOFT.mix(0.4) };
        Some(Circle::new(seen(row)?, 3, fill.filled()))
    });
    chart.draw_series(others).map_err(failed)?;
    let front: Vec<_> = found
        .iter()
        .filter_map(|at| folder.rows().get(*at))
        .filter_map(|row| Some((seen(row)?, row)))
        .collect();
    if goals.len() == 2 && options.x.is_none() && options.y.is_none() {
        let path = PathElement::new(
            front.iter().map(|(at, _)| *at).collect::<Vec<_>>(),
            ShapeStyle::from(INK).stroke_width(1),
        );
        chart.draw_series([path]).map_err(failed)?;
    }
    let marks =
        front.iter().map(|(at, row)| TriangleMarker::new(*at, 8, colour(colours.as_ref(), row).filled()));
    chart.draw_series(marks).map_err(failed)?;
    colours.as_ref().map_or(Ok(()), |axis| legend(area, axis))
}

/// The goals that were named, else those of the study.
fn goals(folder: &StudyFolder, options: &PlotOptions) -> Result<Vec<(usize, Goal)>, StudyError> {
    let named: Vec<(String, Goal)> = if options.goals.is_empty() {
        let about = folder.about().map(|about| about.goals.as_slice()).unwrap_or_default();
        about.iter().map(|goal| (format!("out.{}", goal.output), goal.goal)).collect()
    } else {
        options.goals.clone()
    };
    let found: Vec<(usize, Goal)> = named
        .iter()
        .map(|(name, goal)| Ok((choice::find(folder, name)?, *goal)))
        .collect::<Result<_, StudyError>>()?;
    if found.len() < 2 {
        return Err(StudyError::Unfit(format!(
            "a front has two goals or more, and {} known: name them with --minimise and --maximise",
            if found.is_empty() { "none is" } else { "one is" }
        )));
    }
    Ok(found)
}

fn said(folder: &StudyFolder, column: usize, goal: Goal) -> String {
    let name = folder.columns().get(column).map_or("", |column| &column.name);
    match goal {
        Goal::Least => format!("{name} small"),
        Goal::Most => format!("{name} large"),
        Goal::Near(x) => format!("{name} near {x}"),
    }
}

/// Axes with their names, ready for marks.
pub(super) fn chart<'a>(
    area: &Area<'a>,
    x: &Axis,
    y: &Axis,
    has_legend: bool,
) -> Result<Chart<'a>, StudyError> {
    let mut chart = ChartBuilder::on(area)
        .margin_top(84)
        .margin_left(20)
        .margin_right(if has_legend { 120 } else { 30 })
        .margin_bottom(16)
        .x_label_area_size(52)
        .y_label_area_size(76)
        .build_cartesian_2d(x.range.clone(), y.range.clone())
        .map_err(failed)?;
    chart
        .configure_mesh()
        .light_line_style(LINE.mix(0.0))
        .bold_line_style(LINE.mix(0.6))
        .axis_style(INK)
        .label_style(("Inter, Arial, sans-serif", 15, &INK))
        .axis_desc_style(("Inter, Arial, sans-serif", 17, &INK))
        .x_label_formatter(&|at| x.label(*at))
        .y_label_formatter(&|at| y.label(*at))
        .x_desc(x.name.as_str())
        .y_desc(y.name.as_str())
        .draw()
        .map_err(failed)?;
    words_below(area, x, |at| chart.backend_coord(&(at, y.range.start)))?;
    for (at, word) in y.words(LETTERS / 2) {
        let (left, middle) = chart.backend_coord(&(x.range.start, at));
        write(area, (left - 10, middle), &word, text(15, INK, HPos::Right, VPos::Center))?;
    }
    Ok(chart)
}
