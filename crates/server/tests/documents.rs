//! A document is opened, looked at, changed, saved and taken along, as the page does it.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::time::Duration;

use common::{Studio, WAIT, is_done, refusal};
use katydid_server::Config;
use katydid_session::protocol::{
    AnalysisView, Ask, BendView, CombMeasure, CombView, Edit, Event, GeometrySource, ObjectChange, Probe,
    ProbePlace, Probed, Row, Setting,
};
use tokio::time::Instant;

const SMALL: &str = r#"katydid 1
r = Number Slider(2.0, 0..10)
ball = Sphere(_, r)
double = Operators/Multiplication(r, 2)
shown = Panel(double)
"#;

#[tokio::test(flavor = "multi_thread")]
async fn a_slider_moves_the_model() {
    let studio = Studio::start().await;
    let mut client = studio.with(SMALL).await;
    assert_eq!(client.texts("shown"), ["4"]);
    let ball = client.named("ball");
    let first = client.drawn(ball).await.unwrap();
    let event = client.set("r", 3.0).await;
    assert!(is_done(&event), "{event:?}");
    let second = client.drawn(ball).await.unwrap();
    assert_ne!(first, second);
    client.shows("shown", &["6"]).await;
    let object = client.named("r");
    assert!(matches!(
        client.objects[&object].control,
        Some(katydid_session::protocol::Control::Slider { value: 3.0, .. })
    ));
    let bytes = studio.get(&format!("/geometry/{second}")).await;
    assert_eq!(bytes.status, 200);
    assert_eq!(&bytes.body[..4], b"KTPV");
    assert!(bytes.head.contains("immutable"));
    while client.frames.len() < 2 {
        client.hear().await;
    }
    assert!(client.frames.iter().any(|frame| frame[16..] == bytes.body), "small geometry comes by itself");
    let event = client.ask(Ask::Undo).await;
    assert!(is_done(&event));
    assert_eq!(client.drawn(ball).await.unwrap(), first, "the same data has the same hash");
    client.shows("shown", &["4"]).await;
    studio.server.stop().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn what_is_hidden_is_not_drawn_and_moving_draws_nothing() {
    let studio = Studio::start().await;
    let mut client = studio.with(SMALL).await;
    let ball = client.named("ball");
    let hash = client.drawn(ball).await;
    assert!(hash.is_some());
    let hide = |on| Edit::Change { objects: vec![ball], change: ObjectChange::Hidden { on } };
    client.edit(hide(true)).await;
    assert_eq!(client.drawn(ball).await, None);
    client.edit(hide(false)).await;
    assert_eq!(client.drawn(ball).await, hash);
    let solved = client.finished;
    client.edit(Edit::Move { objects: vec![(ball, [500.0, 500.0])] }).await;
    client.set("r", 2.5).await;
    client.solved(solved + 1).await;
    assert_eq!(client.objects[&ball].bounds[0], 500.0);
}

#[tokio::test(flavor = "multi_thread")]
async fn two_faces_see_the_same() {
    let studio = Studio::start().await;
    let id = studio.upload(SMALL).await;
    let (mut one, mut two) = (studio.join(&id).await, studio.join(&id).await);
    one.solved(1).await;
    one.set("r", 7.0).await;
    let start = Instant::now();
    while two.texts_or_nothing("shown") != ["14"] {
        assert!(start.elapsed() < WAIT);
        two.hear().await;
    }
    let mut three = studio.join(&id).await;
    while three.texts_or_nothing("shown") != ["14"] {
        three.hear().await;
    }
    let ball = three.named("ball");
    while !three.hashes.contains_key(&ball) {
        three.hear().await;
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_document_is_saved_and_opened_again() {
    let studio = Studio::start().await;
    let mut client = studio.with(SMALL).await;
    client.set("r", 5.0).await;
    assert!(client.state.as_ref().unwrap().document.changed);
    assert!(refusal(&client.ask(Ask::Save { path: None }).await).contains("never saved"));
    for form in ["gh", "ghx", "kd"] {
        let path = studio.folder.path().join(format!("saved.{form}"));
        let event = client.ask(Ask::Save { path: Some(path.display().to_string()) }).await;
        assert!(is_done(&event), "{event:?}");
        assert!(!client.state.as_ref().unwrap().document.changed);
        let opened = studio.post_json("/api/open", &format!("{{\"path\":{path:?}}}")).await.json();
        let mut again = studio.join(opened["document"].as_str().unwrap()).await;
        again.solved(1).await;
        assert_eq!(again.texts("shown"), ["10"], "{form}");
        let state = again.state.as_ref().unwrap();
        assert_eq!(state.document.name, format!("saved.{form}"));
        let twice = studio.post_json("/api/open", &format!("{{\"path\":{path:?}}}")).await.json();
        assert_eq!(twice, opened);
    }
    for (path, why) in
        [("relative.gh", "folder"), ("/nowhere/at/all.gh", "no such"), ("/tmp/x.txt", ".kd"), ("", "name")]
    {
        let event = client.ask(Ask::Save { path: Some(path.to_owned()) }).await;
        assert!(refusal(&event).contains(why), "{path}: {event:?}");
    }
    let start = studio.get("/api/start").await.json();
    assert_eq!(start["recent"].as_array().unwrap().len(), 3);
    assert_eq!(start["recent"][0]["name"], "saved.kd");
    assert_eq!(start["local"], true);
}

#[tokio::test(flavor = "multi_thread")]
async fn files_to_take_along() {
    let studio = Studio::start().await;
    let id = studio.upload(SMALL).await;
    let mut client = studio.join(&id).await;
    client.solved(1).await;
    for (form, begins) in [("ghx", &b"\xef\xbb\xbf<?xml"[..]), ("kd", b"katydid 1"), ("gh", b"")] {
        let answer = studio.get(&format!("/api/save?document={id}&format={form}")).await;
        assert_eq!(answer.status, 200);
        assert!(
            answer.body.starts_with(begins) && answer.head.contains(&format!("filename=\"test.{form}\""))
        );
    }
    for (format, begins) in [
        ("3dm", &b"3D Geometry File Format"[..]),
        ("glb", b"glTF"),
        ("obj", b"#"),
        ("stl", b""),
        ("svg", b"<svg"),
        ("png", b"\x89PNG"),
    ] {
        let answer =
            studio.get(&format!("/api/export?document={id}&format={format}&width=320&height=200")).await;
        assert_eq!(answer.status, 200, "{format}: {}", String::from_utf8_lossy(&answer.body));
        assert!(answer.body.starts_with(begins) && answer.body.len() > 84, "{format}");
    }
    for wrong in ["/api/export?document=1&format=3dm", "/api/save?document=1&format=gh", "/geometry/none"] {
        assert_eq!(studio.get(wrong).await.status, 404, "{wrong}");
    }
    for wrong in
        [format!("/api/export?document={id}&format=exe"), format!("/api/save?document={id}&format=zip")]
    {
        assert_eq!(studio.get(&wrong).await.status, 400, "{wrong}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_document_is_closed_when_nobody_shows_it() {
    let studio = Studio::start().await;
    let opened = studio.post_json("/api/open", r#"{"new":true}"#).await.json();
    let id = opened["document"].as_str().unwrap().to_owned();
    let question = format!("{{\"document\":\"{id}\"}}");
    let client = studio.join(&id).await;
    assert_eq!(studio.post_json("/api/close", &question).await.status, 409, "a page shows it");
    drop(client);
    let mut closed = 409;
    for _ in 0..100 {
        closed = studio.post_json("/api/close", &question).await.status;
        if closed != 409 {
            break;
        }
        tokio::time::sleep(std::time::Duration::from_millis(50)).await;
    }
    assert_eq!(closed, 200);
    let open = studio.get("/api/start").await.json()["open"].as_array().unwrap().len();
    assert_eq!((open, studio.post_json("/api/close", &question).await.status), (0, 404));
}

#[tokio::test(flavor = "multi_thread")]
async fn the_gallery_and_the_catalogue() {
    let studio = Studio::start().await;
    let start = studio.get("/api/start").await.json();
    let gallery = start["gallery"].as_array().unwrap();
    assert!(gallery.len() >= 40 && gallery.iter().all(|one| one["title"].as_str().is_some()));
    let opened = studio.post_json("/api/open", r#"{"gallery":"V2"}"#).await.json();
    let mut client = studio.join(opened["document"].as_str().unwrap()).await;
    client.solved(1).await;
    assert!(client.results.values().all(|result| result.status == "ok"), "the book runs without a warning");
    let all = studio.get("/api/components").await.json();
    let addition = all.as_array().unwrap().iter().find(|one| one["name"] == "Addition").unwrap().clone();
    assert!(all.as_array().unwrap().len() > 500 && addition["keywords"][0] == "+");
    let help = studio.get(&format!("/api/help?component={}", addition["guid"].as_str().unwrap())).await;
    assert_eq!((help.status, help.json()["name"].as_str().unwrap()), (200, "Addition"));
    assert_eq!(studio.get("/api/help?component=nonsense").await.status, 400);
}

#[tokio::test(flavor = "multi_thread")]
async fn dragging_is_coarse_and_letting_go_is_fine() {
    let studio = Studio::start().await;
    let mut client = studio.with("katydid 1\nr = Number Slider(2.0, 0..10)\nball = Sphere(_, r)\n").await;
    let ball = client.named("ball");
    client.drawn(ball).await;
    client.tell(Ask::Draft { on: true }).await;
    let slider = client.named("r");
    for k in 0..20 {
        let to = Setting::Number { value: 3.0 + f64::from(k) / 10.0 };
        client
            .tell(Ask::Edit { edit: Edit::Set { object: slider, to }, gesture: Some(1), within: vec![] })
            .await;
    }
    let coarse = client.drawn(ball).await;
    assert!(is_done(&client.ask(Ask::Draft { on: false }).await));
    let start = Instant::now();
    let mut last = coarse;
    // The last word is the fine one of the last value: that which a fresh document of that value shows.
    let mut other = studio.with("katydid 1\nr = Number Slider(4.9, 0..10)\nball = Sphere(_, r)\n").await;
    let other_ball = other.named("ball");
    let fine = other.drawn(other_ball).await;
    let sizes =
        |hash: Option<String>| async { studio.get(&format!("/geometry/{}", hash.unwrap())).await.body.len() };
    let fine = sizes(fine).await;
    while start.elapsed() < WAIT {
        if let Ok(now) = tokio::time::timeout(Duration::from_millis(500), client.drawn(ball)).await {
            last = now;
        } else {
            break;
        }
    }
    assert!(sizes(last).await.abs_diff(fine) < 64);
    assert!(is_done(&client.ask(Ask::Undo).await));
    let state = client.state.as_ref().unwrap();
    assert!(!state.document.changed, "a drag is one step");
}

#[tokio::test(flavor = "multi_thread")]
async fn rows_of_outputs_and_inputs() {
    let studio = Studio::start().await;
    let mut client = studio.with("katydid 1\nn = Series(1, 2, 5)\nsum = Mass Addition(n)\n").await;
    let series = client.objects[&client.named("n")].clone();
    let sum = client.objects[&client.named("sum")].clone();
    for port in [series.outputs[0].id, sum.inputs[0].id] {
        match client.ask(Ask::Rows { port, from: 1, count: 3, exact: false, within: vec![] }).await {
            Event::Rows { page, .. } => assert_eq!((page.from, page.total, page.rows.len()), (1, 6, 3)),
            other => panic!("{other:?}"),
        }
    }
    let nobody = uuid::Uuid::from_u128(1);
    let event = client.ask(Ask::Rows { port: nobody, from: 0, count: 1, exact: false, within: vec![] }).await;
    assert!(refusal(&event).contains("no data"));
}

#[tokio::test(flavor = "multi_thread")]
async fn curvature_is_looked_at_and_follows_a_slider() {
    let studio = Studio::start().await;
    let mut client = studio.with("katydid 1\nr = Number Slider(2.0, 0..10)\nring = Circle(_, r)\n").await;
    let ring = client.named("ring");
    client.drawn(ring).await;
    let comb = Some(CombView { teeth: 8, length: 0.2, surfaces: false });
    let analysis = AnalysisView { objects: Some(vec![ring]), comb, ..AnalysisView::default() };
    assert!(is_done(&client.ask(Ask::Analyse { analysis: Some(analysis) }).await));
    let first = analysed(&mut client).await;
    let (comb, hash) = (first.0.unwrap(), first.1[&ring].clone().unwrap());
    assert!((comb.sharpest - 0.5).abs() < 1e-12);
    // The geometry came before the event that names it, and says its hash.
    let frame = client.frames.last().unwrap();
    let named: String = frame[..16].iter().map(|byte| format!("{byte:02x}")).collect();
    assert_eq!(named, hash);
    assert_eq!(studio.get(&format!("/geometry/{hash}")).await.body, frame[16..]);

    let at = ProbePlace::Near { point: [9.0, 9.0, 0.0] };
    let place = Probe { object: ring, output: 0, path: "{0}".to_owned(), index: 0, at };
    client.tell(Ask::Probe { round: 7, probes: vec![place] }).await;
    assert!((radius(&mut client, 7).await - 2.0).abs() < 1e-12);

    client.set("r", 4.0).await;
    let (mut radius_now, mut curvature_now) = (0.0, 0.0);
    while radius_now == 0.0 || curvature_now == 0.0 {
        match client.hear().await {
            Some(Event::Analysed { comb, .. }) => curvature_now = comb.unwrap().sharpest,
            Some(Event::Probed { round: 7, probes, .. }) => radius_now = radius_of(&probes),
            _ => {}
        }
    }
    assert!((radius_now - 4.0).abs() < 1e-12 && (curvature_now - 0.25).abs() < 1e-12);

    client.tell(Ask::Analyse { analysis: None }).await;
    let (comb, objects) = analysed(&mut client).await;
    assert!(comb.is_none() && objects[&ring].is_none(), "it is taken away");
    let many = AnalysisView { objects: Some(vec![ring; 10_001]), ..AnalysisView::default() };
    assert!(!is_done(&client.ask(Ask::Analyse { analysis: Some(many) }).await));
}

type Drawn = std::collections::HashMap<uuid::Uuid, Option<String>>;

async fn analysed(client: &mut common::Client) -> (Option<CombMeasure>, Drawn) {
    loop {
        if let Some(Event::Analysed { comb, objects, .. }) = client.hear().await {
            return (comb, objects.into_iter().collect());
        }
    }
}

async fn radius(client: &mut common::Client, wanted: u32) -> f64 {
    loop {
        match client.hear().await {
            Some(Event::Probed { round, probes, .. }) if round == wanted => return radius_of(&probes),
            _ => {}
        }
    }
}

fn radius_of(probes: &[Option<Probed>]) -> f64 {
    match &probes[0].as_ref().unwrap().bend {
        BendView::Curve { circle, .. } => circle.unwrap().radius,
        other => panic!("{other:?}"),
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn exact_rows_are_kept_again_as_they_were() {
    let studio = Studio::start().await;
    let mut client = studio.with("katydid 1\np = Point([(0, 0, 0)])\nq = Deconstruct(p)\n").await;
    let point = client.objects[&client.named("p")].inputs[0].id;
    let exact = "{0.1, 0.30000000000000004, -1e-17}";
    let values = Some(format!("{{0}}\n{exact}"));
    assert!(is_done(&client.edit(Edit::Keep { port: point, values }).await));
    client.solved(2).await;
    for (all, text) in [(true, exact), (false, "{0.1, 0.3, -0}")] {
        match client.ask(Ask::Rows { port: point, from: 0, count: 9, exact: all, within: vec![] }).await {
            Event::Rows { page, .. } => match &page.rows[1] {
                Row::Item { text: found, .. } => assert_eq!(found, text),
                other => panic!("{other:?}"),
            },
            other => panic!("{other:?}"),
        }
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn who_joins_hears_that_edits_are_not_kept() {
    let folder = tempfile::tempdir().unwrap();
    let (file, state) = (folder.path().join("a.kd"), folder.path().join("state"));
    std::fs::write(&file, "katydid 1\nr = Number Slider(2.0, 0..10)\n").unwrap();
    let start = || {
        Studio::start_with(|config| Config { file: Some(file.clone()), state: Some(state.clone()), ..config })
    };
    let first = start().await;
    let (_, query) = first.server.url().split_once("document=").unwrap();
    let id = query.split('&').next().unwrap();
    let mut holder = first.join(id).await;
    holder.solved(1).await;
    let second = start().await;
    // Whoever joins late hears it too: it waits for somebody.
    tokio::time::sleep(Duration::from_millis(300)).await;
    let mut client = second.join(id).await;
    let since = Instant::now();
    while !client.notices.iter().any(|notice| notice.contains("another Katydid")) {
        assert!(since.elapsed() < WAIT, "{:?}", client.notices);
        client.hear().await;
    }
    assert!(holder.notices.is_empty(), "{:?}", holder.notices);
}

/// A model with a line of length 5 on the layer Walls.
fn model() -> Vec<u8> {
    use katydid_3dm::{Attributes, Layer, Model, ModelObject, Object};
    let line = katydid_geometry::Line::new(
        katydid_geometry::Point3::ORIGIN,
        katydid_geometry::Point3::new(3.0, 4.0, 0.0),
    );
    let attributes = Attributes { id: uuid::Uuid::from_u128(0xa1), layer: Some(0), ..Attributes::default() };
    let objects = vec![ModelObject { attributes, ..ModelObject::from(Object::Curve(line.into())) }];
    Model { layers: vec![Layer::new("Walls")], objects, ..Model::default() }.write(70).unwrap()
}

#[tokio::test(flavor = "multi_thread")]
async fn a_model_is_shown_by_layers_and_its_objects_are_picked() {
    let studio = Studio::start().await;
    let mut client = studio.with("katydid 1\nwall = Curve()\n").await;
    let id = studio.get("/api/start").await.json()["open"][0]["id"].as_str().unwrap().to_owned();
    let wall = *client.objects.keys().next().unwrap();
    let pick = |object: u128| Edit::SetGeometry {
        port: wall,
        items: vec![GeometrySource::Model { object: uuid::Uuid::from_u128(object) }],
    };
    assert!(matches!(client.edit(pick(0xa1)).await, Event::Refused { .. }), "there is no model yet");
    let sent = studio.ask("POST", &format!("/api/upload?name=house.3dm&document={id}"), "", &model()).await;
    assert_eq!(sent.status, 200);
    let view = loop {
        if let Some(Event::Model { model: Some(view) }) = client.hear().await {
            break view;
        }
    };
    assert_eq!((view.name.as_str(), view.layers.len()), ("house.3dm", 1));
    assert_eq!((view.layers[0].path.as_str(), view.layers[0].objects[0].kind.as_str()), ("Walls", "Curve"));
    let hash = view.layers[0].geometry.clone().unwrap();
    let geometry = studio.get(&format!("/geometry/{hash}")).await;
    assert_eq!((geometry.status, &geometry.body[..4]), (200, b"KTPV".as_slice()));
    // Who joins later is told of it too.
    let mut late = studio.join(&id).await;
    loop {
        if let Some(Event::Model { model }) = late.hear().await {
            assert_eq!(model.as_ref(), Some(&view));
            break;
        }
    }
    assert!(matches!(client.edit(pick(0xff)).await, Event::Refused { .. }), "no such object");
    assert!(matches!(client.edit(pick(0xa1)).await, Event::Done { .. }));
    while client.results.get(&wall).is_none_or(|result| result.outputs[0].items != 1) {
        client.hear().await;
    }
    // Without the model there is nothing that the parameter could refer to.
    assert!(matches!(client.ask(Ask::DetachModel).await, Event::Done { .. }));
    while client.results.get(&wall).is_none_or(|result| result.lacks.is_empty()) {
        client.hear().await;
    }
    let mut last = studio.join(&id).await;
    loop {
        if let Some(Event::Model { model }) = last.hear().await {
            assert_eq!(model, None);
            break;
        }
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn what_a_document_lacks_of_a_model_is_counted() {
    let studio = Studio::start().await;
    let ids = ["a1", "a2"].map(|end| format!("geometry(ref = @00000000-0000-0000-0000-0000000000{end})"));
    let client = studio.with(&format!("katydid 1\nwalls = Curve([{}])\n", ids.join(", "))).await;
    let lacks = &client.results.values().next().unwrap().lacks;
    assert_eq!(lacks.len(), 1);
    assert_eq!((lacks[0].kind.as_str(), lacks[0].objects, lacks[0].has_model), ("Curve", 2, false));
}

#[tokio::test(flavor = "multi_thread")]
async fn definitions_have_pictures_before_they_are_opened() {
    let studio = Studio::start().await;
    let path = studio.folder.path().join("mine.kd");
    std::fs::write(&path, "katydid 1\nball = Sphere(plane((0, 0, 0)), 3)\n").unwrap();
    let asked = format!("/api/portrait?recent={}", path.display());
    assert_eq!(studio.get(&asked).await.status, 404, "it was never opened");
    studio.post_json("/api/open", &format!("{{\"path\":{path:?}}}")).await;
    for address in [asked.as_str(), "/api/portrait?gallery=V2"] {
        let picture = studio.get(address).await;
        assert_eq!((picture.status, &picture.body[..4]), (200, b"\x89PNG".as_slice()), "{address}");
        assert!(picture.body.len() < 100_000, "{address} is small: {}", picture.body.len());
    }
    for (address, status) in [
        ("/api/portrait", 400),
        ("/api/portrait?gallery=../V2", 404),
        ("/api/portrait?recent=/etc/passwd", 404),
    ] {
        assert_eq!(studio.get(address).await.status, status, "{address}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn what_is_only_examined_is_not_solved_until_somebody_says_so() {
    let studio = Studio::start().await;
    let sent = studio.ask("POST", "/api/upload?name=test.kd&locked=true", "", SMALL.as_bytes()).await;
    let mut client = studio.join(sent.json()["document"].as_str().unwrap()).await;
    while client.state.is_none() {
        client.hear().await;
    }
    assert!(client.state.as_ref().unwrap().document.locked);
    // An answer comes behind what was told before it: no result was.
    assert!(is_done(&client.ask(Ask::Draft { on: false }).await));
    assert!(client.results.is_empty());
    assert!(is_done(&client.ask(Ask::Recompute).await));
    client.shows("shown", &["4"]).await;
}

const ROPE: &str = "katydid 1
rope = Line((0, 0, 0), (8, 0, 0)) hidden
points = Divide Curve(rope, 8) -> Points |hidden
chain = PolyLine(points) hidden
links = Explode(chain) hidden
springs = `Length(Line)`(links.Segments, 1.1, 20)
weight = Load(points, (0, 0, -1))
held = Anchor([(0, 0, 0), (8, 0, 0)]) hidden
grab = Grab()
solved = Solver([springs, weight, held, grab.Goal])
place = Deconstruct(solved.Vertices)
hundredths = Operators/Multiplication(place.Z, 100)
whole = Round(hundredths)
shown = Panel(whole.Nearest)
";

#[tokio::test(flavor = "multi_thread")]
async fn a_particle_is_dragged_and_let_go_by_who_leaves() {
    let studio = Studio::start().await;
    let id = studio.upload(ROPE).await;
    let (mut one, mut two) = (studio.join(&id).await, studio.join(&id).await);
    one.solved(1).await;
    two.solved(1).await;
    let rest = two.texts("shown");
    let grab = one.named("grab");
    let hold = |z| Setting::Grab {
        held: Some(katydid_session::protocol::HeldPoint {
            from: [4.0, 0.0, 0.0],
            to: [4.0, 0.0, z],
            reach: 5.0,
        }),
    };
    assert!(is_done(&one.edit(Edit::Set { object: grab, to: hold(6.0) }).await));
    while two.texts("shown") == rest {
        two.hear().await;
    }
    let state = two.state.as_ref().unwrap();
    assert!(state.revision == 0 && state.document.undo.is_none());
    drop(one);
    let rest: Vec<&str> = rest.iter().map(String::as_str).collect();
    two.shows("shown", &rest).await;
    let nobody = Edit::Set { object: two.named("solved"), to: hold(1.0) };
    assert!(refusal(&two.edit(nobody).await).contains("not a Grab"));
    studio.server.stop().await;
}
