//! The chunks that an archive is made of.

use katydid_3dm::{OutlineContent, OutlineCrc, outline};
use serde_json::json;

use crate::args::InfoArgs;
use crate::output::{DIM, GREEN, RED, say};

/// How deep the tree is shown when nobody says: tables, their records, and what records are made of.
const USUAL_DEPTH: usize = 2;

/// Prints every chunk of an archive, broken ones among them.
pub(super) fn show(args: &InfoArgs, bytes: &[u8]) -> Result<u8, String> {
    let mut wrong = 0;
    let mut chunks = Vec::new();
    let walked = outline(bytes, args.depth.unwrap_or(USUAL_DEPTH), |chunk| {
        let (content, crc) = match chunk.content {
            OutlineContent::Value(value) => (format!("= {value}"), ""),
            OutlineContent::Body { length, crc } => {
                wrong += usize::from(crc == OutlineCrc::Wrong);
                (format!("{length} bytes"), crc_name(crc))
            }
        };
        if args.json {
            chunks.push(json!({
                "offset": chunk.offset,
                "depth": chunk.depth,
                "typecode": format!("{:08X}", chunk.typecode),
                "name": chunk.name,
                "class": chunk.class,
                "value": match chunk.content { OutlineContent::Value(value) => Some(value), OutlineContent::Body { .. } => None },
                "length": match chunk.content { OutlineContent::Body { length, .. } => Some(length), OutlineContent::Value(_) => None },
                "crc": crc,
            }));
            return;
        }
        let indent = "  ".repeat(chunk.depth);
        let class = chunk.class.map(|class| format!(" {GREEN}{class}{GREEN:#}")).unwrap_or_default();
        let crc = match crc {
            "wrong" => format!(" {RED}CRC wrong{RED:#}"),
            "" | "none" => String::new(),
            other => format!(" {DIM}CRC {other}{DIM:#}"),
        };
        let name = chunk.name.unwrap_or("unknown");
        say(&format!(
            "{:>10}  {indent}{name}{class} {DIM}{:08X}{DIM:#} {content}{crc}",
            chunk.offset, chunk.typecode
        ));
    });
    let walked = walked.map_err(|error| format!("{}: {error}", args.file.display()))?;
    if args.json {
        let broken = walked.broken.iter().map(|(offset, why)| json!({ "offset": offset, "why": why }));
        let all = json!({
            "file": args.file.display().to_string(),
            "version": walked.version,
            "start": walked.start,
            "ended": walked.ended,
            "broken": broken.collect::<Vec<_>>(),
            "chunks": chunks,
        });
        say(&serde_json::to_string(&all).map_err(|error| error.to_string())?);
    } else {
        for (offset, why) in &walked.broken {
            say(&format!("{offset:>10}  {RED}broken{RED:#}: {why}"));
        }
        if !walked.ended {
            say(&format!("{:>10}  {RED}broken{RED:#}: the archive has no end mark", bytes.len()));
        }
    }
    Ok(u8::from(wrong > 0 || !walked.broken.is_empty() || !walked.ended))
}

fn crc_name(crc: OutlineCrc) -> &'static str {
    match crc {
        OutlineCrc::Absent => "none",
        OutlineCrc::Right => "right",
        OutlineCrc::Wrong => "wrong",
        OutlineCrc::Unknown => "not checked",
    }
}
