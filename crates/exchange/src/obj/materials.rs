//! MTL, the file of materials beside an OBJ: one for each colour, named after it.

use std::collections::{BTreeSet, HashMap};
use std::io::Write;

use crate::text::Text;
use crate::{Result, Scene};

/// What things without a colour are made of. Other programs use the name as well.
const NONE: &str = "None";
/// What such things look like elsewhere: a light grey.
const GREY: f64 = 0.8;

/// The name of the material of a colour.
pub(super) fn name(colour: Option<[u8; 4]>) -> String {
    match colour {
        None => NONE.to_owned(),
        Some([r, g, b, 255]) => format!("colour_{r:02x}{g:02x}{b:02x}"),
        Some([r, g, b, a]) => format!("colour_{r:02x}{g:02x}{b:02x}{a:02x}"),
    }
}

/// Writes the materials of all things.
pub(crate) fn write(scene: &Scene, out: &mut dyn Write) -> Result<()> {
    let mut text = Text::new(out);
    text.push("# Katydid\n");
    let colours: BTreeSet<Option<[u8; 4]>> = scene.things.iter().map(|thing| thing.colour).collect();
    for colour in colours {
        text.push("newmtl ");
        text.push(&name(colour));
        let [r, g, b] = colour.map_or([GREY; 3], |[r, g, b, _]| [r, g, b].map(super::share));
        text.push("\nKd");
        text.reals([r, g, b]);
        let alpha = colour.map_or(255, |[.., a]| a);
        if alpha < 255 {
            text.push("\nd ");
            text.real(super::share(alpha));
        }
        text.push("\nillum 1");
        text.end_line()?;
    }
    text.flush()
}

/// The colours of materials by their names, as far as a file says them. Textures and the rest are passed over.
pub(super) fn read(bytes: &[u8], colours: &mut HashMap<String, Option<[u8; 4]>>) {
    let text = String::from_utf8_lossy(bytes);
    let mut current: Option<(String, Material)> = None;
    let mut end = |current: Option<(String, Material)>| {
        if let Some((name, material)) = current {
            let colour = if name.eq_ignore_ascii_case(NONE) { None } else { material.colour() };
            colours.entry(name).or_insert(colour);
        }
    };
    for line in text.lines() {
        let mut words = line.split_ascii_whitespace();
        let Some(word) = words.next() else { continue };
        if word == "newmtl" {
            end(current.take());
            current = Some((super::rest(line, word).to_owned(), Material::default()));
            continue;
        }
        let Some((_, material)) = &mut current else { continue };
        let mut numbers = words.map_while(|word| word.parse::<f64>().ok().filter(|x| x.is_finite()));
        match word {
            "Kd" => {
                // One number stands for all three.
                if let Some(r) = numbers.next() {
                    material.diffuse = Some([r, numbers.next().unwrap_or(r), numbers.next().unwrap_or(r)]);
                }
            }
            "d" => material.opacity = numbers.next().unwrap_or(material.opacity),
            "Tr" => material.opacity = numbers.next().map_or(material.opacity, |t| 1.0 - t),
            _ => {}
        }
    }
    end(current);
}

struct Material {
    diffuse: Option<[f64; 3]>,
    opacity: f64,
}

impl Default for Material {
    fn default() -> Self {
        Self { diffuse: None, opacity: 1.0 }
    }
}

impl Material {
    fn colour(&self) -> Option<[u8; 4]> {
        let part = |x: f64| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
        let [r, g, b] = self.diffuse?.map(part);
        Some([r, g, b, part(self.opacity)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn materials_of_other_programs_are_understood() {
        let mut colours = HashMap::new();
        let text = "Kd 1 1 1\nnewmtl a b\n  Kd 1 0.5 0 # orange\nd 0.5\nnewmtl grey\nKd 0.2\nTr 0.25\n\
                    newmtl texture\nmap_Kd x.png\nnewmtl odd\nKd spectral x.rfl 1\nd -halo 0.3\nnewmtl none\nKd 1 0 0\n";
        read(text.as_bytes(), &mut colours);
        let of = |name: &str| colours.get(name).copied();
        assert_eq!(of("a b"), Some(Some([255, 128, 0, 128])));
        assert_eq!(of("grey"), Some(Some([51, 51, 51, 191])));
        assert_eq!((of("texture"), of("odd"), of("none")), (Some(None), Some(None), Some(None)));
        assert_eq!(colours.len(), 5);
    }
}
