//! Params / Util: relays, hooks of clusters, viewers, and what gives results to the outside.

use katydid_component::{Context, Each, ManyTrees, Message, component};
use katydid_data::{Column, Path, Tree, Value};

parameters! {
    /// Hands data on, unchanged: a bend in a wire.
    relay, "b6236720-8d88-4289-93c3-ac4c99f9b97b", "Relay", "", "Params/Util", Generic;

    /// Data that comes into a cluster from outside.
    cluster_input, "448de216-3a12-43cf-a135-e3bfafc87744", "Cluster Input", "Input", "Params/Util", Generic;

    /// Data that a cluster gives to the outside.
    cluster_output, "a4b285fe-2e13-4204-b65c-189aa6704da5", "Cluster Output", "Output", "Params/Util", Generic;

    /// Collects data over time. A single solution has only the data of the moment, which it hands on.
    ///
    /// In a run in time (`katydid run FILE --ticks N`) what comes in with each solution stands behind what came before,
    /// branch by branch. With a limit, each branch keeps that many of its newest items. A recorder that is switched off
    /// keeps what it has. A loop of wires that leads through a recorder is closed from one tick to the next.
    data_recorder, "401aa475-997a-4139-991d-f980ffdcf908", "Data Recorder", "Rec", "Params/Util", Generic;
}

/// Shows the shape of a data tree: its paths, and how many items each has. What it gives is the paths.
#[component(
    "72a29b54-2e48-474b-a400-d2124c4edf79",
    name = "Param Viewer",
    nick = "Viewer",
    at = "Params/Util",
    floating
)]
#[output("Param Viewer", "Viewer", "The paths of the data, one for each branch.", kind = Path)]
fn param_viewer(
    context: &Context<'_>,
    /// The data to show.
    #[port("Param Viewer", "Viewer", optional)]
    data: &Tree,
) -> Result<Tree, Message> {
    context.items(data.branch_count())?;
    let paths: Vec<Value> = data.paths().iter().cloned().map(Value::Path).collect();
    Ok(if paths.is_empty() {
        Tree::empty()
    } else {
        Tree::branch_at(Path::zero(), Column::of_values(paths, None))
    })
}

/// Holds data back for a while, so that what is slow is not solved with every change before it. A single solution waits
/// for nothing: the data is handed on at once.
///
/// In a run in time (`katydid run FILE --ticks N`) a dam with a delay lets the newest data through once so much time
/// has passed since data came that it has not let through; one without a delay hands on at once. A loop of wires that
/// leads through a dam is closed after its delay, or with the next tick. What Grasshopper's modes of dams mean is not
/// documented: the delay alone counts.
#[component("65283518-ad00-49d3-87fb-f76823ebb162", name = "Data Dam", nick = "Dam", at = "Params/Util")]
#[output("Data A", "A", "The data that has passed.")]
fn data_dam(
    /// Data to hold back.
    #[port("Data A", "A", optional)]
    data: ManyTrees<'_>,
) -> Each<Tree> {
    Each(data.iter().map(|&tree| tree.clone()).collect())
}

/// Solves what lies elsewhere: a component of a server such as ghhops-server, or a definition.
///
/// The component keeps the address (`http://localhost:5000/add`, `https://example.org/roof.gh`), the path of a file or a
/// definition of its own, and has the inputs and outputs of what lies there. An input that takes items is asked for
/// once for each. Only hosts that are allowed are asked: `--allow-url localhost:5000` names one. Definitions call one
/// another ten times at most.
#[component("c69bb52c-88ba-4640-b69f-188d111029e8", name = "Hops", nick = "Hops", at = "Params/Util")]
#[output("Output", "O", "A result of what lies elsewhere.")]
fn hops(
    /// An input of what lies elsewhere.
    #[port("Input", "I", optional)]
    inputs: ManyTrees<'_>,
) -> Result<Each<Tree>, Message> {
    let _ = inputs;
    Err(Message::error("Nothing that lies elsewhere can be solved here"))
}

/// A result of the definition: geometry for whoever solves it, under the component's name.
#[component(
    "ae2531b4-bab2-4bb1-b5bf-f2143d10c132",
    name = "Context Bake",
    nick = "Context Bake",
    at = "Params/Util"
)]
fn context_bake(
    /// The geometry to give out.
    #[port("Geometry", "Geometry")]
    _geometry: &Tree,
) {
}

/// A result of the definition: texts for whoever solves it, under the component's name.
#[component(
    "73215ec5-0eb5-4f85-9e07-b09c4590ce2b",
    name = "Context Print",
    nick = "Context Print",
    at = "Params/Util"
)]
fn context_print(
    /// The texts to give out.
    #[port("Text", "Tx", kind = Text)]
    _text: &Tree,
) {
}

/// Has its targets solved again at regular times. A single solution takes no notice of it.
///
/// In a run in time (`katydid run FILE --ticks N`) it fires every so many milliseconds, in the definition's own time:
/// its targets expire, and they and what hangs on them are solved again. A trigger without an interval, which is fired
/// by hand in Grasshopper, fires as often as the fastest of the others.
#[component("5a2b0735-ba98-4b7d-a7d3-c1dfc04475ad", name = "Trigger", nick = "Timer", at = "Params/Util")]
fn trigger() {}

