//! Who may ask: every request passes here first.
//!
//! A page of another site can make its visitor's browser send requests to this machine. Three things tell them from
//! those of the studio's own page: the name that the browser looked up (`Host`: a name that was made to point here is
//! none of ours), the page that sends them (`Origin`, and `Sec-Fetch-Site` where the browser says), and the token. The
//! token also keeps out the other users of this machine, whose programs reach the port as well.

use std::sync::{Arc, Mutex};

use axum::extract::{Request, State as Extract};
use axum::http::header::{
    CACHE_CONTROL, CONTENT_SECURITY_POLICY, COOKIE, HOST, HeaderName, HeaderValue, ORIGIN, REFERRER_POLICY,
    SET_COOKIE, X_CONTENT_TYPE_OPTIONS, X_FRAME_OPTIONS,
};
use axum::http::{HeaderMap, Method, StatusCode, Uri};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use uuid::Uuid;

use super::State;
use super::answer::Refused;
use crate::Config;
use crate::lock::held;
use crate::names::{is_this_machine, of_origin, without_port};
use crate::secret::Secret;

/// What the page may load: nothing from elsewhere, and no script but its own files.
const POLICY: &str = "default-src 'self'; script-src 'self'; style-src 'self' 'unsafe-inline'; \
    img-src 'self' data: blob:; font-src 'self' data:; connect-src 'self'; worker-src 'self' blob:; \
    object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Tells the studio's own requests from others.
#[derive(Debug)]
pub(crate) struct Guard {
    token: Token,
    /// What opens the page once, in place of the token.
    ticket: Mutex<Option<Token>>,
    /// The name of the cookie that holds the token. Browsers keep one cookie of a name for all ports of a machine: two
    /// studios must not take each other's.
    cookie: String,
    /// Whether only this machine can reach the port.
    is_local: bool,
}

struct Token {
    text: String,
    secret: Secret,
}

impl Token {
    fn new(text: String) -> Self {
        Self { secret: Secret::new(&text), text }
    }

    /// One that nobody guesses.
    fn chance() -> Self {
        Self::new(format!("{}{}", Uuid::new_v4().simple(), Uuid::new_v4().simple()))
    }
}

impl std::fmt::Debug for Token {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Token")
    }
}

impl Guard {
    pub(crate) fn new(config: &Config, port: u16) -> Self {
        let given = config.token.clone().filter(|token| !token.is_empty());
        Self {
            token: given.map_or_else(Token::chance, Token::new),
            ticket: Mutex::new(Some(Token::chance())),
            cookie: format!("katydid_token_{port}"),
            is_local: config.is_local(),
        }
    }

    /// The token that is needed.
    pub(crate) fn token(&self) -> &str {
        &self.token.text
    }

    /// What opens the page once; empty when it has.
    pub(crate) fn ticket(&self) -> String {
        held(&self.ticket).as_ref().map(|ticket| ticket.text.clone()).unwrap_or_default()
    }

    /// Whether a request brings the token, in its address or in the page's cookie.
    fn knows(&self, uri: &Uri, headers: &HeaderMap) -> bool {
        let is_it = |text: &str| self.token.secret.is(text.as_bytes());
        queried(uri, "token").any(is_it) || cookies(headers, &self.cookie).any(is_it)
    }

    /// Whether a request for the page brings the ticket, which is used up by that.
    fn takes_ticket(&self, method: &Method, uri: &Uri) -> bool {
        if *method != Method::GET || !matches!(uri.path(), "/" | "/study") {
            return false;
        }
        let mut ticket = held(&self.ticket);
        let is_it = ticket
            .as_ref()
            .is_some_and(|ticket| queried(uri, "ticket").any(|text| ticket.secret.is(text.as_bytes())));
        if is_it {
            *ticket = None;
        }
        is_it
    }

    /// Why a request is none of the studio's.
    fn refuses(&self, method: &Method, uri: &Uri, headers: &HeaderMap) -> Option<Refused> {
        let Some(host) = one(headers, &HOST).filter(|host| self.is_ours(host)) else {
            return Some(Refused::forbidden("this name is none of the server's"));
        };
        let changes = !matches!(*method, Method::GET | Method::HEAD);
        let is_page = !changes && !is_inner(uri.path());
        if let Some(origin) = headers.get(ORIGIN)
            && !same(origin.to_str().unwrap_or_default(), host)
        {
            return Some(Refused::forbidden("pages of other sites may not ask"));
        }
        let site = headers.get("sec-fetch-site").and_then(|site| site.to_str().ok()).unwrap_or("same-origin");
        if !is_page && !matches!(site, "same-origin" | "none") {
            return Some(Refused::forbidden("pages of other sites may not ask"));
        }
        let is_known = self.knows(uri, headers) || self.takes_ticket(method, uri);
        (!is_known).then(|| {
            Refused::new(StatusCode::UNAUTHORIZED, "a token is needed: use the address that Katydid printed")
        })
    }

