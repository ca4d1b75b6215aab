//! Object attributes (section 7): identity, name, layer, colour, visibility, groups, user strings.

mod item_form;
mod old_form;

use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::object::UserData;
use crate::version::Version;
use crate::{Result, class_ids, typecode};

/// What an object is besides its geometry.
///
/// Materials, linetypes, plot settings, page space and display order of a file are not read, so they are not
/// written back.
#[derive(Debug, Clone, PartialEq)]
pub struct Attributes {
    /// The object's identifier. A nil one gets a value of its own when written.
    pub id: Uuid,
    /// The name; empty when there is none.
    pub name: String,
    /// A web address; empty when there is none.
    pub url: String,
    /// Index into [`Model::layers`](crate::Model::layers).
    pub layer: usize,
    /// The object's own colour as red, green, blue, alpha; nothing when it shows its layer's (or its material's
    /// or parent's) colour.
    pub colour: Option<[u8; 4]>,
    /// Whether the object is visible.
    pub visible: bool,
    /// Normal, hidden, locked, or part of a block definition.
    pub mode: ObjectMode,
    /// Isocurves a span; −1 for none.
    pub wire_density: i32,
    /// Indices of groups in the file's group table, which this crate does not read yet.
    pub groups: Vec<i32>,
    /// Key and value pairs.
    pub user_strings: Vec<(String, String)>,
    /// Other user data, carried along as it is.
    pub user_data: Vec<UserData>,
}

impl Default for Attributes {
    fn default() -> Self {
        Self {
            id: Uuid::nil(),
            name: String::new(),
            url: String::new(),
            layer: 0,
            colour: None,
            visible: true,
            mode: ObjectMode::Normal,
            wire_density: 1,
            groups: Vec::new(),
            user_strings: Vec::new(),
            user_data: Vec::new(),
        }
    }
}

/// How an object takes part in a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ObjectMode {
    /// Seen and selectable.
    #[default]
    Normal,
    /// Hidden.
    Hidden,
    /// Seen but not selectable.
    Locked,
    /// Part of a block definition.
    InDefinition,
}

impl ObjectMode {
    fn from_code(code: u8) -> Self {
        // The upper four bits say something else.
        match code & 15 {
            1 => Self::Hidden,
            2 => Self::Locked,
            3 => Self::InDefinition,
            _ => Self::Normal,
        }
    }

    fn code(self) -> u8 {
        match self {
            Self::Normal => 0,
            Self::Hidden => 1,
            Self::Locked => 2,
            Self::InDefinition => 3,
        }
    }
}

/// Where a colour comes from: the object itself.
const COLOUR_FROM_OBJECT: u8 = 1;
/// From this openNURBS version on archives of version 5 and up store attributes as items.
const ITEMS_FROM: u32 = 200_712_190;

/// Attributes as a file states them, with the layer by the number that layer gives itself.
#[derive(Debug, Default)]
pub(crate) struct StoredAttributes {
    pub(crate) attributes: Attributes,
    pub(crate) layer_number: i32,
}

impl StoredAttributes {
    /// Reads the body of an attributes chunk in the form its version has.
    pub(crate) fn read(mut body: Reader<'_>) -> Result<Self> {
        let version = body.version();
        let mut stored = Self::default();
        if version.archive >= 5 && version.opennurbs >= ITEMS_FROM {
            item_form::read(&mut body, &mut stored)?;
        } else {
            old_form::read(&mut body, &mut stored)?;
        }
        body.finish();
        Ok(stored)
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
            Some(strings) => self.attributes.user_strings.extend(strings),
            None => self.attributes.user_data.push(data),
        }
        Ok(())
    }
}

impl Attributes {
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
            all.push(UserData::from_strings(&self.user_strings, version)?);
        }
        all.extend(self.user_data.iter().filter(|data| data.class != class_ids::USER_STRINGS).cloned());
        Ok(all)
    }
}
