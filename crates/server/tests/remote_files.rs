//! Who joins a studio from elsewhere reads no file of its machine, whatever they try; the same ways lead to the files
//! for who opens the definition on the machine itself, which shows that they are ways.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::net::{IpAddr, Ipv4Addr};
use std::path::{Path, PathBuf};

use common::{Client, Studio, is_done, refusal};
use katydid_3dm::{Model, Object};
use katydid_definition::archive::{Chunk, write_gh};
use katydid_definition::document::{Persistent, Stored};
use katydid_geometry::Point3;
use katydid_server::Config;
use katydid_session::protocol::{Ask, Connection, Edit, Event};
use uuid::Uuid;

/// What is in each of the files, as text or as a number.
const SECRET: &str = "sesame";
const NUMBER: f64 = 4711.25;

/// A file of each kind that a definition reads, beside the definition of the owner.
fn files(folder: &Path) -> PathBuf {
    let home = folder.join("home");
    std::fs::create_dir_all(home.join("inner")).unwrap();
    let write = |name: &str, bytes: Vec<u8>| std::fs::write(home.join(name), bytes).unwrap();
    write("secret.txt", format!("{SECRET}\n").into_bytes());
    write("secret.csv", format!("{NUMBER},1,2\n").into_bytes());
    let mut model = Model::default();
    model.objects.push(Object::Point(Point3::new(NUMBER, 0.0, 0.0)).into());
    write("secret.3dm", model.write(70).unwrap());
    let mut map = vec![0; 100];
    map[..4].copy_from_slice(&9994_i32.to_be_bytes());
    map.extend([1_i32.to_be_bytes(), 10_i32.to_be_bytes()].concat());
    map.extend([1_i32.to_le_bytes().as_slice(), &NUMBER.to_le_bytes(), &1.0_f64.to_le_bytes()].concat());
    write("secret.shp", map);
    let atom = "ATOM      1  N   GLY A   5      11.104   6.134  -6.504  1.00 12.50           N  \n";
    write("secret.pdb", atom.as_bytes().to_vec());
    let mut data = Chunk::new("Root");
    let stored = Persistent::item(Stored::Number(NUMBER)).to_chunk(true);
    data.chunks = vec![Chunk { name: "Tree".into(), ..stored }];
    write("secret.ghdata", write_gh(&data).unwrap());
    write("secret.png", picture());
    let own = home.join("own.kd");
    std::fs::write(&own, "katydid 1\nown = Read File(\"secret.txt\")\nshown own = Panel(own)\n").unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink(home.join("secret.txt"), home.join("inner").join("link.txt")).unwrap();
    own
}

/// A PNG of one grey pixel.
fn picture() -> Vec<u8> {
    fn piece(kind: &[u8; 4], body: &[u8]) -> Vec<u8> {
        let named = [kind.as_slice(), body].concat();
        let length = u32::try_from(body.len()).unwrap().to_be_bytes();
        let mut crc = flate2::Crc::new();
        crc.update(&named);
        [length.as_slice(), &named, &crc.sum().to_be_bytes()].concat()
    }
    let mut packed = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::fast());
    std::io::Write::write_all(&mut packed, &[0, 128]).unwrap();
    [
        b"\x89PNG\r\n\x1a\n".to_vec(),
        piece(b"IHDR", &[0, 0, 0, 1, 0, 0, 0, 1, 8, 0, 0, 0, 0]),
        piece(b"IDAT", &packed.finish().unwrap()),
        piece(b"IEND", &[]),
    ]
    .concat()
}

/// A text as .kd has it.
fn quoted(text: &str) -> String {
    serde_json::to_string(text).unwrap().replace("\\u0000", "\\u{0}")
}

