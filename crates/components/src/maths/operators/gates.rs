//! Logic on truth values.

use katydid_component::{Context, ManyItems, component};

/// Left to right over the inputs that have data; a null on one of them makes the result null.
fn fold(context: &Context<'_>, states: ManyItems<bool>, gate: fn(bool, bool) -> bool) -> Option<bool> {
    let mut result = None;
    for (k, state) in states.into_iter().enumerate() {
        match state {
            Some(state) => result = Some(result.map_or(state, |r| gate(r, state))),
            None if context.has_data(k) => return None,
            None => {}
        }
    }
    result
}

/// True when all inputs are. Inputs without data are left out.
#[component("040f195d-0b4e-4fe0-901f-fedb2fd3db15", name = "Gate And", nick = "And", at = "Maths/Operators")]
#[output("Result", "R", "Whether all are true.")]
fn gate_and(
    context: &Context<'_>,
    /// A truth value.
    #[port("A", "A", optional)]
    states: ManyItems<bool>,
) -> Option<bool> {
    fold(context, states, |a, b| a && b)
}

/// True when any input is. Inputs without data are left out.
#[component("5cad70f9-5a53-4c5c-a782-54a479b4abe3", name = "Gate Or", nick = "Or", at = "Maths/Operators")]
#[output("Result", "R", "Whether any is true.")]
fn gate_or(
    context: &Context<'_>,
    /// A truth value.
    #[port("A", "A", optional)]
    states: ManyItems<bool>,
) -> Option<bool> {
    fold(context, states, |a, b| a || b)
}

/// Turns true into false and false into true.
#[component("cb2c7d3c-41b4-4c6d-a6bd-9235bd2851bb", name = "Gate Not", nick = "Not", at = "Maths/Operators")]
#[output("Result", "R", "The opposite.")]
fn gate_not(
    /// A truth value.
    #[port("A", "A")]
    a: bool,
) -> bool {
    !a
}

macro_rules! gates {
    ($($(#[doc = $help:tt])+ $function:ident, $guid:tt, $name:tt, $nick:tt, $gate:expr;)*) => {$(
        $(#[doc = $help])+
        #[component($guid, name = $name, nick = $nick, at = "Maths/Operators")]
        #[output("Result", "R", "The result.")]
        fn $function(
            #[doc = "A truth value."]
            #[port("A", "A")]
            a: bool,
            #[doc = "Another truth value."]
            #[port("B", "B")]
            b: bool,
        ) -> bool {
            let gate: fn(bool, bool) -> bool = $gate;
            gate(a, b)
        }
    )*};
}

gates! {
    /// False when both inputs are true, else true.
    gate_nand, "5ca5de6b-bc71-46c4-a8f7-7f30d7040acb", "Gate Nand", "Nand", |a, b| !(a && b);

    /// True when neither input is.
    gate_nor, "548177c2-d1db-4172-b667-bec979e2d38b", "Gate Nor", "Nor", |a, b| !(a || b);

    /// True when the inputs differ.
    gate_xor, "de4a0d86-2709-4564-935a-88bf4d40af89", "Gate Xor", "Xor", |a, b| a != b;

    /// True when the inputs are the same.
    gate_xnor, "b6aedcac-bf43-42d4-899e-d763612f834d", "Gate Xnor", "Xnor", |a, b| a == b;
}

/// What at least two of three inputs are.
#[component(
    "78669f9c-4fea-44fd-ab12-2a69eeec58de",
    name = "Gate Majority",
    nick = "Vote",
    at = "Maths/Operators"
)]
#[output("Result", "R", "The vote of the majority.")]
fn gate_majority(
    /// A vote.
    #[port("A", "A")]
    a: bool,
    /// A vote.
    #[port("B", "B")]
    b: bool,
    /// A vote.
    #[port("C", "C")]
    c: bool,
) -> bool {
    [a, b, c].into_iter().filter(|vote| *vote).count() >= 2
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Tree;

    #[test]
    fn tables_of_truth() {
        let table = |name: &str| {
            let a = Trial::of(name).list([false, false, true, true]).list([false, true, false, true]);
            a.texts(0)
                .concat()
                .replace("{0}: ", "")
                .replace("False", "0")
                .replace("True", "1")
                .replace(", ", "")
        };
        let names = ["Gate And", "Gate Or", "Gate Nand", "Gate Nor", "Gate Xor", "Gate Xnor"];
        assert_eq!(names.map(table), ["0001", "0111", "1110", "1000", "0110", "1001"]);
        assert_eq!(Trial::of("Gate Not").item(true).texts(0), ["{0}: False"]);
        assert_eq!(Trial::of("Gate Majority").item(true).item(false).item(true).texts(0), ["{0}: True"]);
    }

    #[test]
    fn inputs_without_data_are_left_out_and_nulls_are_not() {
        assert_eq!(Trial::of("Gate And").item(true).tree(Tree::empty()).item(true).texts(0), ["{0}: True"]);
        assert_eq!(Trial::of("Gate Or").item(true).gaps([None::<bool>]).texts(0), ["{0}: null"]);
    }
}
