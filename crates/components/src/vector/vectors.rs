//! Vector / Vector.

use std::f64::consts::TAU;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{Plane, Point3, Vector3};

/// The vector with length 1, or the zero vector and a warning.
fn unitized(context: &Context<'_>, v: Vector3) -> Vector3 {
    v.unitized().unwrap_or_else(|| {
        context.warn("A vector of length 0 has no direction and cannot be unitized");
        Vector3::ZERO
    })
}

/// The direction of the world's x axis, `Factor` long.
#[component("79f9fbb3-8f1d-4d9a-88a9-f7961b1012cd", name = "Unit X", nick = "X", at = "Vector/Vector")]
#[output("Unit vector", "V", "The vector (F, 0, 0).")]
fn unit_x(
    /// The length; a negative one reverses the vector.
    #[port("Factor", "F", default = 1.0)]
    factor: f64,
) -> Vector3 {
    Vector3::new(factor, 0.0, 0.0)
}

/// The direction of the world's y axis, `Factor` long.
#[component("d3d195ea-2d59-4ffa-90b1-8b7ff3369f69", name = "Unit Y", nick = "Y", at = "Vector/Vector")]
#[output("Unit vector", "V", "The vector (0, F, 0).")]
fn unit_y(
    /// The length; a negative one reverses the vector.
    #[port("Factor", "F", default = 1.0)]
    factor: f64,
) -> Vector3 {
    Vector3::new(0.0, factor, 0.0)
}

/// The direction of the world's z axis, `Factor` long.
#[component("9103c240-a6a9-4223-9b42-dbd19bf38e2b", name = "Unit Z", nick = "Z", at = "Vector/Vector")]
#[output("Unit vector", "V", "The vector (0, 0, F).")]
fn unit_z(
    /// The length; a negative one reverses the vector.
    #[port("Factor", "F", default = 1.0)]
    factor: f64,
) -> Vector3 {
    Vector3::new(0.0, 0.0, factor)
}

/// A vector from its three components.
#[component("56b92eab-d121-43f7-94d3-6cd8f0ddead8", name = "Vector XYZ", nick = "Vec", at = "Vector/Vector")]
#[output("Vector", "V", "The vector.")]
#[output("Length", "L", "Its length.")]
fn vector_xyz(
    /// Along the world's x axis.
    #[port("X component", "X", default = 0.0)]
    x: f64,
    /// Along the world's y axis.
    #[port("Y component", "Y", default = 0.0)]
    y: f64,
    /// Along the world's z axis.
    #[port("Z component", "Z", default = 0.0)]
    z: f64,
) -> (Vector3, f64) {
    let v = Vector3::new(x, y, z);
    (v, v.length())
}

/// The three components of a vector.
#[component(
    "a50fcd4a-cf42-4c3f-8616-022761e6cc93",
    name = "Deconstruct Vector",
    nick = "DeVec",
    at = "Vector/Vector"
)]
#[output("X component", "X", "Along the world's x axis.")]
#[output("Y component", "Y", "Along the world's y axis.")]
#[output("Z component", "Z", "Along the world's z axis.")]
fn deconstruct_vector(
    /// The vector.
    #[port("Vector", "V")]
    vector: Vector3,
) -> (f64, f64, f64) {
    (vector.x, vector.y, vector.z)
}

/// The length of a vector.
#[component(
    "675e31bf-1775-48d7-bb8d-76b77786dd53",
    name = "Vector Length",
    nick = "VLen",
    at = "Vector/Vector"
)]
#[output("Length", "L", "Its length, never negative.")]
fn vector_length(
    /// The vector.
    #[port("Vector", "V")]
    vector: Vector3,
) -> f64 {
    vector.length()
}

/// The vector from one point to another.
///
/// Two equal points give the zero vector; unitizing that gives a warning.
#[component(
    "934ede4a-924a-4973-bb05-0dc4b36fae75",
    name = "Vector 2Pt",
    nick = "Vec2Pt",
    at = "Vector/Vector"
)]
#[output("Vector", "V", "The vector B - A.")]
#[output("Length", "L", "The distance between the points.")]
fn vector_2pt(
    context: &Context<'_>,
    /// Where the vector starts.
    #[port("Point A", "A")]
    a: Point3,
    /// Where it ends.
    #[port("Point B", "B")]
    b: Point3,
    /// Whether to give it length 1.
    #[port("Unitize", "U", default = false)]
    unitize: bool,
) -> (Vector3, f64) {
    let v = b - a;
    (if unitize { unitized(context, v) } else { v }, v.length())
}

