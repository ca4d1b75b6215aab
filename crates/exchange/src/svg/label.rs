//! Text of a drawing: one `text` element with a line in each `tspan`.

use katydid_geometry::{BoundingBox, Point3, Vector3, Xform};

use super::escaped;
use super::path::place;
use crate::text::Text;
use crate::{Label, LabelSize, Result};

/// The height of capital letters as a share of the font's size, as in most faces without serifs.
const CAPITALS: f64 = 0.716;
/// From one line to the next, in heights of capital letters.
const LINE: f64 = 1.6;
/// The width of a letter on average, in heights of capital letters: only for how large the drawing is.
const LETTER: f64 = 0.75;
/// The height of text of 14 points on the screen as a share of a drawing's larger side: such text has no true size.
const ON_SCREEN: f64 = 0.015 / 14.0;

/// Text as it lies on the page: x to the right, y up.
pub(super) struct Flat<'a> {
    label: &'a Label,
    point: Point3,
    axes: [Vector3; 2],
}

impl<'a> Flat<'a> {
    pub(super) fn of(label: &'a Label, page: &Xform) -> Self {
        let axes = match label.size {
            LabelSize::Units(_) => label.axes.map(|axis| page.vector(axis)),
            // Turned to the viewer.
            LabelSize::Screen(_) => [Vector3::X, Vector3::Y],
        };
        Self { label, point: page.point(label.point), axes }
    }

    /// Whether there is anything to see: text seen from the side is a line.
    pub(super) fn is_visible(&self) -> bool {
        let [x, y] = self.axes;
        (x.x * y.y - x.y * y.x).abs() > 1e-9 * x.length() * y.length()
    }

    /// Nearly the room it takes. Text of the screen's size takes none before the drawing's is known.
    pub(super) fn bounds(&self) -> Option<BoundingBox> {
        let LabelSize::Units(height) = self.label.size else {
            return BoundingBox::from_points([self.point]);
        };
        let letters = self.label.text.lines().map(|line| line.chars().count()).max().unwrap_or(0);
        let (width, total) = (height * LETTER * letters as f64, height * self.heights());
        let (left, low) = (-self.label.across * width, -self.label.upward * total);
        let corners = [(left, low), (left + width, low), (left + width, low + total), (left, low + total)];
        BoundingBox::from_points(corners.map(|(u, v)| self.point + self.axes[0] * u + self.axes[1] * v))
    }

    /// The height of all lines together, in heights of capital letters.
    fn heights(&self) -> f64 {
        1.0 + LINE * self.label.text.lines().count().saturating_sub(1) as f64
    }

    /// Writes the element with more attributes; `side` is the larger side of the drawing.
    pub(super) fn write(&self, text: &mut Text<'_>, attributes: &str, side: f64) -> Result<()> {
        let height = match self.label.size {
            LabelSize::Units(height) => height,
            LabelSize::Screen(points) => points * ON_SCREEN * if side > 0.0 { side } else { 1.0 },
        };
        let [x, y] = self.axes;
        let [at_x, at_y] = place(self.point);
        text.push("<text stroke=\"none\" font-size=\"");
        text.real(height / CAPITALS);
        text.push("\" font-family=\"");
        if !self.label.font.is_empty() {
            text.push(&format!("'{}', ", escaped(&self.label.font).replace('\'', " ")));
        }
        text.push("sans-serif\"");
        match self.label.across {
            a if a > 0.75 => text.push(" text-anchor=\"end\""),
            a if a > 0.25 => text.push(" text-anchor=\"middle\""),
            _ => {}
        }
        text.push(attributes);
        // Down the page is against the upward axis.
        text.push(" transform=\"matrix(");
        for (i, number) in [x.x, 0.0 - x.y, 0.0 - y.x, y.y, at_x, at_y].into_iter().enumerate() {
            if i > 0 {
                text.push(" ");
            }
            text.real(number + 0.0);
        }
        text.push(")\">");
        // The first line stands so high above the point.
        let first = height * (self.heights() * (1.0 - self.label.upward) - 1.0);
        for (i, line) in self.label.text.lines().enumerate() {
            text.push("<tspan x=\"0\" y=\"");
            text.real(0.0 - first + LINE * height * i as f64);
            text.push("\">");
            text.push(&escaped(line));
            text.push("</tspan>");
        }
        text.push("</text>");
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::View;

    fn label(upward: f64) -> Label {
        Label {
            text: "one\n<two>".into(),
            point: Point3::new(3.0, 4.0, 0.0),
            axes: [Vector3::Y, -Vector3::X],
            size: LabelSize::Units(2.0),
            across: 0.5,
            upward,
            font: "It's".into(),
        }
    }

    fn written(label: &Label) -> String {
        let mut out = Vec::new();
        let mut text = Text::new(&mut out);
        Flat::of(label, &View::Top.to_page()).write(&mut text, "", 10.0).unwrap();
        text.flush().unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn text_stands_where_its_point_says() {
        // It reads upward: the page's x axis of the text points up, which is against y in SVG.
        let text = written(&label(0.0));
        assert!(text.contains("matrix(0 -1 1 0 3 -4)"), "{text}");
        assert!(text.contains("font-size=\"2.79") && text.contains("text-anchor=\"middle\""), "{text}");
        assert!(text.contains("font-family=\"'It s', sans-serif\""), "{text}");
        // The point at the foot of the last line: the first is a line's distance above.
        assert!(text.contains("y=\"-3.2\">one<") && text.contains("y=\"0\">&lt;two&gt;<"), "{text}");
        let text = written(&label(1.0));
        assert!(text.contains("y=\"2\">one<") && text.contains("y=\"5.2\">"), "hangs from its top: {text}");
    }

    #[test]
    fn text_from_the_side_is_not_there() {
        assert!(Flat::of(&label(0.0), &View::Top.to_page()).is_visible());
        assert!(!Flat::of(&label(0.0), &View::Front.to_page()).is_visible());
    }
}
