//! The hosts that may be asked, and what an address says of its host.

use std::net::IpAddr;

use ureq::http::Uri;

use super::address::is_public;
use crate::Fault;

/// No address is longer.
const LONGEST: usize = 4096;

/// The hosts that may be asked.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Hosts(Vec<Host>);

/// A host, at any port where none is named.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Host {
    name: String,
    port: Option<u16>,
}

/// The host of an address.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Place {
    /// The name in lower case, without a last dot and without brackets.
    pub(super) name: String,
    pub(super) port: u16,
}

impl Hosts {
    /// Reads a list of hosts; a scheme before them and a slash after them do not count.
    pub(super) fn new(listed: &[String]) -> Self {
        Self(listed.iter().map(|text| Host::new(text)).collect())
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Takes an address apart, if its host may be asked.
    ///
    /// # Errors
    /// `BadRequest` for what is no address, `Refused` for another scheme than http and https and for a host that is
    /// not listed.
    pub(super) fn place(&self, url: &str) -> Result<Place, Fault> {
        if url.len() > LONGEST {
            return Err(no_address());
        }
        let (scheme, _) = url.trim().split_once("://").ok_or_else(no_address)?;
        if !["http", "https"].iter().any(|known| scheme.eq_ignore_ascii_case(known)) {
            return Err(Fault::refused("only http and https addresses are asked"));
        }
        let place = Place::of(&url.trim().parse().map_err(|_| no_address())?)?;
        if self.is_empty() {
            return Err(Fault::refused("nothing is fetched from elsewhere here"));
        }
        if !self.lists(&place.name, place.port) {
            let text = format!("{}:{} is not among the hosts that may be asked", place.name, place.port);
            return Err(Fault::refused(text));
        }
        Ok(place)
    }

    /// Whether an address that was found for a host may be asked: one of the open internet, or one that is listed
    /// itself. `localhost`, once listed, is this machine.
    pub(super) fn may(&self, place: &Place, address: IpAddr) -> bool {
        let is_here = place.name == "localhost" || place.name.ends_with(".localhost");
        is_public(address)
            || self.lists(&address.to_string(), place.port)
            || (is_here && address.is_loopback())
    }

    fn lists(&self, name: &str, port: u16) -> bool {
        self.0.iter().any(|host| host.name == name && host.port.is_none_or(|own| own == port))
    }
}

impl Host {
    fn new(text: &str) -> Self {
        let text = text.trim();
        let text = text.strip_prefix("http://").or_else(|| text.strip_prefix("https://")).unwrap_or(text);
        let text = text.trim_end_matches('/').to_ascii_lowercase();
        let (name, port) = match text.rsplit_once(':') {
            Some((name, port)) if !name.ends_with(':') && (!name.contains(':') || name.ends_with(']')) => {
                match port.parse() {
                    Ok(port) => (name.to_owned(), Some(port)),
                    Err(_) => (text, None),
                }
            }
            _ => (text, None),
        };
        Self { name: name.trim_matches(['[', ']']).to_owned(), port }
    }
}

impl Place {
    /// The host of an address: of the very form that is asked, so that no two readings of it differ.
    ///
    /// # Errors
    /// `BadRequest` for an address that names a user, no host, or a port that is none.
    pub(super) fn of(uri: &Uri) -> Result<Self, Fault> {
        let authority = uri.authority().filter(|authority| !authority.as_str().contains('@'));
        let authority = authority.ok_or_else(no_address)?;
        let name = authority.host().trim_matches(['[', ']']).trim_end_matches('.').to_ascii_lowercase();
        if name.is_empty() {
            return Err(no_address());
        }
        let port = match authority.port() {
            Some(port) => port.as_u16(),
            // A port that is none, or that is empty, is not taken for the usual one.
            None if authority.as_str().contains("]:") || authority.as_str().matches(':').count() == 1 => {
                return Err(no_address());
            }
            None if uri.scheme_str() == Some("https") => 443,
            None => 80,
        };
        Ok(Self { name, port })
    }
}

/// The scheme and the host of an address as they stand in it: `http://example.org:8080`.
///
/// # Errors
/// `BadRequest` for what is no address.
pub(crate) fn authority(url: &str) -> Result<String, Fault> {
    let uri: Uri = url.trim().parse().map_err(|_| no_address())?;
    Place::of(&uri)?;
    match (uri.scheme_str(), uri.authority()) {
        (Some(scheme), Some(authority)) => Ok(format!("{scheme}://{authority}")),
        _ => Err(no_address()),
    }
}

fn no_address() -> Fault {
    Fault::bad_request("this is no address of a host")
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;
    use crate::Cause;

    fn cause(hosts: &Hosts, url: &str) -> Option<Cause> {
        hosts.place(url).err().map(|fault| fault.cause)
    }

    #[test]
    fn only_hosts_that_are_listed_are_asked() {
        let listed = ["Example.org", "127.0.0.1:3000", "[::1]:3000", "http://files.example/"];
        let hosts = Hosts::new(&listed.map(str::to_owned));
        for url in [
            "http://example.org/a.gh",
            "https://example.org/a.gh",
            "HTTP://EXAMPLE.ORG:8080/",
            "http://127.0.0.1:3000/definition/1?x=2",
            "http://[::1]:3000/a",
            "http://files.example",
            "http://example.org./a",
        ] {
            assert_eq!(cause(&hosts, url), None, "{url}");
        }
        for url in [
            "http://evil.example/a.gh",
            "http://127.0.0.1:3001/",
            "https://127.0.0.1/",
            "http://example.org.evil/",
            "ftp://example.org/",
            "file:///etc/passwd",
            "gopher://example.org/",
        ] {
            assert_eq!(cause(&hosts, url), Some(Cause::Refused), "{url}");
        }
        for url in [
            "http://user@example.org/",
            "http://example.org@evil.example/",
            "http://a\\@example.org/",
            "http:///a",
            "http://example.org:99999/",
            "http://example.org:/",
            "http://a b/",
            "C:\\x.gh",
            "",
        ] {
            assert_eq!(cause(&hosts, url), Some(Cause::BadRequest), "{url}");
        }
        assert_eq!(cause(&Hosts::default(), "http://example.org/"), Some(Cause::Refused));
    }

    #[test]
    fn private_addresses_are_asked_only_where_they_are_listed_themselves() {
        let listed = ["example.org", "127.0.0.1:3000", "localhost:4000"];
        let hosts = Hosts::new(&listed.map(str::to_owned));
        let may = |url: &str, address: &str| hosts.may(&hosts.place(url).unwrap(), address.parse().unwrap());
        assert!(may("https://example.org/", "93.184.216.34"));
        assert!(!may("https://example.org/", "127.0.0.1"));
        assert!(!may("http://example.org/", "169.254.169.254"));
        assert!(!may("http://example.org:4000/", "::1"));
        assert!(may("http://127.0.0.1:3000/", "127.0.0.1"));
        assert!(may("http://localhost:4000/", "::1"));
        assert!(!may("http://localhost:4000/", "10.0.0.1"));
    }

    #[test]
    fn the_host_is_what_stands_between_the_slashes() {
        assert_eq!(authority("http://Localhost:5000/add").unwrap(), "http://Localhost:5000");
        assert_eq!(authority("https://host?x=@other").unwrap(), "https://host");
        for bad in ["C:\\x.gh", "http://", "http://a@b/x", "http://a\\@b/x", "http:///x", "x.gh"] {
            assert!(authority(bad).is_err(), "{bad}");
        }
    }
}
