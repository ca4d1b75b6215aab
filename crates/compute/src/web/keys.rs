//! The keys that other servers ask for.

use std::fmt;

use ureq::http::{HeaderValue, Uri};

use super::hosts::Place;
use crate::Fault;

/// The header that carries a key, here and there.
pub(super) const HEADER: &str = "RhinoComputeKey";

/// The key of another server. It goes to that host alone, and only with what Hops components ask.
#[derive(Clone, PartialEq, Eq)]
pub struct HostKey {
    /// The scheme, in lower case; either where none is named.
    scheme: Option<String>,
    name: String,
    /// The port; that which is usual for the scheme where none is named.
    port: Option<u16>,
    key: String,
}

impl HostKey {
    /// Reads `HOST=KEY`, as in `127.0.0.1:6500=secret` or `https://example.org=secret`. A host without a port means the
    /// usual one, 80 or 443; with a scheme the key is sent by that scheme only.
    ///
    /// # Errors
    /// `BadRequest` where there is no host, no key, or one that no header can carry. The words do not show the key.
    pub fn read(text: &str) -> Result<Self, Fault> {
        let wrong = |why: &str| Fault::bad_request(format!("HOST=KEY is expected: {why}"));
        let (place, key) = text.split_once('=').ok_or_else(|| wrong("there is no ="))?;
        let (place, key) = (place.trim().trim_end_matches('/'), key.trim());
        if key.is_empty() {
            return Err(wrong("the key is empty"));
        }
        if !HeaderValue::from_str(key).is_ok_and(|value| value.to_str().is_ok()) {
            return Err(wrong("the key is not of letters, digits and signs that a header can carry"));
        }
        let scheme = place.split_once("://").map(|(scheme, _)| scheme.to_ascii_lowercase());
        if scheme.as_deref().is_some_and(|scheme| !["http", "https"].contains(&scheme)) {
            return Err(wrong("the scheme is neither http nor https"));
        }
        let address = if scheme.is_some() { place.to_owned() } else { format!("http://{place}") };
        let uri: Uri = address.parse().map_err(|_| wrong("there is no host"))?;
        let found = Place::of(&uri).map_err(|_| wrong("there is no host"))?;
        if !matches!(uri.path(), "" | "/") || uri.query().is_some() {
            return Err(wrong("a path stands after the host"));
        }
        let port = uri.port_u16();
        Ok(Self { scheme, name: found.name, port, key: key.to_owned() })
    }

    /// The key, if it is for the host of an address.
    pub(crate) fn for_address(&self, url: &str) -> Option<&str> {
        let uri: Uri = url.trim().parse().ok()?;
        let place = Place::of(&uri).ok()?;
        let scheme = uri.scheme_str()?.to_ascii_lowercase();
        let usual = if scheme == "https" { 443 } else { 80 };
        let fits = self.name == place.name
            && self.port.unwrap_or(usual) == place.port
            && self.scheme.as_ref().is_none_or(|own| *own == scheme);
        fits.then_some(self.key.as_str())
    }
}

/// Shows everything but the key.
impl fmt::Debug for HostKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("HostKey")
            .field("scheme", &self.scheme)
            .field("name", &self.name)
            .field("port", &self.port)
            .finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;

    #[test]
    fn a_key_is_for_its_host_and_port_and_no_other() {
        let fits = |key: &str, url: &str| HostKey::read(key).unwrap().for_address(url) == Some("a=b c");
        for (key, url) in [
            ("127.0.0.1:6500=a=b c", "http://127.0.0.1:6500/solve"),
            ("example.org=a=b c", "http://example.org/x"),
            ("Example.org.=a=b c", "https://EXAMPLE.org:443/x?y"),
            ("https://example.org/= a=b c ", "https://example.org"),
            ("[::1]:5000=a=b c", "http://[::1]:5000/add"),
        ] {
            assert!(fits(key, url), "{key} {url}");
        }
        for (key, url) in [
            ("127.0.0.1:6500=a=b c", "http://127.0.0.1:6501/solve"),
            ("127.0.0.1:6500=a=b c", "http://127.0.0.2:6500/solve"),
            ("example.org=a=b c", "http://example.org:8080/x"),
            ("example.org=a=b c", "http://example.org.evil/x"),
            ("example.org=a=b c", "http://sub.example.org/x"),
            ("example.org=a=b c", "http://example.org@evil/x"),
            ("https://example.org=a=b c", "http://example.org/x"),
            ("https://example.org=a=b c", "http://example.org:443/x"),
            ("example.org=a=b c", "example.org"),
            ("example.org=a=b c", ""),
        ] {
            assert!(!fits(key, url), "{key} {url}");
        }
    }

    #[test]
    fn what_is_no_host_or_no_key_is_refused_without_showing_it() {
        for text in [
            "",
            "secret",
            "=secret",
            "example.org=",
            "example.org= ",
            "example.org=sec\nret",
            "example.org=sécret",
            "ftp://example.org=secret",
            "user@example.org=secret",
            "example.org/path=secret",
            "example.org:=secret",
            "example.org:99999=secret",
            "a b=secret",
        ] {
            let fault = HostKey::read(text).unwrap_err();
            assert!(!fault.message.contains("secret") && !fault.message.contains("ret"), "{}", fault.message);
        }
        let key = HostKey::read("example.org=secret").unwrap();
        assert!(!format!("{key:?}").contains("secret"));
    }
}
