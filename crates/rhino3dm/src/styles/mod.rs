//! Dimension styles in both forms that archives have of them, and how one becomes the other.
//!
//! From version 60 on a style holds its font and the units it shows. Before, fonts are text styles in a table of
//! their own, and units a format and a factor.

mod font;
mod length;
mod newer;
mod older;
mod overrides;
mod tables;

pub(crate) use font::Font;
pub(crate) use length::Length;
pub(crate) use tables::Styles;

use uuid::{Uuid, uuid};

/// The class of dimension styles from version 60 on, and of before.
pub(crate) const NEWER: Uuid = uuid!("67AA51A5-791D-4BEC-8AED-D23B462B6F87");
pub(crate) const OLDER: Uuid = uuid!("81BD83D5-7120-41C4-9A57-C449336FF12C");
/// The class of fonts in archives before version 60.
pub(crate) const TEXT_STYLE: Uuid = uuid!("4F0F51FB-35D0-4865-9998-6D2C6A99721D");

/// Numbers of a style as version 60 and later count them, by which it may differ from its parent.
pub(crate) mod field {
    pub(crate) const HEIGHT: usize = 9;
    pub(crate) const TEXT_LOCATION: usize = 10;
    pub(crate) const MASK: usize = 55;
    pub(crate) const MASK_SOURCE: usize = 56;
    pub(crate) const MASK_COLOUR: usize = 57;
    pub(crate) const MASK_BORDER: usize = 58;
    pub(crate) const SCALE: usize = 59;
    pub(crate) const TEXT_VERTICAL: usize = 85;
    pub(crate) const LEADER_ANGLE: usize = 87;
    pub(crate) const HAS_LANDING: usize = 90;
    pub(crate) const LANDING: usize = 91;
    pub(crate) const TEXT_ORIENTATION: usize = 102;
    pub(crate) const TEXT_ANGLE: usize = 104;
    pub(crate) const LENGTH_DISPLAY: usize = 109;
}

/// A dimension style, as far as both forms have it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Style {
    /// The identifier.
    pub(crate) id: Uuid,
    /// The number in its table.
    pub(crate) number: i32,
    /// The name.
    pub(crate) name: String,
    /// The style whose numbers count where this one has none of its own; nil for none.
    pub(crate) parent: Uuid,
    /// Which numbers are its own, when it has a parent.
    pub(crate) own: Vec<bool>,
    /// How far extension lines go beyond the dimension line, and begin from what is measured.
    pub(crate) extension: [f64; 2],
    /// The length of arrowheads of dimensions and of leaders.
    pub(crate) arrow: [f64; 2],
    /// The size of centre marks.
    pub(crate) centre_mark: f64,
    /// The gap between text and lines.
    pub(crate) gap: f64,
    /// The height of text.
    pub(crate) height: f64,
    /// How the text of dimensions stands, as versions before 60 number it: 0 as by default, 1 horizontal to the view,
    /// 2 above the line, 3 in the line, 4 horizontal in the plane.
    pub(crate) text_display: i32,
    /// The digits of angles and lengths.
    pub(crate) digits: [i32; 2],
    /// How lengths are shown.
    pub(crate) length: Length,
    /// Whether they are shown a second time, how, and with how many digits.
    pub(crate) shows_alternate: bool,
    pub(crate) alternate: Length,
    pub(crate) alternate_digits: i32,
    /// What is put before and behind lengths, then the same of the second ones.
    pub(crate) affixes: [String; 4],
    /// How far the dimension line goes beyond extension lines.
    pub(crate) line_extension: f64,
    /// Which extension lines are left out.
    pub(crate) suppressed: [bool; 2],
    /// How tolerances are shown: 0 not, 1 symmetrical, 2 as deviation, 3 as limits; their digits, the upper and lower
    /// values, and the height of their text as a multiple of the other.
    pub(crate) tolerance: i32,
    pub(crate) tolerance_digits: i32,
    pub(crate) tolerances: [f64; 2],
    pub(crate) tolerance_height: f64,
    /// The distance between parallel dimension lines.
    pub(crate) baseline: f64,
    /// Whether text hides what is behind it, by the background (0) or a colour (1), and the colour.
    pub(crate) mask: bool,
    pub(crate) mask_source: i32,
    pub(crate) mask_colour: [u8; 4],
    /// What all sizes are multiplied by, and a number that says where that comes from.
    pub(crate) scale: f64,
    pub(crate) scale_source: i32,
    /// The style it was made from.
    pub(crate) source: Uuid,
    /// The kinds of arrowheads of dimensions and of leaders, as version 60 numbers them; 2 is a full triangle.
    pub(crate) arrow_kinds: [i32; 2],
    /// The font.
    pub(crate) font: Font,
    /// Whether leaders end in a horizontal piece, and its length. Since version 60.
    pub(crate) has_landing: bool,
    pub(crate) landing: f64,
    /// Where leaders meet their text up and down: 0 at its top. Since version 60.
    pub(crate) text_vertical: i32,
    /// Where text stands from the dimension line (0 above, 1 in it), whether it is turned to the view (1), and how it
    /// is turned in the plane (0 horizontal, 1 along the line). Since version 60.
    pub(crate) text_location: i32,
    pub(crate) text_orientation: i32,
    pub(crate) text_angle: i32,
    /// How the end of leaders is turned: 0 horizontal, 1 along the leader. Since version 60.
    pub(crate) leader_angle: i32,
    /// How far the mask reaches beyond text. Since version 60.
    pub(crate) mask_border: f64,
}

