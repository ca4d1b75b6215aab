//! Tables made by hand come back from every version that is written, and what a version cannot carry is named.
#![allow(clippy::unwrap_used, reason = "helpers of tests only")]

mod common;

use katydid_3dm::{
    ActiveSpace, Arrowheads, Attributes, BlockSource, Clipping, DimensionStyle, FileReference, Group,
    HatchFill, HatchLine, HatchPattern, Layer, Limits, Linetype, LinetypeChoice, LinkedBlock, Material,
    Model, ModelObject, Object, ObjectMode, Properties, RenderSettings, Revision, SectionStyle, Source,
    Table, Texture, TextureKind, Time, UserTable,
};
use katydid_geometry::{Point3, Units};
use proptest::prelude::*;
use uuid::Uuid;

const VERSIONS: [i32; 5] = [4, 50, 60, 70, 80];

fn again(model: &Model, version: i32) -> Model {
    let back = Model::read(&model.write(version).unwrap(), &Limits::default()).unwrap();
    assert_eq!(back.warnings, [], "version {version}");
    back
}

fn id(number: u128) -> Uuid {
    Uuid::from_u128(number)
}

fn point(attributes: Attributes) -> ModelObject {
    ModelObject { attributes, ..Object::Point(Point3::ORIGIN).into() }
}

fn pattern(name: &str, number: i32, fill: HatchFill) -> HatchPattern {
    let name = name.to_owned();
    HatchPattern { id: id(60 + number as u128), name, fill, ..HatchPattern::default() }
}

/// Every kind of entry, with what all versions can carry.
fn full() -> Model {
    let lines = HatchLine { angle: 0.5, base: [1.0, 2.0], offset: [0.0, 3.0], dashes: vec![1.0, -0.5] };
    let mut texture = Texture::new("C:\\wood.png", TextureKind::Bump);
    (texture.id, texture.bump_scale) = (id(31), [0.0, 2.5]);
    let mut model = Model {
        properties: Properties {
            file_name: "/a/model.3dm".into(),
            revision: Some(Revision {
                created_by: "ada".into(),
                created: Time { fields: [1, 2, 3, 4, 5, 126, 0, 154] },
                count: 7,
                ..Revision::default()
            }),
            ..Properties::default()
        },
        materials: vec![
            Material { id: id(30), textures: vec![texture], ..Material::new("wood", [150, 100, 50, 255]) },
            Material { id: id(32), shine: 128.0, channels: vec![(id(30), 1)], ..Material::default() },
        ],
        linetypes: vec![Linetype { id: id(40), ..Linetype::new("dashed", &[5.0, 2.5]) }],
        layers: vec![Layer {
            id: id(50),
            colour: [1, 2, 3, 255],
            expanded: false,
            linetype: LinetypeChoice::Entry(0),
            material: Some(1),
            plot_colour: Some([4, 5, 6, 255]),
            plot_weight: 0.35,
            iges_level: 12,
            display_material: id(51),
            ..Layer::new("walls")
        }],
        groups: vec![Group { id: id(55), ..Group::new("pair") }, Group { id: id(56), ..Group::default() }],
        hatch_patterns: vec![
            pattern("solid", 3, HatchFill::Solid),
            pattern("lines", 1, HatchFill::Lines(vec![lines.clone(), lines])),
        ],
        ..Model::default()
    };
    model.user_tables.push(UserTable {
        plug_in: id(70),
        carried: false,
        archive_version: 50,
        opennurbs_version: 201_206_145,
        body: vec![1, 2, 3],
    });
    model.settings.current_layer = Some(0);
    model.settings.current_material = Some((Some(1), 1));
    model.settings.current_colour = Some(([9, 8, 7, 255], 1));
    model.settings.current_wire_density = Some(2);
    model.settings.render = Some(RenderSettings { size: [320, 200], ..RenderSettings::default() });
    model.objects.push(point(Attributes {
        id: id(1),
        linetype: LinetypeChoice::Entry(0),
        linetype_source: Source::Object,
        material: Some(0),
        material_source: Source::Object,
        colour_source: Source::Parent,
        unused_colour: [10, 20, 30, 255],
        plot_colour: [40, 50, 60, 255],
        plot_colour_source: Source::Display,
        plot_weight: 0.5,
        plot_weight_source: Source::Object,
        arrowheads: Arrowheads { at_start: false, at_end: true },
        groups: vec![1, 0],
        space: ActiveSpace::Page,
        viewport: id(2),
        display_modes: vec![(id(3), id(4))],
        ..Attributes::default()
    }));
    model.objects.push(point(Attributes { id: id(5), layer: None, ..Attributes::default() }));
    model
}

