//! A glTF file as it is found: its two containers, and the part of its JSON that is read.

use std::borrow::Cow;

use base64::Engine;
use base64::engine::general_purpose::{STANDARD, STANDARD_NO_PAD};
use serde::Deserialize;

use super::FORMAT;
use crate::{Error, Result};

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Json {
    pub(super) asset: Asset,
    pub(super) scene: Option<usize>,
    pub(super) scenes: Vec<Scene>,
    pub(super) nodes: Vec<Node>,
    pub(super) meshes: Vec<Mesh>,
    pub(super) materials: Vec<Material>,
    pub(super) accessors: Vec<Accessor>,
    pub(super) buffer_views: Vec<BufferView>,
    pub(super) buffers: Vec<Buffer>,
    pub(super) extensions_required: Vec<String>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
pub(super) struct Asset {
    pub(super) version: String,
}

#[derive(Deserialize)]
pub(super) struct Scene {
    #[serde(default)]
    pub(super) nodes: Vec<usize>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
pub(super) struct Node {
    pub(super) name: String,
    pub(super) children: Vec<usize>,
    pub(super) mesh: Option<usize>,
    /// By columns.
    pub(super) matrix: Option<[f64; 16]>,
    pub(super) translation: Option<[f64; 3]>,
    pub(super) rotation: Option<[f64; 4]>,
    pub(super) scale: Option<[f64; 3]>,
}

#[derive(Deserialize)]
pub(super) struct Mesh {
    #[serde(default)]
    pub(super) name: String,
    pub(super) primitives: Vec<Primitive>,
}

#[derive(Deserialize)]
pub(super) struct Primitive {
    pub(super) attributes: Attributes,
    pub(super) indices: Option<usize>,
    pub(super) material: Option<usize>,
    pub(super) mode: Option<u32>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
pub(super) struct Attributes {
    #[serde(rename = "POSITION")]
    pub(super) position: Option<usize>,
    #[serde(rename = "NORMAL")]
    pub(super) normal: Option<usize>,
    #[serde(rename = "COLOR_0")]
    pub(super) colour: Option<usize>,
}

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Material {
    pub(super) pbr_metallic_roughness: Surface,
}

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
pub(super) struct Surface {
    pub(super) base_color_factor: Option<[f64; 4]>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Accessor {
    pub(super) buffer_view: Option<usize>,
    #[serde(default)]
    pub(super) byte_offset: usize,
    pub(super) component_type: u32,
    #[serde(default)]
    pub(super) normalized: bool,
    pub(super) count: usize,
    pub(super) r#type: String,
    pub(super) sparse: Option<Sparse>,
}

#[derive(Deserialize)]
pub(super) struct Sparse {
    pub(super) count: usize,
    pub(super) indices: SparsePart,
    pub(super) values: SparsePart,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct SparsePart {
    pub(super) buffer_view: usize,
    #[serde(default)]
    pub(super) byte_offset: usize,
    /// Of indices only.
    #[serde(default)]
    pub(super) component_type: u32,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct BufferView {
    pub(super) buffer: usize,
    #[serde(default)]
    pub(super) byte_offset: usize,
    pub(super) byte_length: usize,
    pub(super) byte_stride: Option<usize>,
}

#[derive(Deserialize)]
pub(super) struct Buffer {
    #[serde(default)]
    pub(super) name: String,
    pub(super) uri: Option<String>,
}

impl Buffer {
    /// What a message calls it: its number, and its name where it has one.
    pub(super) fn title(&self, place: usize) -> String {
        match self.name.as_str() {
            "" => format!("buffer {place}"),
            name => format!("buffer {place} '{}'", name.escape_debug()),
        }
    }
}

/// The JSON and the bytes of all buffers.
pub(super) struct File<'a> {
    pub(super) json: Json,
    pub(super) buffers: Vec<Cow<'a, [u8]>>,
}

pub(super) fn malformed(place: impl Into<String>, why: impl Into<String>) -> Error {
    Error::malformed(FORMAT, place, why)
}

impl<'a> File<'a> {
    pub(super) fn open(bytes: &'a [u8], fetch: &mut dyn FnMut(&str) -> Result<Vec<u8>>) -> Result<Self> {
        let (text, binary) = if bytes.starts_with(b"glTF") { split(bytes)? } else { (bytes, None) };
        let json: Json =
            serde_json::from_slice(text).map_err(|error| malformed("the JSON", error.to_string()))?;
        if !json.asset.version.starts_with("2.") {
            return Err(Error::Unsupported(format!(
                "glTF of version '{}'",
                json.asset.version.escape_debug()
            )));
        }
        // Extensions that compress or quantise the numbers stand here; without them they cannot be read.
        if let Some(extension) =
            json.extensions_required.iter().find(|name| !HARMLESS.contains(&name.as_str()))
        {
            return Err(Error::Unsupported(format!("the glTF extension {}", extension.escape_debug())));
        }
        let mut buffers = Vec::new();
        for (place, buffer) in json.buffers.iter().enumerate() {
            let title = buffer.title(place);
            buffers.push(match (&buffer.uri, binary) {
                (None, Some(binary)) if place == 0 => Cow::Borrowed(binary),
                (None, _) => {
                    return Err(malformed(
                        title,
                        "its bytes are not in the file, and it names no other file",
                    ));
                }
                (Some(uri), _) => Cow::Owned(resolve(uri, &title, fetch)?),
            });
        }
        Ok(Self { json, buffers })
    }
}

/// Extensions that change how things look, not where they are.
const HARMLESS: &[&str] =
    &["KHR_materials_unlit", "KHR_texture_transform", "KHR_materials_pbrSpecularGlossiness"];

/// The JSON and the binary chunk of a GLB file.
fn split(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>)> {
    let word = |at: usize| {
        let word = bytes.get(at..).and_then(|left| left.first_chunk::<4>());
        word.map(|word| u32::from_le_bytes(*word))
            .ok_or_else(|| malformed(format!("byte {at}"), "the file ends here"))
    };
    let version = word(4)?;
    if version != 2 {
        return Err(Error::Unsupported(format!("GLB of version {version}")));
    }
    let chunk = |at: usize| -> Result<(u32, &[u8], usize)> {
        let length = word(at)? as usize;
        let end = (at + 8).checked_add(length).filter(|end| *end <= bytes.len());
        let end = end.ok_or_else(|| malformed(format!("byte {at}"), "the chunk is longer than the file"))?;
        Ok((word(at + 4)?, bytes.get(at + 8..end).unwrap_or_default(), end))
    };
    const JSON: u32 = u32::from_le_bytes(*b"JSON");
    const BINARY: u32 = u32::from_le_bytes(*b"BIN\0");
    let (kind, json, mut at) = chunk(12)?;
    if kind != JSON {
        return Err(malformed("byte 12", "the first chunk is not JSON"));
    }
    while at + 8 <= bytes.len() {
        let (kind, body, end) = chunk(at)?;
        if kind == BINARY {
            return Ok((json, Some(body)));
        }
        at = end;
    }
    Ok((json, None))
}

/// The bytes that a buffer names, in the file itself or in another one; `title` is what messages call the buffer.
fn resolve(uri: &str, title: &str, fetch: &mut dyn FnMut(&str) -> Result<Vec<u8>>) -> Result<Vec<u8>> {
    let Some(data) = uri.strip_prefix("data:") else {
        return fetch(uri).map_err(|error| match error {
            Error::Unsupported(what) => Error::Unsupported(format!("{title}: {what}")),
            other => malformed(title, other.to_string()),
        });
    };
    let (_, text) = data
        .split_once(";base64,")
        .ok_or_else(|| Error::Unsupported(format!("{title}: data that is not in base 64")))?;
    let bytes = STANDARD.decode(text).or_else(|_| STANDARD_NO_PAD.decode(text.trim_end_matches('=')));
    bytes.map_err(|error| malformed(title, error.to_string()))
}
