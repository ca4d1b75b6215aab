//! Class Layer (section 8).

use uuid::Uuid;

use super::rendering::{MaterialReference, read_materials, write_materials};
use super::{Entry, Linetype, SectionStyle};
use crate::choices::{Clipping, LinetypeChoice, write_place};
use crate::chunk::{Reader, Writer};
use crate::class_object::UserData;
use crate::places::Places;
use crate::values::{read_colour, read_id_list, write_colour, write_id_list};
use crate::{Error, Result, class_ids};

/// A layer of a model. Colours are red, green, blue, alpha.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// The name, without those of its parents.
    pub name: String,
    /// The colour of its objects.
    pub colour: [u8; 4],
    /// The identifier. A nil one gets a value of its own when written, but then nothing can name it as parent.
    pub id: Uuid,
    /// The identifier of the layer it lies under.
    pub parent: Option<Uuid>,
    /// Whether its objects are visible.
    pub visible: bool,
    /// Whether its objects are locked.
    pub locked: bool,
    /// Whether the layers under it are shown in lists of layers.
    pub expanded: bool,
    /// The linetype of its objects.
    pub linetype: LinetypeChoice,
    /// The material of its objects as an index into [`Model::materials`](crate::Model::materials).
    pub material: Option<usize>,
    /// The colour of its objects in print; nothing for that on the screen.
    pub plot_colour: Option<[u8; 4]>,
    /// The width of its objects in print in millimetres; 0 for a default, negative for nothing at all.
    pub plot_weight: f64,
    /// The level that exchange by IGES uses; −1 for none.
    pub iges_level: i32,
    /// Materials of rendering programs.
    pub rendering_materials: Vec<MaterialReference>,
    /// The display material; nil for none.
    pub display_material: Uuid,
    /// Which clipping planes cut its objects; nothing for all of them.
    pub clipping: Option<Clipping>,
    /// How its objects look where they are cut.
    pub section_style: Option<Box<SectionStyle>>,
    /// A linetype that only this layer has.
    pub own_linetype: Option<Box<Linetype>>,
    /// Whether the layer is visible in views that are made later.
    pub visible_in_new_views: bool,
    /// User data, settings of single viewports among them, carried along as it is.
    pub user_data: Vec<UserData>,
}

impl Layer {
    /// A visible, black layer at the top level.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), ..Self::default() }
    }

    /// Turns the numbers of materials and linetypes into places in their tables.
    pub(crate) fn place(&mut self, places: &Places) {
        self.material = self.material.and_then(|number| places.materials.find(number));
        self.linetype = self.linetype.placed(&places.linetypes);
        if let Some(style) = &mut self.section_style {
            style.place(places);
        }
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
            expanded: true,
            linetype: LinetypeChoice::default(),
            material: None,
            plot_colour: None,
            plot_weight: 0.0,
            iges_level: -1,
            rendering_materials: Vec::new(),
            display_material: Uuid::nil(),
            clipping: None,
            section_style: None,
            own_linetype: None,
            visible_in_new_views: true,
            user_data: Vec::new(),
        }
    }
}

const WHAT: &str = "layer";
/// Files written by an older openNURBS store no parents.
const PARENT_AFTER: u32 = 200_505_110;
/// No colour at all.
const UNSET: [u8; 4] = [255, 255, 255, 0];
/// Files of older versions store transparent layers by mistake.
const TRANSPARENT_FROM: i32 = 70;

const CLIPPING: u8 = 28;
const SECTION_HATCH: u8 = 29;
const SECTION_HATCH_SCALE: u8 = 30;
const SECTION_HATCH_ROTATION: u8 = 31;
const SECTION_FILL_RULE: u8 = 32;
const OWN_LINETYPE: u8 = 33;
const CLIPPING_CUTS: u8 = 34;
const SECTION_STYLE: u8 = 35;
const VISIBLE_IN_NEW_VIEWS: u8 = 36;

impl Layer {
    fn read_items(&mut self, body: &mut Reader<'_>) -> Result<()> {
        loop {
            match body.u8(WHAT)? {
                CLIPPING => {
                    let clipping = self.clipping.get_or_insert_default();
                    clipping.none = body.bool(WHAT)?;
                    clipping.planes = read_id_list(body, WHAT)?;
                }
                SECTION_HATCH => self.section().hatch = Some(body.i32(WHAT)?),
                SECTION_HATCH_SCALE => self.section().hatch_scale = Some(body.f64(WHAT)?),
                SECTION_HATCH_ROTATION => self.section().hatch_rotation = Some(body.f64(WHAT)?),
                SECTION_FILL_RULE => self.section().fill_rule = Some(body.u8(WHAT)?),
                OWN_LINETYPE => self.own_linetype = Some(Box::new(Linetype::read_inside(body)?)),
                CLIPPING_CUTS => self.clipping.get_or_insert_default().planes_cut = body.bool(WHAT)?,
                SECTION_STYLE => self.section_style = Some(Box::new(SectionStyle::read(body)?)),
                VISIBLE_IN_NEW_VIEWS => self.visible_in_new_views = body.bool(WHAT)?,
                // The end, or something newer: items have no length.
                _ => return Ok(()),
            }
        }
    }