/// Picks one item of a tree: the item at the stored index of the stored path.
///
/// Gives a null and a warning when the tree has no such place.
#[component(
    "0ab6acbf-40a6-40e1-a14e-cf0c06268e68",
    name = "Cherry Picker",
    nick = "Item",
    at = "Params/Util",
    floating
)]
#[output("Item", "Item", "The item.")]
fn cherry_picker(
    context: &Context<'_>,
    /// The tree to pick from.
    #[port("Item", "Item", optional)]
    data: &Tree,
) -> Result<Option<Value>, Message> {
    if data.is_empty() {
        return Ok(None);
    }
    let settings = context.settings();
    let path = settings.child("TreePath").and_then(|chunk| chunk.str("path")).unwrap_or("{0}");
    let path: Path = path.parse().map_err(|_| Message::error(format!("{path} is not a path")))?;
    let index = settings.i32("ListIndex").unwrap_or(0);
    let branch = data.branches().find(|branch| *branch.path() == path);
    let item = branch.zip(usize::try_from(index).ok()).filter(|(branch, i)| *i < branch.len());
    if item.is_none() {
        context.warn(format!("There is no item {index} at {path}"));
    }
    Ok(item.and_then(|(branch, i)| branch.get(i)))
}

/// A list of numbers to be varied, each by a slider of its own or by an optimiser.
#[component(
    "21553c44-ea62-475e-a8bb-62b2a3ee5ca5",
    name = "Gene Pool",
    nick = "Genes",
    at = "Params/Util",
    floating
)]
#[output("Genes", "Genes", "The numbers.", kind = Number)]
fn gene_pool(
    context: &Context<'_>,
    /// Not used: the numbers are stored in the pool.
    #[port("Genes", "Genes", optional, kind = Number)]
    _data: &Tree,
) -> Result<Vec<f64>, Message> {
    let data = context.settings().child("GeneData");
    let data = data.ok_or_else(|| Message::error("The pool holds no numbers"))?;
    let places = usize::try_from(data.i32("Decimals").unwrap_or(12).clamp(0, 12)).unwrap_or(12);
    let rounded = |x: f64| format!("{x:.places$}").parse().unwrap_or(x);
    Ok(data.list("Value").into_iter().filter_map(|(_, value)| value.as_f64()).map(rounded).collect())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_definition::archive::Chunk;

    #[test]
    fn parameters_hand_their_data_on() {
        let trial = Trial::of("Relay").branches([("{0;1}", [1.5, 2.0]), ("{3}", [4.0, 5.0])]);
        assert_eq!(trial.texts(0), ["{0;1}: 1.5, 2", "{3}: 4, 5"]);
        // Trial casts as the solver does.
        assert_eq!(Trial::of("Integer").list([2.5, 3.5]).texts(0), ["{0}: 2, 4"]);
        assert!(Trial::of("Number").texts(0).is_empty());
    }

    #[test]
    fn a_viewer_gives_the_paths() {
        let trial = Trial::of("Param Viewer").branches([("{0;1}", [1.5, 2.0]), ("{3}", [4.0, 5.0])]);
        assert_eq!(trial.texts(0), ["{0}: {0;1}, {3}"]);
        assert!(Trial::of("Param Viewer").texts(0).is_empty());
    }

    #[test]
    fn a_dam_hands_on_each_of_its_trees() {
        let out = Trial::of("Data Dam").item(1.0).branches([("{5;0}", ["a"])]).outputs(2).run();
        assert_eq!(
            (texts(&out.outputs[0]), texts(&out.outputs[1])),
            (vec!["{0}: 1".into()], vec!["{5;0}: a".into()])
        );
    }

    #[test]
    fn sinks_take_their_data_and_give_none() {
        for name in ["Context Bake", "Context Print"] {
            let out = Trial::of(name).list(["a", "b"]).run();
            assert!(out.outputs.is_empty() && out.messages.is_empty());
        }
        assert!(Trial::of("Trigger").run().outputs.is_empty());
    }

    #[test]
    fn a_cherry_picker_finds_its_item_or_says_so() {
        let mut path = Chunk::new("TreePath");
        path.set("path", "{0;1}");
        let mut settings = Chunk::default();
        settings.set_child(path);
        settings.set("ListIndex", 1);
        let data = [("{0;0}", ["a", "b"]), ("{0;1}", ["c", "d"])];
        let trial = || Trial::of("Cherry Picker").branches(data).settings(settings.clone());
        assert_eq!(trial().texts(0), ["{0}: d"]);
        assert_eq!(trial().setting("ListIndex", 7).message(), "There is no item 7 at {0;1}");
        assert_eq!(trial().setting("ListIndex", -1).texts(0), ["{0}: null"]);
    }

    #[test]
    fn a_gene_pool_gives_its_numbers() {
        let mut data = Chunk::new("GeneData");
        data.set("Decimals", 1);
        data.set_at("Value", 0, 0.26);
        data.set_at("Value", 1, 3.0);
        let mut settings = Chunk::default();
        settings.set_child(data);
        assert_eq!(Trial::of("Gene Pool").settings(settings).texts(0), ["{0}: 0.3, 3"]);
        assert_eq!(Trial::of("Gene Pool").message(), "The pool holds no numbers");
    }
}
