use katydid_data::Colour;

/// A colour that an object of a figure and the symbols tied to it share.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "colours by their names")]
pub enum Hue {
    Blue,
    Orange,
    Green,
    Red,
    Purple,
    Teal,
    Pink,
    Grey,
}

impl Hue {
    /// All of them.
    pub const ALL: [Self; 8] =
        [Self::Blue, Self::Orange, Self::Green, Self::Red, Self::Purple, Self::Teal, Self::Pink, Self::Grey];

    /// Its name in pages.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Blue => "blue",
            Self::Orange => "orange",
            Self::Green => "green",
            Self::Red => "red",
            Self::Purple => "purple",
            Self::Teal => "teal",
            Self::Pink => "pink",
            Self::Grey => "grey",
        }
    }

    /// The one of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|hue| hue.name() == name)
    }

    /// On a light ground and on a dark one: each has a contrast of 4.5 to 1 and more with it (WCAG 2.2, 1.4.3), as
    /// a test holds.
    pub const fn on_grounds(self) -> [[u8; 3]; 2] {
        match self {
            Self::Blue => [[0, 90, 170], [110, 180, 255]],
            Self::Orange => [[168, 78, 0], [255, 165, 80]],
            Self::Green => [[10, 112, 50], [90, 210, 130]],
            Self::Red => [[185, 25, 40], [255, 125, 125]],
            Self::Purple => [[115, 50, 165], [200, 155, 255]],
            Self::Teal => [[0, 108, 112], [80, 205, 205]],
            Self::Pink => [[170, 30, 115], [255, 135, 205]],
            Self::Grey => [[88, 94, 104], [165, 172, 182]],
        }
    }

    pub(crate) fn colour(self, is_dark: bool) -> Colour {
        let [r, g, b] = self.on_grounds()[usize::from(is_dark)];
        Colour::rgb(r, g, b)
    }
}

/// The grounds of light and dark pages.
pub(crate) const GROUNDS: [[u8; 3]; 2] = [[255, 255, 255], [22, 25, 30]];

/// The colours as variables of a style sheet, light or dark.
pub(crate) fn variables(is_dark: bool) -> String {
    let one = |hue: Hue| {
        let [r, g, b] = hue.on_grounds()[usize::from(is_dark)];
        format!("--{}:#{r:02x}{g:02x}{b:02x};", hue.name())
    };
    Hue::ALL.into_iter().map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The relative luminance of WCAG 2.
    fn luminance([r, g, b]: [u8; 3]) -> f64 {
        let linear = |c: u8| {
            let c = f64::from(c) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        };
        0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b)
    }

    #[test]
    fn every_colour_is_read_on_its_ground() {
        for hue in Hue::ALL {
            for (colour, ground) in hue.on_grounds().into_iter().zip(GROUNDS) {
                let (a, b) = (luminance(colour), luminance(ground));
                let contrast = (a.max(b) + 0.05) / (a.min(b) + 0.05);
                assert!(contrast >= 4.5, "{}: {contrast}", hue.name());
            }
        }
    }
}