#[test]
fn every_table_comes_back_from_every_version() {
    let model = full();
    for version in VERSIONS {
        let back = again(&model, version);
        assert_eq!(model.losses(version).unwrap(), []);
        assert_eq!(back.materials[0].textures[0].file.path(), "C:\\wood.png");
        assert_eq!(back.materials[1].channels, model.materials[1].channels);
        assert_eq!(back.linetypes, model.linetypes);
        assert_eq!(back.layers, model.layers);
        assert_eq!(back.groups, model.groups);
        assert_eq!(back.hatch_patterns, model.hatch_patterns);
        assert_eq!(back.objects, model.objects);
        assert_eq!(back.properties.revision, model.properties.revision);
        assert_eq!(back.properties.file_name, model.properties.file_name);
        assert_eq!(back.settings, model.settings);
        assert_eq!(back.user_tables[0].body, [1, 2, 3]);
        assert_eq!(back.user_tables[0].archive_version, 50);
        assert_eq!(back.properties.revision.unwrap().created.date(), Some((2026, 6, 4)));
    }
}

#[test]
fn what_came_with_later_versions_comes_back_from_them() {
    let clipping = Clipping { none: false, planes: vec![id(8)], planes_cut: false };
    let style = SectionStyle {
        background: Some(2),
        boundary_visible: Some(false),
        hatch: Some(1),
        hatch_scale: Some(2.0),
        boundary_linetype: Some(Box::new(Linetype::new("own", &[1.0, 1.0]))),
        ..SectionStyle::default()
    };
    let mut model = full();
    let layer = &mut model.layers[0];
    (layer.clipping, layer.section_style) = (Some(clipping.clone()), Some(Box::new(style.clone())));
    layer.visible_in_new_views = false;
    let mut frame = [0.0; 16];
    frame[3] = 5.0;
    model.objects.push(point(Attributes {
        id: id(6),
        clipping: Some(clipping),
        section_source: 1,
        section_style: Some(Box::new(style)),
        linetype_scale: 2.0,
        own_linetype: Some(Box::new(Linetype { width: 3.0, width_units: 2, ..Linetype::new("", &[1.0]) })),
        hatch_background: Some([1, 2, 3, 255]),
        hatch_boundary: true,
        frame: Some(frame),
        clipping_label: 1,
        display_order: -3,
        ..Attributes::default()
    }));
    model.linetypes[0].taper = vec![[0.0, 1.0], [1.0, 3.0]];
    model.hatch_patterns.push(pattern("fade", 9, HatchFill::Gradient));
    for version in [60, 70, 80] {
        let back = again(&model, version);
        assert_eq!((&back.layers, &back.objects), (&model.layers, &model.objects));
        assert_eq!((&back.linetypes, &back.hatch_patterns), (&model.linetypes, &model.hatch_patterns));
    }
    let lost: Vec<String> = model.losses(50).unwrap().into_iter().map(|loss| loss.what).collect();
    assert_eq!(lost, ["the gradient of the hatch pattern fade", "the width of the linetype dashed"]);
}

