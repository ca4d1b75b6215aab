//! Surface / Analysis: areas, volumes and moments.

use katydid_component::{Context, Message, component};
use katydid_data::{Geometry, Kind, Value, cast};
use katydid_geometry::subd::SubD;
use katydid_geometry::{Error, MassProperties, Mesh, Point3, Vector3};

use super::subd::subd_of;
use super::{named, warning};

/// Areas and volumes of Breps are measured to this part of themselves; smooth ones come out far better.
const FRACTION: f64 = 1e-9;

/// What a SubD measures: that of two meshes whose vertices lie on it, the finer one with a quarter of the other's error,
/// from which follows what they tend to (Richardson's extrapolation).
fn of_subd(
    context: &Context<'_>,
    subd: &SubD,
    measure: impl Fn(&Mesh) -> Result<MassProperties, Message>,
) -> Result<MassProperties, Message> {
    let levels = subd.fine_levels();
    let at = |levels: u32| {
        context.check()?;
        measure(&subd.limit_mesh(levels).map_err(warning)?)
    };
    let (coarse, fine) = (at(levels - 1)?, at(levels)?);
    let beyond = |coarse: f64, fine: f64| fine + (fine - coarse) / 3.0;
    Ok(MassProperties {
        amount: beyond(coarse.amount, fine.amount),
        centroid: fine.centroid + (fine.centroid - coarse.centroid) / 3.0,
        second_moments: std::array::from_fn(|k| beyond(coarse.second_moments[k], fine.second_moments[k])),
        error: (fine.amount - coarse.amount).abs() / 15.0,
    })
}

/// What the area of a shape is like. Nothing with a warning where it has none.
fn of_area(context: &Context<'_>, geometry: &Value) -> Result<MassProperties, Message> {
    if let Some(subd) = subd_of(geometry) {
        return of_subd(context, &subd?, |mesh| mesh.area_properties().map_err(warning));
    }
    match geometry {
        Value::Mesh(mesh) => mesh.area_properties().map_err(warning),
        Value::Kept(_) | Value::Brep(_) | Value::Surface(_) | Value::Box(_) => {
            let brep = solid(geometry)?;
            measured(context, brep.area_properties(FRACTION, || context.check().is_ok()))
        }
        other => match cast::value(other, Kind::Curve, context.rules()) {
            Some(Value::Curve(curve)) => curve.area_properties(context.tolerance().absolute).map_err(warning),
            _ => Err(Message::warning(format!("A {} has no area", other.kind()))),
        },
    }
}

/// What the volume of a shape is like. Nothing with a warning where it has none.
fn of_volume(context: &Context<'_>, geometry: &Value) -> Result<MassProperties, Message> {
    if let Some(subd) = subd_of(geometry) {
        return of_subd(context, &subd?, |mesh| {
            if mesh.is_closed() {
                mesh.volume_properties().map_err(warning)
            } else {
                Err(Message::warning("An open SubD has no volume"))
            }
        });
    }
    match geometry {
        Value::Mesh(mesh) => {
            if !mesh.is_closed() {
                context.warn("The mesh is open: its volume means nothing");
            }
            mesh.volume_properties().map_err(warning)
        }
        Value::Kept(_) | Value::Brep(_) | Value::Surface(_) | Value::Box(_) => {
            let brep = solid(geometry)?;
            if brep.is_solid() {
                return measured(context, brep.volume_properties(FRACTION, || context.check().is_ok()));
            }
            let what = if brep.faces().len() == 1 { "An open surface" } else { "An open Brep" };
            context.warn(format!("{what} has no volume: that between it and the centre of its box is given"));
            measured(context, brep.open_volume_properties(FRACTION, || context.check().is_ok()))
        }
        other => Err(Message::warning(format!("A {} has no volume", other.kind()))),
    }
}

/// The Brep that a shape is or stands for.
fn solid(geometry: &Value) -> Result<std::sync::Arc<katydid_geometry::Brep>, Message> {
    match geometry.brep() {
        Some(brep) => brep.map_err(Message::warning),
        None => Err(Message::warning(format!("A {} has no faces", named(geometry)))),
    }
}

