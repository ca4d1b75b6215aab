//! `katydid serve`.

use std::net::{IpAddr, Ipv4Addr};

use katydid_server::compute::{self, Config, Orders, Processes, Server};

use crate::Program;
use crate::output::{BOLD, YELLOW, note, printed, say};
use crate::serve_args::{LogForm, ServeArgs};
use crate::serving::{self, Signals};

/// Where the key may be when it is not on the command line, where others could see it.
const KEY: &str = "RHINO_COMPUTE_KEY";

pub(crate) fn serve(args: &ServeArgs, program: &Program) -> Result<u8, String> {
    if args.behind {
        return behind(args);
    }
    log(args.log);
    let mut config = args.config(std::env::var(KEY).ok())?;
    if !args.one_process {
        config.processes = Processes::Two(program.again("--behind")?);
        compute::stand_in_front();
    }
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

/// The process that another one has started: it listens to that one only, and ends when that one ends.
fn behind(args: &ServeArgs) -> Result<u8, String> {
    compute::stand_behind();
    let mut input = std::io::stdin().lock();
    let orders = Orders::read(&mut input).map_err(|error| format!("no orders: {error}"))?;
    let config = Config {
        processes: Processes::Behind(orders),
        address: IpAddr::V4(Ipv4Addr::LOCALHOST),
        port: 0,
        origins: Vec::new(),
        ..args.config(None)?
    };
    drop(input);
    serving::run(async {
        // A terminal tells both processes to end: the first one decides when.
        let _signals = Signals::listen()?;
        let server = compute::start(config).await.map_err(|error| error.to_string())?;
        say(server.url());
        printed()?;
        let ended =
            tokio::task::spawn_blocking(|| std::io::copy(&mut std::io::stdin(), &mut std::io::sink()));
        let _ = ended.await;
        Ok(0)
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