    /// Whether a name in a request is one of this server: `localhost` and numbers, which no name server can redirect.
    /// Where others can reach it, it is known by its number or by a name that they were given: the token protects it.
    fn is_ours(&self, host: &str) -> bool {
        is_this_machine(host) || (!self.is_local && !without_port(host).is_empty())
    }
}

/// Whether the address is more than a file of the page.
fn is_inner(path: &str) -> bool {
    ["/api/", "/geometry/", "/image/"].iter().any(|inner| path.starts_with(inner)) || path == "/socket"
}

/// A header that is there once.
fn one<'a>(headers: &'a HeaderMap, name: &HeaderName) -> Option<&'a str> {
    let mut all = headers.get_all(name).iter();
    let first = all.next()?.to_str().ok()?;
    all.next().is_none().then_some(first)
}

/// Whether an origin is the page of that very host and port.
fn same(origin: &str, host: &str) -> bool {
    of_origin(origin).is_some_and(|of| of.eq_ignore_ascii_case(host))
}

/// The values of a name in the address of a request.
fn queried<'a>(uri: &'a Uri, wanted: &'a str) -> impl Iterator<Item = &'a str> {
    let pairs = uri.query().unwrap_or_default().split('&').filter_map(|pair| pair.split_once('='));
    pairs.filter(move |(name, _)| *name == wanted).map(|(_, value)| value)
}

/// The values of the cookies of a name.
fn cookies<'a>(headers: &'a HeaderMap, wanted: &'a str) -> impl Iterator<Item = &'a str> {
    let all = headers.get_all(COOKIE).iter().filter_map(|cookie| cookie.to_str().ok());
    let pairs = all.flat_map(|all| all.split(';')).filter_map(|one| one.trim().split_once('='));
    pairs.filter(move |(name, _)| *name == wanted).map(|(_, value)| value)
}

