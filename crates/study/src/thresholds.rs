//! The limits and thresholds of studies.

use std::time::Duration;

/// The most points of a plan: the table of places of so many is some gigabytes on the disk.
pub const MOST_POINTS: u64 = 100_000_000;
/// The most values that a plan lists for one input.
pub const MOST_VALUES: usize = 1_000_000;
/// The most bytes of a plan's file: no plan comes near.
pub const MOST_PLAN_BYTES: u64 = 64 << 20;
/// The most items of a list in a cell: more is geometry, not a result to compare.
pub const MOST_CELL_ITEMS: usize = 10_000;
/// The most bytes of a cell.
pub const MOST_CELL_BYTES: usize = 1 << 16;
/// The most bytes of one record of a store; what claims more is damage.
pub const MOST_RECORD_BYTES: u32 = 1 << 26;
/// The most bytes of `study.json`: a definition's inputs come nowhere near.
pub const MOST_ABOUT_BYTES: u64 = 16 << 20;
/// The most columns of a table that is looked at.
pub const MOST_COLUMNS: usize = 1000;
/// The most rows of a table that is looked at: reading more takes minutes.
pub const MOST_TABLE_ROWS: usize = 20_000_000;
/// The most different texts of an axis.
pub const MOST_WORDS: usize = 30;
/// The most axes of a parallel plot.
pub const MOST_AXES: usize = 24;
/// The most bytes of a text that are shown of a cell.
pub const MOST_SHOWN_BYTES: usize = 500;
/// How long rows of a study that is made may wait before others can read them.
pub const TELL_EVERY: Duration = Duration::from_millis(200);
/// How long results may be in the system's hands only, before they are written through to the disk.
pub const SYNC_EVERY: Duration = Duration::from_secs(1);
/// How long a point may take when nobody says so.
pub const POINT_TIME: Duration = Duration::from_secs(60);
/// How long an answer is waited for beyond one and a half of a point's time limit: components look at the time now and then.
pub const HANG_GRACE: Duration = Duration::from_secs(30);
/// How many points may hang in one process: each goes on taking a processor.
pub const MOST_HUNG: usize = 16;
/// Fewer points than this are not worth a thread more.
pub const LEAST_HAND_OUT: usize = 4;
/// Rows of a group in Parquet: what is held in memory while a table is written.
pub const ROWS_A_GROUP: usize = 1 << 15;

/// How often the step of a difference is halved: the last one is 8,000 times smaller than the first.
pub const DIFFERENCE_ROWS: usize = 14;
/// How many terms of the error's series are taken away at most; more only add rounding.
pub const DIFFERENCE_COLUMNS: usize = 7;
/// By how many units of rounding a value may be off: those of some thousand operations that do not all err to one side.
pub const ROUNDING_UNITS: f64 = 8.0;
/// How often the distance in which borders are looked for doubles, from the number itself to the end of the slider.
pub const BORDER_OCTAVES: u32 = 14;
/// Cells in which borders are looked for in each doubling of the distance.
pub const BORDER_CELLS: u32 = 3;
/// A jump smaller than this part of the values beside it is not told from what numerical work on geometry leaves behind.
pub const JUMP_NOISE: f64 = 1e-7;
/// Over how many halvings a second difference must stay to be a jump.
pub const JUMP_LEVELS: usize = 10;
/// What part of a second difference stays over [`JUMP_LEVELS`] at a jump: a corner of a square root leaves a thirtieth.
pub const JUMP_STAYS: f64 = 0.7;
/// Nearer than this part of the slider's range to a border, differences go to the other side alone.
pub const SIDE_ROOM: f64 = 1e-3;
/// Derivatives of two sides that differ by more than this part, and by more than their errors, make a corner.
pub const CORNER: f64 = 1e-4;
/// Walks of a screening; published studies take 10 to 50.
pub const WALKS: usize = 20;
/// Resamples for the confidence of shares.
pub const RESAMPLES: u64 = 200;
/// Standard deviations to either side that hold 95 in 100 of a normal distribution.
pub const DEVIATIONS_95: f64 = 1.959_964;
/// The most points that effects over the whole range solve: they are held in memory.
pub const MOST_EFFECT_SOLVES: usize = 10_000_000;
/// The most points of an optimisation: they are held in memory.
pub const MOST_EVALUATIONS: usize = 10_000_000;
/// After how many batches without a new point an optimisation ends: those of a space of few whole numbers.
pub const REPEATS: usize = 50;
/// Rounds of inputs for a wanted result; from nearby fewer than ten are needed.
pub const MOST_ROUNDS: usize = 100;
/// A move of less than this part of the ranges ends the search for a wanted result: less than sliders show.
pub const LEAST_MOVE: f64 = 1e-13;
/// The part of its range by which an input is moved to see what follows: the root of a unit of rounding, some times over.
pub const NUDGE: f64 = 1e-7;
/// The most places whose motion is told: more hide the model.
pub const MOST_ARROWS: usize = 2_000;
/// In how many parts a curve and each direction of a surface are divided for the places whose motion is told.
pub const MOTION_PARTS: u32 = 4;
