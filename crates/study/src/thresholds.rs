//! The limits and thresholds of studies.

use std::time::Duration;

/// The most points of a plan: a store's index of so many is some gigabytes.
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
/// How long results may be in the system's hands only, before they are written through to the disk.
pub const SYNC_EVERY: Duration = Duration::from_secs(1);
/// How long a point may take when nobody says so.
pub const POINT_TIME: Duration = Duration::from_secs(60);
/// Rows of a group in Parquet: what is held in memory while a table is written.
pub const ROWS_A_GROUP: usize = 1 << 15;
