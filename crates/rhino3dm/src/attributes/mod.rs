//! Object attributes (section 7): identity, name, layer, colour, visibility, groups, print settings, user data.

mod item_form;
mod old_form;

use crate::choices::{ActiveSpace, Arrowheads, Clipping, LinetypeChoice, ObjectMode, Source, write_place};

use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::class_object::UserData;
use crate::places::Places;
use crate::tables::{Linetype, Rendering, SectionStyle};
use crate::values::IDENTITY;
use crate::version::Version;
use crate::{Result, class_ids, typecode};

/// What an object is besides its geometry. Colours are red, green, blue, alpha.
#[derive(Debug, Clone, PartialEq)]
pub struct Attributes {
    /// The object's identifier. A nil one gets a value of its own when written.
    pub id: Uuid,
    /// The name; empty when there is none.
    pub name: String,
    /// A web address; empty when there is none.
    pub url: String,
    /// Index into [`Model::layers`](crate::Model::layers); nothing for an object on no layer.
    pub layer: Option<usize>,
    /// The object's own linetype, used when `linetype_source` is the object.
    pub linetype: LinetypeChoice,
    /// Where the linetype comes from.
    pub linetype_source: Source,
    /// The object's own material as an index into [`Model::materials`](crate::Model::materials), used when
    /// `material_source` is the object.
    pub material: Option<usize>,
    /// Where the material comes from.
    pub material_source: Source,
    /// Materials and mappings of rendering programs, and shadows.
    pub rendering: Rendering,
    /// The object's own colour; nothing when it shows the colour of what `colour_source` says.
    pub colour: Option<[u8; 4]>,
    /// Where the colour comes from when the object does not show its own.
    pub colour_source: Source,
    /// The colour that the object keeps but does not show.
    pub unused_colour: [u8; 4],
    /// The colour in print.
    pub plot_colour: [u8; 4],
    /// Where the colour in print comes from.
    pub plot_colour_source: Source,
    /// The width in print in millimetres; 0 for a default, negative for nothing at all.
    pub plot_weight: f64,
    /// Where the width in print comes from.
    pub plot_weight_source: Source,
    /// Arrowheads on curves.
    pub arrowheads: Arrowheads,
    /// Isocurves a span; −1 for none.
    pub wire_density: i32,
    /// Whether the object is visible.
    pub visible: bool,
    /// Normal, hidden, locked, or part of a block definition.
    pub mode: ObjectMode,
    /// Indices into [`Model::groups`](crate::Model::groups).
    pub groups: Vec<usize>,
    /// Whether the object lies in the model or on a page.
    pub space: ActiveSpace,
    /// The page or view it is shown in alone; nil for all.
    pub viewport: Uuid,
    /// Viewports, and the display mode of the object in each.
    pub display_modes: Vec<(Uuid, Uuid)>,
    /// What is drawn later has a greater number.
    pub display_order: i32,
    /// Which clipping planes cut the object; nothing for all of them.
    pub clipping: Option<Clipping>,
    /// Where the section style comes from, by its number in archives; 0 for the layer.
    pub section_source: u8,
    /// The object's own section style.
    pub section_style: Option<Box<SectionStyle>>,
    /// How much longer the pattern of the linetype is.
    pub linetype_scale: f64,
    /// A linetype that only this object has.
    pub own_linetype: Option<Box<Linetype>>,
    /// The colour behind the lines of a hatch.
    pub hatch_background: Option<[u8; 4]>,
    /// Whether the boundary of a hatch is drawn.
    pub hatch_boundary: bool,
    /// The object's frame as a transform of the world's, row after row.
    pub frame: Option<[f64; 16]>,
    /// How a clipping plane is labelled, by its number in archives; 0 for not at all.
    pub clipping_label: u8,
    /// Key and value pairs.
    pub user_strings: Vec<(String, String)>,
    /// What the writer says of the pairs beside them; nothing for what new ones say.
    pub user_strings_history: Option<StringsHistory>,
    /// Other user data, carried along as it is.
    pub user_data: Vec<UserData>,
}

/// What became of user strings since an object got them.
#[derive(Debug, Clone, PartialEq)]
pub struct StringsHistory {
    /// How often they were copied, as the writer counted.
    pub copies: i32,
    /// The transform applied to the object since, row after row.
    pub transform: [f64; 16],
}

impl Default for Attributes {
    fn default() -> Self {
        Self {
            id: Uuid::nil(),
            name: String::new(),
            url: String::new(),
            layer: Some(0),
            linetype: LinetypeChoice::default(),
            linetype_source: Source::Layer,
            material: None,
            material_source: Source::Layer,
            rendering: Rendering::default(),
            colour: None,
            colour_source: Source::Layer,
            unused_colour: BLACK,
            plot_colour: BLACK,
            plot_colour_source: Source::Layer,
            plot_weight: 0.0,
            plot_weight_source: Source::Layer,
            arrowheads: Arrowheads::default(),
            wire_density: 1,
            visible: true,
            mode: ObjectMode::Normal,
            groups: Vec::new(),
            space: ActiveSpace::Model,
            viewport: Uuid::nil(),
            display_modes: Vec::new(),
            display_order: 0,
            clipping: None,
            section_source: 0,
            section_style: None,
            linetype_scale: 1.0,
            own_linetype: None,
            hatch_background: None,
            hatch_boundary: false,
            frame: None,
            clipping_label: 0,
            user_strings: Vec::new(),
            user_strings_history: None,
            user_data: Vec::new(),
        }
    }
}

