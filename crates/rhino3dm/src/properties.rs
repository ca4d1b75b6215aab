//! The properties table (section 5): who wrote the archive, when, and with what notes.

use crate::chunk::{Chunk, Reader, Writer};
use crate::{Result, StoredBuffer, typecode};

/// What an archive says of itself besides its notes and its application.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Properties {
    /// The path under which it was saved.
    pub file_name: String,
    /// Who made and changed it, and when.
    pub revision: Option<Revision>,
    /// The web address of the application.
    pub application_url: String,
    /// More about the application, its version mostly.
    pub application_details: String,
    /// How the notes are shown.
    pub notes_window: NotesWindow,
    /// A small picture of the model.
    pub preview: Option<Preview>,
}

/// Who made and changed an archive, and when.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Revision {
    /// Who made it.
    pub created_by: String,
    /// When, in universal time.
    pub created: Time,
    /// Who changed it last.
    pub edited_by: String,
    /// When, in universal time.
    pub edited: Time,
    /// How often it was saved.
    pub count: i32,
}

/// A time of a calendar as archives store it, in universal time. All zeros for none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Time {
    /// Seconds, minutes, hours, day of the month, month from 0, year from 1900, day of the week from Sunday 0, day
    /// of the year from 0.
    pub fields: [i32; 8],
}

impl Time {
    /// Year, month and day, both from 1; nothing when no time is stored.
    pub fn date(&self) -> Option<(i32, i32, i32)> {
        let [_, _, _, day, month, year, ..] = self.fields;
        (day > 0).then(|| (year.saturating_add(1900), month.saturating_add(1), day))
    }
}

/// How notes are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NotesWindow {
    /// Whether the text is HTML.
    pub html: bool,
    /// Whether they are shown at all.
    pub visible: bool,
    /// Left, top, right and bottom edge in pixels.
    pub frame: [i32; 4],
    /// Whether they cannot be changed.
    pub locked: bool,
}

impl Default for NotesWindow {
    fn default() -> Self {
        Self { html: false, visible: true, frame: [0; 4], locked: false }
    }
}

/// A picture in the form of a Windows bitmap.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Preview {
    /// The header of the bitmap: size, width, height and so on.
    pub header: [u8; 40],
    /// Palette and pixels, in one piece or two, as they are stored: most who read a model never look at them.
    pub pieces: Vec<StoredBuffer>,
}

impl Time {
    pub(crate) fn read(body: &mut Reader<'_>) -> Result<Self> {
        let mut time = Self::default();
        for field in &mut time.fields {
            *field = body.i32("time")?;
        }
        Ok(time)
    }

    fn write(self, w: &mut Writer) {
        self.fields.iter().for_each(|field| w.i32(*field));
    }
}

impl Revision {
    fn read(body: &mut Reader<'_>) -> Result<Self> {
        const WHAT: &str = "revision history";
        body.packed_version(WHAT)?;
        Ok(Self {
            created_by: body.string(WHAT)?,
            created: Time::read(body)?,
            edited_by: body.string(WHAT)?,
            edited: Time::read(body)?,
            count: body.i32(WHAT)?,
        })
    }

    fn write(&self, w: &mut Writer) -> Result<()> {
        w.packed_version(1, 0);
        w.string(&self.created_by)?;
        self.created.write(w);
        w.string(&self.edited_by)?;
        self.edited.write(w);
        w.i32(self.count);
        Ok(())
    }
}

impl Preview {
    /// The width and height in pixels.
    pub fn size(&self) -> (i32, i32) {
        let number = |at: usize| {
            let bytes = self.header.get(at..).and_then(<[u8]>::first_chunk::<4>);
            bytes.map_or(0, |bytes| i32::from_le_bytes(*bytes))
        };
        (number(4), number(8))
    }

    /// Reads a header and the pieces behind it up to the end.
    pub(crate) fn read(body: &mut Reader<'_>) -> Result<Self> {
        let mut preview = Self { header: body.array("preview")?, pieces: Vec::new() };
        while !body.is_at_end() {
            preview.pieces.push(body.stored_buffer("preview")?);
        }
        Ok(preview)
    }

    fn write(&self, w: &mut Writer) -> Result<()> {
        w.bytes(&self.header);
        self.pieces.iter().try_for_each(|piece| w.stored_buffer(piece))
    }
}

/// Reads one record of the table; gives whether it was one that is known.
pub(crate) fn read(
    record: &Chunk<'_>,
    properties: &mut Properties,
    notes: &mut String,
    application: &mut String,
) -> Result<bool> {
    let mut body = record.body.clone();
    match record.typecode {
        typecode::FILE_NAME => properties.file_name = body.string("file name")?,
        typecode::REVISION => properties.revision = Some(Revision::read(&mut body)?),
        typecode::PREVIEW => properties.preview = Some(Preview::read(&mut body)?),
        typecode::NOTES => {
            const WHAT: &str = "notes";
            let (_, minor) = body.packed_version(WHAT)?;
            let window = &mut properties.notes_window;
            window.html = body.i32(WHAT)? != 0;
            *notes = body.string(WHAT)?;
            window.visible = body.i32(WHAT)? != 0;
            for edge in &mut window.frame {
                *edge = body.i32(WHAT)?;
            }
            if minor >= 1 {
                window.locked = body.bool(WHAT)?;
            }
        }
        typecode::APPLICATION => {
            const WHAT: &str = "application";
            body.packed_version(WHAT)?;
            *application = body.string(WHAT)?;
            properties.application_url = body.string(WHAT)?;
            properties.application_details = body.string(WHAT)?;
        }
        _ => return Ok(false),
    }
    body.finish();
    Ok(true)
}

/// Writes the records of the table behind the version; a new model without an application gets ours.
pub(crate) fn write(
    properties: &Properties,
    notes: &str,
    application: &str,
    is_new: bool,
    w: &mut Writer,
) -> Result<()> {
    if !properties.file_name.is_empty() {
        w.chunk(typecode::FILE_NAME, |w| w.string(&properties.file_name))?;
    }
    if let Some(revision) = &properties.revision {
        w.chunk(typecode::REVISION, |w| revision.write(w))?;
    }
    let window = &properties.notes_window;
    if !notes.is_empty() || *window != NotesWindow::default() {
        w.chunk(typecode::NOTES, |w| {
            w.packed_version(1, 1);
            w.i32(i32::from(window.html));
            w.string(notes)?;
            w.i32(i32::from(window.visible));
            window.frame.iter().for_each(|edge| w.i32(*edge));
            w.bool(window.locked);
            Ok(())
        })?;
    }
    if let Some(preview) = &properties.preview {
        w.chunk(typecode::PREVIEW, |w| preview.write(w))?;
    }
    w.chunk(typecode::APPLICATION, |w| {
        w.packed_version(1, 0);
        // A model that was read keeps what it says, be it nothing.
        if application.is_empty() && is_new {
            w.string("Katydid")?;
            w.string("")?;
            return w.string(env!("CARGO_PKG_VERSION"));
        }
        w.string(application)?;
        w.string(&properties.application_url)?;
        w.string(&properties.application_details)
    })
}
