//! The limits of what an assistant may ask for, each with its reason.

use std::time::Duration;

/// The most definitions that are open at a time: each keeps its results.
pub(crate) const MOST_DOCUMENTS: usize = 32;
/// The longest message, in bytes. A call with a text of [`MOST_TEXT`] fits in, and one that is too long is still refused by
/// name.
pub(crate) const LONGEST_MESSAGE: usize = 64 << 20;
/// The longest text in .kd that a call may bring, in bytes: ten times the largest of the definitions that are known.
pub(crate) const MOST_TEXT: usize = 8 << 20;
/// The largest file that is opened, in bytes.
pub(crate) const MOST_FILE: u64 = 256 << 20;
/// The most edits of one call.
pub(crate) const MOST_EDITS: usize = 1_000;
/// The most characters of an answer's list: some ten thousand words, which an assistant can still take in.
pub(crate) const MOST_LETTERS: usize = 40_000;
/// The most characters of a message or a value in an answer.
pub(crate) const LONGEST_LINE: usize = 2_000;
/// How many rows a list has when nobody says how many.
pub(crate) const USUAL_ROWS: usize = 100;
/// The most rows of a list that are given at a time.
pub(crate) const MOST_ROWS: usize = 2_000;
/// The sides of a picture in pixels: less shows nothing, more is scaled down by those who look.
pub(crate) const PICTURE_SIDES: std::ops::RangeInclusive<u32> = 64..=2_048;
/// The size of a picture when nobody says one.
pub(crate) const USUAL_PICTURE: [u32; 2] = [1_024, 768];
/// The largest file that is given within an answer, in bytes: it is a third longer there, as text.
pub(crate) const MOST_INLINE: usize = 4 << 20;
/// How long a call to solve waits for the end when nobody says how long: most definitions are done by then, and a client
/// does not give up yet.
pub(crate) const USUAL_WAIT: Duration = Duration::from_secs(10);
/// The longest that a call may wait: clients give up after a minute, as a rule.
pub(crate) const LONGEST_WAIT: Duration = Duration::from_secs(50);
/// How often a call that waits looks whether the solve is over.
pub(crate) const LOOK_EVERY: Duration = Duration::from_millis(5);
/// How often the client is told how far a solve is.
pub(crate) const TELL_EVERY: Duration = Duration::from_millis(200);
/// The most seconds that a picture, a measure or a file may take.
pub(crate) const LONGEST_WORK: Duration = Duration::from_secs(45);
/// The most of a list of folders' files.
pub(crate) const MOST_FILES: usize = 1_000;
/// How deep folders are looked through.
pub(crate) const DEEPEST_FOLDER: usize = 8;
/// Areas and volumes are measured to this part of themselves, as by the components Area and Volume.
pub(crate) const MEASURED_TO: f64 = 1e-9;
/// The most items that one call measures.
pub(crate) const MOST_MEASURED: usize = 10_000;
/// The most objects that are told to have failed.
pub(crate) const MOST_FAILED: usize = 50;
/// The archive version of .3dm files: Rhino 7 and all after it read it.
pub(crate) const ARCHIVE_VERSION: i32 = 70;
/// The longest that a studio of this machine may take to answer: it never solves in between.
pub(crate) const LONGEST_QUESTION: Duration = Duration::from_secs(10);
/// The largest answer of a studio, in bytes: the largest file that is opened, as text.
pub(crate) const LONGEST_ANSWER: u64 = MOST_FILE / 3 * 4 + (1 << 20);
/// The longest file with the address of a studio, in bytes.
pub(crate) const LONGEST_ADDRESS: u64 = 4 << 10;
