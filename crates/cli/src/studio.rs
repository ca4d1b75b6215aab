//! `katydid studio`.

use katydid_server::{Config, Server};

use crate::args::StudioArgs;
use crate::output::{BOLD, YELLOW, note, printed, say};
use crate::serving::{self, Signals};

pub(crate) fn studio(args: &StudioArgs) -> Result<u8, String> {
    let config = Config {
        address: args.host,
        port: args.port,
        token: args.token.clone(),
        folders: args.files.clone(),
        file: args.file.clone(),
        model: args.model.clone(),
        player: args.player,
        assistant: args.allow_assistant,
        book: args.book.clone(),
        state: Config::usual_state(),
        scripts: Some(args.scripts.for_studio()),
        ..Config::default()
    };
    serve(config, args.no_open)
}

/// Serves until a signal ends it, after the address is printed and opened in the browser.
pub(crate) fn serve(config: Config, no_open: bool) -> Result<u8, String> {
    let (is_shared, has_files) = (!config.address.is_loopback(), !config.folders.is_empty());
    let lets_in = config.assistant;
    serving::run(async {
        let mut signals = Signals::listen()?;
        let server = katydid_server::start(config).await.map_err(|error| error.to_string())?;
        greet(&server, is_shared, has_files, no_open);
        if lets_in {
            let how = if server.tells_assistants() {
                "katydid mcp --studio"
            } else {
                "katydid mcp --studio ADDRESS"
            };
            note(&format!("{YELLOW}note{YELLOW:#}: an assistant can join with {how}, and edit what is open"));
        }
        printed()?;
        signals.next().await;
        Ok(signals.stopping(server.stop()).await)
    })
}

fn greet(server: &Server, is_shared: bool, has_files: bool, no_open: bool) {
    say(&format!("{BOLD}{}{BOLD:#}", server.url()));
    if is_shared {
        note(&format!("{YELLOW}note{YELLOW:#}: others can join with this address, and change what is open"));
        if !has_files {
            note(
                "definitions read no files of this machine; --files FOLDER lets them read those of a folder",
            );
        }
    }
    if !server.has_page() {
        note(&format!("{YELLOW}note{YELLOW:#}: the page is not built: the address tells how"));
    }
    note("Ctrl+C ends it");
    if !no_open && ::open::that_detached(server.opening()).is_err() {
        note(&format!("{YELLOW}note{YELLOW:#}: no browser could be started: open the address in one"));
    }
}
