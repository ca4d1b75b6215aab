//! Keys of other servers.

use std::sync::{Arc, Mutex};

use katydid_component::Cancel;
use katydid_compute::{CacheControl, Compute, HostKey, SolveRequest};

use super::*;

/// Two servers that note which keys they are shown, with what lies at `/double.gh` of either.
fn noting() -> (Arc<Mutex<Vec<Option<String>>>>, String) {
    let seen = Arc::new(Mutex::new(Vec::new()));
    let note = seen.clone();
    let port = serve(move |asked| {
        note.lock().unwrap().push(asked.key.clone());
        if asked.path == "/double.gh" { files(asked) } else { components(asked) }
    });
    (seen, format!("127.0.0.1:{port}"))
}

#[test]
fn a_host_is_shown_its_own_key_and_no_other() {
    let [(ours, our_host), (others, other_host)] = [noting(), noting()];
    let mut settings = settings(&[our_host.clone(), other_host.clone()]);
    settings.hops.keys = vec![HostKey::read(&format!("{our_host}=for us")).unwrap()];
    for host in [&our_host, &other_host] {
        let add = hops(&format!("http://{host}/add"), &["A", "B"], "Sum");
        let (failed, reply) =
            answer(settings.clone(), &add, vec![value("A", "0", &[json!(4)])], &Bounds::default()).unwrap();
        assert!(!failed && item(&reply, "RH_OUT:x") == "6.0", "{reply}");
        let double = hops(&format!("http://{host}/double.gh"), &["N"], "D");
        let (failed, reply) =
            answer(settings.clone(), &double, vec![value("N", "0", &[json!(4)])], &Bounds::default())
                .unwrap();
        assert!(!failed && item(&reply, "RH_OUT:x") == "8.0", "{reply}");
    }
    assert_eq!(*ours.lock().unwrap(), vec![Some("for us".to_owned()); 3]);
    assert_eq!(*others.lock().unwrap(), [None, None, None]);
    // Whoever names a definition by its address has no use of the key.
    let compute = Compute::new(settings);
    compute
        .fetch(&format!("http://{our_host}/double.gh"), None, &Cancel::default(), CacheControl::Allowed)
        .unwrap();
    assert_eq!(ours.lock().unwrap().last(), Some(&None));
    assert!(SolveRequest::read(b"{}", &compute.settings().request).is_ok());
}
