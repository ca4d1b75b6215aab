//! What it takes, measured: `cargo test --release -p katydid-server --test measures -- --ignored --nocapture`.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::print_stdout, reason = "it prints")]

mod common;

use std::time::Duration;

use common::{Client, Studio};
use katydid_session::protocol::{Ask, Edit, Event, Setting};
use tokio::time::Instant;
use uuid::Uuid;

fn milliseconds(time: Duration) -> f64 {
    (time.as_secs_f64() * 1e4).round() / 10.0
}

/// The value below which so large a part of them lies.
fn share(values: &mut [f64], part: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values[((values.len() - 1) as f64 * part).round() as usize]
}

/// 300 objects that all hang on one slider.
fn three_hundred() -> String {
    let mut text = "katydid 1\nr = Number Slider(20.0, 1..100)\n".to_owned();
    for k in 1..=60 {
        text.push_str(&format!(
            "f{k} = Operators/Multiplication(r, {k})\nc{k} = Circle(_, f{k})\nd{k} = Divide Curve(c{k}, 200)\n\
             m{k} = Move(d{k}.Points, (0, 0, {k}))\ni{k} = Interpolate(m{k})\n"
        ));
    }
    text
}

struct Change {
    solve: f64,
    results: f64,
    previews: f64,
}

/// Sets a slider, and waits for the results and the geometry of it.
async fn change(client: &mut Client, slider: Uuid, value: f64) -> Change {
    let start = Instant::now();
    let edit = Edit::Set { object: slider, to: Setting::Number { value } };
    client.tell(Ask::Edit { edit, gesture: Some(1), within: vec![] }).await;
    let (mut solved, mut drawn) = (None, None);
    loop {
        match client.hear().await {
            Some(Event::Results { finished: true, milliseconds: took, .. }) => {
                solved = Some((took, milliseconds(start.elapsed())));
            }
            Some(Event::Preview { .. }) => drawn = Some(milliseconds(start.elapsed())),
            _ => {}
        }
        // Geometry that is drawn soon comes first, else the results.
        if let (Some((solve, results)), Some(previews)) = (solved, drawn) {
            return Change { solve, results, previews };
        }
    }
}

#[tokio::test(flavor = "multi_thread")]
#[ignore = "a measurement"]
async fn a_slider_of_three_hundred_objects() {
    let studio = Studio::start().await;
    let mut client = studio.with(&three_hundred()).await;
    let slider = client.named("r");
    for draft in [false, true] {
        client.ask(Ask::Draft { on: draft }).await;
        tokio::time::sleep(Duration::from_millis(500)).await;
        let mut all = Vec::new();
        for k in 0..60 {
            all.push(
                change(
                    &mut client,
                    slider,
                    20.0 + f64::from(k + 1) / 10.0 + 10.0 * f64::from(u8::from(draft)),
                )
                .await,
            );
        }
        let of = |part: f64, value: fn(&Change) -> f64| {
            share(&mut all.iter().map(value).collect::<Vec<_>>(), part)
        };
        println!(
            "300 objects, draft {draft}: solve {} ms, results {} ms, geometry {} ms (95 %: {} ms); beyond the solve {} ms",
            of(0.5, |c| c.solve),
            of(0.5, |c| c.results),
            of(0.5, |c| c.previews),
            of(0.95, |c| c.previews),
            of(0.5, |c| c.previews - c.solve),
        );
    }
    // As a hand drags: a change every 16 ms, whether the last is shown or not.
    client.ask(Ask::Draft { on: true }).await;
    let (start, mut shown) = (Instant::now(), 0);
    let mut next = tokio::time::interval(Duration::from_millis(16));
    let mut sent = 0_u32;
    while sent < 125 {
        tokio::select! {
            _ = next.tick() => {
                let edit = Edit::Set { object: slider, to: Setting::Number { value: 30.0 + f64::from(sent) / 10.0 } };
                client.tell(Ask::Edit { edit, gesture: Some(2), within: vec![] }).await;
                sent += 1;
            }
            event = client.hear() => shown += usize::from(matches!(event, Some(Event::Preview { .. }))),
        }
    }
    let dragged = start.elapsed();
    let last = client.named("f1");
    let wanted = change(&mut client, slider, 77.0).await;
    println!(
        "dragged for {} ms with {sent} changes: {shown} frames; the last change shown after {} ms; {last}",
        milliseconds(dragged),
        wanted.previews,
    );
}

/// The memory of this process in MB.
fn memory() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|line| line.starts_with("VmRSS")).unwrap_or_default();
    let kilobytes: f64 = line.split_whitespace().nth(1).and_then(|x| x.parse().ok()).unwrap_or(0.0);
    (kilobytes / 102.4).round() / 10.0
}

#[tokio::test(flavor = "multi_thread")]
#[ignore = "a measurement"]
async fn a_mesh_of_a_million_triangles() {
    let studio = Studio::start().await;
    let text = "katydid 1\nh = Number Slider(1.0, 0..100)\nm = Mesh Plane(rectangle(plane((0, 0, 0)), 0..100, 0..100), 707, 707) hidden\n\
                out = Move(m.Mesh, Vector XYZ(0, 0, h).Vector)\n";
    let mut client = studio.with(text).await;
    let (slider, out) = (client.named("h"), client.named("out"));
    client.drawn(out).await;
    let (mut encode, mut fetch, mut bytes) = (Vec::new(), Vec::new(), 0);
    let before = memory();
    for k in 0..100 {
        let made = change(&mut client, slider, 1.0 + f64::from(k + 1) / 10.0).await;
        encode.push(made.previews - made.solve);
        let hash = client.hashes[&out].clone().unwrap();
        let start = Instant::now();
        bytes = studio.get(&format!("/geometry/{hash}")).await.body.len();
        fetch.push(milliseconds(start.elapsed()));
        if k % 20 == 19 {
            println!("after {} changes: {} MB (before: {before} MB)", k + 1, memory());
        }
    }
    println!(
        "1,000,000 triangles: {} MB, encoded in {} ms (95 %: {} ms), fetched in {} ms",
        bytes >> 20,
        share(&mut encode, 0.5),
        share(&mut encode, 0.95),
        share(&mut fetch, 0.5),
    );
    client.ask(Ask::Draft { on: true }).await;
    let mut coarse = Vec::new();
    for k in 0..10 {
        let made = change(&mut client, slider, 50.0 + f64::from(k)).await;
        coarse.push(made.previews - made.solve);
    }
    println!("the same while dragging: {} ms", share(&mut coarse, 0.5));
}
