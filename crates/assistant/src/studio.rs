//! A studio that a person has open on this machine, and what its documents are asked over HTTP.

use std::time::Duration;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use katydid_data::cast::Rules;
use katydid_data::units;
use katydid_definition::archive::Limits;
use katydid_definition::document::{Difference, Document};
use katydid_session::journal::write_difference;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use ureq::http::Uri;
use ureq::{Agent, Body};

use crate::thresholds::{LONGEST_ANSWER, LONGEST_QUESTION};

/// The address of a studio.
#[derive(Debug, Clone)]
pub(crate) struct Studio {
    agent: Agent,
    /// Scheme, host and port.
    place: String,
    token: String,
    /// The only document that is meant, where the address names one.
    only: Option<String>,
}

/// A document that is open there.
#[derive(Debug, Clone, Deserialize)]
pub(crate) struct There {
    pub(crate) id: String,
    pub(crate) name: String,
}

/// How a document there stands.
#[derive(Debug, Deserialize)]
pub(crate) struct Standing {
    pub(crate) revision: u64,
    units: String,
    tolerance: f64,
    angle: f64,
    /// The name of the Rhino model beside it.
    pub(crate) model: Option<String>,
    /// Whether edits wait there until the person has them solved.
    pub(crate) locked: bool,
    /// What was taken back or made again.
    pub(crate) step: Option<String>,
    /// The document in base64, where it is another than is known.
    document: Option<String>,
}

impl Standing {
    /// The units and tolerances that count there.
    pub(crate) fn rules(&self, usual: Rules) -> Rules {
        let mut rules = usual;
        rules.units = units::named(&self.units).unwrap_or(rules.units);
        (rules.tolerance.absolute, rules.tolerance.angle) = (self.tolerance, self.angle);
        rules
    }

    /// The document, where it came along.
    pub(crate) fn document(&self) -> Result<Option<Document>, String> {
        let Some(text) = &self.document else { return Ok(None) };
        let bytes = STANDARD.decode(text).map_err(|_| "the studio sent no document".to_owned())?;
        Document::read(&bytes, &Limits::default()).map(Some).map_err(|error| error.to_string())
    }
}

#[derive(Deserialize)]
struct Documents {
    documents: Vec<There>,
    version: String,
}

#[derive(Deserialize)]
struct Refusal {
    error: String,
}

impl Studio {
    /// The studio at an address, as `katydid studio --allow-assistant` prints it.
    ///
    /// # Errors
    /// It is no address of this machine, or names no token.
    pub(crate) fn new(url: &str) -> Result<Self, String> {
        let told = |why: &str| format!("--studio: {why}");
        let uri: Uri = url.trim().parse().map_err(|_| told("this is no address"))?;
        let host = uri.host().unwrap_or_default();
        let bare = host.trim_start_matches('[').trim_end_matches(']');
        let is_here = bare == "localhost" || bare.parse().is_ok_and(|ip: std::net::IpAddr| ip.is_loopback());
        if uri.scheme_str() != Some("http") || !is_here {
            return Err(told(
                "only a studio of this machine can be joined, as http://127.0.0.1:6510/?token=…",
            ));
        }
        let pairs = uri.query().unwrap_or_default().split('&').filter_map(|pair| pair.split_once('='));
        let named =
            |wanted: &str| pairs.clone().find(|(name, _)| *name == wanted).map(|(_, value)| value.to_owned());
        let token = named("token").filter(|token| !token.is_empty());
        let token =
            token.ok_or_else(|| told("the address names no token: give it as the studio prints it"))?;
        let place = uri.authority().map(|authority| format!("http://{authority}")).unwrap_or_default();
        let agent = Agent::config_builder()
            .http_status_as_error(false)
            .max_redirects(0)
            .max_redirects_will_error(false)
            // What a proxy would see is the token.
            .proxy(None)
            .timeout_global(Some(LONGEST_QUESTION))
            .timeout_connect(Some(Duration::from_secs(2)))
            .build();
        Ok(Self { agent: agent.into(), place, token, only: named("document") })
    }

