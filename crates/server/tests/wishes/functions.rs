//! Functions of another program as components (compute.rhino3d#336, open since 2021): a server of functions, in Python as
//! a rule, is asked by the Hops components of a definition. That packages of Python install once, and are there for the
//! scripts of every definition, is tested in `crates/cli/tests/python_packages.rs`.

use std::net::SocketAddr;

use katydid_server::compute::Config;
use serde_json::{Value, json};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::{TcpListener, TcpStream};

use crate::client::{Compute, input};
use crate::definitions::gh;

const PORT: &str =
    r#""Description":"","AtLeast":1,"AtMost":1,"ParamType":"Number","ResultType":"System.Double""#;

/// What a server of functions answers: a number times itself.
fn answered(head: &str, body: &str) -> String {
    if head.starts_with("GET") {
        let port = |name: &str| format!(r#"{{"Name":"{name}","Nickname":"{name}",{PORT}}}"#);
        return format!(
            r#"{{"Uri":"/square","Name":"square","Inputs":[{}],"Outputs":[{}]}}"#,
            port("x"),
            port("y")
        );
    }
    let asked: Value = serde_json::from_str(body).unwrap();
    let x: f64 = asked["values"][0]["InnerTree"]
        .as_object()
        .and_then(|tree| tree.values().next()?[0]["data"].as_str()?.parse().ok())
        .unwrap_or_else(|| panic!("{asked}"));
    let item = json!({"type": "System.Double", "data": (x * x).to_string()});
    json!({"values": [{"ParamName": "y", "InnerTree": {"0": [item]}}]}).to_string()
}

async fn talk(mut stream: TcpStream) {
    let mut heard = Vec::new();
    let mut piece = [0; 4096];
    loop {
        let text = String::from_utf8_lossy(&heard).into_owned();
        if let Some((head, body)) = text.split_once("\r\n\r\n") {
            let length = head.to_lowercase().lines().find_map(|line| {
                line.strip_prefix("content-length:").and_then(|length| length.trim().parse::<usize>().ok())
            });
            if body.len() >= length.unwrap_or(0) {
                let reply = answered(head, body);
                let answer = format!(
                    "HTTP/1.1 200 OK\r\nContent-Type: application/json\r\nConnection: close\r\nContent-Length: {}\r\n\r\n{reply}",
                    reply.len()
                );
                let _ = stream.write_all(answer.as_bytes()).await;
                return;
            }
        }
        match stream.read(&mut piece).await {
            Ok(read) if read > 0 => heard.extend_from_slice(&piece[..read]),
            _ => return,
        }
    }
}

async fn functions() -> SocketAddr {
    let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
    let address = listener.local_addr().unwrap();
    tokio::spawn(async move {
        while let Ok((stream, _)) = listener.accept().await {
            tokio::spawn(talk(stream));
        }
    });
    address
}

#[tokio::test(flavor = "multi_thread")]
async fn functions_of_another_program_are_components() {
    let host = functions().await;
    let text = format!(
        "katydid 1\nn = Number()\nh = Hops(x = n) variable -> y {{ RemoteDefinitionLocation = \"http://{host}/square\" }}\n\
         r = Data(h)\n\"RH_IN:n\": n\n\"RH_OUT:r\": r\n"
    );
    let compute = Compute::start_with(|config| Config { hosts: vec![host.to_string()], ..config }).await;
    for x in [3.0, 5.0] {
        let answer = compute.solve(&gh(&text), json!([input("RH_IN:n", "0", &[json!(x)])])).await;
        assert_eq!(answer.status, 200, "{}", answer.text());
        assert_eq!(answer.output("RH_OUT:r"), x * x);
    }
    let closed = Compute::start().await;
    let answer = closed.solve(&gh(&text), json!([input("RH_IN:n", "0", &[json!(3)])])).await;
    assert_eq!(answer.status, 500, "nobody is asked that was not named");
}
