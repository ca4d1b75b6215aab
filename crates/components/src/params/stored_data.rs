//! Params / Util: data that files keep from one definition to another.

use katydid_component::{Context, Each, ManyTrees, Message, component, stored};
use katydid_data::Tree;
use katydid_definition::archive::{self, Chunk, Limits};
use katydid_definition::document::Persistent;

/// Chunks in chunks beyond this depth are not looked into.
const DEEPEST: usize = 20;

/// The data trees of a .ghdata file, in the order in which they stand.
///
/// The format is not documented: it is an archive as definitions are, and whatever in it is laid out as the stored
/// values of a parameter are is a tree.
fn trees(chunk: &Chunk, depth: usize, found: &mut Vec<Persistent>) {
    if !chunk.children("Branch").is_empty() {
        let mut values = chunk.clone();
        "PersistentData".clone_into(&mut values.name);
        let holder = Chunk { chunks: vec![values], ..Chunk::new("Holder") };
        found.extend(Persistent::read(&holder));
        return;
    }
    if let Some(depth) = depth.checked_sub(1) {
        chunk.chunks.iter().for_each(|inner| trees(inner, depth, found));
    }
}

/// The path of the file among the settings: the text that ends as such files do, else that of Destination.
fn path(settings: &Chunk) -> Option<&str> {
    let texts = settings.items.iter().filter_map(|item| item.value.as_str());
    let named = |text: &&str| text.trim().to_ascii_lowercase().ends_with(".ghdata");
    texts
        .filter(|text| !text.trim().is_empty())
        .find(named)
        .or_else(|| settings.str("Destination").filter(|path| !path.trim().is_empty()))
}

/// Takes in data that another definition handed over through a .ghdata file: a tree for each output, in order.
///
/// How Grasshopper lays such files out is not documented: whatever in the file is laid out as stored values are is read. A
/// path that is not absolute starts where the definition lies, and what is not found there is looked for in its folder.
#[component("d8033e3f-8387-4ffc-ab99-929218e8c740", name = "Data Input", nick = "Input", at = "Params/Util")]
#[output("Data Output", "A", "A tree of the file.")]
fn data_input(context: &Context<'_>) -> Result<Each<Tree>, Message> {
    let path = path(context.settings()).ok_or_else(|| Message::error("No file is chosen"))?;
    let bytes = context.read_file(path)?;
    let archive = archive::read(&bytes, &Limits::default())
        .map_err(|error| Message::error(format!("{path} is no file of stored data: {error}")))?;
    let mut found = Vec::new();
    trees(&archive.root, DEEPEST, &mut found);
    context
        .tell(Message::remark("The format of .ghdata files is not documented: the data is our best reading"));
    let outputs = context.output_count();
    if found.len() != outputs {
        context.warn(format!("The file has {} trees for {outputs} outputs", found.len()));
    }
    let mut read = Vec::with_capacity(outputs);
    for persistent in found.iter().take(outputs) {
        context.items(persistent.count())?;
        let (tree, messages) = stored::tree(persistent, context.model());
        messages.into_iter().for_each(|message| context.tell(message));
        read.push(tree);
    }
    read.resize(outputs, Tree::empty());
    Ok(Each(read))
}

/// Keeps content of a Rhino document under a name.
///
/// There is no document beside a definition that runs here: nothing is baked, cleared or taken from one. The name and the
/// content pass on, and a remark says so.
#[component(
    "1fae4c7a-d84a-4f04-8400-179e13193381",
    name = "Content Cache",
    nick = "Cache",
    at = "Params/Util"
)]
#[output("Output", "O", "Name and content as they came; results of actions are empty.")]
fn content_cache(
    context: &Context<'_>,
    /// The name, the content, and what to do with it.
    #[port("Input", "I", optional)]
    inputs: ManyTrees<'_>,
) -> Each<Tree> {
    context.tell(Message::remark("There is no Rhino document to keep content in: the content passes on"));
    // Name and content stand first on both sides; behind them are results, which there are none of.
    let passed = inputs.iter().take(2).map(|&tree| tree.clone());
    Each(passed.chain(std::iter::repeat(Tree::empty())).take(context.output_count()).collect())
}

/// Takes values in. What Grasshopper does with them is not documented.
#[component(
    "d2a31d0a-8a1c-4ffb-b3c7-96931fee6c34",
    name = "PersistentValues",
    nick = "PersistentValues",
    at = "Params/Util"
)]
fn persistent_values(
    context: &Context<'_>,
    /// Values of any type.
    #[port("Value", "V", optional)]
    _values: ManyTrees<'_>,
) {
    context.tell(Message::remark(
        "What this object does is not documented: it takes its values and gives nothing",
    ));
}

#[cfg(test)]
mod tests {
    use katydid_component::Files;
    use katydid_component::testing::{Trial, texts};
    use katydid_definition::archive::{Chunk, write_gh, write_ghx};
    use katydid_definition::document::{Branch, Persistent, Stored};

    fn folder(name: &str) -> std::path::PathBuf {
        let folder = std::env::temp_dir().join(format!("katydid-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        folder
    }

    /// An archive of two trees, one of them deep inside.
    fn archive() -> Chunk {
        let first = Persistent {
            branches: vec![
                Branch { path: vec![0, 1], items: vec![Stored::Number(1.5), Stored::Null] },
                Branch { path: vec![2], items: vec![Stored::Text("a".into())] },
            ],
        };
        let mut data = Chunk::new("Data");
        data.chunks =
            vec![Chunk { name: "Tree".into(), ..Persistent::item(Stored::Boolean(true)).to_chunk(true) }];
        let mut root = Chunk::new("Root");
        root.chunks = vec![Chunk { name: "A".into(), ..first.to_chunk(true) }, data];
        root
    }

    #[test]
    fn trees_are_found_in_either_form_of_archive() {
        let folder = folder("ghdata");
        std::fs::write(folder.join("a.ghdata"), write_gh(&archive()).unwrap()).unwrap();
        std::fs::write(folder.join("b.ghdata"), write_ghx(&archive()).unwrap()).unwrap();
        std::fs::write(folder.join("c.ghdata"), "no archive").unwrap();
        let trial = |path: &str| {
            let trial = Trial::of("Data Input").files(Files::Inside(folder.clone()));
            trial.setting("Destination", path).outputs(2)
        };
        // The folder of another machine: the file lies beside the definition.
        for path in ["a.ghdata", "C:\\Temp\\b.ghdata"] {
            let out = trial(path).run();
            assert_eq!(texts(&out.outputs[0]), ["{0;1}: 1.5, null", "{2}: a"]);
            assert_eq!(texts(&out.outputs[1]), ["{0}: True"]);
        }
        assert!(trial("a.ghdata").outputs(3).run().messages.iter().any(|m| m.text.contains("2 trees for 3")));
        assert!(trial("c.ghdata").message().contains("no file of stored data"));
        assert_eq!(Trial::of("Data Input").message(), "No file is chosen");
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn content_passes_on() {
        let out = Trial::of("Content Cache").item("name").list([1, 2]).item("Bake").outputs(3).run();
        assert_eq!(texts(&out.outputs[0]), ["{0}: name"]);
        assert_eq!(texts(&out.outputs[1]), ["{0}: 1, 2"]);
        assert!(out.outputs[2].is_empty());
        assert!(Trial::of("PersistentValues").item(1).run().outputs.is_empty());
    }
}