/// The colour of objects and prints that have none.
const BLACK: [u8; 4] = [0, 0, 0, 255];
/// From this openNURBS version on archives of version 5 and up store attributes as items.
const ITEMS_FROM: u32 = 200_712_190;

impl Attributes {
    /// Reads the body of an attributes chunk in the form its version has. Indices are the numbers of the archive
    /// until [`Attributes::place`] makes places of them.
    pub(crate) fn read(mut body: Reader<'_>) -> Result<Self> {
        let version = body.version();
        let mut attributes = Self::default();
        if version.archive >= 5 && version.opennurbs >= ITEMS_FROM {
            item_form::read(&mut body, &mut attributes)?;
        } else {
            old_form::read(&mut body, &mut attributes)?;
        }
        body.finish();
        Ok(attributes)
    }

    /// Reads the chunk of attribute user data: user data chunks until the end mark.
    pub(crate) fn read_user_data(&mut self, mut chunks: Reader<'_>) -> Result<()> {
        while !chunks.is_at_end() {
            let context = chunks.context();
            let chunk = chunks.chunk()?;
            match chunk.typecode {
                typecode::CLASS_USER_DATA => {
                    let added = UserData::read(chunk.body).and_then(|data| self.add_user_data(data));
                    if let Err(error) = added {
                        context.left_out(chunk.offset, "attribute user data", error);
                    }
                }
                typecode::CLASS_END => break,
                _ => {}
            }
        }
        Ok(())
    }

    fn add_user_data(&mut self, data: UserData) -> Result<()> {
        match data.strings()? {
            Some(strings) => {
                // New pairs are written with their number as the count, and no transform.
                let is_fresh =
                    usize::try_from(data.copy_count) == Ok(strings.len()) && data.transform == IDENTITY;
                let history = StringsHistory { copies: data.copy_count, transform: data.transform };
                self.user_strings_history = (!is_fresh).then_some(history);
                self.user_strings.extend(strings);
            }
            None => self.user_data.push(data),
        }
        Ok(())
    }

    /// Turns the numbers of layers, materials, linetypes and groups into places in their tables. An object on a layer
    /// that is not there lies on the first.
    pub(crate) fn place(&mut self, places: &Places) {
        self.layer = self.layer.and_then(|number| places.layers.find_or_first(number));
        self.material = self.material.and_then(|number| places.materials.find(number));
        self.linetype = self.linetype.placed(&places.linetypes);
        if let Some(style) = &mut self.section_style {
            style.place(places);
        }
        self.groups = self.groups.iter().filter_map(|number| places.groups.find(*number)).collect();
    }

    /// Takes the colour that is stored and where the one that is shown comes from.
    fn set_colour(&mut self, stored: [u8; 4], source: Source) {
        if source == Source::Object {
            self.colour = Some(stored);
        } else {
            (self.unused_colour, self.colour_source) = (stored, source);
        }
    }

    /// The colour that is stored, shown or not, and where the one that is shown comes from.
    fn stored_colour(&self) -> ([u8; 4], Source) {
        match self.colour {
            Some(colour) => (colour, Source::Object),
            // Without a colour of its own an object cannot show it.
            None if self.colour_source == Source::Object => (self.unused_colour, Source::Layer),
            None => (self.unused_colour, self.colour_source),
        }
    }

    /// Writes the attributes chunk and, when there is any, the chunk of user data behind it.
    pub(crate) fn write(&self, w: &mut Writer, id: Uuid, attributes: u32, user_data: u32) -> Result<()> {
        let version = w.version();
        w.chunk(attributes, |w| {
            if version.archive >= 5 { item_form::write(self, id, w) } else { old_form::write(self, id, w) }
        })?;
        let data = self.all_user_data(version)?;
        if data.is_empty() {
            return Ok(());
        }
        w.chunk(user_data, |w| {
            data.iter().try_for_each(|data| data.write(w))?;
            w.short(typecode::CLASS_END, 0);
            Ok(())
        })
    }

    fn all_user_data(&self, version: Version) -> Result<Vec<UserData>> {
        let mut all = Vec::new();
        if !self.user_strings.is_empty() {
            let mut strings = UserData::from_strings(&self.user_strings, version)?;
            if let Some(history) = &self.user_strings_history {
                (strings.copy_count, strings.transform) = (history.copies, history.transform);
            }
            all.push(strings);
        }
        all.extend(self.user_data.iter().filter(|data| data.class != class_ids::USER_STRINGS).cloned());
        Ok(all)
    }
}
