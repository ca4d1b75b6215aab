//! Scripts run where whoever is at the machine lets them: asked once for a file, and not for what others change.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use common::{Client, Studio, is_done, refusal};
use katydid_server::ScriptConfig;
use katydid_session::protocol::{Ask, Control, Edit, Event, ScriptPermission, Setting};

const DOUBLES: &str = r#"katydid 1
s = Number Slider(21, 0..100)
twice = `GhPython Script` @410755b1-224a-4c1e-a407-bf32fb45ea7e(x = s) variable -> out, a {
    CodeInput = """
        import os
        a = x * 2
        """
    HideInput = true
}
shown = Panel(twice.a)
"#;

async fn studio() -> Studio {
    Studio::start_with(|mut config| {
        let trusted = config.state.as_ref().map(|state| state.join("trusted"));
        config.scripts = Some(ScriptConfig { trusted, ..ScriptConfig::default() });
        config
    })
    .await
}

fn permission(client: &Client) -> Option<ScriptPermission> {
    client.state.as_ref().and_then(|state| state.document.scripts).map(|scripts| scripts.permission)
}

async fn until(client: &mut Client, wanted: ScriptPermission) {
    while permission(client) != Some(wanted) {
        client.hear().await.expect("it goes on");
    }
}

fn text(client: &Client, text: &str) -> Edit {
    let control = Control::Script {
        language: String::new(),
        text: text.to_owned(),
        additional: None,
        using: None,
        from_wire: false,
        hints: Vec::new(),
    };
    Edit::Reshape { object: client.named("twice"), control }
}

const RUN: Ask = Ask::AllowScripts { run: true, keep: true };

#[tokio::test]
async fn it_is_asked_once_for_a_file() {
    let studio = studio().await;
    let mut client = studio.with(DOUBLES).await;
    assert_eq!(permission(&client), Some(ScriptPermission::Asked));
    assert!(client.texts("shown").iter().all(|text| text != "42"));
    let Event::Scripts { scripts, .. } = client.ask(Ask::Scripts).await else { panic!("no scripts") };
    assert_eq!(scripts[0].imports, ["os"]);
    assert!(scripts[0].text.contains("a = x * 2"));
    assert!(is_done(&client.ask(RUN).await));
    client.shows("shown", &["42"]).await;
    // The owner writes on without being asked again.
    let edit = text(&client, "a = x * 3");
    assert!(is_done(&client.edit(edit).await));
    client.shows("shown", &["63"]).await;
    let mut again = studio.with(DOUBLES).await;
    again.shows("shown", &["42"]).await;
    let other = studio.with(&DOUBLES.replace("21", "22")).await;
    assert_eq!(permission(&other), Some(ScriptPermission::Asked));
}

#[tokio::test]
async fn others_neither_answer_nor_bring_in_code() {
    let studio = studio().await;
    let document = studio.upload(DOUBLES).await;
    let mut owner = studio.join(&document).await;
    let mut guest = studio.join_from(&document, "192.168.1.7").await;
    owner.solved(1).await;
    assert!(refusal(&guest.ask(RUN).await).contains("at the machine"));
    assert!(is_done(&owner.ask(RUN).await));
    owner.shows("shown", &["42"]).await;
    // A number is data.
    guest.hear().await;
    assert!(is_done(&guest.set("s", 4.0).await));
    owner.shows("shown", &["8"]).await;
    until(&mut owner, ScriptPermission::Given).await;
    let edit = text(&guest, "a = 'mine'");
    assert!(is_done(&guest.edit(edit).await));
    until(&mut owner, ScriptPermission::Asked).await;
    assert!(is_done(&owner.ask(RUN).await));
    owner.shows("shown", &["mine"]).await;
    // What was taken back before the owner looked cannot be made again behind their back.
    assert!(is_done(&guest.ask(Ask::Undo).await));
    until(&mut owner, ScriptPermission::Asked).await;
    assert!(is_done(&owner.ask(RUN).await));
    assert!(is_done(&guest.ask(Ask::Redo).await));
    until(&mut owner, ScriptPermission::Asked).await;
    let panel = guest.named("shown");
    assert!(is_done(&owner.ask(RUN).await));
    let code = Edit::Set { object: panel, to: Setting::Text { text: "import os".to_owned() } };
    let _ = guest.edit(code).await;
    until(&mut owner, ScriptPermission::Asked).await;
}

#[tokio::test]
async fn what_is_pasted_with_a_script_in_it_is_asked_about() {
    let studio = studio().await;
    let mut client = studio.with(DOUBLES).await;
    assert!(is_done(&client.ask(RUN).await));
    client.shows("shown", &["42"]).await;
    let objects = vec![client.named("twice")];
    let Event::Copied { text, .. } = client.ask(Ask::Copy { objects, within: vec![] }).await else {
        panic!("nothing copied")
    };
    let paste = Edit::Paste { text, at: None, seed: uuid::Uuid::from_u128(7) };
    assert!(is_done(&client.edit(paste).await));
    until(&mut client, ScriptPermission::Asked).await;
    let objects = vec![client.named("s")];
    assert!(is_done(&client.ask(RUN).await));
    until(&mut client, ScriptPermission::Given).await;
    let Event::Copied { text, .. } = client.ask(Ask::Copy { objects, within: vec![] }).await else {
        panic!("nothing copied")
    };
    let paste = Edit::Paste { text, at: None, seed: uuid::Uuid::from_u128(8) };
    assert!(is_done(&client.edit(paste).await));
    assert_eq!(permission(&client), Some(ScriptPermission::Given));
}

#[tokio::test]
async fn without_a_place_for_scripts_nobody_is_asked() {
    let studio = Studio::start().await;
    let mut client = studio.with(DOUBLES).await;
    assert_eq!(permission(&client), None);
    assert!(refusal(&client.ask(RUN).await).contains("not run here"));
}
