//! `/rhino/geometry/…`: functions of RhinoCommon.

use std::sync::Arc;
use std::time::{Duration, Instant};

use axum::response::Response;
use katydid_compute::geometry::{self, Query};

use super::asked::{self, Asking};
use super::body::Received;
use super::pool::Step;
use super::refusal::Refusal;
use super::sent::{HTML, JSON, Page, Sent};
use super::service::Service;
use super::work::Reins;

/// Where functions begin; what else there is below `/rhino` is not here.
fn name(parts: &[String]) -> Result<String, Refusal> {
    match parts {
        [rhino, geometry, rest @ ..] if rhino == "rhino" && geometry == "geometry" && !rest.is_empty() => {
            Ok(rest.join("/"))
        }
        _ => Err(Refusal::unsupported(&parts.join("/"))),
    }
}

/// Calls a function.
pub(crate) async fn call(
    service: Arc<Service>,
    asking: Asking,
    parts: &[String],
    body: Received,
) -> Result<Response, Refusal> {
    let name = name(parts)?;
    let query = Query::read(asking.query.pairs())?;
    let (packs, held, whole) = (asking.packs, Arc::clone(&service), body.clone());
    let call = move |reins: Reins| {
        Step::Done(called(&held, &name, &query, body, &reins).map(|sent| sent.packed(packs)))
    };
    asked::answered(&service, &asking, Some(&whole), call).await.map(|answered| answered.response)
}

fn called(
    service: &Service,
    name: &str,
    query: &Query,
    body: Received,
    reins: &Reins,
) -> Result<Sent, Refusal> {
    let start = Instant::now();
    let bounds = reins.bounds()?;
    let body = body.unpacked()?;
    let decode = start.elapsed();
    service.idle.touch();
    let called = geometry::call(name, query, &body, &bounds);
    let solve = start.elapsed().saturating_sub(decode);
    let called = called.map_err(|fault| reins.refusal(fault));
    service.solved(None, solve, called.as_ref().err());
    let called = called?;
    let text = called.text();
    let encode = start.elapsed().saturating_sub(decode + solve);
    let steps: [(&str, Duration); 3] = [("decode", decode), ("solve", solve), ("encode", encode)];
    Ok(Sent::new(JSON, text).timed(&steps))
}

/// A page that explains a function.
pub(crate) fn help(parts: &[String]) -> Result<Sent, Refusal> {
    Ok(Sent::new(HTML, geometry::endpoints().help(&name(parts)?)?))
}

/// A page that lists all functions.
pub(crate) fn list(packs: bool) -> Sent {
    static KEPT: Page = Page::new();
    KEPT.sent(packs, || Sent::new(HTML, geometry::endpoints().index()))
}
