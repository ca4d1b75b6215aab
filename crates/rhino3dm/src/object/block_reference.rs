//! Class InstanceReference (section 8): a block placed in the model.

use katydid_geometry::{BoundingBox, Xform};
use uuid::Uuid;

use super::major_1;
use crate::Result;
use crate::chunk::{Reader, Writer};

/// A block placed in the model: a definition and where it stands.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockReference {
    /// The identifier of the block's definition.
    pub definition: Uuid,
    /// From the definition's space to the model's.
    pub transform: Xform,
    /// The box around the placed members as the writer stored it; `None` when it stored an empty one.
    pub bounds: Option<BoundingBox>,
}

impl BlockReference {
    /// A reference to a definition.
    pub fn new(definition: Uuid, transform: Xform) -> Self {
        Self { definition, transform, bounds: None }
    }
}

const WHAT: &str = "block reference";

pub(super) fn read(body: &mut Reader<'_>) -> Result<BlockReference> {
    major_1(body, WHAT)?;
    let definition = body.uuid(WHAT)?;
    let transform = body.matrix(WHAT)?;
    Ok(BlockReference { definition, transform, bounds: body.bounds(WHAT)? })
}

pub(super) fn write(reference: &BlockReference, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 0);
    w.uuid(reference.definition);
    w.matrix(&reference.transform);
    w.bounds(reference.bounds);
    Ok(())
}