/// A result, or why there is none: that the work was stopped is for the user to know first.
fn measured(context: &Context<'_>, found: Result<MassProperties, Error>) -> Result<MassProperties, Message> {
    context.check()?;
    found.map_err(warning)
}

/// The area of a Brep, a surface, a mesh, a SubD, a box, or the region inside a closed flat curve.
///
/// Trimmed parts do not count. A curve that is open or not flat has none: a warning.
#[component(
    "2e205f24-9279-47b2-b414-d06dcd0b21a7",
    name = "Area",
    nick = "Area",
    at = "Surface/Analysis",
    also("86b28a7e-94d9-4791-8306-e13e10d5f8d5")
)]
#[output("Area", "A", "Its area.")]
#[output("Centroid", "C", "The centroid of the area.")]
fn area(
    context: &Context<'_>,
    /// The geometry.
    #[port("Geometry", "G")]
    geometry: Geometry,
) -> Result<(f64, Point3), Message> {
    let found = of_area(context, &geometry.0)?;
    Ok((found.amount, found.centroid))
}

/// The area of a Brep.
#[component(
    "ab766b01-a3f5-4257-831a-fc84d7b288b4",
    name = "Brep Area",
    nick = "Area",
    at = "Surface/Analysis",
    old
)]
#[output("Area", "A", "Its area.")]
#[output("Centroid", "C", "The centroid of the area.")]
fn brep_area(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Geometry,
) -> Result<(f64, Point3), Message> {
    let found = of_area(context, &brep.0)?;
    Ok((found.amount, found.centroid))
}

/// The volume inside a closed Brep, a closed mesh, a closed SubD or a box.
///
/// What is open has no volume. Its faces and the centre of the box around it enclose one, which is given with a warning;
/// a flat shape gives a null.
#[component(
    "224f7648-5956-4b26-80d9-8d771f3dfd5d",
    name = "Volume",
    nick = "Volume",
    at = "Surface/Analysis",
    also("7c0523e8-79c9-45a2-8777-cf0d46bc5432")
)]
#[output("Volume", "V", "Its volume.")]
#[output("Centroid", "C", "The centroid of the volume.")]
fn volume(
    context: &Context<'_>,
    /// The geometry.
    #[port("Geometry", "G")]
    geometry: Geometry,
) -> Result<(f64, Point3), Message> {
    let found = of_volume(context, &geometry.0)?;
    Ok((found.amount, found.centroid))
}

/// The volume inside a closed Brep.
#[component(
    "c72d0184-bb99-4af4-a629-4662e1c3d428",
    name = "Brep Volume",
    nick = "Volume",
    at = "Surface/Analysis",
    old
)]
#[output("Volume", "V", "Its volume.")]
#[output("Centroid", "C", "The centroid of the volume.")]
fn brep_volume(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Geometry,
) -> Result<(f64, Point3), Message> {
    let found = of_volume(context, &brep.0)?;
    Ok((found.amount, found.centroid))
}

/// Amount, centroid, inertia with its error, second moments with theirs, and radii of gyration.
type WithErrors = (f64, Point3, Vector3, Vector3, Vector3, Vector3, Vector3);

fn with_errors(found: &MassProperties) -> WithErrors {
    let [x, y, z, ..] = found.second_moments;
    // The moments are as good, in proportion, as the amount.
    let part = found.error / found.amount;
    let inertia = found.inertia_about(found.centroid);
    let second = Vector3::new(x, y, z);
    let gyration = found.gyration_about(found.centroid);
    (found.amount, found.centroid, inertia, inertia * part, second, second * part, gyration)
}

