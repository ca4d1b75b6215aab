//! Display / Graphs.

use katydid_component::component;
use katydid_data::Tree;

/// Shows numbers as a graph, and hands them on.
#[component(
    "2b69bf71-4e69-43aa-b7be-4f6ce7e45bef",
    name = "Quick Graph",
    nick = "Graph",
    at = "Display/Graphs",
    floating
)]
#[output("Graph", "Graph", "The numbers.", kind = Number)]
fn quick_graph(
    /// The numbers.
    #[port("Graph", "Graph", optional, kind = Number)]
    data: &Tree,
) -> Tree {
    data.clone()
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn numbers_pass() {
        assert_eq!(Trial::of("Quick Graph").list([1.5, 2.0]).texts(0), ["{0}: 1.5, 2"]);
    }
}
