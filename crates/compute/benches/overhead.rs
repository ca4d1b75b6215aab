//! What a request costs beyond its solve: with the definition kept, and with it sent along.
//!
//! `cargo bench -p katydid-compute --bench overhead [FILE]...` prints medians in milliseconds. Without a file it makes
//! a definition of 300 objects of its own.

use std::time::{Duration, Instant};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use katydid_component::registry;
use katydid_compute::{Bounds, Compute, Located, Settings, SolveRequest};
use katydid_definition::document::{Document, Object, ids};
use serde_json::json;
use uuid::Uuid;

const ROUNDS: usize = 200;

/// A chain of additions of one input: every object depends on it.
fn chain(objects: u128) -> Document {
    let mut document = Document::new();
    let make = |component: Uuid, n: u128| katydid_session::new_object(component, Uuid::from_u128(n)).ok();
    let addition = registry::by_name("Addition").map(|component| component.guid).unwrap_or_default();
    document.objects.extend(make(ids::NUMBER_SLIDER, 1));
    let mut before = document.objects.first().and_then(|object| object.outputs.first()).map(|port| port.id);
    for n in 2..objects {
        let Some(mut object) = make(addition, n) else { continue };
        for input in 0..2 {
            if object.set_sources(input, before.as_slice()).is_err() {
                eprintln!("an addition has two inputs");
            }
        }
        before = object.outputs.first().map(|port| port.id);
        document.objects.push(object);
    }
    let last = document.objects.last().map(|object| object.id).unwrap_or_default();
    for (k, (label, member)) in [("RH_IN:x", Uuid::from_u128(1)), ("RH_OUT:y", last)].into_iter().enumerate()
    {
        let mut group = Object::new_component(ids::GROUP, "Group", label, Uuid::from_u128(9000 + k as u128));
        group.container_mut().set_at("ID", 0, member);
        group.container_mut().set("ID_Count", 1);
        group.refresh();
        document.objects.push(group);
    }
    document
}

fn median(mut times: Vec<Duration>) -> f64 {
    times.sort_unstable();
    times.get(times.len() / 2).map_or(0.0, |time| time.as_secs_f64() * 1e3)
}

fn report(name: &str, bytes: &[u8]) -> Result<(), Box<dyn std::error::Error>> {
    let algo = STANDARD.encode(bytes);
    let compute = Compute::new(Settings::default());
    let (mut solves, mut kept, mut sent, mut first) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut answer = |compute: &Compute, body: String, times: &mut Vec<Duration>| {
        let begin = Instant::now();
        let request = SolveRequest::read(body.as_bytes(), &compute.settings().request)?;
        let Located::Here(definition) = compute.locate(&request)? else { return Ok(()) };
        let answer = compute.answer(&definition, &request, &Bounds::default())?;
        times.push(begin.elapsed() - answer.timings.solve);
        solves.push(answer.timings.solve);
        Ok::<(), katydid_compute::Fault>(())
    };
    let key = katydid_compute::cache::key(&algo);
    for round in 0..ROUNDS {
        let values = json!([{"ParamName": "RH_IN:x", "InnerTree": {"0": [{"data": round}]}}]);
        if round < ROUNDS / 10 {
            let fresh = Compute::new(Settings::default());
            answer(&fresh, json!({ "algo": algo, "values": values }).to_string(), &mut first)?;
        }
        answer(&compute, json!({ "algo": algo, "values": values }).to_string(), &mut sent)?;
        answer(&compute, json!({ "pointer": key, "values": values }).to_string(), &mut kept)?;
    }
    let objects = compute.cached(&key).map_or(0, |definition| definition.document().objects.len());
    println!(
        "{name}: {objects} objects, {} kB; beyond the solve of {:.3} ms: kept {:.3} ms, sent again {:.3} ms, read anew {:.3} ms",
        bytes.len() / 1000,
        median(solves),
        median(kept),
        median(sent),
        median(first),
    );
    Ok(())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    katydid_components::link();
    report("a chain", &chain(298).to_gh()?)?;
    for file in std::env::args().skip(1).filter(|argument| !argument.starts_with("--")) {
        report(&file, &std::fs::read(&file)?)?;
    }
    Ok(())
}
