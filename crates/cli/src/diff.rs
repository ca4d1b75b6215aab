//! `katydid diff`.

use katydid_definition::diff::{Change, ChangeKind, Options, compare};
use serde_json::json;

use crate::args::DiffArgs;
use crate::output::{BOLD, DIM, GREEN, RED, YELLOW, say};
use crate::source;

pub(crate) fn diff(args: &DiffArgs) -> Result<u8, String> {
    let (old, new) = (source::document(&args.old)?, source::document(&args.new)?);
    let changes = compare(&old, &new, &Options { layout: args.layout });
    if args.json {
        let list: Vec<serde_json::Value> = changes.iter().map(entry).collect();
        say(&serde_json::to_string(&list).map_err(|error| error.to_string())?);
    } else {
        changes.iter().for_each(print);
    }
    Ok(u8::from(!changes.is_empty()))
}

fn entry(change: &Change) -> serde_json::Value {
    json!({
        "kind": change.kind.name(),
        "clusters": change.clusters,
        "object": change.object,
        "id": change.id,
        "text": change.text,
    })
}

fn print(change: &Change) {
    let (sign, style) = match change.kind {
        ChangeKind::Added => ("+", GREEN),
        ChangeKind::Removed => ("-", RED),
        _ => ("~", YELLOW),
    };
    let inside: String = change.clusters.iter().map(|cluster| format!("{cluster} › ")).collect();
    let Change { object, text, .. } = change;
    let colon = if object.is_empty() { "" } else { ": " };
    say(&format!("{style}{sign}{style:#} {DIM}{inside}{DIM:#}{BOLD}{object}{BOLD:#}{colon}{text}"));
}
