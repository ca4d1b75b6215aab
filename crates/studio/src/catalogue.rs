//! The components as the page lists and explains them.

use std::sync::LazyLock;

use katydid_component::{Access, Component, Port, registry};
use serde_json::{Value, json};
use uuid::Uuid;

fn access(access: Access) -> &'static str {
    match access {
        Access::Item => "item",
        Access::List => "list",
        Access::Tree => "tree",
    }
}

fn port(port: &Port) -> Value {
    json!({
        "name": port.name,
        "nick": port.nick,
        "help": port.help,
        "kind": port.kind.name(),
        "access": access(port.access),
        "optional": port.optional,
        "many": port.many,
    })
}

fn entry(component: &Component) -> Value {
    let variable = |ports: &[Port]| ports.last().is_some_and(|port| port.many);
    json!({
        "guid": component.guid,
        "name": component.name,
        "nick": component.nick,
        "tab": component.tab,
        "panel": component.panel,
        "help": component.help,
        "keywords": keywords(component),
        "floating": component.floating,
        "old": component.old,
        "inputs": component.inputs.iter().map(port).collect::<Vec<_>>(),
        "outputs": component.outputs.iter().map(port).collect::<Vec<_>>(),
        "variableInputs": variable(component.inputs),
        "variableOutputs": variable(component.outputs),
    })
}

/// Words that a component is looked for by, besides its name: the signs of operators, above all.
fn keywords(component: &Component) -> Vec<&'static str> {
    match component.name {
        "Addition" => vec!["+", "add", "plus", "sum"],
        "Subtraction" => vec!["-", "minus", "difference"],
        "Multiplication" => vec!["*", "×", "times", "product"],
        "Division" => vec!["/", "÷", "divide", "quotient"],
        "Integer Division" => vec!["\\"],
        "Modulus" => vec!["%", "mod", "remainder"],
        "Power" => vec!["^", "**", "exponent"],
        "Negative" => vec!["-"],
        "Factorial" => vec!["!"],
        "Larger Than" => vec![">", "≥", "greater"],
        "Smaller Than" => vec!["<", "≤", "less"],
        "Equality" => vec!["=", "==", "≠"],
        "Similarity" => vec!["~", "≈"],
        "Gate And" => vec!["&", "&&"],
        "Gate Or" => vec!["|", "||"],
        "Gate Not" => vec!["!", "not"],
        "Concatenate" => vec!["&", "join text"],
        "Number Slider" => vec!["slider"],
        "Panel" => vec!["//", "text", "note"],
        _ => Vec::new(),
    }
}

/// All components, as a JSON array.
pub fn all() -> &'static str {
    static ALL: LazyLock<String> = LazyLock::new(|| {
        let list: Vec<Value> = registry::all().into_iter().map(entry).collect();
        serde_json::to_string(&list).unwrap_or_default()
    });
    &ALL
}

/// One component with the ids it had before, or why there is none.
pub fn help(guid: Uuid) -> Option<Value> {
    match registry::by_guid(guid) {
        Some(component) => {
            let mut entry = entry(component);
            if let Some(fields) = entry.as_object_mut() {
                fields.insert("also".to_owned(), json!(component.also));
            }
            Some(entry)
        }
        None => registry::unsupported(guid)
            .map(|known| json!({"guid": known.guid, "name": known.name, "unsupported": known.reason})),
    }
}