#[test]
fn blocks_are_made_with_their_members() {
    let mut model = Model { units: Units::Millimeters, ..Model::default() };
    let layer = model.layer_at("steel::bolts");
    let group = model.group_named("set");
    let member = |name: &str| {
        point(Attributes {
            name: name.into(),
            layer: Some(layer),
            groups: vec![group],
            user_strings: vec![("part".into(), name.into())],
            ..Attributes::default()
        })
    };
    let first = model.add_block("bolt", vec![member("head"), member("shaft")]);
    let second = model.add_block("Bolt", vec![member("other")]);
    assert_ne!(first, second);
    for version in VERSIONS {
        let back = again(&model, version);
        let block = back.block("BOLT").unwrap();
        assert_eq!((block.id, block.units.number, block.units.metres), (first, 2, 1e-3));
        let members: Vec<&str> = back.members(block).map(|o| o.attributes.name.as_str()).collect();
        assert_eq!(members, ["head", "shaft"]);
        assert!(back.members(block).all(|o| o.attributes.mode == ObjectMode::InDefinition));
        assert_eq!(back.block_by_id(second).unwrap().name, "Bolt 2");
        assert_eq!(back.in_group(group).count(), 3);
        assert_eq!(back.groups_of(&back.objects[0]).next().unwrap().name, "set");
        assert_eq!(back.layer_path(layer).as_deref(), Some("steel::bolts"));
    }
}

#[test]
fn linked_blocks_come_back() {
    let mut model = Model::default();
    model.add_block("far", vec![]);
    let file = FileReference::from_path("/models/far.3dm");
    let link = LinkedBlock { file, skip_nested: true, appearance: 2, ..LinkedBlock::default() };
    model.blocks[0].source = BlockSource::Linked(link);
    for version in VERSIONS {
        assert_eq!(again(&model, version).blocks, model.blocks, "version {version}");
    }
}

#[test]
fn numbers_of_entries_that_are_not_there_are_left_out() {
    let mut model = Model::default();
    model.objects.push(point(Attributes {
        id: id(1),
        material: Some(7),
        linetype: LinetypeChoice::Entry(9),
        groups: vec![4],
        ..Attributes::default()
    }));
    let read = &again(&model, 70).objects[0].attributes;
    assert_eq!((read.material, read.linetype, read.groups.len()), (None, LinetypeChoice::Continuous, 0));
}

#[test]
fn real_archives_keep_every_table_in_versions_from_60_on() {
    for (path, bytes) in common::archives() {
        let Ok(model) = Model::read(&bytes, &Limits::default()) else { continue };
        for version in [60, 70, 80] {
            let (written, losses) = model.write_what_fits(version).unwrap();
            let back = Model::read(&written, &Limits::default()).unwrap();
            let name = path.display();
            let is_object = |what: &str| what.starts_with("object") || what.starts_with("light");
            let lost: Vec<_> = losses.iter().filter(|loss| !is_object(&loss.what)).collect();
            assert!(lost.is_empty(), "{name} as {version}: {lost:?}");
            // Text styles of before are fonts of the dimension styles now.
            let others =
                |model: &Model| model.kept.iter().filter(|record| record.table != Table::TextStyles).count();
            assert_eq!(others(&back), others(&model), "{name} as {version}");
            assert_eq!((&back.linetypes, &back.settings), (&model.linetypes, &model.settings), "{name}");
            assert_eq!(back.views(), model.views(), "{name} as {version}");
            // Styles of early archives have no identifiers.
            let bare = |style: DimensionStyle| DimensionStyle { id: Uuid::nil(), number: 0, ..style };
            let styles = |model: &Model| model.dimension_styles().into_iter().map(bare).collect::<Vec<_>>();
            assert_eq!(styles(&back), styles(&model), "{name} as {version}");
        }
    }
}

proptest! {
    #[test]
    fn layers_are_found_where_they_were_made(paths in prop::collection::vec("[a-c ]{0,2}(::[a-c:]{0,3}){0,3}", 1..12)) {
        let mut model = Model::default();
        let places: Vec<usize> = paths.iter().map(|path| model.layer_at(path)).collect();
        for (path, place) in paths.iter().zip(&places) {
            prop_assert_eq!(model.layer_at(path), *place);
            let full = model.layer_path(*place).unwrap();
            prop_assert_eq!(model.layer_at(&full), *place);
        }
        let ids: std::collections::HashSet<Uuid> = model.layers.iter().map(|layer| layer.id).collect();
        prop_assert_eq!(ids.len(), model.layers.len());
    }
}
