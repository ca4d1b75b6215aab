//! The page on a study: its rows while it is made and after, its pictures, and its points opened in the studio.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::fs;
use std::path::Path;

use common::Studio;
use katydid_definition::kd;
use katydid_server::StudyConfig;
use katydid_session::Registry;
use katydid_session::protocol::Control;
use katydid_solver::Options;
use katydid_study::{DefinitionFile, Plan, PlanFile, Settings, sweep};
use serde_json::json;

const TEXT: &str = "katydid 1\nx = Number Slider(1, 0.00..2.00)\nn = Number Slider(3, 1..5)\nk = Number Slider(7, 0..9)\n\
    root = Expression(\"Sqrt(x - 1) * n * k\", x = x, n = n, k = k)\nball = Sphere(_, n)\n";

/// A sweep of 15 points in a folder, 5 of them without a root.
fn make(folder: &Path, definition: Option<&Path>) {
    katydid_components::link();
    let document = kd::read(TEXT, &Registry).unwrap().document;
    let plan = r#"{"inputs": {"x": {"steps": 3}, "n": {}}, "outputs": ["root"], "pictures": true}"#;
    let plan = Plan::bind(&PlanFile::parse(plan).unwrap(), &document).unwrap();
    let definition = definition.map(|file| DefinitionFile {
        file: file.to_path_buf(),
        set: vec![("k".to_owned(), "4".to_owned())],
        ..DefinitionFile::default()
    });
    let settings = Settings { workers: 2, definition, ..Settings::default() };
    sweep(document, Options::default(), &plan, folder, &settings, |_| ()).unwrap();
}

async fn served(folder: &Path) -> Studio {
    let study = StudyConfig { folder: folder.to_path_buf(), definition: None };
    Studio::start_with(|config| katydid_server::Config { study: Some(study), ..config }).await
}

