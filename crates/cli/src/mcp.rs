//! `katydid mcp`.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use katydid_assistant::{Config, StudioAddress};

use crate::scripts::ScriptArgs;
use crate::serving;

/// What an assistant may do.
#[derive(Debug, Args)]
#[command(after_help = "\
An assistant's program starts this command by itself, and speaks with it over the standard input and output; docs/assistants.md
tells how to set one up. Nothing is read or written but what lies below the folders that are named.")]
pub(crate) struct McpArgs {
    /// A folder whose files may be opened, and in which files may be saved; may be given several times. Without one there are
    /// no files, only what is made in memory
    #[arg(long = "folder", value_name = "FOLDER")]
    folders: Vec<PathBuf>,

    /// Work on what is open in a studio of this machine, started with --allow-assistant: the person sees each edit, and can
    /// take it back. The one started last, or the one at this address, as it was printed
    #[arg(long, value_name = "URL", num_args = 0..=1, default_missing_value = "")]
    studio: Option<String>,

    /// The folder of a book whose pages can be read, besides the definitions that come with Katydid
    #[arg(long, value_name = "FOLDER")]
    book: Option<PathBuf>,

    /// The most seconds of one solve
    #[arg(long, value_name = "SECONDS", default_value_t = 120.0, value_parser = seconds)]
    limit_seconds: f64,

    /// The most bytes of one solve
    #[arg(long, value_name = "N", default_value_t = 2 << 30)]
    limit_bytes: u64,

    #[command(flatten)]
    scripts: ScriptArgs,
}

fn seconds(text: &str) -> Result<f64, String> {
    let seconds: Option<f64> = text.parse().ok();
    seconds
        .filter(|s| *s > 0.0 && *s <= 1e6)
        .ok_or_else(|| "expected seconds, more than 0 and no more than a million".to_owned())
}

/// Where the studio is.
fn studio(url: &str) -> Result<StudioAddress, String> {
    if !url.is_empty() {
        return Ok(StudioAddress::Url(url.to_owned()));
    }
    let state = katydid_server::Config::usual_state();
    let state =
        state.ok_or("--studio: there is no folder in which a studio tells its address: give the address")?;
    Ok(StudioAddress::File(katydid_server::Config::address_file(&state)))
}

pub(crate) fn mcp(args: &McpArgs) -> Result<u8, String> {
    let scripts = args.scripts.clone();
    let config = Config {
        folders: args.folders.clone(),
        book: args.book.clone(),
        studio: args.studio.as_deref().map(studio).transpose()?,
        scripts: Some(Arc::new(move |file: Option<&Path>| match file {
            Some(file) => scripts.scripts(file),
            None => scripts.of_no_file(),
        })),
        seconds: args.limit_seconds,
        bytes: args.limit_bytes,
    };
    serving::run(async {
        let mut signals = serving::Signals::listen()?;
        tokio::select! {
            served = katydid_assistant::serve(config) => served.map(|()| 0),
            code = signals.next() => Ok(code),
        }
    })
}
