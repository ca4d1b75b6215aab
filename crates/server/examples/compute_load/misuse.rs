//! What clients do besides asking and waiting.

use std::thread::sleep;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::Outcome;
use crate::cases::{Case, Chance};
use crate::client::{Answer, Client, request};

/// Where and what is asked.
#[derive(Clone, Copy)]
pub(crate) struct Site<'a> {
    pub(crate) host: &'a str,
    pub(crate) cases: &'a [Case],
    /// The body of a solve that takes longer than anybody waits.
    pub(crate) endless: &'a [u8],
}

/// What came of something.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Came {
    /// As it should.
    Right,
    /// An answer that is not the one of `katydid run`, or a status that does not fit.
    Wrong(u16),
    /// The server has no time or room for it now.
    Refused,
}

/// Something that a client does, and how many of a thousand turns it has.
pub(crate) struct Deed {
    pub(crate) name: &'static str,
    pub(crate) turns: usize,
    pub(crate) run: fn(&Site<'_>, &mut Chance) -> Outcome<Came>,
}

/// All but to ask and to wait, which has the turns that are left.
pub(crate) const DEEDS: [Deed; 8] = [
    Deed { name: "left a solve that runs", turns: 4, run: leave },
    Deed { name: "left in the middle of a request", turns: 15, run: break_off },
    Deed { name: "bodies that are no request", turns: 15, run: nonsense },
    Deed { name: "bodies that are too large", turns: 4, run: too_large },
    Deed { name: "bodies that come slowly", turns: 4, run: slowly },
    Deed { name: "jobs submitted, polled, fetched", turns: 10, run: job },
    Deed { name: "jobs cancelled", turns: 4, run: cancelled_job },
    Deed { name: "requests that refuse the cache", turns: 10, run: no_store },
];

/// What an answer to a case comes to.
pub(crate) fn judged(case: &Case, answer: &Answer) -> Came {
    match answer.status {
        200 if case.is_right(&answer.body) => Came::Right,
        408 | 503 => Came::Refused,
        status => Came::Wrong(status),
    }
}

fn wants(answer: &Answer, statuses: &[u16]) -> Came {
    match answer.status {
        status if statuses.contains(&status) => Came::Right,
        503 => Came::Refused,
        status => Came::Wrong(status),
    }
}

impl Site<'_> {
    pub(crate) fn case(&self, chance: &mut Chance) -> Outcome<&Case> {
        Ok(self.cases.get(chance.below(self.cases.len())).ok_or("there are no cases")?)
    }

    fn ask(&self, method: &str, path: &str, body: &[u8]) -> Outcome<Answer> {
        Client::new(self.host)?.ask(&request(method, self.host, path, body))
    }
}

/// Asks for something without end, and goes.
fn leave(site: &Site<'_>, chance: &mut Chance) -> Outcome<Came> {
    let mut client = Client::new(site.host)?;
    client.say(&request("POST", site.host, "/grasshopper", site.endless))?;
    sleep(Duration::from_millis(20 + chance.below(300) as u64));
    Ok(Came::Right)
}

/// Goes before all is said, or as soon as it is.
fn break_off(site: &Site<'_>, chance: &mut Chance) -> Outcome<Came> {
    let whole = &site.case(chance)?.request;
    let end = 1 + chance.below(whole.len());
    Client::new(site.host)?.say(whole.get(..end).unwrap_or_default())?;
    Ok(Came::Right)
}

/// Says what is no request, and is told so.
fn nonsense(site: &Site<'_>, chance: &mut Chance) -> Outcome<Came> {
    let case = &site.case(chance)?.body;
    let cut = case.get(..chance.below(case.len())).unwrap_or_default();
    let bodies: [&[u8]; 8] = [
        b"",
        b"{}",
        b"null",
        b"{\"algo\": \"%%%\", \"values\": []}",
        b"{\"algo\": \"AAAA\", \"values\": []}",
        b"{\"pointer\": \"/etc/passwd\"}",
        b"{\"pointer\": \"md5_0\", \"values\": {\"a\": 1}}",
        cut,
    ];
    let body = bodies.get(chance.below(bodies.len())).copied().unwrap_or_default();
    Ok(wants(&site.ask("POST", "/grasshopper", body)?, &[400, 403, 404]))
}

/// Says more than may be said, up to the end.
fn too_large(site: &Site<'_>, _: &mut Chance) -> Outcome<Came> {
    // The server of the soak takes a megabyte.
    let body = vec![b' '; 1_500_000];
    Ok(wants(&site.ask("POST", "/grasshopper", &body)?, &[413]))
}

/// Says the right thing, a little at a time.
fn slowly(site: &Site<'_>, chance: &mut Chance) -> Outcome<Came> {
    const STEPS: usize = 12;
    let case = site.case(chance)?;
    let mut client = Client::new(site.host)?;
    for piece in case.request.chunks(case.request.len().div_ceil(STEPS).max(1)) {
        client.say(piece)?;
        sleep(Duration::from_millis(100));
    }
    Ok(judged(case, &client.hear()?))
}

/// Where a job is, when it was taken.
fn submitted(site: &Site<'_>, body: &[u8]) -> Outcome<Result<String, Came>> {
    let answer = site.ask("POST", "/jobs", body)?;
    Ok(match answer.json()["id"].as_str() {
        Some(id) if answer.status == 202 => Ok(format!("/jobs/{id}")),
        _ => Err(wants(&answer, &[])),
    })
}

fn state(about: &Value) -> &str {
    about["state"].as_str().unwrap_or_default()
}

/// Has a case solved as a job, looks after it, fetches the result, and lets it go.
fn job(site: &Site<'_>, chance: &mut Chance) -> Outcome<Came> {
    const LONG: Duration = Duration::from_secs(60);
    let case = site.case(chance)?;
    let place = match submitted(site, &case.body)? {
        Ok(place) => place,
        Err(came) => return Ok(came),
    };
    let start = Instant::now();
    loop {
        let about = site.ask("GET", &place, b"")?;
        match state(&about.json()) {
            "waiting" | "running" if start.elapsed() < LONG => sleep(Duration::from_millis(50)),
            "done" => break,
            _ => return Ok(wants(&about, &[])),
        }
    }
    let result = site.ask("GET", &format!("{place}/result"), b"")?;
    let came = judged(case, &result);
    let gone = site.ask("DELETE", &place, b"")?;
    Ok(if came == Came::Right { wants(&gone, &[200]) } else { came })
}

/// Begins a job without end, and cancels it.
fn cancelled_job(site: &Site<'_>, chance: &mut Chance) -> Outcome<Came> {
    let place = match submitted(site, site.endless)? {
        Ok(place) => place,
        Err(came) => return Ok(came),
    };
    sleep(Duration::from_millis(20 + chance.below(300) as u64));
    let answer = site.ask("DELETE", &place, b"")?;
    let is_so = state(&answer.json()) == "cancelled";
    Ok(if is_so { wants(&answer, &[200]) } else { Came::Wrong(answer.status) })
}

/// Has a case solved without anything kept.
fn no_store(site: &Site<'_>, chance: &mut Chance) -> Outcome<Came> {
    let case = site.case(chance)?;
    let text = String::from_utf8_lossy(&case.request);
    let changed = text.replacen("\r\n", "\r\nCache-Control: no-store\r\n", 1);
    Ok(judged(case, &Client::new(site.host)?.ask(changed.as_bytes())?))
}
