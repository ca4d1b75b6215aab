use uuid::Uuid;

use crate::archive::Chunk;

/// A Trigger, which makes objects run again and again.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Trigger {
    /// Milliseconds from one run to the next.
    pub interval: i32,
    /// The objects.
    pub targets: Vec<Uuid>,
}

/// A Data Dam, which holds data back for a while.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DataDam {
    /// How long, in steps of 100 ns; 0 for not at all.
    pub delay: i64,
}

/// A Galapagos solver.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Galapagos {
    /// The sliders and gene pools that it moves.
    pub genes: Vec<Uuid>,
    /// The parameter whose number it drives up or down.
    pub fitness: Option<Uuid>,
}

impl Trigger {
    pub(super) fn read(c: &Chunk) -> Self {
        Self {
            interval: c.i32("TimerInterval").or_else(|| c.i32("Interval")).unwrap_or(0),
            targets: c.list("Target").into_iter().filter_map(|(_, id)| id.as_guid()).collect(),
        }
    }
}

impl DataDam {
    pub(super) fn read(c: &Chunk) -> Self {
        Self { delay: c.i64("BufferDelay").unwrap_or(0) }
    }
}

impl Galapagos {
    pub(super) fn read(c: &Chunk) -> Option<Self> {
        let chunk = c.child("GalapagosData")?;
        Some(Self {
            genes: chunk.list("gene").into_iter().filter_map(|(_, id)| id.as_guid()).collect(),
            fitness: chunk.guid("fitness"),
        })
    }
}