/// A vector of the same direction with another length.
///
/// The zero vector has no direction: that is an error.
#[component("6ec39468-dae7-4ffa-a766-f2ab22a2c62e", name = "Amplitude", nick = "Amp", at = "Vector/Vector")]
#[output("Vector", "V", "The vector with that length.")]
fn amplitude(
    /// Gives the direction.
    #[port("Vector", "V")]
    vector: Vector3,
    /// The new length; a negative one reverses the vector.
    #[port("Amplitude", "A", default = 1.0)]
    amplitude: f64,
) -> Result<Vector3, Message> {
    vector.with_length(amplitude).ok_or_else(|| Message::error("A vector of length 0 has no direction"))
}

/// The vector of length 1 in the same direction.
///
/// The zero vector stays as it is, with a warning.
#[component(
    "d2da1306-259a-4994-85a4-672d8a4c7805",
    name = "Unit Vector",
    nick = "Unit",
    at = "Vector/Vector"
)]
#[output("Vector", "V", "The vector with length 1.")]
fn unit_vector(
    context: &Context<'_>,
    /// Gives the direction.
    #[port("Vector", "V")]
    vector: Vector3,
) -> Vector3 {
    unitized(context, vector)
}

/// The vector that points the opposite way.
#[component("d5788074-d75d-4021-b1a3-0bf992928584", name = "Reverse", nick = "Rev", at = "Vector/Vector")]
#[output("Vector", "V", "The same with all components negated.")]
fn reverse(
    /// The vector.
    #[port("Vector", "V")]
    vector: Vector3,
) -> Vector3 {
    -vector
}

/// Turns a vector about an axis through the origin, by the right-hand rule.
///
/// An axis of length 0 is an error.
#[component("b6d7ba20-cf74-4191-a756-2216a36e30a7", name = "Rotate", nick = "VRot", at = "Vector/Vector")]
#[output("Vector", "V", "The turned vector.")]
fn rotate(
    /// The vector to turn.
    #[port("Vector", "V")]
    vector: Vector3,
    /// The direction of the axis.
    #[port("Axis", "X")]
    axis: Vector3,
    /// In radians.
    #[port("Angle", "A")]
    angle: f64,
) -> Result<Vector3, Message> {
    vector.rotated(angle, axis).ok_or_else(|| Message::error("The axis has no direction"))
}

/// The vector at right angles to both inputs, by the right-hand rule; |A||B| sin of the angle between them long.
///
/// Parallel vectors give the zero vector.
#[component(
    "2a5cfb31-028a-4b34-b4e1-9b20ae15312e",
    name = "Cross Product",
    nick = "XProd",
    at = "Vector/Vector"
)]
#[output("Vector", "V", "The product A x B.")]
#[output("Length", "L", "Its length.")]
fn cross_product(
    context: &Context<'_>,
    /// The first vector.
    #[port("Vector A", "A")]
    a: Vector3,
    /// The second vector.
    #[port("Vector B", "B")]
    b: Vector3,
    /// Whether to give the result length 1.
    #[port("Unitize", "U", default = false)]
    unitize: bool,
) -> (Vector3, f64) {
    let v = a.cross(b);
    let v = if unitize { unitized(context, v) } else { v };
    (v, v.length())
}

/// The sum of the products of the components: |A||B| cos of the angle between them, 0 at right angles.
#[component(
    "43b9ea8f-f772-40f2-9880-011a9c3cbbb0",
    name = "Dot Product",
    nick = "DProd",
    at = "Vector/Vector"
)]
#[output("Dot product", "D", "The product A . B.")]
fn dot_product(
    context: &Context<'_>,
    /// The first vector.
    #[port("Vector A", "A")]
    a: Vector3,
    /// The second vector.
    #[port("Vector B", "B")]
    b: Vector3,
    /// Whether to give both inputs length 1 first; the result is then the cosine.
    #[port("Unitize", "U", default = false)]
    unitize: bool,
) -> f64 {
    if unitize { unitized(context, a).dot(unitized(context, b)) } else { a.dot(b) }
}

