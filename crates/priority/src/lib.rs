//! Which threads the system runs first: what a server asks for so that short work does not wait for long work.
//!
//! Every function is a wish. Where the system has no such thing, or forbids it, nothing changes.
//!
//! ```
//! std::thread::spawn(|| {
//!     katydid_priority::lower();
//!     // Work that may be long.
//! })
//! .join()
//! .unwrap();
//! ```

#[cfg(target_os = "linux")]
mod linux;

/// Lowers the priority of the calling thread, and of those that it starts from now on, for good: Linux alone has a
/// priority of a thread.
pub fn lower() {
    #[cfg(target_os = "linux")]
    linux::lower();
}

/// Asks for short turns for the calling thread and those that it starts from now on: one that wakes is run before
/// another in the middle of a long turn. For threads that work for a short time and then wait. They get no more of a
/// processor than before, and what works on gets shorter turns.
///
/// Linux 6.12 and later. Elsewhere nothing changes.
pub fn take_short_turns() {
    #[cfg(target_os = "linux")]
    linux::set_turns(Some(linux::SHORT));
}

/// Gives the calling thread, and those that it starts from now on, turns of the usual length again: after a program
/// with short turns has started another.
pub fn take_usual_turns() {
    #[cfg(target_os = "linux")]
    linux::set_turns(None);
}

/// Keeps the threads of another process off one of the processors that this one may use, for good: what is asked of this
/// process finds that one free of them. With one processor nothing changes. Threads that it starts later follow those
/// that start them, so this is to be said again from time to time.
///
/// Linux alone lets a process say where another one runs. It gives whether the other process was found there.
pub fn keep_off_one_processor(process: u32) -> bool {
    #[cfg(target_os = "linux")]
    return linux::place(process, linux::Processors::AllButOne);
    #[cfg(not(target_os = "linux"))]
    return {
        _ = process;
        false
    };
}

/// Lets the threads of another process run on all processors that this one may use: undoes
/// [`keep_off_one_processor`].
pub fn let_use_all_processors(process: u32) -> bool {
    #[cfg(target_os = "linux")]
    return linux::place(process, linux::Processors::All);
    #[cfg(not(target_os = "linux"))]
    return {
        _ = process;
        false
    };
}
