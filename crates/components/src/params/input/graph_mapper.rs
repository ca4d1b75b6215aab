//! The Graph Mapper.

use katydid_component::{Context, Message, component};
use katydid_data::{Gather, Tree};
use katydid_geometry::Interval;

use super::graphs::Graph;

/// Sends numbers through a graph: from the range below it to the range beside it.
///
/// Numbers outside the range below count as its nearer end. Without a graph they are handed on unchanged.
#[component(
    "bc984576-7aa6-491f-a91d-e444c33675a7",
    name = "Graph Mapper",
    nick = "Graph",
    at = "Params/Input",
    floating
)]
#[output("Graph", "Graph", "The heights of the graph.", kind = Number)]
fn graph_mapper(
    context: &Context<'_>,
    /// The numbers to send through.
    #[port("Graph", "Graph", optional, kind = Number)]
    data: &Tree,
) -> Result<Tree, Message> {
    let chunk = context.settings().child("LocalGraph");
    let Some((chunk, graph)) = chunk.and_then(|chunk| Some((chunk, chunk.child("Graph")?))) else {
        return Ok(data.clone());
    };
    let graph = Graph::read(graph)?;
    let domain = chunk.child("Domain");
    let end = |name, default| domain.and_then(|domain| domain.f64(name)).unwrap_or(default);
    let (x0, x1) = (end("x0", 0.0), end("x1", 1.0));
    let y = Interval::new(end("y0", 0.0), end("y1", 1.0));
    let column = data.column();
    let mut heights = Gather::<f64>::with_capacity(column.len());
    for i in 0..column.len() {
        if i % 1024 == 1023 {
            context.check()?;
        }
        let height = |x: f64| {
            let u = (x - x0) / (x1 - x0);
            y.at(graph.at(if u.is_nan() { 0.0 } else { u.clamp(0.0, 1.0) }))
        };
        heights.push(<f64 as katydid_data::Item>::get(column, i).map(height));
    }
    Ok(data.with_column(heights.finish()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_definition::archive::Chunk;

    fn mapper(name: &str, items: &[(&str, f64)]) -> Trial {
        let mut graph = Chunk::new("Graph");
        graph.set("container_name", name);
        items.iter().for_each(|(name, x)| graph.set(name, *x));
        let mut domain = Chunk::new("Domain");
        for (name, x) in [("x0", 0.0), ("x1", 10.0), ("y0", 100.0), ("y1", 200.0)] {
            domain.set(name, x);
        }
        let mut local = Chunk::new("LocalGraph");
        local.set_child(graph);
        local.set_child(domain);
        let mut settings = Chunk::default();
        settings.set_child(local);
        Trial::of("Graph Mapper").settings(settings)
    }

    #[test]
    fn numbers_go_from_range_to_range() {
        let trial = mapper("Power", &[("power", 2.0)]).gaps([Some(5.0), None, Some(20.0)]);
        assert_eq!(trial.texts(0), ["{0}: 125, null, 200"]);
    }

    #[test]
    fn without_a_graph_or_a_formula() {
        assert_eq!(Trial::of("Graph Mapper").list([1, 7]).texts(0), ["{0}: 1, 7"]);
        assert_eq!(mapper("Perlin", &[]).item(1.0).message(), "The graph type Perlin is not supported");
        assert_eq!(mapper("Power", &[]).item(1.0).message(), "The Power graph has no valid power stored");
    }
}
