//! Mesh / Util: how finely surfaces become meshes.

use katydid_component::{Message, component};
use katydid_data::MeshSettings;

/// Mesh settings for little work: few polygons, edges that may look jagged.
#[component(
    "255ca3e9-2c1e-443a-a404-e76b5c63f4cb",
    name = "Settings (Speed)",
    nick = "Jagged",
    at = "Mesh/Util"
)]
#[output("Settings", "S", "The settings.")]
fn settings_speed() -> MeshSettings {
    MeshSettings::SPEED
}

/// Mesh settings for good looks: more polygons, edges turn by at most 20 degrees.
#[component(
    "1b0ee096-cc76-4847-8941-04a9e256de76",
    name = "Settings (Quality)",
    nick = "Smooth",
    at = "Mesh/Util"
)]
#[output("Settings", "S", "The settings.")]
fn settings_quality() -> MeshSettings {
    MeshSettings::QUALITY
}

/// Mesh settings of one's own. A limit of 0 is off.
#[component(
    "4a0180e5-d8f9-46e7-bd34-ced804601462",
    name = "Settings (Custom)",
    nick = "Custom Mesh Settings",
    at = "Mesh/Util"
)]
#[output("Settings", "S", "The settings.")]
#[allow(clippy::too_many_arguments, reason = "an argument is a port")]
fn settings_custom(
    /// Whether faces that meet share their vertices along the seam.
    #[port("Stitch Seams", "Stitch", default = true)]
    stitch_seams: bool,
    /// Whether plane faces become as few polygons as they can.
    #[port("Simple Planes", "Planes", default = false)]
    simple_planes: bool,
    /// Whether the first grid is refined until the limits hold.
    #[port("Refine", "Refine", default = true)]
    refine: bool,
    /// The fewest quads of the first grid, 0 or more.
    #[port("Min Count", "Min", default = 16)]
    min_count: i32,
    /// The most quads of the first grid, 0 or more.
    #[port("Max Count", "Max", default = 400)]
    max_count: i32,
    /// The longest side of a quad over its shortest.
    #[port("Aspect Ratio", "Aspect", default = 20.0)]
    aspect: f64,
    /// The greatest distance between an edge and the surface, in units.
    #[port("Max Distance", "Max Dist", default = 0.0)]
    max_distance: f64,
    /// The greatest angle between neighbouring faces, in degrees.
    #[port("Max Angle", "Max Angle", default = 20.0)]
    max_angle: f64,
    /// The shortest edge, in units.
    #[port("Min Edge", "Min Edge", default = 0.0)]
    min_edge: f64,
    /// The longest edge, in units.
    #[port("Max Edge", "Max Edge", default = 0.0)]
    max_edge: f64,
) -> Result<MeshSettings, Message> {
    let limits = [aspect, max_distance, max_angle, min_edge, max_edge];
    if limits.iter().any(|x| !(*x >= 0.0 && x.is_finite())) || min_count < 0 || max_count < 0 {
        return Err(Message::error("A limit of mesh settings is a number from 0 on, where 0 is off"));
    }
    Ok(MeshSettings {
        max_edge,
        min_edge,
        tolerance: max_distance,
        min_tolerance: 0.0,
        relative_tolerance: 0.0,
        refine_angle: max_angle.to_radians(),
        aspect,
        grid_min: min_count,
        grid_max: max_count,
        refine,
        jagged_seams: !stitch_seams,
        simple_planes,
    })
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{MeshSettings, Value};

    fn settings(trial: Trial) -> MeshSettings {
        match trial.run().outputs[0].column().get(0) {
            Some(Value::MeshSettings(s)) => *s,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn three_ways() {
        assert_eq!(settings(Trial::of("Settings (Speed)")), MeshSettings::SPEED);
        let quality = settings(Trial::of("Settings (Quality)"));
        assert!((quality.refine_angle.to_degrees() - 20.0).abs() < 1e-12);
        let custom = settings(Trial::of("Settings (Custom)").item(false).item(true));
        assert!(custom.jagged_seams && custom.simple_planes && custom.aspect == 20.0);
        assert!((custom.refine_angle.to_degrees() - 20.0).abs() < 1e-12);
        let wrong = Trial::of("Settings (Custom)").default().default().default().item(-1);
        assert!(wrong.message().contains("0 is off"));
        assert_eq!(Trial::of("Settings (Speed)").texts(0), ["{0}: Mesh Settings"]);
    }
}