/// How the area of a shape is spread about its centroid: moments about lines through it along the world axes.
#[component(
    "c98c1666-5f29-4bb8-aafd-bb5a708e8a95",
    name = "Area Moments",
    nick = "AMoments",
    at = "Surface/Analysis"
)]
#[output("Area", "A", "The area.")]
#[output("Centroid", "C", "The centroid of the area.")]
#[output("Inertia", "I", "The moments of inertia about the x, y and z axis through the centroid.")]
#[output("Inertia (error)", "I±", "How far these may be off.")]
#[output("Secondary", "S", "The integrals of the squared distances from the centroid along x, y and z.")]
#[output("Secondary (error)", "S±", "How far these may be off.")]
#[output("Gyration", "G", "The radii of gyration about the x, y and z axis through the centroid.")]
fn area_moments(
    context: &Context<'_>,
    /// A Brep, a mesh or a closed flat curve.
    #[port("Geometry", "G")]
    geometry: Geometry,
) -> Result<(f64, Point3, Vector3, Vector3, Vector3, Vector3, Vector3), Message> {
    Ok(with_errors(&of_area(context, &geometry.0)?))
}

/// How the area of a Brep is spread about its centroid: moments about lines through it along the world axes.
#[component(
    "5d2fb801-2905-4a55-9d48-bbb22c73ad13",
    name = "Brep Area Moments",
    nick = "AMoments",
    at = "Surface/Analysis",
    old
)]
#[output("Area", "A", "The area.")]
#[output("Centroid", "C", "The centroid of the area.")]
#[output("Inertia", "I", "The moments of inertia about the x, y and z axis through the centroid.")]
#[output("Inertia (error)", "I±", "How far these may be off.")]
#[output("Secondary", "S", "The integrals of the squared distances from the centroid along x, y and z.")]
#[output("Secondary (error)", "S±", "How far these may be off.")]
#[output("Gyration", "G", "The radii of gyration about the x, y and z axis through the centroid.")]
fn brep_area_moments(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Geometry,
) -> Result<(f64, Point3, Vector3, Vector3, Vector3, Vector3, Vector3), Message> {
    Ok(with_errors(&of_area(context, &brep.0)?))
}

/// How a volume is spread about its centroid: moments about lines through it along the world axes.
#[component(
    "4b5f79e1-c2b3-4b9c-b97d-470145a3ca74",
    name = "Volume Moments",
    nick = "VMoments",
    at = "Surface/Analysis"
)]
#[output("Volume", "V", "The volume.")]
#[output("Centroid", "C", "The centroid of the volume.")]
#[output("Inertia", "I", "The moments of inertia about the x, y and z axis through the centroid.")]
#[output("Inertia (error)", "I±", "How far these may be off.")]
#[output("Secondary", "S", "The integrals of the squared distances from the centroid along x, y and z.")]
#[output("Secondary (error)", "S±", "How far these may be off.")]
#[output("Gyration", "G", "The radii of gyration about the x, y and z axis through the centroid.")]
fn volume_moments(
    context: &Context<'_>,
    /// A closed Brep or mesh.
    #[port("Geometry", "G")]
    geometry: Geometry,
) -> Result<(f64, Point3, Vector3, Vector3, Vector3, Vector3, Vector3), Message> {
    Ok(with_errors(&of_volume(context, &geometry.0)?))
}

/// How the volume of a Brep is spread about its centroid: moments about lines through it along the world axes.
#[component(
    "ffdfcfc5-3933-4c38-b680-8bb530e243ff",
    name = "Brep Volume Moments",
    nick = "VMoments",
    at = "Surface/Analysis",
    old
)]
#[output("Volume", "V", "The volume.")]
#[output("Centroid", "C", "The centroid of the volume.")]
#[output("Inertia", "I", "The moments of inertia about the x, y and z axis through the centroid.")]
#[output("Inertia (error)", "I±", "How far these may be off.")]
#[output("Secondary", "S", "The integrals of the squared distances from the centroid along x, y and z.")]
#[output("Secondary (error)", "S±", "How far these may be off.")]
#[output("Gyration", "G", "The radii of gyration about the x, y and z axis through the centroid.")]
fn brep_volume_moments(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Geometry,
) -> Result<(f64, Point3, Vector3, Vector3, Vector3, Vector3, Vector3), Message> {
    Ok(with_errors(&of_volume(context, &brep.0)?))
}

