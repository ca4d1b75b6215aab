//! Definitions that lie elsewhere.
//!
//! Nobody is asked but the hosts that the server was started with. A name is looked up once, and the connection goes to
//! the address that was found and looked at: a name that changes in between leads nowhere else. Addresses of this
//! machine and of its network are refused unless they are listed themselves. Who answers with another address is not
//! followed.

mod address;

use std::net::{IpAddr, SocketAddr};
use std::time::Duration;

use axum::body::{Body, Bytes};
use axum::http::header::{ACCEPT_ENCODING, CONTENT_ENCODING, CONTENT_LENGTH, HOST, HeaderValue, USER_AGENT};
use axum::http::{Method, StatusCode, Uri};
use flate2::read::MultiGzDecoder;
use futures_util::StreamExt;
use hyper_util::rt::TokioIo;
use katydid_compute::Fault;
use tokio::net::{TcpStream, lookup_host};
use tokio::time::timeout;

use super::body::unpack;
use super::refusal::Refusal;

/// No definition takes longer to fetch.
const TIME: Duration = Duration::from_secs(20);
/// A host is found and reached in this time.
const REACH: Duration = Duration::from_secs(5);
/// No address is longer.
const LONGEST: usize = 4096;

/// A host that may be asked, at any port where none is named.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Host {
    name: String,
    port: Option<u16>,
}

/// Fetches what lies at an address.
#[derive(Debug, Clone)]
pub(crate) struct Fetcher {
    hosts: Vec<Host>,
    /// The most bytes, packed and unpacked.
    most: usize,
}

/// An address in its parts.
struct Place {
    host: String,
    port: u16,
    /// Path and query.
    rest: String,
}

impl Fetcher {
    /// Asks these hosts: `example.org`, `example.org:8080`, `127.0.0.1:3000`, `[::1]:3000`.
    pub(crate) fn new(hosts: &[String], most: usize) -> Self {
        let host = |text: &String| {
            let text = text.trim();
            let text = text.strip_prefix("http://").or_else(|| text.strip_prefix("https://")).unwrap_or(text);
            let text = text.trim_end_matches('/').to_ascii_lowercase();
            let (name, port) = match text.rsplit_once(':') {
                Some((name, port))
                    if !name.ends_with(':') && (!name.contains(':') || name.ends_with(']')) =>
                {
                    match port.parse() {
                        Ok(port) => (name.to_owned(), Some(port)),
                        Err(_) => (text, None),
                    }
                }
                _ => (text, None),
            };
            Host { name: name.trim_matches(['[', ']']).to_owned(), port }
        };
        Self { hosts: hosts.iter().map(host).collect(), most }
    }

    /// The bytes of a definition, unpacked.
    pub(crate) async fn definition(&self, url: &str, time: Option<Duration>) -> Result<Vec<u8>, Refusal> {
        let time = time.unwrap_or(TIME).min(TIME);
        let late = || Refusal::late("the definition could not be fetched in time");
        let (bytes, is_packed) =
            timeout(time, self.fetch(Method::GET, url, Bytes::new())).await.map_err(|_| late())??;
        if is_packed || bytes.starts_with(&[0x1f, 0x8b]) {
            return unpack(MultiGzDecoder::new(bytes.as_slice()), self.most);
        }
        Ok(bytes)
    }

    async fn fetch(&self, method: Method, url: &str, body: Bytes) -> Result<(Vec<u8>, bool), Refusal> {
        let place = self.place(url)?;
        let address = self.find(&place).await?;
        let gone = || Refusal::from(Fault::not_found("the host of the definition does not answer"));
        let stream = timeout(REACH, TcpStream::connect(address)).await;
        let stream = stream.map_err(|_| gone())?.map_err(|_| gone())?;
        let _ = stream.set_nodelay(true);
        let (mut sender, connection) =
            hyper::client::conn::http1::handshake(TokioIo::new(stream)).await.map_err(|_| gone())?;
        let serving = tokio::spawn(connection);
        let asked = async {
            let mut request = axum::http::Request::new(Body::from(body));
            *request.method_mut() = method;
            *request.uri_mut() = place.rest.parse().map_err(|_| Refusal::bad("the pointer is no address"))?;
            let host = place.header().ok_or_else(|| Refusal::bad("the pointer is no address"))?;
            request.headers_mut().insert(HOST, host);
            request.headers_mut().insert(ACCEPT_ENCODING, HeaderValue::from_static("gzip"));
            let agent = HeaderValue::from_static(concat!("katydid/", env!("CARGO_PKG_VERSION")));
            request.headers_mut().insert(USER_AGENT, agent);
            let answer = sender.send_request(request).await.map_err(|_| gone())?;
            self.read(answer).await
        };
        let read = asked.await;
        serving.abort();
        read
    }

