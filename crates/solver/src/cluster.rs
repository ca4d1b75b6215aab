//! Clusters: the nested document is solved in place, with the outer data at its inputs.

use std::collections::HashMap;

use katydid_component::Message;
use katydid_data::{Column, Path, Tree};
use katydid_definition::archive::Limits;
use katydid_definition::document::{ClusterContent, Object};
use uuid::Uuid;

use crate::collect;
use crate::engine::solve_nested;
use crate::object::{Turn, output};
use crate::report::{ObjectReport, Status};

/// Solves a cluster; `None` when the object is none.
pub(crate) fn solve(turn: &Turn<'_>, object: &Object, wired: &[Vec<&Tree>]) -> Option<ObjectReport> {
    let content = match object.cluster(&Limits::default())? {
        Ok(content) => content,
        Err(error) => {
            return Some(failed(object, Status::Error, format!("The cluster cannot be opened: {error}")));
        }
    };
    Some(match content {
        ClusterContent::Open { document: inside, hooks } => {
            let lookup = inside.lookup();
            let hook = |port: Uuid| {
                hooks.iter().find(|hook| hook.port == port).and_then(|hook| lookup.object(hook.object))
            };
            let mut messages = Vec::new();
            let mut given = HashMap::new();
            for (k, port) in object.inputs.iter().enumerate() {
                let wires = wired.get(k).map_or(&[][..], Vec::as_slice);
                let collected = collect::port(object, port, None, wires, turn.options);
                messages.extend(collected.messages);
                if let Some(inner) = hook(port.id) {
                    given.insert(inner, collected.tree);
                }
            }
            let reports = solve_nested(&inside, turn, &given);
            for (inner, report) in inside.objects.iter().zip(&reports) {
                messages.extend(
                    report.messages.iter().filter(|m| m.level > katydid_component::Level::Remark).map(
                        |message| Message {
                            text: format!("{}: {}", inner.title(), message.text),
                            ..message.clone()
                        },
                    ),
                );
            }
            let outputs = object
                .outputs
                .iter()
                .enumerate()
                .map(|(k, port)| {
                    let inner = hook(port.id).and_then(|i| reports.get(i));
                    let tree = inner.and_then(|r| r.outputs.first()).cloned().unwrap_or_default();
                    output(object, k, tree, turn.options, &mut messages)
                })
                .collect();
            let status = ObjectReport::status_of(&messages);
            messages.truncate(20);
            ObjectReport { outputs, inside: Some(reports.into()), ..ObjectReport::idle(status, messages, 0) }
        }
        ClusterContent::Locked => {
            failed(object, Status::Unsupported, "The cluster is locked by a password".to_owned())
        }
        ClusterContent::File(path) => failed(
            object,
            Status::Unsupported,
            format!("The cluster lives in another file, {path}: not supported yet"),
        ),
    })
}

fn failed(object: &Object, status: Status, text: String) -> ObjectReport {
    let message = if status == Status::Error { Message::error(text) } else { Message::warning(text) };
    let mut report = ObjectReport::idle(status, vec![message], 0);
    report.outputs = vec![Tree::branch_at(Path::zero(), Column::nulls(1)); object.outputs.len()];
    report
}