    /// The documents that are open there; only one where the address names it.
    pub(crate) fn documents(&self) -> Result<Vec<There>, String> {
        let Documents { documents, version } = self.get("/api/assistant", &[])?;
        if version != env!("CARGO_PKG_VERSION") {
            return Err(format!(
                "the studio is of version {version}, this program of {}",
                env!("CARGO_PKG_VERSION")
            ));
        }
        let is_meant = |there: &There| self.only.as_ref().is_none_or(|only| *only == there.id);
        Ok(documents.into_iter().filter(is_meant).collect())
    }

    /// How a document stands, with all of it where its revision is another than is known.
    pub(crate) fn state(&self, document: &str, known: Option<u64>) -> Result<Standing, String> {
        let known = known.map(|known| known.to_string());
        let mut query = vec![("document", document)];
        query.extend(known.as_deref().map(|known| ("known", known)));
        self.get("/api/assistant/state", &query)
    }

    /// Takes a step from the state of a revision.
    pub(crate) fn step(
        &self,
        document: &str,
        revision: u64,
        name: &str,
        difference: &Difference,
    ) -> Result<Standing, String> {
        let body = write_difference(difference).map_err(|error| error.to_string())?;
        let revision = revision.to_string();
        self.post(
            "/api/assistant/step",
            &[("document", document), ("revision", &revision), ("name", name)],
            &body,
        )
    }

    /// Takes the last step of an assistant back, or makes it again.
    pub(crate) fn walk(&self, document: &str, revision: u64, again: bool) -> Result<Standing, String> {
        let (revision, again) = (revision.to_string(), again.to_string());
        let query = [("document", document), ("revision", revision.as_str()), ("again", again.as_str())];
        self.post("/api/assistant/walk", &query, &[])
    }

    fn get<T: DeserializeOwned>(&self, path: &str, query: &[(&str, &str)]) -> Result<T, String> {
        let request =
            self.agent.get(format!("{}{path}", self.place)).query_pairs_raw([("token", self.token.as_str())]);
        answered(request.query_pairs(query.iter().copied()).call())
    }

    fn post<T: DeserializeOwned>(
        &self,
        path: &str,
        query: &[(&str, &str)],
        body: &[u8],
    ) -> Result<T, String> {
        let request = self
            .agent
            .post(format!("{}{path}", self.place))
            .query_pairs_raw([("token", self.token.as_str())]);
        answered(request.query_pairs(query.iter().copied()).send(body))
    }
}

fn answered<T: DeserializeOwned>(
    answer: Result<ureq::http::Response<Body>, ureq::Error>,
) -> Result<T, String> {
    let unreached = |error: ureq::Error| format!("the studio does not answer: {error}");
    let mut answer = answer.map_err(unreached)?;
    let bytes = answer.body_mut().with_config().limit(LONGEST_ANSWER).read_to_vec().map_err(unreached)?;
    if answer.status().is_success() {
        return serde_json::from_slice(&bytes)
            .map_err(|error| format!("the studio's answer is not understood: {error}"));
    }
    let reason = serde_json::from_slice(&bytes).map(|Refusal { error }| error);
    Err(reason.unwrap_or_else(|_| format!("the studio refused with status {}", answer.status().as_u16())))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;

    #[test]
    fn only_studios_of_this_machine_are_joined() {
        for url in [
            "http://127.0.0.1:6510/?token=a",
            "http://[::1]:1/?document=x&token=b",
            "http://localhost/?token=c",
        ] {
            assert!(Studio::new(url).is_ok(), "{url}");
        }
        let one = Studio::new("http://[::1]:1/?document=x&token=b").unwrap();
        assert_eq!(
            (one.place.as_str(), one.token.as_str(), one.only.as_deref()),
            ("http://[::1]:1", "b", Some("x"))
        );
        for url in [
            "",
            "6510",
            "http://127.0.0.1:6510/",
            "http://127.0.0.1:6510/?token=",
            "https://127.0.0.1/?token=a",
            "http://127.0.0.1.evil.example/?token=a",
            "http://192.168.1.5:6510/?token=a",
            "http://user@evil.example/?token=a",
            "file:///etc/passwd?token=a",
        ] {
            assert!(Studio::new(url).is_err(), "{url}");
        }
    }
}
