//! Colours: screens show sRGB (IEC 61966-2-1), glTF states light.

use katydid_elementary::Elementary;

/// A part of a colour on the screen, of 255, as a share of light.
pub(super) fn to_light(part: u8) -> f64 {
    let c = f64::from(part) / 255.0;
    if c <= 0.040_45 { c / 12.92 } else { ((c + 0.055) / 1.055).raised_to(2.4) }
}

/// A share of light as a part of a colour on the screen, of 255.
pub(super) fn to_screen(light: f64) -> u8 {
    let c = light.clamp(0.0, 1.0);
    let c = if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * c.raised_to(1.0 / 2.4) - 0.055 };
    (c * 255.0).round() as u8
}

/// A colour of the screen as four shares of 65535, which keep it apart from its neighbours.
pub(super) fn to_wide([r, g, b, a]: [u8; 4]) -> [u16; 4] {
    let wide = |part| (to_light(part) * 65535.0).round() as u16;
    [wide(r), wide(g), wide(b), u16::from(a) * 257]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_come_back() {
        for part in 0..=255 {
            assert_eq!(to_screen(to_light(part)), part);
            let [wide, ..] = to_wide([part; 4]);
            assert_eq!(to_screen(f64::from(wide) / 65535.0), part);
        }
        // The middle of the screen's range is a fifth of the light.
        assert!((to_light(128) - 0.2158).abs() < 1e-3);
    }
}
