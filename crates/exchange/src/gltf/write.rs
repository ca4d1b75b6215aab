//! Writing: the plan first, then the numbers, list by list.

use std::io::Write;

use base64::engine::general_purpose::STANDARD;
use base64::write::EncoderWriter;
use katydid_geometry::Vector3;

use super::plan::{List, Plan};
use super::{FORMAT, colour};
use crate::piece::{Form, Piece, pieces};
use crate::text::Text;
use crate::{Error, LeftOut, Options, Result, Scene};

pub(crate) fn write_glb(scene: &Scene, options: &Options, out: &mut dyn Write) -> Result<Vec<LeftOut>> {
    let (pieces, left_out) = pieces(scene, options);
    let plan = Plan::of(scene, &pieces)?;
    let mut json = json_but_buffers(&plan)?;
    if plan.length > 0 {
        json.extend_from_slice(format!(r#","buffers":[{{"byteLength":{}}}]"#, plan.length).as_bytes());
    }
    json.push(b'}');
    json.resize(json.len().next_multiple_of(4), b' ');
    let header = 12 + 8 + json.len();
    let whole = header + if plan.length > 0 { 8 + plan.length } else { 0 };
    let word = |n: usize| -> Result<[u8; 4]> {
        let n =
            u32::try_from(n).map_err(|_| Error::TooLarge { format: "GLB", what: format!("{n} bytes") })?;
        Ok(n.to_le_bytes())
    };
    for part in [*b"glTF", 2_u32.to_le_bytes(), word(whole)?, word(json.len())?, *b"JSON"] {
        out.write_all(&part)?;
    }
    out.write_all(&json)?;
    if plan.length > 0 {
        out.write_all(&word(plan.length)?)?;
        out.write_all(b"BIN\0")?;
        numbers(&plan, &pieces, out)?;
    }
    Ok(left_out)
}

pub(crate) fn write_gltf(scene: &Scene, options: &Options, out: &mut dyn Write) -> Result<Vec<LeftOut>> {
    let (pieces, left_out) = pieces(scene, options);
    let plan = Plan::of(scene, &pieces)?;
    out.write_all(&json_but_buffers(&plan)?)?;
    if plan.length > 0 {
        write!(
            out,
            r#","buffers":[{{"byteLength":{},"uri":"data:application/octet-stream;base64,"#,
            plan.length
        )?;
        let mut encoder = EncoderWriter::new(&mut *out, &STANDARD);
        numbers(&plan, &pieces, &mut encoder)?;
        encoder.finish()?;
        drop(encoder);
        out.write_all(br#""}]"#)?;
    }
    out.write_all(b"}")?;
    Ok(left_out)
}

/// The document up to the place where the buffers belong.
fn json_but_buffers(plan: &Plan) -> Result<Vec<u8>> {
    let mut json = serde_json::to_vec(&plan.document)
        .map_err(|error| Error::TooLarge { format: FORMAT, what: error.to_string() })?;
    json.pop();
    Ok(json)
}

/// All lists, each with the items of all pieces.
fn numbers(plan: &Plan, pieces: &[Piece<'_>], out: &mut dyn Write) -> Result<()> {
    let mut bytes = Text::new(out);
    for list in List::ALL {
        for (piece, frame) in pieces.iter().zip(&plan.frames) {
            match list {
                List::Positions => {
                    piece.points().iter().try_for_each(|p| bytes.bytes(&little(frame.place(*p))))?;
                }
                List::Normals => piece.normals().iter().try_for_each(|n| bytes.bytes(&little(unit(*n))))?,
                List::Colours => piece.colours().iter().try_for_each(|c| {
                    let mut item = [0; 8];
                    for (place, part) in item.chunks_exact_mut(2).zip(colour::to_wide(*c)) {
                        place.copy_from_slice(&part.to_le_bytes());
                    }
                    bytes.bytes(&item)
                })?,
                List::Indices => {
                    let Form::Mesh(mesh) = &piece.form else { continue };
                    for corner in mesh.faces().iter().flat_map(|face| face.triangles()).flatten() {
                        bytes.bytes(&corner.to_le_bytes())?;
                    }
                }
            }
        }
    }
    bytes.flush()
}

/// A normal of length 1, which glTF asks for; upward where it has no direction.
fn unit(n: Vector3) -> [f32; 3] {
    let n = n.unitized().unwrap_or(Vector3::Z);
    [n.x as f32, n.z as f32, -n.y as f32]
}

fn little(numbers: [f32; 3]) -> [u8; 12] {
    let mut bytes = [0; 12];
    for (place, x) in bytes.chunks_exact_mut(4).zip(numbers) {
        place.copy_from_slice(&x.to_le_bytes());
    }
    bytes
}
