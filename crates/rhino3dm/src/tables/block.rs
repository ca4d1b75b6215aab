//! Class InstanceDefinition (section 8): a block, the objects that its references show.

use uuid::{Uuid, uuid};

use super::{Component, Entry, FileReference};
use crate::chunk::{Reader, Writer};
use crate::class_object::UserData;
use crate::unit_scale::UnitScale;
use crate::values::{read_box, read_ids, write_ids};
use crate::version::Version;
use crate::{Error, Result, class_ids, typecode};

/// A block definition. Its members are objects of the model whose mode is
/// [`InDefinition`](crate::ObjectMode::InDefinition).
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// The identifier, by which references name it.
    pub id: Uuid,
    /// The name.
    pub name: String,
    /// A description.
    pub description: String,
    /// A web address.
    pub url: String,
    /// What the web address is called.
    pub url_tag: String,
    /// The identifiers of the member objects.
    pub members: Vec<Uuid>,
    /// The least and the greatest corner of a box around the members.
    pub bounds: [[f64; 3]; 2],
    /// The unit the members are in.
    pub units: UnitScale,
    /// Where the members come from.
    pub source: BlockSource,
    /// User data, carried along as it is.
    pub user_data: Vec<UserData>,
}

/// Where the members of a block come from.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum BlockSource {
    /// Nobody has said.
    Unset,
    /// This archive.
    #[default]
    Static,
    /// Another file, with a copy in this archive.
    LinkedAndEmbedded(LinkedBlock),
    /// Another file alone.
    Linked(LinkedBlock),
}

/// The file that a block is linked to.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct LinkedBlock {
    /// The file.
    pub file: FileReference,
    /// Whether blocks that the file links to are left out.
    pub skip_nested: bool,
    /// How layers and materials of the file are shown, by its number in archives: 0 not set, 1 as those of this
    /// model, 2 apart from them.
    pub appearance: u32,
    /// Size, time and check sums of the file in archives before version 60.
    pub checksum: Checksum,
    /// States of the file's layers and the like: the bytes of an anonymous chunk, written from version 60 on.
    pub reference_settings: Option<Vec<u8>>,
}

/// The 48 bytes of a check sum.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Checksum(pub [u8; 48]);

impl Default for Checksum {
    fn default() -> Self {
        Self([0; 48])
    }
}

impl Default for Block {
    fn default() -> Self {
        Self {
            id: Uuid::nil(),
            name: String::new(),
            description: String::new(),
            url: String::new(),
            url_tag: String::new(),
            members: Vec::new(),
            bounds: [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]],
            units: UnitScale { number: 0, name: String::new(), metres: 1.0 },
            source: BlockSource::default(),
            user_data: Vec::new(),
        }
    }
}

const WHAT: &str = "block definition";
/// Archives of version 60 have the older layout up to this openNURBS version.
const OLD_UNTIL: u32 = 2_348_834_153;

/// User data: the relative path of the file in archives of version 5, which have the full one in the body.
const RELATIVE_PATH: Uuid = uuid!("F42D9671-21EB-4692-9B9A-BC3507FF28F5");

const STATIC: u32 = 1;
const LINKED_AND_EMBEDDED: u32 = 2;
const LINKED: u32 = 3;
const UNSET: u32 = u32::MAX;

impl Block {
    /// The file it is linked to, if it is.
    pub fn link(&self) -> Option<&LinkedBlock> {
        match &self.source {
            BlockSource::LinkedAndEmbedded(link) | BlockSource::Linked(link) => Some(link),
            _ => None,
        }
    }

    fn is_linked_only(&self) -> bool {
        matches!(self.source, BlockSource::Linked(_))
    }

    fn set_bounds(&mut self, corners: [f64; 6]) {
        let [a, b, c, d, e, f] = corners;
        self.bounds = [[a, b, c], [d, e, f]];
    }

    fn write_bounds(&self, w: &mut Writer) {
        self.bounds.iter().flatten().for_each(|x| w.f64(*x));
    }