#[tokio::test(flavor = "multi_thread")]
async fn rows_come_from_where_the_page_is_and_anew_when_they_changed() {
    let folder = tempfile::tempdir().unwrap();
    let studio = served(folder.path()).await;
    assert!(studio.server.url().contains("/study?token="), "{}", studio.server.url());
    let empty = studio.get("/api/study").await.json();
    assert_eq!(
        (&empty["state"], &empty["rows"], &empty["problem"]),
        (&json!("empty"), &json!([]), &json!(null))
    );
    make(folder.path(), None);
    let all = studio.get("/api/study").await.json();
    assert_eq!((&all["state"], &all["total"], &all["planned"]), (&json!("done"), &json!(15), &json!(15)));
    assert_eq!(all["columns"][2], json!({"name": "root", "kind": "out", "number": true}));
    let rows = all["rows"].as_array().unwrap();
    assert_eq!((rows.len(), &rows[14][0], &rows[14][5][0]), (15, &json!(14), &json!(2.0)));
    let failed: Vec<_> = rows.iter().filter(|row| row[1] != "ok" && row[1] != "warning").collect();
    assert!(
        failed.len() == 5 && failed.iter().all(|row| row[2].as_str().unwrap().contains("root")),
        "{failed:?}"
    );
    let generation = &all["generation"];
    let rest = studio.get(&format!("/api/study?generation={generation}&from=12")).await.json();
    assert_eq!((&rest["from"], rest["rows"].as_array().unwrap().len()), (&json!(12), 3));
    for query in ["generation=999&from=12", "from=12", &format!("generation={generation}&from=99")] {
        let anew = studio.get(&format!("/api/study?{query}")).await.json();
        assert_eq!((&anew["from"], anew["rows"].as_array().unwrap().len()), (&json!(0), 15), "{query}");
    }
    assert_eq!(studio.get("/api/study?from=-1").await.status, 400);
    // A table that cannot be read is told; what was read stays.
    fs::write(folder.path().join("table.parquet"), "PAR1").unwrap();
    let broken = studio.get("/api/study").await.json();
    assert!(broken["problem"].as_str().unwrap().contains("table.parquet"), "{broken}");
    assert_eq!(broken["rows"].as_array().unwrap().len(), 15);
    studio.server.stop().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn pictures_are_given_and_nothing_else_of_the_machine() {
    let outside = tempfile::tempdir().unwrap();
    fs::write(outside.path().join("secret.png"), "secret").unwrap();
    let folder = outside.path().join("study");
    fs::create_dir(&folder).unwrap();
    make(&folder, None);
    #[cfg(unix)]
    std::os::unix::fs::symlink(outside.path().join("secret.png"), folder.join("pictures/link.png")).unwrap();
    let studio = served(&folder).await;
    let rows = studio.get("/api/study").await.json();
    let picture = rows["rows"][14][3].as_str().unwrap().to_owned();
    let answer = studio.get(&format!("/api/study/file/{picture}")).await;
    assert!(answer.status == 200 && answer.body.starts_with(b"\x89PNG") && answer.head.contains("image/png"));
    for name in [
        "../secret.png",
        "..%2fsecret.png",
        "pictures/..%2f..%2fsecret.png",
        "pictures/%2e%2e/%2e%2e/secret.png",
        "pictures/link.png",
        "%2fetc/passwd",
        "study.json",
        "table.parquet",
        "pictures/",
        "pictures/none.png",
        "%00.png",
        "%ff.png",
    ] {
        let answer = studio.get(&format!("/api/study/file/{name}")).await;
        assert!(matches!(answer.status, 400 | 404), "{name}: {}", answer.status);
        assert!(!answer.body.windows(6).any(|bytes| bytes == b"secret"), "{name}");
    }
    studio.server.stop().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_point_is_opened_as_a_copy_with_its_values() {
    let folder = tempfile::tempdir().unwrap();
    let definition = folder.path().join("roots.kd");
    fs::write(&definition, TEXT).unwrap();
    make(folder.path(), Some(&definition));
    let studio = served(folder.path()).await;
    let told = studio.get("/api/study").await.json();
    assert_eq!(told["definition"], json!("roots.kd"));
    let opened = studio.post_json("/api/study/open", &json!({"point": 13}).to_string()).await;
    assert_eq!(opened.status, 200);
    let id = opened.json()["document"].as_str().unwrap().to_owned();
    let mut client = studio.join(&id).await;
    client.solved(1).await;
    for (name, wanted) in [("x", 2.0), ("n", 4.0), ("k", 4.0)] {
        let object = client.named(name);
        let control = &client.objects[&object].control;
        assert!(
            matches!(control, Some(Control::Slider { value, .. }) if *value == wanted),
            "{name}: {control:?}"
        );
    }
    let start = studio.get("/api/start").await.json();
    assert!(start["open"].as_array().unwrap().iter().any(|one| one["name"] == "roots point 13"), "{start}");
    assert_eq!(fs::read_to_string(&definition).unwrap(), TEXT, "the original is as it was");
    // Each opening is a document of its own, so that two points can be compared.
    let again = studio.post_json("/api/study/open", &json!({"point": 13}).to_string()).await.json();
    assert_ne!(again["document"], json!(id));
    for body in ["{\"point\": 15}", "{\"point\": -1}", "{}", "[", "{\"point\": \"13\"}"] {
        assert!(studio.post_json("/api/study/open", body).await.status >= 400, "{body}");
    }
    fs::remove_file(&definition).unwrap();
    let gone = studio.post_json("/api/study/open", "{\"point\": 1}").await;
    assert!(
        gone.status == 400 && gone.json()["error"].as_str().unwrap().contains("--definition"),
        "{}",
        gone.json()
    );
    studio.server.stop().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn it_takes_the_token_as_the_studio_does_and_is_not_there_without_a_study() {
    let folder = tempfile::tempdir().unwrap();
    let studio = served(folder.path()).await;
    for path in ["/study", "/api/study", "/api/study/file/a.png"] {
        let bare = format!("GET {path} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", studio.host());
        let bare = studio.raw(bare.as_bytes()).await;
        assert_eq!(bare.status, 401, "{path}");
        let foreign = format!(
            "GET {path} HTTP/1.1\r\nHost: evil.example\r\n{}Connection: close\r\n\r\n",
            studio.cookie()
        );
        assert_eq!(studio.raw(foreign.as_bytes()).await.status, 403, "{path}");
    }
    studio.server.stop().await;
    let plain = Studio::start().await;
    assert_eq!(plain.get("/api/study").await.status, 404);
    assert_eq!(plain.post_json("/api/study/open", "{\"point\": 0}").await.status, 404);
    plain.server.stop().await;
    let config = katydid_server::Config {
        port: 0,
        study: Some(StudyConfig { folder: folder.path().join("none"), definition: None }),
        ..katydid_server::Config::default()
    };
    assert!(katydid_server::start(config).await.is_err());
}
