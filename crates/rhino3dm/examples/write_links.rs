//! Writes what refers to something: linked blocks, hatches and their patterns, details: `write_links OUT.3dm VERSION`.

use katydid_3dm::{
    Block, BlockSource, Checksum, CurveForm, DetailView, FileReference, Hatch, HatchFill, HatchLine,
    HatchLoop, HatchPattern, LinkedBlock, Model, ModelObject, Object,
};
use katydid_geometry::{Arc, Circle, Interval, Plane, Point2, Point3};
use uuid::Uuid;

fn blocks() -> Vec<Block> {
    let full = FileReference {
        full_path: "/models/größe/far 🦗.3dm".into(),
        relative_path: "far 🦗.3dm".into(),
        ..FileReference::default()
    };
    let relative = FileReference::from_path("beside.3dm");
    let link = |file: &FileReference, appearance| LinkedBlock {
        file: file.clone(),
        skip_nested: appearance == 2,
        appearance,
        checksum: Checksum([7; 48]),
        ..LinkedBlock::default()
    };
    let sources = [
        ("static", BlockSource::Static),
        ("unset", BlockSource::Unset),
        ("embedded", BlockSource::LinkedAndEmbedded(link(&full, 0))),
        ("embedded, relative", BlockSource::LinkedAndEmbedded(link(&relative, 0))),
        ("active", BlockSource::Linked(link(&full, 1))),
        ("apart", BlockSource::Linked(link(&full, 2))),
        ("relative", BlockSource::Linked(link(&relative, 1))),
    ];
    let numbered = sources.into_iter().zip(1..);
    let block = |((name, source), number): ((&str, BlockSource), u128)| Block {
        id: Uuid::from_u128(number),
        name: name.into(),
        description: "Beschreibung".into(),
        source,
        ..Block::default()
    };
    numbered.map(block).collect()
}

fn hatch(pattern: i32) -> Object {
    let angle = Interval::new(0.0, std::f64::consts::TAU);
    let arc = Arc { circle: Circle { plane: Plane::XY, radius: 2.0 }, angle };
    let curve = CurveForm::Arc { arc, offset: None, domain: angle, dimension: 2 };
    Object::Hatch(Box::new(Hatch {
        plane: Plane::XY.into(),
        scale: 1.5,
        rotation: 0.25,
        pattern,
        loops: vec![HatchLoop { outer: true, curve }],
        base_point: Point2::ORIGIN,
    }))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [output, version] = arguments.as_slice() else {
        return Err("usage: write_links OUT.3dm VERSION".into());
    };
    let named = |name: &str, object: Object| {
        let mut object = ModelObject::from(object);
        object.attributes.name = name.into();
        object
    };
    let line = HatchLine { offset: [0.0, 3.0], dashes: vec![1.0, -0.5], ..HatchLine::default() };
    let pattern = |name: &str, fill| HatchPattern { name: name.into(), fill, ..HatchPattern::default() };
    let mut model = Model {
        blocks: blocks(),
        hatch_patterns: vec![
            pattern("solid", HatchFill::Solid),
            pattern("lines", HatchFill::Lines(vec![line.clone()])),
            pattern("more", HatchFill::Lines(vec![line.clone(), line])),
        ],
        ..Model::default()
    };
    for (name, index) in [("hatched 2", 2), ("hatched 0", 0), ("hatched -1", -1)] {
        model.objects.push(named(name, hatch(index)));
    }
    let detail = DetailView::from_above([[10.0, 20.0], [110.0, 80.0]], Point3::new(1.0, 2.0, 3.0), 0.5)?;
    model.objects.push(named("detail", Object::DetailView(Box::new(detail))));
    model.write_to(version.parse()?, &mut std::fs::File::create(output)?)?;
    Ok(())
}
