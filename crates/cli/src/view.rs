//! `katydid view`.

use katydid_data::Colour;
use katydid_data::cast::parse_colour;
use katydid_picture::{Drawing, HiddenLines, View, canvas, result};

use crate::args::{HiddenLinesName, ViewArgs, ViewName};
use crate::output::{YELLOW, extension, note, write_file};
use crate::{open, run, ticks};

/// The longer side of a canvas in pixels, when no size is asked for.
const LONGEST: f64 = 8192.0;

pub(crate) fn view(args: &ViewArgs) -> Result<u8, String> {
    for path in &args.output {
        if !["svg", "png"].contains(&extension(path).as_str()) {
            return Err(format!("{}: a picture can be saved as .svg or .png", path.display()));
        }
    }
    let background = background(&args.background)?;
    let mut session = open::session(&args.definition)?;
    ticks::solve(&mut session, &args.definition);
    let failed = run::complain(&session);

    let size = args.size.unwrap_or([1200, 800]);
    let title = if session.document().header.name.is_empty() {
        args.definition.file.file_stem().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
    } else {
        String::new()
    };
    let look = katydid_picture::Options {
        size,
        view: args.view.map(View::from),
        axes: args.axes,
        grid: args.grid,
        legend: args.legend,
        hidden_lines: args.hidden_lines.map(HiddenLines::from).unwrap_or_default(),
        background,
        title,
    };
    if args.canvas {
        let size = args.size.map(|size| size.map(f64::from));
        let drawing = canvas(session.engine(), &look);
        let drawing = match size {
            Some(size) => drawing.fitted(size),
            None => drawing,
        };
        save(&drawing, args)?;
    } else {
        let picture = result(session.engine(), &look);
        if picture.is_empty {
            let why = "no object with its preview on gives geometry: --canvas draws the definition itself";
            note(&format!("{YELLOW}nothing to show{YELLOW:#}: {why}"));
        }
        for reason in &picture.left_out {
            note(&format!("{YELLOW}left out{YELLOW:#}: {reason}"));
        }
        save(&picture.drawing, args)?;
    }
    Ok(u8::from(failed))
}

fn save(drawing: &Drawing, args: &ViewArgs) -> Result<(), String> {
    for path in &args.output {
        let bytes = if extension(path) == "png" {
            reduced(drawing, args).to_png().map_err(|error| format!("{}: {error}", path.display()))?
        } else {
            drawing.to_svg().into_bytes()
        };
        write_file(path, &bytes)?;
    }
    Ok(())
}

/// A canvas larger than a picture of pixels should be, made smaller; as it is where its size was asked for.
fn reduced(drawing: &Drawing, args: &ViewArgs) -> Drawing {
    let longer = drawing.size[0].max(drawing.size[1]);
    let factor = if args.size.is_none() { f64::min(LONGEST / longer, 1.0) } else { 1.0 };
    drawing.clone().scaled(factor)
}

/// A colour by one of a few names, as hexadecimal digits, or as Grasshopper writes it; none for a clear ground.
fn background(text: &str) -> Result<Option<Colour>, String> {
    let hexadecimal = |text: &str| {
        let digits = text.strip_prefix('#')?;
        let pair = |k: usize| u8::from_str_radix(digits.get(2 * k..2 * k + 2)?, 16).ok();
        if digits.len() == 6 { Some(Colour::rgb(pair(0)?, pair(1)?, pair(2)?)) } else { None }
    };
    match text.trim().to_lowercase().as_str() {
        "none" | "transparent" => Ok(None),
        "white" => Ok(Some(Colour::rgb(255, 255, 255))),
        "black" => Ok(Some(Colour::rgb(0, 0, 0))),
        other => match hexadecimal(other).or_else(|| parse_colour(other)) {
            Some(colour) => Ok(Some(colour)),
            None => Err(format!(
                "--background {text}: expected white, black, none, #rrggbb, or three numbers to 255"
            )),
        },
    }
}

impl From<HiddenLinesName> for HiddenLines {
    fn from(name: HiddenLinesName) -> Self {
        match name {
            HiddenLinesName::Hide => Self::Hide,
            HiddenLinesName::Dash => Self::Dash,
            HiddenLinesName::Show => Self::Show,
        }
    }
}

impl From<ViewName> for View {
    fn from(name: ViewName) -> Self {
        match name {
            ViewName::Perspective => Self::Perspective,
            ViewName::Top => Self::Top,
            ViewName::Front => Self::Front,
            ViewName::Right => Self::Right,
            ViewName::Iso => Self::Isometric,
        }
    }
}