/// Amount, centroid, inertia, second moments and radii of gyration.
type WithoutErrors = (f64, Point3, Vector3, Vector3, Vector3);

fn without_errors(found: &MassProperties) -> WithoutErrors {
    let (amount, centroid, inertia, _, second, _, gyration) = with_errors(found);
    (amount, centroid, inertia, second, gyration)
}

/// How the area of a shape is spread about its centroid: moments about lines through it along the world axes.
#[component(
    "1eb7b856-ec7d-40b6-a76c-f216a11df37c",
    name = "Area Moments",
    nick = "AMoments",
    at = "Surface/Analysis",
    old
)]
#[output("Area", "A", "The area.")]
#[output("Centroid", "C", "The centroid of the area.")]
#[output("Inertia", "I", "The moments of inertia about the x, y and z axis through the centroid.")]
#[output("Secondary", "S", "The integrals of the squared distances from the centroid along x, y and z.")]
#[output("Gyration", "G", "The radii of gyration about the x, y and z axis through the centroid.")]
fn plain_area_moments(
    context: &Context<'_>,
    /// A Brep, a mesh or a closed flat curve.
    #[port("Geometry", "G")]
    geometry: Geometry,
) -> Result<(f64, Point3, Vector3, Vector3, Vector3), Message> {
    Ok(without_errors(&of_area(context, &geometry.0)?))
}

/// How a volume is spread about its centroid: moments about lines through it along the world axes.
#[component(
    "2e685fd9-7b8f-461b-b330-44857b099937",
    name = "Volume Moments",
    nick = "VMoments",
    at = "Surface/Analysis",
    old
)]
#[output("Volume", "V", "The volume.")]
#[output("Centroid", "C", "The centroid of the volume.")]
#[output("Inertia", "I", "The moments of inertia about the x, y and z axis through the centroid.")]
#[output("Secondary", "S", "The integrals of the squared distances from the centroid along x, y and z.")]
#[output("Gyration", "G", "The radii of gyration about the x, y and z axis through the centroid.")]
fn plain_volume_moments(
    context: &Context<'_>,
    /// A closed Brep or mesh.
    #[port("Geometry", "G")]
    geometry: Geometry,
) -> Result<(f64, Point3, Vector3, Vector3, Vector3), Message> {
    Ok(without_errors(&of_volume(context, &geometry.0)?))
}

#[cfg(test)]
mod tests {
    /// The SubD of a cube with side 2 is twice that of a cube with side 1, however it is moved; where all is a crease it
    /// is the cube.
    #[test]
    fn subds_are_measured() {
        let side = |half: f64| katydid_geometry::Interval::new(-half, half);
        let cube = |half: f64| katydid_geometry::Box3 {
            plane: katydid_geometry::Plane {
                origin: Point3::new(3.0, 4.0, 5.0),
                ..katydid_geometry::Plane::XY
            },
            x: side(half),
            y: side(half),
            z: side(half),
        };
        let measured = |half: f64, creases: bool| {
            let net =
                || Trial::of("SubD Box").item(cube(half)).item(1).item(creases).run().outputs[0].clone();
            let number = |name: &str| {
                let found = Trial::of(name).tree(net()).run();
                match (found.outputs[0].column().get(0), found.outputs[1].column().get(0)) {
                    (Some(Value::Number(n)), Some(Value::Point(p))) => {
                        assert!(p.distance_to(Point3::new(3.0, 4.0, 5.0)) < 1e-9);
                        n
                    }
                    other => panic!("{other:?}"),
                }
            };
            let bounds = Trial::of("Bounding Box").tree(net()).run().outputs[0].column().get(0);
            let Some(Value::Box(bounds)) = bounds else { panic!("a box") };
            (number("Area"), number("Volume"), bounds.x.length())
        };
        let (area, volume, width) = measured(1.0, true);
        assert!((area - 24.0).abs() < 1e-9 && (volume - 8.0).abs() < 1e-9 && (width - 2.0).abs() < 1e-12);
        let (small, large) = (measured(0.5, false), measured(1.0, false));
        assert!((large.0 - 4.0 * small.0).abs() < 1e-9 && (large.1 - 8.0 * small.1).abs() < 1e-9);
        assert!(large.1 < 8.0 && (large.1 / small.1 - 8.0).abs() < 1e-9);
        assert!(large.2 < 2.0 && large.2 > 1.0);
    }

    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{
        Box3, Brep, Circle, Cylinder, Interval, Line, Mesh, Plane, Point3, Surface, Tolerance, construct,
    };

