//! HoopSnake: a loop whose wires lead back to one object. The solver makes its rounds.

use katydid_component::component;
use katydid_data::{Tree, Value};

/// Gives data out, takes what other objects make of it in, and gives that out in the next round.
///
/// Stands for HoopSnake; our own work. Its wires may lead in a circle. In Grasshopper a user steps it round by hand, or until its third input
/// is false; here it goes round until that is false, and gives what it begins with where nothing is wired to it. The order
/// of its ports is our reading.
#[component(
    "a4e302e5-0c1b-4f7e-9d02-6f1f0a9c5e05",
    name = "HoopSnake",
    nick = "HoopSnake",
    at = "HoopSnake/Loop"
)]
#[output("Feedback", "F", "The state.")]
#[output("History", "H", "The states of all rounds, the number of the round behind each path.")]
#[output("Counter", "i", "The number of rounds.", kind = Integer)]
fn hoopsnake(
    /// What the loop begins with.
    #[port("Start", "S")]
    start: &Tree,
    /// What the other objects made of the state.
    #[port("Data", "D", optional)]
    _data: &Tree,
    /// Whether to go round again.
    #[port("Continue", "B", optional)]
    _go_on: &Tree,
) -> (Tree, Tree, Tree) {
    (start.clone(), start.clone(), Tree::item(Value::Integer(0)))
}
