//! Plots of a study as SVG.

mod axis;
mod choice;
mod histogram;
mod parallel;
mod points;
mod style;

use plotters::coord::Shift;
use plotters::prelude::{DrawingArea, IntoDrawingArea, SVGBackend};

use crate::{Goal, StudyError, StudyFolder};

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Plot {
    /// An axis a column, a line a point.
    Parallel,
    /// A column over another.
    Scatter,
    /// How many points there are in each part of a column's range.
    Histogram,
    /// Two goals over each other, with the points that no other is better than.
    Front,
}

/// Which columns are drawn, by their names: `Area`, or `in.Area` and `out.Area` where both are there.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PlotOptions {
    /// From left to right; the column of a histogram. Without it the first input that has several values, or the first
    /// output for a histogram.
    pub x: Option<String>,
    /// From bottom to top. Without it the first output.
    pub y: Option<String>,
    /// What colours tell. Without it the last output of a parallel plot; nothing otherwise.
    pub colour: Option<String>,
    /// The goals of a front. Without them those of the study.
    pub goals: Vec<(String, Goal)>,
}

/// Width and height of a plot in pixels.
const SIZE: (u32, u32) = (960, 600);

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A plot of a study as SVG.
///
/// # Errors
/// The study has no rows, there is no such column, or the plot cannot be made of what is in it.
pub fn plot(folder: &StudyFolder, plot: Plot, options: &PlotOptions) -> Result<String, StudyError> {
    if folder.rows().is_empty() {
        return Err(StudyError::Unfit(format!(
            "{}: no point of this study is solved",
            folder.path().display()
        )));
    }
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        area.fill(&style::GROUND).map_err(failed)?;
        match plot {
            Plot::Parallel => parallel::draw(&area, folder, options)?,
            Plot::Scatter => points::scatter(&area, folder, options)?,
            Plot::Histogram => histogram::draw(&area, folder, options)?,
            Plot::Front => points::front(&area, folder, options)?,
        }
        area.present().map_err(failed)?;
    }
    Ok(text)
}

fn failed(error: impl std::fmt::Display) -> StudyError {
    StudyError::Unfit(format!("the plot cannot be drawn: {error}"))
}
