//! Anemone: loops. The solver makes their rounds (`katydid_solver`); what stands here is what an object gives that has lost the
//! other one of its pair, and the help.

use katydid_component::{Context, Each, ManyTrees, Message, component};
use katydid_data::{Tree, Value};

/// What a start gives before any round: link and counter.
fn before_any_round(data: &ManyTrees<'_>) -> (Tree, Tree, Each<Tree>) {
    let none = || Tree::item(Value::Integer(0));
    (none(), none(), Each(data.iter().map(|&tree| tree.clone()).collect()))
}

/// What an end hands on that no start is linked to.
fn without_start(context: &Context<'_>, data: &ManyTrees<'_>) -> Each<Tree> {
    context.tell(Message::warning(
        "No Loop Start is linked to this: there is no loop, and the data passes through",
    ));
    Each(data.iter().map(|&tree| tree.clone()).collect())
}

/// Begins a loop: gives the data out, and in each further round what the loop's end took in.
///
/// Stands for Anemone's Loop Start; our own work. All that hangs on this and is read by the Loop End that reads the link is
/// solved again and again; objects aside see the last round. The number of rounds is that of Repeat; without one, or with
/// one below zero, the loop goes on until the end's Exit is true, 100 000 rounds at most. The counter begins with 0.
/// In Grasshopper a user watches such a loop and begins it with the trigger; here a definition is run once, so that the loop
/// is run to its end whatever the trigger says. How often Repeat goes round is our reading: so many times as it says.
#[component(
    "a4e302e5-0c1b-4f7e-9d02-6f1f0a9c5e01",
    name = "Loop Start",
    nick = "LoopStart",
    at = "Anemone/Classic"
)]
#[output("Loop", ">", "The link to the Loop End.", kind = Generic)]
#[output("Counter", "C", "The number of the round, from 0.", kind = Integer)]
#[output("Data", "D0", "The state: first the data, then what the end took in.")]
fn loop_start(
    /// The number of rounds; until Exit is true where there is none.
    #[port("Repeat", "R", optional)]
    _repeat: &Tree,
    /// Begins the loop anew in Grasshopper; does nothing here.
    #[port("Trigger", "T", optional)]
    _trigger: &Tree,
    /// What the loop begins with; any number of inputs.
    #[port("Data", "D0", optional)]
    data: ManyTrees<'_>,
) -> (Tree, Tree, Each<Tree>) {
    before_any_round(&data)
}

/// Ends a loop: takes the state in at the end of each round, and gives the last one out.
///
/// Stands for Anemone's Loop End; our own work. The loop stops when its rounds are done, or after the round in which Exit is
/// true. With "record" in its menu it gives the states of all rounds: behind each path stands the number of the round,
/// `{0;0}`, `{0;1}` and so on, which is our reading, as is that the data the loop begins with is no part of it.
#[component(
    "a4e302e5-0c1b-4f7e-9d02-6f1f0a9c5e02",
    name = "Loop End",
    nick = "LoopEnd",
    at = "Anemone/Classic"
)]
#[output("Data", "D0", "The state after the last round, or those of all rounds.")]
fn loop_end(
    context: &Context<'_>,
    /// The link of the Loop Start.
    #[port("Loop", "<")]
    _link: &Tree,
    /// Whether this round is the last.
    #[port("Exit", "E", optional)]
    _exit: &Tree,
    /// The state after the round; an input for each of the start.
    #[port("Data", "D0", optional)]
    data: ManyTrees<'_>,
) -> Each<Tree> {
    without_start(context, &data)
}

/// Begins a loop that is not watched: gives the data out, and in each further round what the loop's end took in.
///
/// Stands for Anemone's Fast Loop Start; our own work. It does what Loop Start does, so many times as Iterations says.
#[component(
    "a4e302e5-0c1b-4f7e-9d02-6f1f0a9c5e03",
    name = "Fast Loop Start",
    nick = "FastStart",
    at = "Anemone/Fast"
)]
#[output("Loop", ">", "The link to the Fast Loop End.", kind = Generic)]
#[output("Counter", "C", "The number of the round, from 0.", kind = Integer)]
#[output("Data", "D0", "The state: first the data, then what the end took in.")]
fn fast_loop_start(
    /// The number of rounds; until Exit is true where there is none.
    #[port("Iterations", "N", optional)]
    _iterations: &Tree,
    /// What the loop begins with; any number of inputs.
    #[port("Data", "D0", optional)]
    data: ManyTrees<'_>,
) -> (Tree, Tree, Each<Tree>) {
    before_any_round(&data)
}

/// Ends a loop that is not watched: takes the state in at the end of each round, and gives the last one out.
///
/// Stands for Anemone's Fast Loop End; our own work. It does what Loop End does.
#[component(
    "a4e302e5-0c1b-4f7e-9d02-6f1f0a9c5e04",
    name = "Fast Loop End",
    nick = "FastEnd",
    at = "Anemone/Fast"
)]
#[output("Data", "D0", "The state after the last round, or those of all rounds.")]
fn fast_loop_end(
    context: &Context<'_>,
    /// The link of the Fast Loop Start.
    #[port("Loop", "<")]
    _link: &Tree,
    /// Whether this round is the last.
    #[port("Exit", "E", optional)]
    _exit: &Tree,
    /// The state after the round; an input for each of the start.
    #[port("Data", "D0", optional)]
    data: ManyTrees<'_>,
) -> Each<Tree> {
    without_start(context, &data)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn a_start_alone_gives_what_it_begins_with() {
        let alone = || Trial::of("Loop Start").item(5).item(true).list([1, 2]);
        assert_eq!(alone().texts(1), ["{0}: 0"]);
        assert_eq!(alone().texts(2), ["{0}: 1, 2"]);
        let end = Trial::of("Fast Loop End").item(0).item(false).list([3]);
        assert!(end.message().contains("No Loop Start"));
    }
}