    async fn read(
        &self,
        answer: axum::http::Response<hyper::body::Incoming>,
    ) -> Result<(Vec<u8>, bool), Refusal> {
        let status = answer.status();
        if status.is_redirection() {
            return Err(Fault::refused("the definition is elsewhere: redirects are not followed").into());
        }
        if status != StatusCode::OK {
            let status = status.as_u16();
            return Err(Fault::not_found(format!("the host of the definition answers {status}")).into());
        }
        let too_large =
            || Refusal::too_large(format!("the definition at the pointer has more than {} bytes", self.most));
        let headers = answer.headers();
        let told = headers.get(CONTENT_LENGTH).and_then(|length| length.to_str().ok()?.parse::<u64>().ok());
        if told.is_some_and(|length| length > self.most as u64) {
            return Err(too_large());
        }
        let packing = headers.get(CONTENT_ENCODING).and_then(|value| value.to_str().ok()).unwrap_or_default();
        let is_packed = packing.eq_ignore_ascii_case("gzip") || packing.eq_ignore_ascii_case("x-gzip");
        let mut stream = Body::new(answer.into_body()).into_data_stream();
        let mut bytes = Vec::new();
        while let Some(chunk) = stream.next().await {
            let chunk = chunk.map_err(|_| Refusal::from(Fault::not_found("the definition broke off")))?;
            if bytes.len() + chunk.len() > self.most {
                return Err(too_large());
            }
            bytes.extend_from_slice(&chunk);
        }
        Ok((bytes, is_packed))
    }

    /// Takes an address apart, if its host may be asked.
    fn place(&self, url: &str) -> Result<Place, Refusal> {
        let no_address = || Refusal::bad("the pointer is no address");
        if url.len() > LONGEST {
            return Err(no_address());
        }
        let (scheme, _) = url.trim().split_once("://").ok_or_else(no_address)?;
        let (usual, is_secure) = match scheme.to_ascii_lowercase().as_str() {
            "http" => (80, false),
            "https" => (443, true),
            _ => return Err(Fault::refused("only http and https addresses can be pointers").into()),
        };
        let uri: Uri = url.trim().parse().map_err(|_| no_address())?;
        let authority = uri.authority().filter(|authority| !authority.as_str().contains('@'));
        let authority = authority.ok_or_else(no_address)?;
        let host = authority.host().trim_matches(['[', ']']).trim_end_matches('.').to_ascii_lowercase();
        let port = match authority.port() {
            Some(port) => port.as_u16(),
            // A port that is none, or that is empty, is not taken for the usual one.
            None if authority.as_str().contains("]:") || authority.as_str().matches(':').count() == 1 => {
                return Err(no_address());
            }
            None => usual,
        };
        if self.hosts.is_empty() {
            let reason = "definitions are not fetched from elsewhere here: send the definition itself";
            return Err(Fault::refused(reason).into());
        }
        if !self.lists(&host, port) {
            return Err(Fault::refused("definitions are not fetched from this host").into());
        }
        if is_secure {
            return Err(Fault::not_supported("fetching definitions over https").into());
        }
        let rest = uri.path_and_query().map_or("/", |rest| rest.as_str()).to_owned();
        Ok(Place { host, port, rest })
    }

    fn lists(&self, name: &str, port: u16) -> bool {
        self.hosts.iter().any(|host| host.name == name && host.port.is_none_or(|own| own == port))
    }

    /// Looks a name up, once.
    async fn find(&self, place: &Place) -> Result<SocketAddr, Refusal> {
        let unknown = || Refusal::from(Fault::not_found("the host of the definition is not known"));
        let found: Vec<SocketAddr> = match place.host.parse::<IpAddr>() {
            Ok(address) => vec![SocketAddr::new(address, place.port)],
            Err(_) => {
                let found = timeout(REACH, lookup_host((place.host.as_str(), place.port))).await;
                found.map_err(|_| unknown())?.map_err(|_| unknown())?.collect()
            }
        };
        let is_here = place.host == "localhost" || place.host.ends_with(".localhost");
        let may = |address: &SocketAddr| {
            address::is_public(address.ip())
                || self.lists(&address.ip().to_string(), place.port)
                || (is_here && address.ip().is_loopback())
        };
        if found.is_empty() {
            return Err(unknown());
        }
        let reason = "this host is in a private network: its address must be listed itself";
        found.into_iter().find(may).ok_or_else(|| Fault::refused(reason).into())
    }
}

impl Place {
    fn header(&self) -> Option<HeaderValue> {
        let host = if self.host.contains(':') { format!("[{}]", self.host) } else { self.host.clone() };
        let text = if self.port == 80 { host } else { format!("{host}:{}", self.port) };
        HeaderValue::from_str(&text).ok()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;

    fn status(fetcher: &Fetcher, url: &str) -> Option<u16> {
        fetcher.place(url).err().map(|refusal| refusal.status.as_u16())
    }

    #[test]
    fn only_hosts_that_are_listed_are_asked() {
        let listed = ["Example.org", "127.0.0.1:3000", "[::1]:3000", "http://files.example/"];
        let fetcher = Fetcher::new(&listed.map(str::to_owned), 1 << 20);
        for url in [
            "http://example.org/a.gh",
            "HTTP://EXAMPLE.ORG:8080/",
            "http://127.0.0.1:3000/definition/1?x=2",
            "http://[::1]:3000/a",
            "http://files.example",
            "http://example.org./a",
        ] {
            assert_eq!(status(&fetcher, url), None, "{url}");
        }
        for url in [
            "http://evil.example/a.gh",
            "http://127.0.0.1:3001/",
            "http://127.0.0.1/",
            "http://example.org.evil/",
            "ftp://example.org/",
            "file:///etc/passwd",
            "gopher://example.org/",
        ] {
            assert_eq!(status(&fetcher, url), Some(403), "{url}");
        }
        for url in [
            "http://user@example.org/",
            "http://example.org@evil.example/",
            "http:///a",
            "http://example.org:99999/",
            "http://a b/",
        ] {
            assert_eq!(status(&fetcher, url), Some(400), "{url}");
        }
        assert_eq!(status(&Fetcher::new(&[], 1), "http://example.org/"), Some(403));
    }
}