/// The paths by which somebody may try to name a file that lies in a folder.
fn paths(home: &Path, name: &str) -> Vec<String> {
    let (folder, slashes) = (home.display().to_string(), home.display().to_string().replace('/', "//"));
    let up = "../".repeat(40);
    let user = home.file_name().unwrap().to_string_lossy().into_owned();
    [
        format!("{folder}/{name}"),
        name.to_owned(),
        format!("./{name}"),
        format!("inner/../{name}"),
        format!("../{user}/{name}"),
        format!("{folder}/inner/../{name}"),
        format!("{up}{folder}/{name}"),
        format!("{slashes}//{name}"),
        format!("{folder}/./{name}"),
        format!("  {folder}/{name}  "),
        format!("{folder}/{}", name.to_uppercase()),
        format!("file://{folder}/{name}"),
        format!("FILE://localhost{folder}/{name}"),
        format!("\\\\localhost\\share\\{name}"),
        format!("//localhost/share/{name}"),
        format!("C:\\Users\\me\\{name}"),
        format!("..\\{user}\\{name}"),
        format!("~/{name}"),
        format!("$HOME/{name}"),
        format!("${{PWD}}/{name}"),
        format!("%USERPROFILE%\\{name}"),
        format!("/proc/self/root{folder}/{name}"),
        format!("/proc/thread-self/root{folder}/{name}"),
        format!("{folder}/{name}/"),
        format!("{folder}/{name}\u{0}.png"),
        format!("{folder}/%73ecret.txt"),
    ]
    .to_vec()
}

/// Definitions that read a file, by the names of the objects `f` that give its content; `{}` stands for the path.
fn readers(home: &Path) -> Vec<String> {
    let at = |name: &str| quoted(&home.join(name).display().to_string());
    let text = at("secret.txt");
    let mut all: Vec<String> =
        paths(home, "secret.txt").iter().map(|path| format!("f = Read File({})", quoted(path))).collect();
    all.push("f = Read File(\"inner/link.txt\")".to_owned());
    for (reader, name, more) in [
        ("Import Coordinates", "secret.csv", ""),
        ("Import 3DM", "secret.3dm", ""),
        ("Import SHP", "secret.shp", ""),
        ("Import PDB", "secret.pdb", ""),
        ("Import Image", "secret.png", ", rectangle(plane((0, 0, 0)), 0..1, 0..1)"),
        ("Import Model Block Definition", "secret.3dm", ""),
    ] {
        all.push(format!("f = {reader}({}{more})", at(name)));
        all.push(format!("f = {reader}({}{more})", quoted(name)));
    }
    for path in [at("secret.ghdata"), quoted("secret.ghdata")] {
        all.push(format!("f = Data Input() {{\n    Destination = {path}\n}}"));
    }
    for path in [at("secret.png"), quoted("secret.png")] {
        all.push(format!("f = Image Sampler(Construct Point(0.5, 0.5, 0)) {{\n    FilePath = {path}\n}}"));
    }
    all.extend([
        format!("path = Panel({text})\nf = Read File(path)"),
        format!("path = File Path({text})\nf = Read File(path)"),
        format!(
            "path = Concatenate({}, \"/secret.txt\")\nf = Read File(path)",
            quoted(&home.display().to_string())
        ),
        format!("path = Value List(* \"a\": {})\nf = Read File(path)", quoted(&text)),
        format!("f = Read File([\"none.txt\", {text}])"),
        format!("f = Read File({text}, false)"),
        format!("f = Cluster() -> out inside {{\n    r = Read File({text})\n    out = Cluster Output(r)\n}}"),
        format!(
            "path = Panel({text})\nf = Cluster(path) -> out inside {{\n    p = Cluster Input()\n    \
             r = Read File(p)\n    out = Cluster Output(r)\n}}"
        ),
    ]);
    all
}

/// A way with labels of its own, and a panel that shows what it gives.
fn numbered(way: &str, k: usize) -> String {
    let named = way.replace("f = ", &format!("f {k} = ")).replace("path = ", &format!("path {k} = "));
    let named = named.replace("(path", &format!("(path {k}"));
    format!("katydid 1\n{named}\nshown {k} = Panel(f {k})\n")
}

