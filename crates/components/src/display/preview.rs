//! Display / Preview.

use katydid_component::{List, component};
use katydid_data::{Colour, Geometry, Material};
use katydid_geometry::Point3;

/// What a preview has without a material of its own.
const PLUM: Material = Material {
    diffuse: Colour::rgb(221, 160, 221),
    specular: Colour::rgb(255, 255, 255),
    emission: Colour::rgb(66, 48, 66),
    transparency: 0.0,
    shine: 0.5,
};

/// Draws geometry with a material or colour of its own.
#[component(
    "537b0419-bbc2-4ff4-bf08-afe526367b2c",
    name = "Custom Preview",
    nick = "Preview",
    at = "Display/Preview"
)]
fn custom_preview(
    /// The geometry.
    #[port("Geometry", "G")]
    _geometry: Geometry,
    /// The material, or a colour.
    #[port("Material", "M", default = PLUM)]
    _material: Material,
) {
}

/// Draws points as dots.
#[component(
    "6b1bd8b2-47a4-4aa6-a471-3fd91c62a486",
    name = "Dot Display",
    nick = "Dots",
    at = "Display/Preview"
)]
fn dot_display(
    /// The point.
    #[port("Point", "P")]
    _point: Point3,
    /// The colour of the dot.
    #[port("Colour", "C", default = Colour::rgb(0, 0, 0))]
    _colour: Colour,
    /// The size of the dot.
    #[port("Size", "S", default = 1.0)]
    _size: f64,
) {
}

/// Draws points as a cloud of soft dots.
#[component(
    "059b72b0-9bb3-4542-a805-2dcd27493164",
    name = "Cloud Display",
    nick = "Cloud",
    at = "Display/Preview"
)]
fn cloud_display(
    /// The points.
    #[port("Points", "P", optional)]
    _points: List<Point3>,
    /// The colours of the dots.
    #[port("Colours", "C", default = Colour::rgb(255, 20, 147), optional)]
    _colours: List<Colour>,
    /// The size of the dots.
    #[port("Size", "S", default = 1.0)]
    _size: Option<f64>,
) {
}

/// Makes a material for previews.
#[component(
    "76975309-75a6-446a-afed-f8653720a9f2",
    name = "Create Material",
    nick = "Material",
    at = "Display/Preview"
)]
#[output("Material", "M", "The material.")]
fn create_material(
    /// The colour of the lit surface.
    #[port("Diffuse", "Kd", default = Colour::rgb(255, 105, 180))]
    diffuse: Colour,
    /// The colour of its highlights.
    #[port("Specular", "Ks", default = Colour::rgb(255, 255, 255))]
    specular: Colour,
    /// The colour it gives off without light.
    #[port("Emission", "Ke", default = Colour::rgb(0, 0, 0))]
    emission: Colour,
    /// 0 is opaque, 1 cannot be seen.
    #[port("Transparency", "T", default = 0.0)]
    transparency: f64,
    /// 0 is dull, 100 is polished.
    #[port("Shine", "S", default = 0)]
    shine: i32,
) -> Material {
    let transparency = if transparency.is_nan() { 0.0 } else { transparency.clamp(0.0, 1.0) };
    Material { diffuse, specular, emission, transparency, shine: f64::from(shine.clamp(0, 100)) / 100.0 }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Colour, Material, Value};
    use katydid_geometry::Point3;

    #[test]
    fn drawing_gives_no_data() {
        for name in ["Custom Preview", "Dot Display", "Cloud Display"] {
            let out = Trial::of(name).list([Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)]).run();
            assert!(out.outputs.is_empty() && out.messages.is_empty(), "{name}");
        }
    }

    #[test]
    fn materials_keep_their_parts() {
        let red = Colour::rgb(255, 0, 0);
        let out = Trial::of("Create Material").item(red).default().default().item(1.5).item(40).run();
        let expected = Material { transparency: 1.0, shine: 0.4, ..Material::from(red) };
        assert_eq!(out.outputs[0].column().get(0), Some(Value::from(expected)));
    }
}