    /// The section style, which betas of version 8 wrote piece by piece.
    fn section(&mut self) -> &mut SectionStyle {
        self.section_style.get_or_insert_default()
    }

    fn write_items(&self, w: &mut Writer) -> Result<()> {
        if let Some(clipping) = &self.clipping {
            w.u8(CLIPPING);
            w.bool(clipping.none);
            write_id_list(&clipping.planes, w)?;
        }
        if let Some(linetype) = &self.own_linetype {
            w.u8(OWN_LINETYPE);
            linetype.write_inside(w)?;
        }
        if self.clipping.as_ref().is_some_and(|clipping| !clipping.planes_cut) {
            w.bytes(&[CLIPPING_CUTS, 0]);
        }
        if let Some(style) = &self.section_style {
            w.u8(SECTION_STYLE);
            style.write(w)?;
        }
        if !self.visible_in_new_views {
            w.bytes(&[VISIBLE_IN_NEW_VIEWS, 0]);
        }
        w.u8(0);
        Ok(())
    }

    /// The state that was all there was before visibility and locking became two.
    fn mode(&self) -> i32 {
        match (self.visible, self.locked) {
            (true, _) => 0,
            (false, true) => 2,
            (false, false) => 1,
        }
    }
}

impl Entry for Layer {
    const CLASS: Uuid = class_ids::LAYER;
    const WHAT: &'static str = WHAT;

    fn read(body: &mut Reader<'_>) -> Result<Self> {
        let offset = body.offset();
        let version = body.version();
        let (major, minor) = body.packed_version(WHAT)?;
        if major != 1 {
            return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
        }
        let mode = body.i32(WHAT)?;
        body.i32("layer number")?;
        let mut layer = Self { iges_level: body.i32(WHAT)?, ..Self::default() };
        layer.material = usize::try_from(body.i32("material")?).ok();
        body.i32(WHAT)?;
        layer.colour = read_colour(body, WHAT)?;
        if layer.colour[3] == 0 && layer.colour != UNSET && version.archive < TRANSPARENT_FROM {
            layer.colour[3] = 255;
        }
        // A line style that was never used.
        body.take(20, WHAT)?;
        layer.name = body.string("layer name")?;
        layer.visible = mode != 1;
        layer.locked = mode == 2;
        if minor >= 1 {
            layer.visible &= body.bool(WHAT)?;
        }
        if minor >= 2 {
            layer.linetype = LinetypeChoice::from_number(body.i32("linetype")?);
        }
        if minor >= 3 {
            layer.plot_colour = Some(read_colour(body, WHAT)?).filter(|colour| *colour != UNSET);
            layer.plot_weight = body.f64(WHAT)?;
        }
        if minor >= 4 {
            layer.locked |= body.bool(WHAT)?;
        }
        if minor >= 5 {
            layer.id = body.uuid(WHAT)?;
        }
        if minor >= 6 && version.opennurbs > PARENT_AFTER {
            layer.parent = Some(body.uuid(WHAT)?).filter(|id| !id.is_nil());
            layer.expanded = body.bool(WHAT)?;
        }
        if minor >= 7 {
            let (mut rendering, _) = body.versioned_1(WHAT)?;
            layer.rendering_materials = read_materials(&mut rendering)?;
            rendering.finish();
        }
        if minor >= 8 {
            layer.display_material = body.uuid(WHAT)?;
        }
        // Version 1.9 lived for a day.
        if minor >= 10 {
            layer.read_items(body)?;
        }
        Ok(layer)
    }

    fn write(&self, number: i32, id: Uuid, w: &mut Writer) -> Result<()> {
        w.packed_version(1, 15);
        w.i32(self.mode());
        w.i32(number);
        w.i32(self.iges_level);
        write_place(self.material, "materials", w)?;
        w.i32(0);
        write_colour(self.colour, w);
        w.bytes(&[0; 12]);
        w.f64(1.0);
        w.string(&self.name)?;
        w.bool(self.visible);
        self.linetype.write(w)?;
        write_colour(self.plot_colour.unwrap_or(UNSET), w);
        w.f64(self.plot_weight);
        w.bool(self.locked);
        w.uuid(id);
        w.uuid(self.parent.unwrap_or_default());
        w.bool(self.expanded);
        w.versioned(1, 0, |w| write_materials(&self.rendering_materials, w))?;
        w.uuid(self.display_material);
        self.write_items(w)
    }
}
