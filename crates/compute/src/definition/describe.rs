//! The reply of `/io`.

use katydid_definition::archive::Chunk;
use katydid_definition::document::Document;
use serde::Serialize;

use super::{Definition, Input, Output, defaults, idle_objects};
use crate::reply::OutputTree;
use crate::request::DATA_VERSION;

/// What `/io` replies: what the definition asks for and gives, from top to bottom of the canvas.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "PascalCase")]
pub struct Description {
    /// What the definition is for, in its author's words.
    pub description: String,
    /// The key by which it is known in later requests.
    pub cache_key: String,
    /// The names of the inputs.
    pub input_names: Vec<String>,
    /// The names of the outputs.
    pub output_names: Vec<String>,
    /// A picture: a PNG of 24 by 24 pixels in base64, or the text of an SVG.
    pub icon: Option<String>,
    /// The inputs.
    pub inputs: Vec<InputDescription>,
    /// The outputs.
    pub outputs: Vec<OutputDescription>,
    /// What one should know.
    pub warnings: Vec<String>,
    /// What is wrong with the definition.
    pub errors: Vec<String>,
}

impl Description {
    /// About how many bytes of memory it takes: most of them are the texts of defaults.
    pub(crate) fn weight(&self) -> usize {
        let items = |input: &InputDescription| -> usize {
            let branches = input.default.inner_tree.iter();
            branches.flat_map(|(_, items)| items).map(|item| size_of_val(item) + item.data.len()).sum()
        };
        let inputs: usize = self.inputs.iter().map(|input| 300 + items(input)).sum();
        300 + inputs + 100 * self.outputs.len() + self.icon.as_ref().map_or(0, String::len)
    }
}

/// An input as a client sees it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "PascalCase")]
pub struct InputDescription {
    /// What its user is asked.
    pub description: Option<String>,
    /// The fewest items; 0 when it may be left out.
    pub at_least: i32,
    /// The most items; 2³¹ − 1 for a list.
    pub at_most: i32,
    /// Whether it takes a whole tree.
    pub tree_access: bool,
    /// What it has when it is left out.
    pub default: OutputTree,
    /// The smallest number it takes.
    pub minimum: Option<f64>,
    /// The largest number it takes.
    pub maximum: Option<f64>,
    /// Its name in requests.
    pub name: String,
    /// Another name: none.
    pub nickname: Option<String>,
    /// The name of its type.
    pub param_type: &'static str,
}

/// An output as a client sees it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "PascalCase")]
pub struct OutputDescription {
    /// Its name in replies.
    pub name: String,
    /// Another name: none.
    pub nickname: Option<String>,
    /// The name of its type.
    pub param_type: &'static str,
}

/// Describes a definition.
pub(super) fn describe(definition: &Definition) -> Description {
    let document = definition.document();
    let interface = definition.interface();
    let defaults = defaults::of(document, &interface.inputs);
    let mut inputs: Vec<_> = interface
        .inputs
        .iter()
        .zip(defaults)
        .map(|(input, default)| {
            let name = document.objects.get(input.object).map_or("", |object| object.name.as_str());
            let (default, _) = OutputTree::of(name, &default, 10 * DATA_VERSION, false);
            (input.height, describe_input(input, default))
        })
        .collect();
    inputs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut outputs: Vec<&Output> = interface.outputs.iter().collect();
    outputs.sort_by(|a, b| a.height.total_cmp(&b.height));
    Description {
        description: definition.about().unwrap_or(&document.header.description).to_owned(),
        cache_key: definition.key().to_owned(),
        input_names: inputs.iter().map(|(_, input)| input.name.clone()).collect(),
        output_names: outputs.iter().map(|output| output.name.clone()).collect(),
        icon: icon(document),
        inputs: inputs.into_iter().map(|(_, input)| input).collect(),
        outputs: outputs
            .into_iter()
            .map(|output| OutputDescription {
                name: output.name.clone(),
                nickname: None,
                param_type: output.type_name,
            })
            .collect(),
        warnings: idle_objects(document),
        errors: interface.problems.clone(),
    }
}

fn describe_input(input: &Input, default: OutputTree) -> InputDescription {
    InputDescription {
        description: input.prompt.clone(),
        at_least: input.at_least,
        at_most: input.at_most,
        tree_access: input.tree_access,
        default,
        minimum: input.minimum,
        maximum: input.maximum,
        name: input.name.clone(),
        nickname: None,
        param_type: input.type_name,
    }
}

/// The picture that its author gave the definition.
fn icon(document: &Document) -> Option<String> {
    let root = document.tree();
    let definition = root.child("Definition").unwrap_or(root);
    let properties: &Chunk = definition.child("DefinitionProperties")?;
    properties.str("IconImageData").filter(|text| !text.trim().is_empty()).map(str::to_owned)
}