/// The angle between two vectors, in radians.
///
/// Without a plane it is the smaller angle, 0 to pi. With one, both vectors are projected into it and the angle
/// runs counter-clockwise about its normal from A to B, 0 to 2 pi. A vector without direction is an error.
#[component(
    "b464fccb-50e7-41bd-9789-8438db9bea9f",
    name = "Angle",
    nick = "Angle",
    at = "Vector/Vector",
    also("152a264e-fc74-40e5-88cc-d1a681cd09c3")
)]
#[output("Angle", "A", "The angle from A to B.")]
#[output("Reflex", "R", "What it lacks to a full turn.")]
fn angle(
    /// The first vector.
    #[port("Vector A", "A")]
    a: Vector3,
    /// The second vector.
    #[port("Vector B", "B")]
    b: Vector3,
    /// The plane to measure in.
    #[port("Plane", "P")]
    plane: Option<Plane>,
) -> Result<(f64, f64), Message> {
    let angle = match plane {
        None => a.angle_to(b),
        Some(plane) => a.angle_in_plane(b, &plane),
    };
    let angle = angle.ok_or_else(|| Message::error("A vector has no direction to measure an angle from"))?;
    Ok((angle, TAU - angle))
}

/// The sum of two vectors.
#[component("fb012ef9-4734-4049-84a0-b92b85bb09da", name = "Addition", nick = "VAdd", at = "Vector/Vector")]
#[output("Vector", "V", "The vector A + B.")]
#[output("Length", "L", "Its length.")]
fn vector_addition(
    context: &Context<'_>,
    /// The first vector.
    #[port("Vector A", "A")]
    a: Vector3,
    /// The second vector.
    #[port("Vector B", "B")]
    b: Vector3,
    /// Whether to give the sum length 1.
    #[port("Unitize", "U", default = false)]
    unitize: bool,
) -> (Vector3, f64) {
    let v = a + b;
    let v = if unitize { unitized(context, v) } else { v };
    (v, v.length())
}

/// A vector times a number.
#[component("63fff845-7c61-4dfb-ba12-44d481b4bf0f", name = "Multiply", nick = "VMul", at = "Vector/Vector")]
#[output("Vector", "V", "The vector V F.")]
#[output("Length", "L", "Its length.")]
fn multiply(
    /// The vector.
    #[port("Vector", "V")]
    vector: Vector3,
    /// The number.
    #[port("Factor", "F")]
    factor: f64,
) -> (Vector3, f64) {
    let v = vector * factor;
    (v, v.length())
}

/// A vector divided by a number. Zero is an error.
#[component("310e1065-d03a-4858-bcd1-809d39c042af", name = "Divide", nick = "VDiv", at = "Vector/Vector")]
#[output("Vector", "V", "The vector V / F.")]
#[output("Length", "L", "Its length.")]
fn divide(
    /// The vector.
    #[port("Vector", "V")]
    vector: Vector3,
    /// The number; not zero.
    #[port("Factor", "F")]
    factor: f64,
) -> Result<(Vector3, f64), Message> {
    if factor == 0.0 {
        return Err(Message::error("Division by zero"));
    }
    let v = vector / factor;
    Ok((v, v.length()))
}

