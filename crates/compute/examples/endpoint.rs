//! Calls functions by path: reads lines `{"path": ..., "body": ...}` and writes a line for each, with the reply or the
//! fault. A path may have a query.

use std::io::{BufRead as _, Write as _};

use katydid_compute::{Bounds, geometry};
use serde_json::{Value as Json, json};

fn main() -> std::io::Result<()> {
    let mut out = std::io::stdout().lock();
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let request: Json = serde_json::from_str(&line).unwrap_or(Json::Null);
        let path = request.get("path").and_then(Json::as_str).unwrap_or_default();
        // A body is text, as it would travel, or JSON.
        let body = match request.get("body") {
            Some(Json::String(text)) => text.clone(),
            Some(other) => other.to_string(),
            None => String::new(),
        };
        let (path, pairs) = path.split_once('?').unwrap_or((path, ""));
        let pairs = pairs.split('&').filter_map(|pair| pair.split_once('='));
        let bounds = Bounds::default();
        let reply = geometry::Query::read(pairs)
            .and_then(|query| geometry::call(path, &query, body.as_bytes(), &bounds));
        let answer = match reply {
            Ok(reply) => json!({ "path": path, "reply": reply.json }),
            Err(fault) => {
                json!({ "path": path, "cause": format!("{:?}", fault.cause), "fault": fault.message })
            }
        };
        writeln!(out, "{answer}")?;
    }
    Ok(())
}
