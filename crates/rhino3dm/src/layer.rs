//! Class Layer (section 8).

use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::{Error, Result, colour};

/// A layer of a model.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// The name, without those of its parents.
    pub name: String,
    /// The colour of its objects as red, green, blue, alpha.
    pub colour: [u8; 4],
    /// The identifier. A nil one gets a value of its own when written, but then nothing can name it as parent.
    pub id: Uuid,
    /// The identifier of the layer it lies under.
    pub parent: Option<Uuid>,
    /// Whether its objects are visible.
    pub visible: bool,
    /// Whether its objects are locked.
    pub locked: bool,
}

impl Layer {
    /// A visible, black layer at the top level.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), ..Self::default() }
    }
}

impl Default for Layer {
    fn default() -> Self {
        Self {
            name: String::new(),
            colour: [0, 0, 0, 255],
            id: Uuid::nil(),
            parent: None,
            visible: true,
            locked: false,
        }
    }
}

const WHAT: &str = "layer";
/// Files written by an older openNURBS store no parents.
const PARENT_AFTER: u32 = 200_505_110;

/// Reads a layer's body; gives the number by which attributes refer to it, too.
pub(crate) fn read(body: &mut Reader<'_>) -> Result<(Layer, i32)> {
    let offset = body.offset();
    let (major, minor) = body.packed_version(WHAT)?;
    if major != 1 {
        return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
    }
    let mode = body.i32(WHAT)?;
    let number = body.i32(WHAT)?;
    // IGES level, material and a reserved number.
    body.take(12, WHAT)?;
    let mut layer = Layer { colour: colour::from_archive(body.colour(WHAT)?), ..Layer::default() };
    // A line style that was never used.
    body.take(20, WHAT)?;
    layer.name = body.string("layer name")?;
    layer.visible = mode != 1;
    layer.locked = mode == 2;
    if minor >= 1 {
        layer.visible = body.bool(WHAT)?;
    }
    if minor >= 2 {
        body.i32("linetype")?;
    }
    if minor >= 3 {
        body.take(12, "plot colour and weight")?;
    }
    if minor >= 4 {
        layer.locked = body.bool(WHAT)?;
    }
    if minor >= 5 {
        layer.id = body.uuid(WHAT)?;
    }
    if minor >= 6 && body.version().opennurbs > PARENT_AFTER {
        layer.parent = Some(body.uuid(WHAT)?).filter(|id| !id.is_nil());
    }
    Ok((layer, number))
}

/// Writes a layer's body, its number being its place in the table.
pub(crate) fn write(layer: &Layer, number: usize, id: Uuid, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 15);
    w.i32(if !layer.visible {
        1
    } else if layer.locked {
        2
    } else {
        0
    });
    w.count(number, "layers")?;
    w.i32(-1);
    w.i32(-1);
    w.i32(0);
    w.colour(colour::to_archive(layer.colour));
    w.bytes(&[0; 12]);
    w.f64(1.0);
    w.string(&layer.name)?;
    w.bool(layer.visible);
    w.i32(-1);
    // Plot colour as the layer's, default plot weight.
    w.colour([255; 4]);
    w.f64(0.0);
    w.bool(layer.locked);
    w.uuid(id);
    w.uuid(layer.parent.unwrap_or_default());
    w.bool(true);
    // No rendering attributes.
    w.versioned(1, 0, |w| {
        w.i32(0);
        Ok(())
    })?;
    w.uuid(Uuid::nil());
    w.u8(0);
    Ok(())
}
