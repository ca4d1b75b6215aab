//! `katydid serve`.

use katydid_server::compute::{self, Server};

use crate::output::{BOLD, YELLOW, note, printed, say};
use crate::serve_args::{LogForm, ServeArgs};
use crate::serving::{self, Signals};

/// Where the key may be when it is not on the command line, where others could see it.
const KEY: &str = "RHINO_COMPUTE_KEY";

pub(crate) fn serve(args: &ServeArgs) -> Result<u8, String> {
    log(args.log);
    let config = args.config(std::env::var(KEY).ok())?;
    serving::run(async {
        let mut signals = Signals::listen()?;
        let has_key = config.key.as_deref().is_some_and(|key| !key.trim().is_empty());
        let server = compute::start(config).await.map_err(|error| error.to_string())?;
        greet(&server, args, has_key);
        printed()?;
        signals.next().await;
        note("ending: requests that are under way are finished; a second signal ends at once");
        Ok(signals.stopping(server.stop()).await)
    })
}

fn greet(server: &Server, args: &ServeArgs, has_key: bool) {
    say(&format!("{BOLD}{}{BOLD:#}", server.url()));
    note(&format!("{}docs explains the addresses and tries them; Ctrl+C ends it", server.url()));
    if !args.is_local() {
        note(&format!(
            "{YELLOW}note{YELLOW:#}: others can ask, with the key; nothing is encrypted: put a proxy with TLS before it"
        ));
    } else if !has_key {
        note("only programs and web pages of this machine can ask, without a key");
    }
}

/// Lines to standard error. Neither bodies nor keys nor what clients write into addresses are in them.
fn log(form: LogForm) {
    let lines = tracing_subscriber::fmt().with_writer(std::io::stderr);
    // Only fails when lines are written already.
    let _ = match form {
        LogForm::Off => Ok(()),
        LogForm::Text => lines.with_ansi(false).try_init(),
        LogForm::Json => lines.json().flatten_event(true).try_init(),
    };
}