/// The sum of a list of vectors. Nulls are skipped.
#[component(
    "63f79e72-36c0-4489-a0c2-9ded0b9ca41f",
    name = "Mass Addition",
    nick = "MassAdd",
    at = "Vector/Vector",
    also("b7f1178f-4222-47fd-9766-5d06e869362b")
)]
#[output("Vector", "V", "The sum; the zero vector for an empty list.")]
#[output("Length", "L", "Its length.")]
fn vector_mass_addition(
    context: &Context<'_>,
    /// The vectors.
    #[port("Vectors", "V")]
    vectors: List<Vector3>,
    /// Whether to give the sum length 1.
    #[port("Unitize", "U", default = false)]
    unitize: bool,
) -> (Vector3, f64) {
    let v: Vector3 = vectors.present().sum();
    let v = if unitize { unitized(context, v) } else { v };
    (v, v.length())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Plane, Point3, Vector3};

    const V: Vector3 = Vector3::new(1.0, 2.0, 2.0);

    #[test]
    fn axes_and_components() {
        assert_eq!(Trial::of("Unit X").item(2.0).texts(0), ["{0}: {2, 0, 0}"]);
        assert_eq!(Trial::of("Unit Y").texts(0), ["{0}: {0, 1, 0}"]);
        assert_eq!(Trial::of("Unit Z").item(-3.0).texts(0), ["{0}: {0, 0, -3}"]);
        assert_eq!(Trial::of("Vector XYZ").item(1.0).item(2.0).item(2.0).texts(1), ["{0}: 3"]);
        assert_eq!(Trial::of("Deconstruct Vector").item(V).texts(2), ["{0}: 2"]);
        assert_eq!(Trial::of("Vector Length").item(V).texts(0), ["{0}: 3"]);
        assert_eq!(
            Trial::of_guid("d5788074-d75d-4021-b1a3-0bf992928584").item(V).texts(0),
            ["{0}: {-1, -2, -2}"]
        );
    }

    #[test]
    fn between_points() {
        let trial = || Trial::of("Vector 2Pt").item(Point3::ORIGIN).item(Point3::new(0.0, 3.0, 4.0));
        assert_eq!(trial().texts(0), ["{0}: {0, 3, 4}"]);
        assert_eq!(trial().item(true).texts(0), ["{0}: {0, 0.6, 0.8}"]);
        assert_eq!(trial().item(true).texts(1), ["{0}: 5"]);
        let none = Trial::of("Vector 2Pt").item(Point3::ORIGIN).item(Point3::ORIGIN).item(true);
        assert!(none.message().contains("direction"));
    }

    #[test]
    fn lengths() {
        assert_eq!(Trial::of("Amplitude").item(V).item(-6.0).texts(0), ["{0}: {-2, -4, -4}"]);
        assert!(Trial::of("Amplitude").item(Vector3::ZERO).item(1.0).message().contains("direction"));
        assert_eq!(Trial::of("Unit Vector").item(Vector3::new(0.0, -5.0, 0.0)).texts(0), ["{0}: {0, -1, 0}"]);
        assert_eq!(Trial::of("Unit Vector").item(Vector3::ZERO).texts(0), ["{0}: {0, 0, 0}"]);
    }

    #[test]
    fn products() {
        let trial = |name| Trial::of(name).item(Vector3::X * 2.0).item(Vector3::Y * 3.0);
        assert_eq!(trial("Cross Product").texts(0), ["{0}: {0, 0, 6}"]);
        assert_eq!(trial("Cross Product").item(true).texts(1), ["{0}: 1"]);
        assert_eq!(Trial::of("Dot Product").item(V).item(V).texts(0), ["{0}: 9"]);
        assert_eq!(Trial::of("Dot Product").item(V).item(V).item(true).texts(0), ["{0}: 1"]);
    }

    #[test]
    fn turning_and_angles() {
        let turned = Trial::of_guid("b6d7ba20-cf74-4191-a756-2216a36e30a7")
            .item(Vector3::X)
            .item(Vector3::Z)
            .item(std::f64::consts::PI);
        assert_eq!(turned.texts(0), ["{0}: {-1, 0, 0}"]);
        let angle = || Trial::of("Angle").item(Vector3::Y).item(Vector3::X);
        assert_eq!(angle().texts(0), ["{0}: 1.570796"]);
        assert_eq!(angle().item(Plane::XY).texts(0), ["{0}: 4.712389"]);
        assert_eq!(angle().item(Plane::XY).texts(1), ["{0}: 1.570796"]);
        assert!(Trial::of("Angle").item(Vector3::Y).item(Vector3::ZERO).message().contains("direction"));
    }

    #[test]
    fn sums() {
        let sum = Trial::of_guid("fb012ef9-4734-4049-84a0-b92b85bb09da").item(V).item(Vector3::X);
        assert_eq!(sum.texts(0), ["{0}: {2, 2, 2}"]);
        let product = Trial::of_guid("63fff845-7c61-4dfb-ba12-44d481b4bf0f").item(V).item(2.0);
        assert_eq!(product.texts(1), ["{0}: 6"]);
        let quotient = Trial::of_guid("310e1065-d03a-4858-bcd1-809d39c042af").item(V).item(0.0);
        assert_eq!(quotient.message(), "Division by zero");
        let all = Trial::of_guid("63f79e72-36c0-4489-a0c2-9ded0b9ca41f").gaps([Some(V), None, Some(V)]);
        assert_eq!(all.texts(0), ["{0}: {2, 4, 4}"]);
    }
}
