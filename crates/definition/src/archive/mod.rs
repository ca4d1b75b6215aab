//! The GH_IO archive: a tree of named chunks with typed items, in a binary and an XML encoding.
//!
//! A .gh or .ghuser file, and the byte array of a cluster, is one raw DEFLATE stream (RFC 1951) around the
//! binary tree; a .ghx file is the same tree as XML. [`read`] tells them apart by content.
//!
//! A binary archive that is read and written unchanged inflates to the same bytes. What cannot be kept is
//! refused with an [`Error`] that says so: text that is not UTF-8, a boolean byte that is neither 0 nor 1.
//! Between the encodings the tree survives too, with one exception: XML knows only one NaN.

mod binary;
mod chunk;
mod cursor;
mod decimal;
mod deflate;
mod getters;
mod value;
mod xml;

pub(crate) use cursor::Cursor;
pub(crate) use deflate::{deflate, inflate};

pub use chunk::{Chunk, Item};
pub use decimal::Decimal;
pub use value::{Colour, ItemValue, Version};

use crate::{Error, Place, Result};

/// How deep a tree may nest whatever [`Limits::max_depth`] says: below this, walking it by recursion is safe.
/// Real files stay under 30.
pub const DEEPEST: usize = 500;

/// How much a file may ask for before it is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// The most bytes a compressed stream may inflate to, and the longest XML text.
    pub max_inflated: usize,
    /// How many chunks may stand inside each other; never more than [`DEEPEST`].
    pub max_depth: usize,
    /// How many chunks and items together a tree may have. Each takes about 100 bytes of memory.
    pub max_nodes: usize,
}

impl Default for Limits {
    /// 256 MiB, 200 deep, 4 million nodes.
    fn default() -> Self {
        Self { max_inflated: 256 << 20, max_depth: 200, max_nodes: 4_000_000 }
    }
}

impl Limits {
    /// The depth that holds: the caller's or [`DEEPEST`].
    pub(crate) fn depth(&self) -> usize {
        self.max_depth.min(DEEPEST)
    }

    /// Counts one more node.
    pub(crate) fn count(&self, nodes: &mut usize, place: Place, offset: usize) -> Result<()> {
        *nodes += 1;
        if *nodes > self.max_nodes {
            let (what, limit) = ("the number of chunks and items", self.max_nodes);
            return Err(Error::Limit { place, offset, what, limit });
        }
        Ok(())
    }
}

/// Which of the two encodings a file is in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Encoding {
    /// Compressed binary: .gh, .ghuser, the inside of a cluster.
    Binary,
    /// XML text: .ghx.
    Xml,
}

/// A file, read.
#[derive(Debug, Clone, PartialEq)]
pub struct Archive {
    /// The chunk everything stands in: `Root`, or `Document` in a cluster.
    pub root: Chunk,
    /// The encoding the file was in.
    pub encoding: Encoding,
    /// Peculiarities that did not keep the file from being read: wrong counts, bytes after the end.
    pub notes: Vec<String>,
}

impl Archive {
    /// An archive around a tree, without notes.
    pub fn new(root: Chunk, encoding: Encoding) -> Self {
        Self { root, encoding, notes: Vec::new() }
    }

    /// The file's bytes in the archive's own encoding.
    ///
    /// # Errors
    /// When the tree cannot be written; see [`write_gh`] and [`write_ghx`].
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        match self.encoding {
            Encoding::Binary => write_gh(&self.root),
            Encoding::Xml => write_ghx(&self.root).map(String::into_bytes),
        }
    }
}

/// Tells the encoding by content: the first sign after a byte order mark and blanks is `<` in XML.
///
/// # Errors
/// When the bytes are empty or carry the signature of another format, such as PNG.
pub fn sniff(bytes: &[u8]) -> Result<Encoding> {
    if bytes.is_empty() {
        return Err(Error::at(Place::File, 0, "it is empty"));
    }
    if let Some(what) = foreign(bytes) {
        return Err(Error::Foreign(what));
    }
    Ok(if xml::looks_like_xml(bytes) { Encoding::Xml } else { Encoding::Binary })
}

/// Reads a .gh, .ghx or .ghuser file, or the byte array of a cluster.
///
/// # Errors
/// When the bytes are another format, are cut short or broken ([`Error::Archive`], with the offset), or ask
/// for more than the limits allow.
pub fn read(bytes: &[u8], limits: &Limits) -> Result<Archive> {
    if sniff(bytes)? == Encoding::Xml {
        return xml::read(bytes, limits);
    }
    let inflated = match inflate(bytes, limits.max_inflated) {
        Ok(inflated) => inflated,
        Err(Error::Archive { .. }) if is_text(bytes) => return Err(Error::Foreign("plain text")),
        Err(error) => return Err(error),
    };
    let mut archive = if xml::looks_like_xml(&inflated.data) {
        xml::read(&inflated.data, limits)?
    } else {
        read_binary_tree(&inflated.data, limits)?
    };
    if inflated.consumed < bytes.len() {
        let rest = bytes.len() - inflated.consumed;
        archive.notes.push(format!("{rest} bytes after the end of the compressed stream were ignored"));
    }
    Ok(archive)
}

/// Reads the binary tree itself, already inflated.
///
/// # Errors
/// As for [`read`].
pub fn read_binary_tree(inflated: &[u8], limits: &Limits) -> Result<Archive> {
    binary::read(inflated, limits)
}

/// The binary tree itself, not yet compressed.
///
/// # Errors
/// When the tree is deeper than [`DEEPEST`] or holds more than 2³¹ − 1 of anything.
pub fn write_binary_tree(root: &Chunk) -> Result<Vec<u8>> {
    binary::write(root)
}

/// A .gh file: the binary tree, compressed.
///
/// # Errors
/// As for [`write_binary_tree`].
pub fn write_gh(root: &Chunk) -> Result<Vec<u8>> {
    deflate::deflate(&binary::write(root)?)
}

/// A .ghx file: XML in the layout Grasshopper gives it.
///
/// # Errors
/// When the tree is deeper than [`DEEPEST`] or holds a decimal number that is none.
pub fn write_ghx(root: &Chunk) -> Result<String> {
    xml::write(root)
}

/// Names the format of bytes that are surely no archive.
fn foreign(bytes: &[u8]) -> Option<&'static str> {
    const SIGNATURES: [(&[u8], &str); 12] = [
        (b"\x89PNG\r\n\x1a\n", "a PNG picture"),
        (b"\xff\xd8\xff", "a JPEG picture"),
        (b"GIF8", "a GIF picture"),
        (b"PK\x03\x04", "a zip file"),
        (b"PK\x05\x06", "a zip file"),
        (b"\x1f\x8b", "a gzip file"),
        (b"7z\xbc\xaf\x27\x1c", "a 7-Zip file"),
        (b"3D Geometry File Format", "a Rhino model (.3dm)"),
        (b"%PDF", "a PDF document"),
        (b"ISO-10303-21", "a STEP file"),
        (b"glTF", "a glTF model"),
        (b"version https://git-lfs", "a Git LFS pointer, whose file was not fetched"),
    ];
    SIGNATURES.iter().find(|(signature, _)| bytes.starts_with(signature)).map(|(_, what)| *what)
}

/// Whether the bytes are text that somebody typed.
fn is_text(bytes: &[u8]) -> bool {
    std::str::from_utf8(bytes)
        .is_ok_and(|text| !text.chars().any(|c| c.is_control() && !matches!(c, '\t' | '\r' | '\n')))
}
