//! Larger, smaller, equal, similar.

use katydid_component::component;

/// Whether two numbers are the same, to the last bit: 0.1 + 0.2 is not 0.3.
#[component(
    "5db0fb89-4f22-4f09-a777-fa5e55aed7ec",
    name = "Equality",
    nick = "Equals",
    at = "Maths/Operators"
)]
#[output("Equality", "=", "Whether they are equal.")]
#[output("Inequality", "≠", "Whether they differ.")]
fn equality(
    /// A number.
    #[port("First Number", "A")]
    a: f64,
    /// Another number.
    #[port("Second Number", "B")]
    b: f64,
) -> (bool, bool) {
    (a == b, a != b)
}

/// Whether one number is larger than another.
#[component(
    "30d58600-1aab-42db-80a3-f1ea6c4269a0",
    name = "Larger Than",
    nick = "Larger",
    at = "Maths/Operators"
)]
#[output("Larger than", ">", "Whether A is larger than B.")]
#[output("… or Equal to", ">=", "Whether A is larger than B or equal to it.")]
fn larger_than(
    /// A number.
    #[port("First Number", "A")]
    a: f64,
    /// The number it is compared with.
    #[port("Second Number", "B", default = 0.0)]
    b: f64,
) -> (bool, bool) {
    (a > b, a >= b)
}

/// Whether one number is smaller than another.
#[component(
    "ae840986-cade-4e5a-96b0-570f007d4fc0",
    name = "Smaller Than",
    nick = "Smaller",
    at = "Maths/Operators"
)]
#[output("Smaller than", "<", "Whether A is smaller than B.")]
#[output("… or Equal to", "<=", "Whether A is smaller than B or equal to it.")]
fn smaller_than(
    /// A number.
    #[port("First Number", "A")]
    a: f64,
    /// The number it is compared with.
    #[port("Second Number", "B", default = 0.0)]
    b: f64,
) -> (bool, bool) {
    (a < b, a <= b)
}

/// Whether two numbers differ by no more than a percentage of the larger one.
#[component(
    "40177d8a-a35c-4622-bca7-d150031fe427",
    name = "Similarity",
    nick = "Similar",
    at = "Maths/Operators"
)]
#[output("Similarity", "=", "Whether they are similar.")]
#[output("Absolute difference", "dt", "How far they are apart.")]
fn similarity(
    /// A number.
    #[port("First Number", "A")]
    a: f64,
    /// Another number.
    #[port("Second Number", "B")]
    b: f64,
    /// The percentage: with 20, numbers are similar that differ by a fifth.
    #[port("Threshold", "T%", default = 0.1)]
    percent: f64,
) -> (bool, f64) {
    let difference = (a - b).abs();
    (difference <= percent / 100.0 * a.abs().max(b.abs()), difference)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    fn both(name: &str, a: f64, b: f64) -> String {
        let out = Trial::of(name).item(a).item(b).run();
        let text = |k: usize| katydid_component::testing::texts(&out.outputs[k]).concat();
        format!("{} {}", text(0), text(1)).replace("{0}: ", "")
    }

    #[test]
    fn as_pictures_of_the_original_show() {
        assert_eq!(both("Equality", 2.0, 4.5), "False True");
        assert_eq!(both("Larger Than", 2.0, 5.0), "False False");
        assert_eq!(both("Smaller Than", 2.0, 2.0), "False True");
        let similar = Trial::of("Similarity").item("2").item("2.5").item("20");
        assert_eq!(similar.texts(0), ["{0}: True"]);
        assert_eq!(Trial::of("Similarity").item(2.0).item(2.5).item(19.0).texts(0), ["{0}: False"]);
        assert_eq!(Trial::of("Similarity").item(2.0).item(2.5).item(20.0).texts(1), ["{0}: 0.5"]);
    }

    #[test]
    fn a_null_gives_nulls() {
        let trial = Trial::of("Larger Than").gaps([Some(1.0), None, Some(-1.0)]);
        assert_eq!(trial.texts(0), ["{0}: True, null, False"]);
        assert_eq!(Trial::of("Equality").item(0.1 + 0.2).item(0.3).texts(0), ["{0}: False"]);
    }
}
