//! Clusters: the nested document is solved in place, with the outer data at its inputs.

use std::collections::HashMap;

use katydid_component::Message;
use katydid_data::{Column, Path, Tree};
use katydid_definition::{ClusterContent, Object};

use crate::collect;
use crate::engine::solve_nested;
use crate::object::{Turn, output};
use crate::report::{ObjectReport, Status};

/// Clusters deeper than this are refused.
const DEEPEST: usize = 16;

/// Solves a cluster; `None` when the object is none.
pub(crate) fn solve(turn: &Turn<'_>, object: &Object, wired: &[Vec<&Tree>]) -> Option<ObjectReport> {
    let content = match object.cluster()? {
        Ok(content) => content,
        Err(error) => {
            return Some(failed(object, Status::Error, format!("The cluster cannot be opened: {error}")));
        }
    };
    Some(match content {
        ClusterContent::Open(open) if turn.depth < DEEPEST => {
            let mut messages = Vec::new();
            let mut given = HashMap::new();
            for (k, port) in object.inputs.iter().enumerate() {
                let wires = wired.get(k).map_or(&[][..], Vec::as_slice);
                let collected = collect::port(object, port, None, wires, &turn.options.rules);
                messages.extend(collected.messages);
                if let Some(inner) = open.hook_index(port.id) {
                    given.insert(inner, collected.tree);
                }
            }
            let reports = solve_nested(&open.document, turn, &given);
            for (inner, report) in open.document.objects().iter().zip(&reports) {
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
                    let inner = open.hook_index(port.id).and_then(|i| reports.get(i));
                    let tree = inner.and_then(|r| r.outputs.first()).cloned().unwrap_or_default();
                    output(object, k, tree, turn.options, &mut messages)
                })
                .collect();
            let status = match ObjectReport::status_of(&messages) {
                // What is not supported inside is not supported outside.
                Status::Warning if reports.iter().any(|r| r.status == Status::Unsupported) => Status::Warning,
                status => status,
            };
            messages.truncate(20);
            ObjectReport { outputs, ..ObjectReport::idle(status, messages, 0) }
        }
        ClusterContent::Open(_) => {
            failed(object, Status::Error, format!("Clusters are nested deeper than {DEEPEST} levels"))
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
