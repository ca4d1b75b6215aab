use katydid_component::testing::Trial;
use katydid_data::{Colour, Value};
use katydid_geometry::{Interval, Plane, Rectangle};

fn first(trial: Trial) -> Value {
    trial.run().outputs[0].column().get(0).unwrap()
}

fn colours() -> Vec<Colour> {
    (0..6).map(|i| Colour::rgb(i * 40, 0, 255 - i * 40)).collect()
}

/// A picture of three columns and two rows.
fn picture() -> Value {
    first(Trial::of("Build Bitmap").list(colours()).item(3).item(2))
}

#[test]
fn pictures_come_apart_as_they_were_put_together() {
    let run = Trial::of("Deconstruct Bitmap").item(picture()).run();
    let found: Vec<_> = run.outputs[0].column().iter().flatten().collect();
    assert_eq!(found, colours().into_iter().map(Value::from).collect::<Vec<_>>());
    let of = |k: usize| Trial::of("Bitmap Properties").item(picture()).texts(k);
    assert_eq!([of(1), of(2)], [["{0}: 3"], ["{0}: 2"]]);
    let pixel = Trial::of("Get Pixel").item(picture()).item(2).item(1);
    assert_eq!(first(pixel), Value::from(colours()[5]));
    // In the middle of the first pixel there is its own colour.
    let place = Trial::of("Evaluate Bitmap").item(picture()).item(1.0 / 6.0).item(0.25);
    assert_eq!(first(place), Value::from(colours()[0]));
}

#[test]
fn pictures_are_cut_and_mirrored() {
    let region = Rectangle { plane: Plane::XY, x: Interval::new(1.0, 3.0), y: Interval::new(1.0, 2.0) };
    let part = first(Trial::of("Crop Image").item(picture()).item(region));
    let run = Trial::of("Deconstruct Bitmap").item(part).run();
    let found: Vec<_> = run.outputs[0].column().iter().flatten().collect();
    assert_eq!(found, [Value::from(colours()[4]), Value::from(colours()[5])]);
    let mirrored = first(Trial::of("Mirror Image").item(picture()).item(true).item(true));
    let run = Trial::of("Deconstruct Bitmap").item(mirrored).run();
    assert_eq!(run.outputs[0].column().get(0), Some(Value::from(colours()[5])));
    let same = first(Trial::of("Resize Image").item(picture()).default().item(3).item(2));
    let run = Trial::of("Deconstruct Bitmap").item(same).run();
    assert_eq!(run.outputs[0].column().get(1), Some(Value::from(colours()[1])));
}

#[test]
fn noises_fill_pictures() {
    for mode in 0..5 {
        let image = first(
            Trial::of("Procedural Noise").item(3).item(64).item(32).item(1.0).item(mode).item(2).item(0.13),
        );
        let run = Trial::of("Deconstruct Bitmap").item(image).run();
        assert_eq!(run.outputs[0].item_count(), 64 * 32);
        let levels: std::collections::BTreeSet<u8> = run.outputs[0]
            .column()
            .iter()
            .filter_map(|value| match value {
                Some(Value::Colour(c)) => Some(c.r),
                _ => None,
            })
            .collect();
        assert!(levels.len() > 30, "{mode}: {}", levels.len());
    }
    let cells = Trial::of("Procedural Cellular").item(1).item(8).item(8).item(1.0).item(0).item(6);
    assert_eq!(cells.item(0.5).item(0.25).texts(0), ["{0}: Bitmap (8 x 8)"]);
    let wide = Trial::of("Procedural Noise").item(1).item(1_000_000_000).item(1_000_000_000);
    assert!(wide.default().default().default().default().message().contains("pixels"));
}