    fn read_old(body: &mut Reader<'_>) -> Result<Self> {
        let offset = body.offset();
        let (major, minor) = body.packed_version(WHAT)?;
        if major != 1 {
            return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
        }
        let mut block = Self { id: body.uuid(WHAT)?, members: read_ids(body, WHAT)?, ..Self::default() };
        block.name = body.string("block name")?;
        block.description = body.string(WHAT)?;
        block.url = body.string(WHAT)?;
        block.url_tag = body.string(WHAT)?;
        block.set_bounds(read_box(body, WHAT)?);
        let kind = body.u32(WHAT)?;
        let path = body.string("path")?;
        let mut link = LinkedBlock { file: FileReference::from_path(&path), ..LinkedBlock::default() };
        if minor >= 1 {
            link.checksum = Checksum(body.array("check sum")?);
        }
        if minor >= 2 {
            block.units.number = body.i32(WHAT)?;
        }
        if minor >= 3 {
            block.units.metres = body.f64(WHAT)?;
            if body.bool(WHAT)? && !link.file.full_path.is_empty() {
                link.file.relative_path = std::mem::take(&mut link.file.full_path);
            }
        }
        if minor >= 4 {
            block.units = read_unit(body)?;
        }
        if minor >= 5 {
            link.skip_nested = body.i32(WHAT)? == 1;
        }
        if minor >= 6 {
            link.appearance = body.u32(WHAT)?;
        }
        if minor >= 7 && body.bool(WHAT)? {
            link.file = FileReference::read(body)?;
        }
        // Old linked blocks looked like the model, later ones stood apart; of others nobody asks.
        link.appearance = match link.appearance {
            _ if kind != LINKED => 0,
            known @ (1 | 2) => known,
            _ if body.version().is_wide() => 2,
            _ => 1,
        };
        block.source = match kind {
            LINKED_AND_EMBEDDED if !path.is_empty() => BlockSource::LinkedAndEmbedded(link),
            LINKED if !path.is_empty() => BlockSource::Linked(link),
            0..=LINKED => BlockSource::Static,
            _ => BlockSource::Unset,
        };
        Ok(block)
    }

    fn read_new(body: &mut Reader<'_>) -> Result<Self> {
        let (mut chunk, _) = body.versioned_1(WHAT)?;
        let component = Component::read_fields(&mut chunk)?;
        let kind = chunk.u32(WHAT)?;
        let units = read_unit(&mut chunk)?;
        let mut block = Self { id: component.id, name: component.name, units, ..Self::default() };
        block.description = chunk.string(WHAT)?;
        block.url = chunk.string(WHAT)?;
        block.url_tag = chunk.string(WHAT)?;
        block.set_bounds(read_box(&mut chunk, WHAT)?);
        if chunk.bool(WHAT)? {
            block.members = read_ids(&mut chunk, WHAT)?;
        }
        let mut link = LinkedBlock::default();
        if chunk.bool(WHAT)? {
            let (mut inner, _) = chunk.versioned_1(WHAT)?;
            link.file = FileReference::read(&mut inner)?;
            link.skip_nested = inner.i32(WHAT)? == 1;
            link.appearance = inner.u32(WHAT)?;
            if inner.bool(WHAT)? {
                link.reference_settings = Some(inner.chunk()?.whole.to_vec());
            }
            inner.finish();
        }
        block.source = match kind {
            LINKED_AND_EMBEDDED => BlockSource::LinkedAndEmbedded(link),
            LINKED => BlockSource::Linked(link),
            STATIC => BlockSource::Static,
            _ => BlockSource::Unset,
        };
        chunk.finish();
        Ok(block)
    }

    fn write_old(&self, id: Uuid, w: &mut Writer) -> Result<()> {
        w.packed_version(1, 6);
        w.uuid(id);
        write_ids(if self.is_linked_only() { &[] } else { &self.members }, w)?;
        for text in [&self.name, &self.description, &self.url, &self.url_tag] {
            w.string(text)?;
        }
        self.write_bounds(w);
        w.u32(match self.source {
            BlockSource::Unset => UNSET,
            BlockSource::Static => 0,
            BlockSource::LinkedAndEmbedded(_) => LINKED_AND_EMBEDDED,
            BlockSource::Linked(_) => LINKED,
        });
        let link = self.link().cloned().unwrap_or_default();
        w.string(link.file.path())?;
        w.bytes(&link.checksum.0);
        w.i32(self.units.number);
        w.f64(self.units.metres);
        w.bool(link.file.full_path.is_empty() && !link.file.relative_path.is_empty());
        write_unit(&self.units, w)?;
        w.i32(i32::from(link.skip_nested));
        w.u32(link.appearance);
        Ok(())
    }