/// Tries all ways in a document; gives those that give content.
async fn tried(client: &mut Client, ways: &[String]) -> Vec<usize> {
    for (k, way) in ways.iter().enumerate() {
        let seed = Uuid::from_u128(k as u128 + 1);
        let event = client.edit(Edit::Paste { text: numbered(way, k), at: None, seed }).await;
        assert!(is_done(&event), "{way}: {event:?}");
    }
    // An undone and a repeated step, and everything once more.
    client.ask(Ask::Undo).await;
    client.ask(Ask::Redo).await;
    assert!(is_done(&client.ask(Ask::Recompute).await));
    settled(client).await;
    (0..ways.len()).filter(|k| gives(client, &format!("shown {k}"))).collect()
}

/// Waits until the last of the document is solved.
async fn settled(client: &mut Client) {
    let end = Uuid::new_v4();
    let text = "katydid 1\nend = Panel(\"the end\")\n".to_owned();
    let Event::Done { made, .. } = client.edit(Edit::Paste { text, at: None, seed: end }).await else {
        panic!("nothing is pasted");
    };
    let before = client.finished;
    while !client.results.contains_key(&made[0]) || client.finished == before {
        client.hear().await;
    }
}

/// Whether a panel shows data.
fn gives(client: &Client, panel: &str) -> bool {
    let is_data = |text: &String| !text.is_empty() && !text.to_lowercase().contains("null");
    client.texts(panel).iter().any(is_data)
}

fn shared(own: &Path, folders: Vec<PathBuf>) -> impl FnOnce(Config) -> Config {
    let (address, file) = (IpAddr::V4(Ipv4Addr::UNSPECIFIED), Some(own.to_path_buf()));
    move |config| Config { address, file, folders, ..config }
}

/// The id of the document that the studio was started with.
fn first(studio: &Studio) -> String {
    let (_, query) = studio.server.url().split_once("document=").unwrap();
    query.split('&').next().unwrap().to_owned()
}

#[tokio::test(flavor = "multi_thread")]
async fn who_joins_reads_no_file_of_the_machine() {
    let folder = tempfile::tempdir().unwrap();
    let own = files(folder.path());
    let home = own.parent().unwrap();
    let ways = readers(home);
    assert!(ways.len() >= 50, "{}", ways.len());

    // Whoever opens it on the machine reads them: these are ways.
    let local = Studio::start_with(|config| Config { file: Some(own.clone()), ..config }).await;
    let mut client = local.join(&first(&local)).await;
    client.solved(1).await;
    assert_eq!(client.texts("shown own"), [SECRET]);
    let found = tried(&mut client, &ways).await;
    let missing: Vec<&String> =
        ways.iter().enumerate().filter(|(k, _)| !found.contains(k)).map(|(_, w)| w).collect();
    println!("{} of {} ways lead to a file for its owner, all but {missing:#?}", found.len(), ways.len());
    assert!(found.len() >= 40, "{}", found.len());

    // Who joins reads none, neither by their own edits nor by what the owner's definition names.
    let studio = Studio::start_with(shared(&own, Vec::new())).await;
    let mut client = studio.join(&first(&studio)).await;
    client.solved(1).await;
    assert!(!gives(&client, "shown own"));
    let found = tried(&mut client, &ways).await;
    assert_eq!(found, Vec::<usize>::new(), "{:?}", found.iter().map(|k| &ways[*k]).collect::<Vec<_>>());
    assert!(!client.heard.contains(SECRET) && !client.heard.contains("4711.25"));
    edited(&mut client, home).await;
    asked(&studio, &mut client, home, &own).await;
    assert!(!client.heard.contains(SECRET) && !client.heard.contains("4711.25"));
}

