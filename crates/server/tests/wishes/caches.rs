//! A cache that can be refused, and that never keeps errors (compute.rhino3d.appserver#50).

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use katydid_server::compute::Config;
use serde_json::{Value, json};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpListener;

use crate::client::{Answer, Compute, input};
use crate::definitions::{SUM, bytes, gh};

const NO_STORE: &str = "Cache-Control: no-store\r\n";
const NO_CACHE: &str = "Cache-Control: no-cache\r\n";

fn is_kept(answer: &Answer) -> bool {
    answer.header("cache-status") == "katydid; hit"
}

fn body(cachesolve: bool) -> Vec<u8> {
    let values = json!([input("RH_IN:A", "0", &[json!(4)])]);
    json!({"algo": gh(SUM), "values": values, "cachesolve": cachesolve}).to_string().into_bytes()
}

async fn ask(compute: &Compute, headers: &str, body: &[u8]) -> Answer {
    let answer = compute.ask("POST", "/grasshopper", headers, body).await;
    assert_eq!(answer.output("RH_OUT:sum"), 7.0, "{}", answer.text());
    answer
}

#[tokio::test(flavor = "multi_thread")]
async fn who_refuses_the_cache_is_solved_for_anew() {
    let compute = Compute::start().await;
    let asking = body(true);
    assert!(!is_kept(&ask(&compute, "", &asking).await));
    assert!(is_kept(&ask(&compute, "", &asking).await));
    for headers in [NO_STORE, NO_CACHE, "Cache-Control: max-age=0\r\n", "Pragma: no-cache\r\n"] {
        assert!(!is_kept(&ask(&compute, headers, &asking).await), "{headers}");
    }
    assert!(!is_kept(&ask(&compute, "", &body(false)).await));
    assert!(is_kept(&ask(&compute, "", &asking).await));
}

#[tokio::test(flavor = "multi_thread")]
async fn nothing_is_kept_of_who_forbids_it() {
    let compute = Compute::start().await;
    let asking = body(true);
    let pointer = ask(&compute, NO_STORE, &asking).await.json()["pointer"].clone();
    let later = compute.post("/grasshopper", &json!({"pointer": pointer})).await;
    assert_eq!(later.status, 404, "the definition is not kept: {}", later.text());
    assert!(!is_kept(&ask(&compute, "", &asking).await), "nor the reply");
    let later = compute.post("/grasshopper", &json!({"pointer": pointer})).await;
    assert_eq!(later.output("RH_OUT:sum"), 5.0);
    // Who asks without anything said is answered from there.
    assert!(is_kept(&ask(&compute, "", &asking).await));
}

#[tokio::test(flavor = "multi_thread")]
async fn errors_are_never_kept() {
    let compute = Compute::start().await;
    let text = "katydid 1\na = Number Slider(0.0, 0..10)\nn = List Item([1, 2], a)\ns = Series(0, 1, 100)\n\
        t = Addition(s, n)\n\"RH_IN:a\": a\n\"RH_OUT:t\": t\n";
    let asking = json!({"algo": gh(text), "cachesolve": true});
    // What is an error for want of items, in an object that no input leads to, is none for who may have more.
    for _ in 0..2 {
        let few = compute.post("/grasshopper?items=10", &asking).await;
        assert_eq!(few.status, 500, "{}", few.text());
        assert!(!is_kept(&few));
    }
    let all = compute.post("/grasshopper", &asking).await;
    assert_eq!((all.status, is_kept(&all)), (200, false), "{}", all.text());
    let again = compute.post("/grasshopper?items=10", &asking).await;
    assert!(again.status == 500 || is_kept(&again), "{}", again.text());
}

/// A host whose one definition adds one more each time that it is fetched.
async fn counting() -> (String, Arc<AtomicUsize>) {
    let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
    let host = listener.local_addr().unwrap().to_string();
    let count = Arc::new(AtomicUsize::new(0));
    let counted = Arc::clone(&count);
    tokio::spawn(async move {
        while let Ok((mut stream, _)) = listener.accept().await {
            let mut head = [0; 4096];
            let _ = stream.read(&mut head).await;
            let n = counted.fetch_add(1, Ordering::SeqCst);
            let file = bytes(&SUM.replace("3.0", &format!("{n}.0")));
            let head =
                format!("HTTP/1.1 200 OK\r\nConnection: close\r\nContent-Length: {}\r\n\r\n", file.len());
            let _ = stream.write_all(&[head.as_bytes(), &file].concat()).await;
        }
    });
    (host, count)
}

#[tokio::test(flavor = "multi_thread")]
async fn a_definition_elsewhere_is_fetched_anew_where_asked_for() {
    let (host, count) = counting().await;
    let hosts = vec![host.clone()];
    let compute = Compute::start_with(|config| Config { hosts, ..config }).await;
    let asking = json!({"pointer": format!("http://{host}/sum.gh")}).to_string();
    let sum = async |headers: &str| -> Value {
        compute.ask("POST", "/grasshopper", headers, asking.as_bytes()).await.output("RH_OUT:sum")
    };
    // What was fetched is kept; fetched anew it takes the place of the one before; not so where nothing may be kept.
    for (headers, wanted) in [("", 2.0), ("", 2.0), (NO_CACHE, 3.0), ("", 3.0), (NO_STORE, 4.0), ("", 3.0)] {
        assert_eq!(sum(headers).await, wanted, "{headers}");
    }
    assert_eq!(count.load(Ordering::SeqCst), 3);
}