/// Lets a request through, or refuses it.
pub(crate) async fn check(Extract(state): Extract<Arc<State>>, request: Request, next: Next) -> Response {
    let guard = &state.guard;
    let mut response = match guard.refuses(request.method(), request.uri(), request.headers()) {
        Some(refused) => refused.into_response(),
        None => {
            let is_page = !is_inner(request.uri().path());
            let mut response = next.run(request).await;
            let (name, token) = (&guard.cookie, guard.token());
            let cookie = format!("{name}={token}; Path=/; HttpOnly; SameSite=Strict");
            if is_page && let Ok(cookie) = HeaderValue::from_str(&cookie) {
                response.headers_mut().append(SET_COOKIE, cookie);
            }
            response
        }
    };
    let headers = response.headers_mut();
    let fixed = [
        (CONTENT_SECURITY_POLICY, POLICY),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (X_FRAME_OPTIONS, "DENY"),
        (REFERRER_POLICY, "no-referrer"),
        (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
        (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    ];
    for (name, value) in fixed {
        headers.insert(name, HeaderValue::from_static(value));
    }
    headers.entry(CACHE_CONTROL).or_insert(HeaderValue::from_static("no-store"));
    response
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use std::net::{IpAddr, Ipv4Addr};

    use super::*;

    fn refused(
        guard: &Guard,
        method: &Method,
        uri: &str,
        headers: &[(&'static str, &str)],
    ) -> Option<StatusCode> {
        let mut map = HeaderMap::new();
        for (name, value) in headers {
            map.append(*name, HeaderValue::from_str(value).unwrap());
        }
        if guard.token() == "secret" && !headers.iter().any(|(name, _)| *name == "cookie") {
            map.append(COOKIE, HeaderValue::from_static("katydid_token_6510=secret"));
        }
        guard.refuses(method, &uri.parse().unwrap(), &map).map(|refused| refused.into_response().status())
    }

    /// A guard whose token the requests bring.
    fn known() -> Guard {
        Guard::new(&Config { token: Some("secret".to_owned()), ..Config::default() }, 6510)
    }

    #[test]
    fn only_names_of_this_machine_are_ours() {
        let guard = known();
        for host in ["127.0.0.1:6510", "localhost:5173", "[::1]:6510", "LOCALHOST", "127.0.0.1"] {
            assert_eq!(refused(&guard, &Method::GET, "/api/start", &[("host", host)]), None, "{host}");
        }
        for host in
            ["evil.example", "evil.example:6510", "192.168.1.5:6510", "127.0.0.1.evil.example", "", "[::2]"]
        {
            let found = refused(&guard, &Method::GET, "/", &[("host", host)]);
            assert_eq!(found, Some(StatusCode::FORBIDDEN), "{host}");
        }
        let twice = [("host", "localhost"), ("host", "evil.example")];
        assert!(refused(&guard, &Method::GET, "/", &twice).is_some());
        assert!(refused(&guard, &Method::GET, "/", &[]).is_some());
    }

    #[test]
    fn pages_of_other_sites_may_not_ask() {
        let guard = known();
        let ask = |method: &Method, uri: &str, origin: &str| {
            refused(&guard, method, uri, &[("host", "localhost:6510"), ("origin", origin)])
        };
        for origin in
            ["https://evil.example", "http://localhost:6511", "null", "http://localhost:6510.evil.example"]
        {
            assert_eq!(ask(&Method::POST, "/api/open", origin), Some(StatusCode::FORBIDDEN), "{origin}");
            assert_eq!(ask(&Method::GET, "/socket", origin), Some(StatusCode::FORBIDDEN), "{origin}");
        }
        assert_eq!(ask(&Method::POST, "/api/open", "http://localhost:6510"), None);
        let site = |uri: &str, site: &str| {
            refused(&guard, &Method::GET, uri, &[("host", "localhost"), ("sec-fetch-site", site)])
        };
        assert_eq!(site("/", "cross-site"), None, "a link to the page is a link");
        assert_eq!(site("/api/export", "cross-site"), Some(StatusCode::FORBIDDEN));
        assert_eq!(site("/geometry/1", "same-site"), Some(StatusCode::FORBIDDEN));
        assert_eq!(site("/api/export", "same-origin"), None);
    }

    #[test]
    fn everybody_needs_the_token() {
        for address in [Ipv4Addr::LOCALHOST, Ipv4Addr::UNSPECIFIED] {
            let guard = Guard::new(&Config { address: IpAddr::V4(address), ..Config::default() }, 6510);
            let token = guard.token().to_owned();
            assert_eq!(token.len(), 64);
            let host = ("host", "127.0.0.1:6510");
            for uri in ["/", "/api/start", "/socket", "/api/start?token=wrong", "/?token=", "/assets/a.js"] {
                assert_eq!(
                    refused(&guard, &Method::GET, uri, &[host]),
                    Some(StatusCode::UNAUTHORIZED),
                    "{uri}"
                );
            }
            assert_eq!(refused(&guard, &Method::GET, &format!("/?token={token}"), &[host]), None);
            let cookie = |name: &str| {
                let cookie = format!("other=1; {name}={token}");
                refused(&guard, &Method::GET, "/api/start", &[host, ("cookie", &cookie)])
            };
            assert_eq!(cookie("katydid_token_6510"), None);
            // That of another studio of this machine.
            assert_eq!(cookie("katydid_token_6511"), Some(StatusCode::UNAUTHORIZED));
        }
        let far =
            Guard::new(&Config { address: IpAddr::V4(Ipv4Addr::UNSPECIFIED), ..Config::default() }, 6510);
        let uri = format!("/?token={}", far.token());
        assert_eq!(refused(&far, &Method::GET, &uri, &[("host", "192.168.1.5:6510")]), None);
    }

    #[test]
    fn a_ticket_opens_the_page_once() {
        let guard = Guard::new(&Config::default(), 6510);
        let uri = format!("/?document=1&ticket={}", guard.ticket());
        let host = ("host", "127.0.0.1:6510");
        let ask = |method: &Method, uri: &str| refused(&guard, method, uri, &[host]);
        let inner = uri.replace("/?", "/api/start?");
        let unknown = Some(StatusCode::UNAUTHORIZED);
        assert_eq!((ask(&Method::GET, &inner), ask(&Method::HEAD, &uri)), (unknown, unknown));
        assert_eq!(ask(&Method::GET, "/?ticket="), unknown);
        assert_eq!((ask(&Method::GET, &uri), ask(&Method::GET, &uri)), (None, unknown));
    }
}