    fn write_new(&self, number: i32, id: Uuid, w: &mut Writer) -> Result<()> {
        w.versioned(1, 0, |w| {
            Component::new(id, number, &self.name).write_fields(w)?;
            w.u32(match self.source {
                BlockSource::Unset => 0,
                BlockSource::Static => STATIC,
                BlockSource::LinkedAndEmbedded(_) => LINKED_AND_EMBEDDED,
                BlockSource::Linked(_) => LINKED,
            });
            write_unit(&self.units, w)?;
            for text in [&self.description, &self.url, &self.url_tag] {
                w.string(text)?;
            }
            self.write_bounds(w);
            w.bool(!self.is_linked_only());
            if !self.is_linked_only() {
                write_ids(&self.members, w)?;
            }
            w.bool(self.link().is_some());
            let Some(link) = self.link() else { return Ok(()) };
            w.versioned(1, 0, |w| {
                link.file.write(w)?;
                w.i32(i32::from(link.skip_nested));
                w.u32(link.appearance);
                w.bool(link.reference_settings.is_some());
                link.reference_settings
                    .iter()
                    .try_for_each(|settings| w.foreign_chunk(typecode::ANONYMOUS, settings))
            })
        })
    }
}

/// A unit system in a chunk of its own.
fn read_unit(body: &mut Reader<'_>) -> Result<UnitScale> {
    const WHAT: &str = "unit system";
    let (mut chunk, _) = body.versioned_1(WHAT)?;
    let (number, metres) = (chunk.i32(WHAT)?, chunk.f64(WHAT)?);
    let units = UnitScale { number, metres, name: chunk.string(WHAT)? };
    chunk.finish();
    Ok(units)
}

fn write_unit(units: &UnitScale, w: &mut Writer) -> Result<()> {
    w.versioned(1, 0, |w| {
        w.i32(units.number);
        w.f64(units.metres);
        w.string(&units.name)
    })
}

impl Entry for Block {
    const CLASS: Uuid = uuid!("26F8BFF6-2618-417F-A158-153D64A94989");
    const WHAT: &'static str = WHAT;

    fn read(body: &mut Reader<'_>) -> Result<Self> {
        let version = body.version();
        let chunked = body.peek_typecode() == Some(typecode::ANONYMOUS);
        let old = version.archive < 60 || version.archive == 60 && version.opennurbs <= OLD_UNTIL || !chunked;
        if old { Self::read_old(body) } else { Self::read_new(body) }
    }

    fn write(&self, number: i32, id: Uuid, w: &mut Writer) -> Result<()> {
        if w.version().archive < 60 { self.write_old(id, w) } else { self.write_new(number, id, w) }
    }

    fn take_own_data(&mut self) {
        let Some(place) = self.user_data.iter().position(|data| data.class == RELATIVE_PATH) else { return };
        let (BlockSource::LinkedAndEmbedded(link) | BlockSource::Linked(link)) = &mut self.source else {
            return;
        };
        let path = self.user_data.get(place).map(|data| data.with_body(read_relative_path));
        if let Some(Ok(Some(path))) = path {
            link.file.relative_path = path;
            self.user_data.remove(place);
        }
    }

    fn own_data(&self, version: Version) -> Result<Option<UserData>> {
        let file = self.link().map(|link| &link.file).filter(|_| version.archive == 50);
        let both = file.filter(|file| !file.full_path.is_empty() && !file.relative_path.is_empty());
        let Some(file) = both else { return Ok(None) };
        let data = UserData::core(RELATIVE_PATH, 0, version, |w| {
            w.versioned(1, 0, |w| {
                w.string(&file.relative_path)?;
                w.bool(true);
                Ok(())
            })
        })?;
        Ok(Some(UserData { application: class_ids::OPENNURBS_5_APPLICATION, ..data }))
    }
}

/// The path in the user data of version 5, if it is a relative one.
fn read_relative_path(body: &mut Reader<'_>) -> Result<Option<String>> {
    let (mut chunk, _) = body.versioned_1(WHAT)?;
    let path = chunk.string("path")?;
    Ok(chunk.bool(WHAT)?.then_some(path))
}
