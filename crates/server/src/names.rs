//! The names by which a browser reaches this machine.

use std::net::{IpAddr, Ipv6Addr};

/// Whether a host, with or without its port, can be no other machine than this one: `localhost`, which no name server
/// answers for, and the addresses of the loopback.
pub(crate) fn is_this_machine(host: &str) -> bool {
    let name = without_port(host).to_ascii_lowercase();
    name == "localhost"
        || name.ends_with(".localhost")
        || address(&name).is_some_and(|address| address.is_loopback())
}

/// The host without its port.
pub(crate) fn without_port(host: &str) -> &str {
    match host.rsplit_once(':') {
        Some((name, port)) if !port.is_empty() && port.bytes().all(|b| b.is_ascii_digit()) => name,
        _ => host,
    }
}

/// The address that a host is, when it is one; those of six parts stand in brackets.
pub(crate) fn address(name: &str) -> Option<IpAddr> {
    match name.strip_prefix('[').and_then(|name| name.strip_suffix(']')) {
        Some(inner) => inner.parse::<Ipv6Addr>().ok().map(IpAddr::V6),
        None => name.parse().ok(),
    }
}

/// The host and port of a page's origin; none where it is not of the web, as `null` is not.
pub(crate) fn of_origin(origin: &str) -> Option<&str> {
    origin.strip_prefix("http://").or_else(|| origin.strip_prefix("https://"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_no_name_server_can_turn_elsewhere_is_this_machine() {
        for host in
            ["localhost", "LOCALHOST:80", "a.localhost:1", "127.0.0.1", "127.1.2.3:9", "[::1]", "[::1]:6500"]
        {
            assert!(is_this_machine(host), "{host}");
        }
        for host in [
            "",
            "localhost.evil.example",
            "127.0.0.1.evil.example",
            "::1",
            "[::2]:1",
            "192.168.0.1",
            "0.0.0.0",
            "evil",
        ] {
            assert!(!is_this_machine(host), "{host}");
        }
    }
}
