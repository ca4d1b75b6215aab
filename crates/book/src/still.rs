//! Stills of figures: for pages without a script, for print, and until the engine has come.

use std::collections::BTreeSet;

use katydid_data::Colour;
use katydid_picture::{Options, Paint, result_with};

use crate::figure::Figure;
use crate::palette::{GROUNDS, Hue};
use crate::solved::Solved;

/// The size of a still in pixels: three by two, as the stage of a figure on a page.
pub(crate) const SIZE: [u32; 2] = [720, 480];

/// The still of a figure as SVG, on a light or a dark ground; nothing where it only computes.
pub(crate) fn svg(figure: &Figure, solved: &Solved, is_dark: bool) -> Option<Vec<u8>> {
    let [r, g, b] = GROUNDS[usize::from(is_dark)];
    let options = Options {
        size: SIZE,
        view: Some(figure.view),
        axes: false,
        grid: true,
        background: Some(Colour::rgb(r, g, b)),
        title: figure.caption.clone(),
        ..Options::default()
    };
    let only: BTreeSet<&str> = figure.only.iter().map(String::as_str).collect();
    let picture = result_with(solved.session.engine(), &options, |object| {
        if !only.is_empty() && !only.contains(object.nickname.as_str()) {
            return Paint::Nothing;
        }
        match figure.hue(&object.nickname) {
            Some(hue) => Paint::Colour(hue.colour(is_dark)),
            // The dark red of previews is not seen on a dark ground.
            None if is_dark => Paint::Colour(Hue::Red.colour(true)),
            None => Paint::Own,
        }
    });
    if picture.is_empty {
        return None;
    }
    let mut drawing = picture.drawing;
    drawing.description.clone_from(&figure.alt);
    Some(drawing.to_svg().into_bytes())
}

/// The definition on its canvas as SVG.
pub(crate) fn graph(solved: &Solved) -> Vec<u8> {
    katydid_picture::canvas(solved.session.engine(), &Options::default()).to_svg().into_bytes()
}
