//! TreeSloth: lists.

use katydid_component::{List, component};
use katydid_data::Value;

/// The first and the last item of a list; null where it is empty. Stands for TreeSloth's First/Last.
#[component(
    "3e1c809d-a35b-429c-a01f-151471f5240b",
    name = "First/Last",
    nick = "First/Last",
    at = "TreeSloth/List"
)]
#[output("First Value", "F", "The first item.", kind = Generic)]
#[output("Last Value", "L", "The last item.", kind = Generic)]
fn first_last(
    /// The list.
    #[port("List", "L")]
    list: List<Value>,
) -> (Option<Value>, Option<Value>) {
    let last = list.len().checked_sub(1);
    (list.get(0), last.and_then(|last| list.get(last)))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn ends_of_lists() {
        let trial = || Trial::of("First/Last").list([7, 8, 9]);
        assert_eq!(trial().texts(0), ["{0}: 7"]);
        assert_eq!(trial().texts(1), ["{0}: 9"]);
        assert_eq!(Trial::of("First/Last").list([5]).texts(1), ["{0}: 5"]);
    }
}
