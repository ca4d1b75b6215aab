use std::sync::Arc;

use ureq::Error;
use ureq::config::Config;
use ureq::http::Uri;
use ureq::unversioned::resolver::{DefaultResolver, ResolvedSocketAddrs, Resolver};
use ureq::unversioned::transport::NextTimeout;

use super::hosts::{Hosts, Place};
use crate::Fault;

/// Finds the addresses of a host, and gives those that may be asked: the connection goes to one of these.
#[derive(Debug)]
pub(super) struct Listed {
    hosts: Arc<Hosts>,
    system: DefaultResolver,
}

impl Listed {
    pub(super) fn new(hosts: Arc<Hosts>) -> Self {
        Self { hosts, system: DefaultResolver::default() }
    }
}

impl Resolver for Listed {
    fn resolve(
        &self,
        uri: &Uri,
        config: &Config,
        timeout: NextTimeout,
    ) -> Result<ResolvedSocketAddrs, Error> {
        let refused = |fault: Fault| Error::Other(Box::new(fault));
        let place = self.hosts.place(&uri.to_string()).map_err(refused)?;
        let found = self.system.resolve(uri, config, timeout)?;
        let mut allowed = self.empty();
        for address in found.iter().filter(|address| self.hosts.may(&place, address.ip())) {
            allowed.push(*address);
        }
        if allowed.is_empty() {
            let Place { name, .. } = place;
            let text = format!("{name} is in a private network: its address must be listed itself");
            return Err(refused(Fault::refused(text)));
        }
        Ok(allowed)
    }
}