/// An Image Gallery shows a file small to who opens it on the machine, and its name to who joins, by any path.
#[tokio::test(flavor = "multi_thread")]
async fn galleries_show_who_joins_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let own = files(folder.path());
    let paths = paths(own.parent().unwrap(), "secret.png");
    let local = Studio::start_with(|config| Config { file: Some(own.clone()), ..config }).await;
    let mut client = local.join(&first(&local)).await;
    let found = pictured(&mut client, &paths).await;
    assert!(found.iter().filter(|found| **found).count() >= 10, "{found:?}");
    let studio = Studio::start_with(shared(&own, Vec::new())).await;
    let mut client = studio.join(&first(&studio)).await;
    assert_eq!(pictured(&mut client, &paths).await, vec![false; found.len()]);
    let opened = Studio::start_with(shared(&own, vec![own.parent().unwrap().to_path_buf()])).await;
    let mut client = opened.join(&first(&opened)).await;
    assert!(pictured(&mut client, &paths[..2]).await.iter().all(|found| *found));
}

/// Of each path whether a gallery shows the picture there.
async fn pictured(client: &mut Client, paths: &[String]) -> Vec<bool> {
    let list: Vec<String> = paths.iter().map(|path| quoted(path)).collect();
    let text = format!("katydid 1\ngallery = Image Gallery([{}])\n", list.join(", "));
    let made = client.edit(Edit::Paste { text, at: None, seed: Uuid::from_u128(9) }).await;
    assert!(is_done(&made), "{made:?}");
    settled(client).await;
    let gallery = client.named("gallery");
    let port = client.objects[&gallery].outputs.first().map_or(gallery, |output| output.id);
    match client.ask(Ask::Pictures { port, within: vec![] }).await {
        Event::Pictures { pictures, .. } => pictures
            .iter()
            .map(|view| {
                assert!(!view.name.is_empty());
                view.image.is_some()
            })
            .collect(),
        other => panic!("{other:?}"),
    }
}

/// Turns the reader of the owner's definition to another file, by every edit that may do so.
async fn edited(client: &mut Client, home: &Path) {
    let path = home.join("secret.txt").display().to_string();
    let (reader, shown) = (client.named("own"), client.named("shown own"));
    let port = client.objects[&reader].inputs[0].id;
    let panel = Uuid::from_u128(1 << 64);
    let text = format!("katydid 1\nwired = Panel({})\n", quoted(&path));
    let Event::Done { made, .. } = client.edit(Edit::Paste { text, at: None, seed: panel }).await else {
        panic!("nothing is pasted");
    };
    let from = client.objects[&made[0]].outputs.first().map_or(made[0], |output| output.id);
    let edits = [
        Edit::Keep { port, values: Some(path.clone()) },
        Edit::Connect { from, to: port, how: Connection::Replace },
        Edit::Disconnect { port },
        Edit::Extract { port, id: Uuid::from_u128(2 << 64) },
        Edit::Duplicate { objects: vec![reader, shown], by: [10.0, 10.0], seed: Uuid::from_u128(3 << 64) },
        Edit::Internalise { port: client.objects[&shown].inputs.first().map_or(shown, |input| input.id) },
        Edit::MakeCluster { id: Uuid::from_u128(4 << 64), objects: vec![reader] },
        Edit::ExplodeCluster { cluster: Uuid::from_u128(4 << 64) },
    ];
    for edit in edits {
        client.edit(edit).await;
        settled(client).await;
    }
    for ask in [Ask::Undo, Ask::Undo, Ask::Redo, Ask::Settle { keep: false }, Ask::Recompute] {
        client.ask(ask).await;
    }
    settled(client).await;
}

