//! `katydid info`.

mod summary;
mod tree;

use katydid_3dm::WarningKind;

use crate::args::InfoArgs;
use crate::output::say;
use crate::{model_file, source};
use summary::Summary;

/// Tells what is in a model, or shows its chunks.
pub(crate) fn info(args: &InfoArgs) -> Result<u8, String> {
    let bytes = source::bytes(&args.file)?;
    if args.tree {
        return tree::show(args, &bytes);
    }
    let model = model_file::read(&args.file, &bytes, args.lenient)?;
    let tables = summary::tables(&bytes).map_err(|error| format!("{}: {error}", args.file.display()))?;
    let summary = Summary::of(&model, tables);
    if args.json {
        let text = summary.to_json(args, &model, bytes.len());
        say(&serde_json::to_string(&text).map_err(|error| error.to_string())?);
    } else {
        summary.print(args, &model, bytes.len());
    }
    Ok(u8::from(summary.has_faults() || !model.warnings.is_empty()))
}

/// The word for a kind of warning.
fn kind_name(kind: WarningKind) -> &'static str {
    match kind {
        WarningKind::LeftOut => "skipped",
        WarningKind::Kept => "kept",
        WarningKind::Checksum => "checksum",
        _ => "warning",
    }
}