impl Default for Style {
    /// What styles are that say nothing.
    fn default() -> Self {
        Self {
            id: Uuid::nil(),
            number: -1,
            name: String::new(),
            parent: Uuid::nil(),
            own: Vec::new(),
            extension: [0.5; 2],
            arrow: [1.0; 2],
            centre_mark: 0.5,
            gap: 0.25,
            height: 1.0,
            text_display: 2,
            digits: [2; 2],
            length: Length::MODEL,
            shows_alternate: false,
            alternate: Length { factor: 25.4, ..Length::MODEL },
            alternate_digits: 2,
            affixes: [const { String::new() }; 4],
            line_extension: 0.0,
            suppressed: [false; 2],
            tolerance: 0,
            tolerance_digits: 4,
            tolerances: [0.0; 2],
            tolerance_height: 1.0,
            baseline: 1.0,
            mask: false,
            mask_source: 0,
            mask_colour: [255, 255, 255, 0],
            scale: 1.0,
            scale_source: 0,
            source: Uuid::nil(),
            arrow_kinds: [2; 2],
            font: Font::default(),
            has_landing: true,
            landing: 1.0,
            text_vertical: 0,
            text_location: 0,
            text_orientation: 0,
            text_angle: 1,
            leader_angle: 0,
            mask_border: 0.0,
        }
    }
}

impl Style {
    /// Whether a number is its own, not its parent's.
    fn owns(&self, field: usize) -> bool {
        self.own.get(field).copied().unwrap_or_default()
    }

    /// How the text of dimensions stands, as versions before 60 number it.
    pub(crate) fn text_display(&self) -> i32 {
        match (self.text_orientation, self.text_location, self.text_angle) {
            // Turned to the view.
            (1, ..) => 1,
            (_, 0 | 2, _) => 2,
            // In the line: horizontal or along it.
            (_, 1, 0) => 4,
            (_, 1, _) => 3,
            _ => 0,
        }
    }

    /// The numbers that count for an annotation of this style which has some of its own, as far as the older form of
    /// annotations asks for them.
    pub(crate) fn with(&self, other: &Self) -> Self {
        let mut style = self.clone();
        macro_rules! take {
            ($($number:ident => $field:ident),* $(,)?) => {
                $(if other.owns(field::$number) {
                    style.$field = other.$field;
                })*
            };
        }
        take!(
            HEIGHT => height,
            TEXT_LOCATION => text_location,
            MASK => mask,
            MASK_SOURCE => mask_source,
            MASK_COLOUR => mask_colour,
            MASK_BORDER => mask_border,
            SCALE => scale,
            TEXT_VERTICAL => text_vertical,
            LEADER_ANGLE => leader_angle,
            HAS_LANDING => has_landing,
            LANDING => landing,
            TEXT_ORIENTATION => text_orientation,
            TEXT_ANGLE => text_angle,
        );
        style
    }
}