/// Asks for files in every other way that there is.
async fn asked(studio: &Studio, client: &mut Client, home: &Path, own: &Path) {
    let path = home.join("secret.txt").display().to_string();
    let document = first(studio);
    let json = |value: &str| format!("{{\"path\":{}}}", quoted(value));
    let mut bodies = Vec::new();
    for name in
        [path.as_str(), "secret.txt", "../secret.txt", &own.display().to_string(), "file:///etc/passwd"]
    {
        let answer = studio.post_json("/api/open", &json(name)).await;
        assert_eq!(answer.status, 403, "{name}");
        bodies.push(answer.body);
    }
    for way in readers(home).iter().map(|way| numbered(way, 0)) {
        let answer = studio.ask("POST", "/api/convert?name=a.kd&format=ghx", "", way.as_bytes()).await;
        bodies.push(answer.body);
    }
    // One that is sent reads no files either, whatever it is called.
    for name in ["a.kd", "..%2Fown.kd", "%2Fetc%2Fown.kd"] {
        let text = numbered(&format!("f = Read File({})", quoted(&path)), 0);
        let answer = studio.ask("POST", &format!("/api/upload?name={name}"), "", text.as_bytes()).await;
        let id = answer.json()["document"].as_str().unwrap().to_owned();
        let mut other = studio.join(&id).await;
        other.solved(1).await;
        assert!(!gives(&other, "shown 0"), "{name}");
        bodies.push(other.heard.into_bytes());
    }
    for query in ["format=kd", "format=ghx", "format=svg&canvas=true", "format=3dm", "format=obj"] {
        let call = if query.contains("kd") || query.contains("ghx") { "save" } else { "export" };
        bodies.push(studio.get(&format!("/api/{call}?document={document}&{query}")).await.body);
    }
    for target in ["/image/..%2f..%2fsecret.png", "/geometry/secret.txt", "/secret.txt", "/api/start"] {
        bodies.push(studio.get(target).await.body);
    }
    for named in [path.clone(), home.join("stolen.kd").display().to_string(), "~/a.kd".to_owned()] {
        assert!(refusal(&client.ask(Ask::Save { path: Some(named) }).await).contains("download"));
    }
    assert!(!home.join("stolen.kd").exists());
    for body in bodies {
        let text = String::from_utf8_lossy(&body);
        assert!(!text.contains(SECRET) && !text.contains("4711.25"), "{text}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn paths_stay_at_home() {
    let folder = tempfile::tempdir().unwrap();
    let own = files(folder.path());
    let place = folder.path().display().to_string();
    let studio = Studio::start_with(shared(&own, Vec::new())).await;
    assert!(!studio.server.url().contains(&place));
    let mut client = studio.join(&first(&studio)).await;
    client.solved(1).await;
    let state = client.state.clone().unwrap();
    assert_eq!((state.document.name.as_str(), state.document.path.as_deref()), ("own.kd", Some("own.kd")));
    // Saved where it is kept, and where that cannot be done.
    assert!(is_done(&client.ask(Ask::Save { path: None }).await));
    std::fs::remove_dir_all(own.parent().unwrap()).unwrap();
    let refused = client.ask(Ask::Save { path: None }).await;
    assert!(refusal(&refused).starts_with("own.kd: "), "{refused:?}");
    let start = studio.get("/api/start").await;
    assert_eq!(start.json()["recent"].as_array().map(Vec::len), Some(0));
    let told = client.heard.clone() + &String::from_utf8_lossy(&start.body);
    assert!(!told.contains(&place), "{told}");
}

#[tokio::test(flavor = "multi_thread")]
async fn folders_that_the_owner_opens_are_read_and_no_others() {
    let folder = tempfile::tempdir().unwrap();
    let own = files(folder.path());
    let open = folder.path().join("open");
    std::fs::create_dir(&open).unwrap();
    std::fs::write(open.join("a.txt"), "welcome").unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink(own.with_file_name("secret.txt"), open.join("link.txt")).unwrap();
    let ways: Vec<String> =
        ["a.txt", &open.join("a.txt").display().to_string(), "link.txt", "../home/secret.txt"]
            .iter()
            .map(|path| format!("f = Read File({})", quoted(path)))
            .chain(readers(own.parent().unwrap()))
            .collect();
    let studio = Studio::start_with(shared(&own, vec![open])).await;
    let mut client = studio.join(&first(&studio)).await;
    client.solved(1).await;
    assert_eq!(tried(&mut client, &ways).await, [0, 1]);
    assert_eq!((client.texts("shown 0"), gives(&client, "shown own")), (vec!["welcome".to_owned()], false));
    assert!(!client.heard.contains(SECRET));
}
