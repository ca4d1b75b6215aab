//! Accounts in a program whose allocator counts.

use std::sync::Arc;

use katydid_memory::{Account, Counting, is_counting};

#[global_allocator]
static ALLOCATOR: Counting = Counting;

const MEGA: u64 = 1 << 20;

fn block(megas: u64) -> Vec<u8> {
    vec![1; (megas * MEGA) as usize]
}

/// Within a page of so many megabytes.
fn about(bytes: u64, megas: u64) -> bool {
    bytes.abs_diff(megas * MEGA) < 4096
}

#[test]
fn what_is_given_back_is_not_counted() {
    assert!(is_counting());
    let account = Account::new(10 * MEGA);
    account.begin();
    let mut kept = block(3);
    drop(block(5));
    account.settle();
    assert!(about(account.bytes(), 3), "{}", account.bytes());
    kept.extend(block(6));
    account.settle();
    assert!(account.bytes() >= 9 * MEGA);
    assert!(account.without_room(0).is_none() || kept.capacity() as u64 > 10 * MEGA);
    drop(kept);
    account.settle();
    assert!(about(account.bytes(), 0));
}

#[test]
fn a_part_counts_for_the_whole() {
    let whole = Arc::new(Account::new(5 * MEGA));
    let parts = [0, 1].map(|_| Account::part_of(whole.clone(), 4 * MEGA));
    let kept = parts.each_ref().map(|part| {
        part.begin();
        let kept = block(3);
        part.settle();
        kept
    });
    assert!(parts.iter().all(|part| about(part.bytes(), 3)));
    assert!(about(whole.bytes(), 6) && whole.is_over());
    // Each is within its own limit, and the whole is not.
    let over = parts[0].without_room(0).unwrap();
    assert_eq!(over.limit(), 5 * MEGA);
    drop(kept);
}

#[test]
fn threads_share_an_account_and_others_do_not() {
    let account = Arc::new(Account::new(100 * MEGA));
    let kept: Vec<Vec<u8>> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..4)
            .map(|k| {
                let account = account.clone();
                scope.spawn(move || {
                    let before = block(7);
                    account.begin();
                    let kept = block(k);
                    account.settle();
                    drop(before);
                    kept
                })
            })
            .collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    assert!(about(account.bytes(), 6), "{}", account.bytes());
    // Given back on this thread by work that has begun here.
    account.begin();
    drop(kept);
    account.settle();
    assert!(about(account.bytes(), 0));
}

#[test]
fn a_thread_works_for_one_account_at_a_time() {
    let [outer, inner] = [0, 1].map(|_| Account::new(100 * MEGA));
    outer.begin();
    let first = block(2);
    outer.end();
    let nobodys = block(40);
    inner.begin();
    let second = block(3);
    // The outer work does not run on this thread now.
    outer.settle();
    inner.end();
    inner.end();
    outer.begin();
    let third = block(4);
    outer.end();
    assert!(about(outer.bytes(), 6) && about(inner.bytes(), 3), "{} {}", outer.bytes(), inner.bytes());
    drop((first, second, third, nobodys));
}

#[test]
fn what_would_not_fit_is_told_before_it_is_taken() {
    let account = Account::new(MEGA);
    assert!(account.without_room(MEGA).is_none());
    assert!(account.without_room(MEGA + 1).is_some());
    assert!(account.without_room(u64::MAX).is_some());
    assert!(!account.is_over());
}

#[test]
fn work_beside_other_work_has_its_share_and_gives_back_the_rest() {
    let whole = Arc::new(Account::new(5 * MEGA));
    let [large, small] = [0, 1].map(|_| Arc::new(Account::beside(whole.clone(), 2 * MEGA, u64::MAX)));
    let solve = Account::part_of(large.clone(), 100 * MEGA);
    solve.begin();
    let kept = block(6);
    solve.end();
    assert!(about(large.bytes(), 6) && about(whole.bytes(), 4) && !solve.is_over());
    // The rest of the whole is one megabyte: for who has used up the own share, and nobody is refused the own share.
    assert!(solve.without_room(MEGA / 2).is_none() && !large.was_refused());
    assert_eq!(solve.without_room(2 * MEGA).unwrap().limit(), 5 * MEGA);
    assert!(solve.was_refused() && large.was_refused());
    assert!(small.without_room(2 * MEGA).is_none() && small.without_room(4 * MEGA).is_some());
    solve.begin();
    let more = block(6);
    solve.end();
    assert!(solve.is_over() && !small.is_over());
    drop((solve, large));
    assert_eq!(whole.bytes(), 0);
    small.begin();
    drop((kept, more));
    small.end();
    assert_eq!((small.bytes(), whole.bytes()), (0, 0));
}
