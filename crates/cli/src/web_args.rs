//! The words on other hosts that may be asked.

use std::path::PathBuf;

use clap::Args;
use katydid_compute::{HopsSettings, HostKey, WebSettings};

use crate::source;

/// Which other hosts may be asked.
#[derive(Debug, Args)]
pub(crate) struct WebArgs {
    /// A host that definitions may be fetched from and Hops components may ask, as example.org or 127.0.0.1:3000
    #[arg(long, value_name = "HOST")]
    pub(crate) allow_url: Vec<String>,

    /// The server that solves definitions which Hops components name by an address; they are solved here when not given
    #[arg(long, value_name = "URL")]
    pub(crate) hops_server: Option<String>,

    /// The key of a server that Hops components ask, as 127.0.0.1:6500=KEY; better in a file, where others do not see it
    #[arg(long, value_name = "HOST=KEY")]
    hops_key: Vec<String>,

    /// A file with such keys, one a line; lines that begin with # do not count
    #[arg(long, value_name = "FILE")]
    hops_keys: Option<PathBuf>,

    /// Certificates (PEM) of the authorities to believe over https, in place of those that browsers believe
    #[arg(long, value_name = "FILE")]
    pub(crate) authorities: Option<PathBuf>,
}

impl WebArgs {
    pub(crate) fn web(&self) -> Result<WebSettings, String> {
        Ok(WebSettings { hosts: self.hosts(), authorities: self.certificates()?, ..WebSettings::default() })
    }

    pub(crate) fn hops(&self) -> Result<HopsSettings, String> {
        Ok(HopsSettings { server: self.hops_server.clone(), keys: self.keys()?, ..HopsSettings::default() })
    }

    /// The keys of other servers: those on the command line go before those in the file.
    pub(crate) fn keys(&self) -> Result<Vec<HostKey>, String> {
        let given = self
            .hops_key
            .iter()
            .map(|text| HostKey::read(text).map_err(|fault| format!("--hops-key: {}", fault.message)));
        let mut keys = given.collect::<Result<Vec<_>, _>>()?;
        let Some(path) = &self.hops_keys else { return Ok(keys) };
        let text = String::from_utf8(source::bytes(path)?);
        let text = text.map_err(|_| format!("{}: it is no text", path.display()))?;
        for (line, text) in (1..).zip(text.lines().map(str::trim)) {
            if text.is_empty() || text.starts_with('#') {
                continue;
            }
            let key = HostKey::read(text);
            keys.push(key.map_err(|fault| format!("{}, line {line}: {}", path.display(), fault.message))?);
        }
        Ok(keys)
    }

    /// The hosts on the list; a server that is named may be asked too.
    pub(crate) fn hosts(&self) -> Vec<String> {
        let server = self.hops_server.iter().map(|url| {
            let rest = url.split_once("://").map_or(url.as_str(), |(_, rest)| rest);
            rest.split('/').next().unwrap_or(rest).to_owned()
        });
        self.allow_url.iter().cloned().chain(server).collect()
    }

    /// What the file of certificates holds; nothing when none is named.
    pub(crate) fn certificates(&self) -> Result<Vec<u8>, String> {
        let Some(path) = &self.authorities else { return Ok(Vec::new()) };
        let bytes = source::bytes(path)?;
        match String::from_utf8_lossy(&bytes).contains("BEGIN CERTIFICATE") {
            true => Ok(bytes),
            false => Err(format!("{}: no certificate in PEM form is in it", path.display())),
        }
    }
}
