//! The words of `katydid serve`.

use std::net::IpAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use clap::{Args, ValueEnum};
use katydid_component::Limits;
use katydid_server::compute::{Config, Processes};

use crate::scripts::ScriptArgs;
use crate::web_args::WebArgs;

#[derive(Debug, Args)]
#[command(after_help = "\
The server runs until Ctrl+C or SIGTERM; requests that are under way are finished first, unless it is told a second time.

Hops and the Rhino.Compute clients look for port 6500; for those that look for 5000 or 8081, say --port.

The exit code is 0 when it was ended, 130 or 143 when it was told twice, 2 when the port is taken or a key is missing.")]
pub(crate) struct ServeArgs {
    /// The port; 0 for any that is free
    #[arg(long, value_name = "N", default_value_t = 6500)]
    pub(crate) port: u16,

    /// The address to listen on; 0.0.0.0 for all. Others can ask then, so it needs a key
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1")]
    host: IpAddr,

    /// What clients must send as RhinoComputeKey; the variable RHINO_COMPUTE_KEY when not given
    #[arg(long, value_name = "KEY")]
    key: Option<String>,

    /// A page that may ask from a browser, by its scheme and host, or * for all. When none is named, all may ask with a
    /// key, and without a key those of this machine
    #[arg(long, value_name = "ORIGIN")]
    allow_origin: Vec<String>,

    #[command(flatten)]
    web: WebArgs,

    #[command(flatten)]
    scripts: ScriptArgs,

    /// A folder whose definitions, and those in the folders inside it, a request may name by their paths
    #[arg(long, value_name = "FOLDER")]
    definitions: Vec<PathBuf>,

    /// The most seconds a request may take, waiting included
    #[arg(long, value_name = "SECONDS", default_value_t = 100.0, value_parser = seconds)]
    timeout: f64,

    /// The most seconds a job may run
    #[arg(long, value_name = "SECONDS", default_value_t = 3600.0, value_parser = seconds)]
    job_timeout: f64,

    /// The most bytes of a request, packed and unpacked
    #[arg(long, value_name = "BYTES", default_value_t = 52_428_800)]
    max_body: usize,

    /// The most items one object may put out
    #[arg(long, value_name = "N", default_value_t = Limits::default().items)]
    limit_items: u64,

    /// The most bytes that one solve may take
    #[arg(long, value_name = "BYTES", default_value_t = Limits::default().bytes)]
    limit_bytes: u64,

    /// The most bytes that all requests together may take while they are worked on; four times --limit-bytes when not
    /// given
    #[arg(long, value_name = "BYTES")]
    total_bytes: Option<u64>,

    /// How many solves run at a time; as many as the machine has processors when not given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    workers: Option<u16>,

    /// How many requests may wait for their turn
    #[arg(long, value_name = "N", default_value_t = 1024)]
    queue: usize,

    /// How many jobs are kept, finished ones too
    #[arg(long, value_name = "N", default_value_t = 256)]
    jobs: usize,

    /// For how many seconds the result of a job is kept
    #[arg(long, value_name = "SECONDS", default_value_t = 600.0, value_parser = seconds)]
    keep_jobs: f64,

    /// The most bytes of definitions that are kept for the next request
    #[arg(long, value_name = "BYTES", default_value_t = 256 << 20)]
    cache_bytes: usize,

    /// For how many seconds requests that are under way may go on when the server is to stop
    #[arg(long, value_name = "SECONDS", default_value_t = 30.0, value_parser = seconds)]
    grace: f64,

    /// Works in one process only. Otherwise what is not known to be quick is solved in a second one, with a lower
    /// priority: it holds up nothing else, and if it ends, another is started
    #[arg(long)]
    pub(crate) one_process: bool,

    /// Is the second process
    #[arg(long, hide = true)]
    pub(crate) behind: bool,

    /// How requests are logged, to standard error
    #[arg(long, value_name = "FORM", default_value = "off")]
    pub(crate) log: LogForm,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum LogForm {
    /// Not at all
    Off,
    /// A line each, for people
    Text,
    /// A JSON object each, for programs
    Json,
}

impl ServeArgs {
    /// How the server shall run; `variable` is the key of the environment.
    pub(crate) fn config(&self, variable: Option<String>) -> Result<Config, String> {
        let time = |seconds: f64| Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX);
        Ok(Config {
            processes: Processes::One,
            address: self.host,
            port: self.port,
            key: self.key.clone().or(variable),
            origins: self.allow_origin.clone(),
            hosts: self.web.hosts(),
            definitions: self.folders()?,
            authorities: self.web.certificates()?,
            hops_server: self.web.hops_server.clone(),
            hops_keys: self.web.keys()?,
            timeout: time(self.timeout),
            job_timeout: time(self.job_timeout),
            most_body: self.max_body,
            limits: Limits { items: self.limit_items, ..Limits::default() }.with_bytes(self.limit_bytes),
            total_bytes: self.total_bytes.unwrap_or(self.limit_bytes.saturating_mul(4)),
            workers: self.workers.map(usize::from),
            most_waiting: self.queue,
            most_jobs: self.jobs,
            keep_jobs: time(self.keep_jobs),
            cache_bytes: self.cache_bytes,
            scripts: Some(Arc::new(self.scripts.of_server())),
            grace: time(self.grace),
        })
    }

    /// The folders of definitions.
    fn folders(&self) -> Result<Vec<PathBuf>, String> {
        match self.definitions.iter().find(|folder| !folder.is_dir()) {
            Some(folder) => Err(format!("--definitions {}: there is no such folder", folder.display())),
            None => Ok(self.definitions.clone()),
        }
    }

    pub(crate) fn is_local(&self) -> bool {
        self.host.is_loopback()
    }
}

fn seconds(text: &str) -> Result<f64, String> {
    let seconds: Option<f64> = text.parse().ok();
    let most = 1e6;
    seconds
        .filter(|seconds| *seconds > 0.0 && *seconds <= most)
        .ok_or_else(|| "expected seconds, more than 0 and no more than a million".to_owned())
}
