//! Tables: layers, materials, linetypes, groups, blocks and the attributes that refer to them.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use katydid_3dm::{Attributes, BlockSource, Limits, LinetypeChoice, Model, Source, View, ViewProjection};
use serde_json::{Value, json};

use crate::numbers::{point, vector};

/// The tables of a model.
pub(crate) fn tables(model: &Model) -> Value {
    let layers: Vec<Value> = (model.layers.iter().enumerate())
        .map(|(i, layer)| {
            json!({"name": layer.name, "path": model.layer_path(i), "colour": layer.colour,
                "id": layer.id.to_string(), "visible": layer.visible, "locked": layer.locked,
                "expanded": layer.expanded, "iges": layer.iges_level, "material": place(layer.material),
                "linetype": linetype(layer.linetype), "plot_colour": layer.plot_colour,
                "plot_weight": layer.plot_weight, "parent": layer.parent.unwrap_or_default().to_string()})
        })
        .collect();
    let materials: Vec<Value> = (model.materials.iter())
        .map(|m| {
            json!({"name": m.name, "id": m.id.to_string(), "diffuse": m.diffuse, "shine": m.shine,
                "transparency": m.transparency, "reflectivity": m.reflectivity, "refraction": m.refraction,
                "textures": m.textures.iter().map(|t| t.file.path()).collect::<Vec<_>>()})
        })
        .collect();
    let linetypes: Vec<Value> = (model.linetypes.iter())
        .map(|l| {
            let segments: Vec<_> = l.segments.iter().map(|s| json!([s.length, s.is_gap])).collect();
            json!({"name": l.name, "id": l.id.to_string(), "segments": segments})
        })
        .collect();
    let groups: Vec<Value> =
        (model.groups.iter()).map(|group| json!({"name": group.name, "id": group.id.to_string()})).collect();
    let blocks: Vec<Value> = (model.blocks.iter())
        .map(|block| {
            let members: Vec<String> = block.members.iter().map(ToString::to_string).collect();
            let link = block.link().cloned().unwrap_or_default();
            let source = match &block.source {
                BlockSource::Static | BlockSource::Unset => "static",
                BlockSource::LinkedAndEmbedded(_) => "linked and embedded",
                BlockSource::Linked(_) => "linked",
            };
            json!({"name": block.name, "id": block.id.to_string(), "description": block.description,
                "members": members, "source": source, "file": link.file.full_path,
                "relative": link.file.relative_path, "skips": link.skip_nested, "appearance": link.appearance})
        })
        .collect();
    let styles: Vec<Value> = (model.dimension_styles().iter())
        .map(|s| {
            json!({"name": s.name, "id": s.id.to_string(), "arrow": s.arrow_length, "text": s.text_height,
                "extension": s.extension_line_extension, "offset": s.extension_line_offset,
                "centermark": s.centermark_size, "gap": s.text_gap})
        })
        .collect();
    let patterns: Vec<Value> = (model.hatch_patterns.iter())
        .map(|p| json!({"name": p.name, "description": p.description}))
        .collect();
    let page = model.page_settings().map(|page| {
        let earth = page.earth.as_ref();
        json!({"units": page.units.name(), "absolute": page.tolerance.absolute, "angle": page.tolerance.angle,
            "base": point(page.base_point), "position": earth.and_then(|earth| earth.position),
            "elevation": earth.map(|earth| earth.elevation)})
    });
    let commands: Vec<String> = model.history().iter().map(|record| record.command.to_string()).collect();
    let mappings: Vec<String> = model.texture_mappings().iter().map(|m| m.id.to_string()).collect();
    let embedded_files: Vec<Value> = (model.embedded_files().iter())
        .map(|file| {
            let content = file.content(&Limits::default()).ok().flatten().unwrap_or_default();
            json!({"path": file.path, "content": STANDARD.encode(content)})
        })
        .collect();
    json!({"embedded_files": embedded_files, "history": commands,
        "texture_mappings": mappings, "views": views(&model.views()), "named_views": views(&model.named_views()),
        "dimension_styles": styles, "hatch_patterns": patterns, "page": page, "layers": layers, "materials": materials, "linetypes": linetypes, "groups": groups, "blocks": blocks})
}

fn views(views: &[View]) -> Vec<Value> {
    let perspective = |view: &View| view.projection == ViewProjection::Perspective;
    (views.iter())
        .map(|v| {
            json!({"name": v.name, "camera": point(v.camera), "direction": vector(v.direction),
                "up": vector(v.up), "frustum": v.frustum, "perspective": perspective(v)})
        })
        .collect()
}

/// The parts of attributes that rhino3dm shows, too.
pub(crate) fn attributes(attributes: &Attributes) -> Value {
    let a = attributes;
    json!({"id": a.id.to_string(), "name": a.name, "url": a.url, "layer": place(a.layer),
        "colour": a.colour, "colour_source": source(a.colour.map_or(a.colour_source, |_| Source::Object)),
        "stored_colour": a.colour.unwrap_or(a.unused_colour), "visible": a.visible,
        "material": place(a.material), "material_source": source(a.material_source),
        "linetype": linetype(a.linetype), "linetype_source": source(a.linetype_source),
        "plot_colour": a.plot_colour, "plot_colour_source": source(a.plot_colour_source),
        "plot_weight": a.plot_weight, "plot_weight_source": source(a.plot_weight_source),
        "wire_density": a.wire_density, "groups": a.groups, "display_order": a.display_order,
        "viewport": a.viewport.to_string(), "casts": a.rendering.casts_shadows,
        "receives": a.rendering.receives_shadows, "user_strings": a.user_strings})
}

fn place(place: Option<usize>) -> Value {
    place.map_or(json!(-1), |place| json!(place))
}

fn linetype(choice: LinetypeChoice) -> Value {
    match choice {
        LinetypeChoice::ByLayer => json!(-2),
        LinetypeChoice::ByParent => json!(-3),
        LinetypeChoice::Entry(place) => json!(place),
        _ => json!(-1),
    }
}

fn source(source: Source) -> u8 {
    match source {
        Source::Layer => 0,
        Source::Object => 1,
        Source::Display => 2,
        Source::Parent => 3,
    }
}