    fn block() -> Box3 {
        let unit = Interval::new(0.0, 2.0);
        Box3 { plane: Plane::XY, x: unit, y: unit, z: unit }
    }

    fn can() -> Brep {
        construct::cylinder(&Cylinder::new(Plane::XY, 1.0, Interval::new(0.0, 2.0)).unwrap(), [true; 2])
            .unwrap()
    }

    #[test]
    fn areas_and_volumes() {
        let circle = Circle { plane: Plane::XY, radius: 1.0 };
        let area = |v: Value| Trial::of("Area").item(v).texts(0).join("");
        assert_eq!(area(circle.into()), "{0}: 3.141593");
        assert_eq!(area(block().into()), "{0}: 24");
        assert_eq!(area(Mesh::cuboid(&block(), 1, 1, 1).unwrap().into()), "{0}: 24");
        assert_eq!(area(can().into()), "{0}: 18.849556");
        let line = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
        assert!(Trial::of("Area").item(line).message().contains("open"));
        let volume = |v: Value| Trial::of("Volume").item(v);
        assert_eq!(volume(Mesh::cuboid(&block(), 2, 2, 2).unwrap().into()).texts(0), ["{0}: 8"]);
        assert_eq!(volume(block().into()).texts(1), ["{0}: {1, 1, 1}"]);
        assert_eq!(volume(can().into()).texts(0), ["{0}: 6.283185"]);
        let tube: Surface = Cylinder::new(Plane::XY, 1.0, Interval::UNIT).unwrap().into();
        // A cone of height r over each strip of the wall: a third of r times its area.
        let open = || volume(tube.clone().into());
        assert!(open().message().contains("open surface"));
        assert_eq!(open().texts(0), ["{0}: 2.094395"]);
        assert!(open().texts(1)[0].ends_with("0.5}"));
        let flat: Surface =
            katydid_geometry::PlaneSurface::new(Plane::XY, Interval::UNIT, Interval::UNIT).unwrap().into();
        assert_eq!(volume(flat.into()).texts(0), ["{0}: null"]);
        assert!(volume(circle.into()).message().contains("no volume"));
    }

    #[test]
    fn plates_with_holes() {
        let round = |r: f64| Circle { plane: Plane::XY, radius: r }.into();
        let rings = Brep::planar_faces(&[round(3.0), round(1.0)], &Tolerance::default()).unwrap();
        let found = Trial::of("Area").item(Value::from(rings.breps[0].clone())).texts(0);
        assert_eq!(found, ["{0}: 25.132741"]);
    }

    #[test]
    fn moments() {
        let body = || Trial::of("Volume Moments").item(can());
        // A cylinder of radius 1 and height 2 about its middle: m (3 r² + h²) / 12, and m r² / 2 about the axis.
        let (cross, axial) = (std::f64::consts::TAU * 7.0 / 12.0, std::f64::consts::PI);
        assert_eq!(body().texts(2), [format!("{{0}}: {{{cross:.6}, {cross:.6}, {axial:.6}}}")]);
        assert_eq!(body().texts(6), ["{0}: {0.763763, 0.763763, 0.707107}"]);
        let plate = Trial::of("Area Moments").item(Circle { plane: Plane::XY, radius: 2.0 }).texts(4);
        let quarter = 4.0 * std::f64::consts::PI;
        assert_eq!(plate, [format!("{{0}}: {{{quarter:.6}, {quarter:.6}, 0}}")]);
        assert!(
            Trial::of("Volume Moments")
                .item(Line::new(Point3::ORIGIN, Point3::ORIGIN))
                .message()
                .contains("no volume")
        );
    }
}
