//! Small pictures of what an Image Gallery is given.

use std::io::Cursor;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use image::{ImageFormat, ImageReader, Limits, RgbaImage};
use katydid_component::Files;
use katydid_data::{Tree, Value, text};
use katydid_geometry::{BoundingBox, Mesh};
use katydid_session::protocol::PictureView;

/// More pictures than this are not shown.
const MOST: usize = 32;
/// The longest side of a small picture, in pixels.
const SIDE: u32 = 160;
/// That of one of many.
const SMALL_SIDE: u32 = 96;
/// From so many on they are many.
const MANY: usize = 9;
/// The most bytes of a file.
const MOST_BYTES: u64 = 1 << 25;
/// The most bytes of all files together.
const MOST_BYTES_IN_ALL: u64 = 1 << 27;
/// The most pixels that are read for all together: whoever solves waits meanwhile.
const MOST_PIXELS_IN_ALL: u64 = 1 << 27;
/// The longest side of a picture that is read.
const LONGEST: u32 = 1 << 14;
/// The most bytes that a picture may take while it is read.
const MOST_MEMORY: u64 = 1 << 28;
/// The most letters of a name.
const MOST_LETTERS: usize = 200;

/// What may still be read.
struct Room {
    bytes: u64,
    pixels: u64,
}

/// What a gallery shows of each of its items: files of pictures, as far as the definition may read them, and coloured
/// meshes are small pictures; colours are themselves; of all else there is the name.
pub fn pictures(tree: &Tree, files: &Files, style: &text::Style) -> Vec<PictureView> {
    let values: Vec<Value> = tree.column().iter().flatten().take(MOST).collect();
    let side = if values.len() < MANY { SIDE } else { SMALL_SIDE };
    let mut room = Room { bytes: MOST_BYTES_IN_ALL, pixels: MOST_PIXELS_IN_ALL };
    let mut shown = Vec::with_capacity(values.len());
    for value in &values {
        let words = text::value(value, style);
        let name = words.rsplit(['/', '\\']).find(|part| !part.trim().is_empty()).unwrap_or(&words);
        let mut view = PictureView { name: cut(name), image: None, colour: None };
        match value {
            Value::Text(path) => view.image = of_file(path, files, &mut room, side),
            Value::Mesh(mesh) => view.image = of_mesh(mesh, side).and_then(|picture| encoded(&picture)),
            Value::Colour(c) => view.colour = Some([c.r, c.g, c.b, c.a]),
            _ => {}
        }
        shown.push(view);
    }
    shown
}

fn cut(name: &str) -> String {
    name.chars().take(MOST_LETTERS).collect()
}

/// A small picture of a file; none of what may not be read, is no picture or is too large.
fn of_file(path: &str, files: &Files, room: &mut Room, side: u32) -> Option<String> {
    let bytes = files.read(path, MOST_BYTES.min(room.bytes)).ok()?;
    room.bytes = room.bytes.saturating_sub(bytes.len() as u64);
    let read = || ImageReader::new(Cursor::new(&bytes)).with_guessed_format().ok();
    let (width, height) = read()?.into_dimensions().ok()?;
    room.pixels = room.pixels.checked_sub(u64::from(width) * u64::from(height))?;
    let mut reader = read()?;
    let mut limits = Limits::default();
    limits.max_image_width = Some(LONGEST);
    limits.max_image_height = Some(LONGEST);
    limits.max_alloc = Some(MOST_MEMORY);
    reader.limits(limits);
    let picture = reader.decode().ok()?;
    let large = picture.width().max(picture.height()) > side;
    encoded(&if large { picture.thumbnail(side, side) } else { picture }.into_rgba8())
}

/// A picture as an address with all of it inside.
fn encoded(picture: &RgbaImage) -> Option<String> {
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, ImageFormat::Png).ok()?;
    Some(format!("data:image/png;base64,{}", STANDARD.encode(bytes.into_inner())))
}

/// A coloured mesh seen from above, each face in the mean of its vertices' colours; none of one without colours.
fn of_mesh(mesh: &Mesh, side: u32) -> Option<RgbaImage> {
    let BoundingBox { min, max } = mesh.bounding_box()?;
    let (wide, high) = (max.x - min.x, max.y - min.y);
    let colours = mesh.colours();
    if colours.is_empty() || !(wide > 0.0 && high > 0.0) {
        return None;
    }
    let scale = f64::from(side) / wide.max(high);
    let pixels = |length: f64| ((length * scale).round() as u32).clamp(1, side);
    let mut picture = RgbaImage::new(pixels(wide), pixels(high));
    let (w, h) = (picture.width(), picture.height());
    for (f, face) in mesh.faces().iter().enumerate() {
        let Some(points) = mesh.face_points(f) else { continue };
        let own: Vec<[u8; 4]> =
            face.indices().iter().filter_map(|&i| colours.get(i as usize).copied()).collect();
        let mean = |c: usize| {
            let sum: u32 = own.iter().filter_map(|rgba| rgba.get(c)).map(|v| u32::from(*v)).sum();
            (f64::from(sum) / own.len().max(1) as f64).round() as u8
        };
        let pixel = image::Rgba([mean(0), mean(1), mean(2), 255]);
        let corners: Vec<[f64; 2]> =
            points.iter().map(|p| [(p.x - min.x) * scale, (max.y - p.y) * scale]).collect();
        let range = |d: usize, most: u32| {
            let low = corners.iter().map(|c| c[d]).fold(f64::INFINITY, f64::min);
            let high = corners.iter().map(|c| c[d]).fold(f64::NEG_INFINITY, f64::max);
            (low.floor().max(0.0) as u32)..(high.ceil().max(0.0) as u32).min(most)
        };
        for y in range(1, h) {
            for x in range(0, w) {
                if holds(&corners, [f64::from(x) + 0.5, f64::from(y) + 0.5]) {
                    picture.put_pixel(x, y, pixel);
                }
            }
        }
    }
    Some(picture)
}

/// Whether a polygon holds a point, by the sides that a ray to the right crosses.
fn holds(corners: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).fold(false, |inside, (a, b)| {
        let crosses = (a[1] > y) != (b[1] > y) && x < a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]);
        inside != crosses
    })
}

#[cfg(test)]
mod tests {
    use katydid_data::{Colour, Column};
    use katydid_geometry::{Interval, Plane, Rectangle};

    use super::*;

    fn tree(values: Vec<Value>) -> Tree {
        Tree::branch_at(katydid_data::Path::from([0].as_slice()), Column::of_values(values, None))
    }

    fn shown(values: Vec<Value>, files: &Files) -> Vec<PictureView> {
        pictures(&tree(values), files, &text::Style::default())
    }

    fn decoded(view: &PictureView) -> RgbaImage {
        let address = view.image.as_deref().unwrap();
        let bytes = STANDARD.decode(address.strip_prefix("data:image/png;base64,").unwrap()).unwrap();
        image::load_from_memory(&bytes).unwrap().into_rgba8()
    }

    /// Left half red, right half blue.
    fn flag(width: u32, height: u32) -> RgbaImage {
        RgbaImage::from_fn(width, height, |x, _| {
            image::Rgba(if 2 * x < width { [255, 0, 0, 255] } else { [0, 0, 255, 255] })
        })
    }

    #[test]
    fn files_are_shown_small_as_far_as_they_may_be_read() {
        let folder = tempfile::tempdir().unwrap();
        let open = folder.path().join("open");
        std::fs::create_dir(&open).unwrap();
        flag(640, 320).save(open.join("large.png")).unwrap();
        flag(8, 4).save(open.join("small.png")).unwrap();
        flag(8, 4).save(folder.path().join("secret.png")).unwrap();
        std::fs::write(open.join("broken.png"), b"\x89PNG\r\n\x1a\n and no more").unwrap();
        let paths = || {
            let all = ["large.png", "small.png", "../secret.png", "broken.png", "missing.png"];
            all.map(Value::text).to_vec()
        };
        let views = shown(paths(), &Files::Inside(open.clone()));
        let names: Vec<&str> = views.iter().map(|view| view.name.as_str()).collect();
        assert_eq!(names, ["large.png", "small.png", "secret.png", "broken.png", "missing.png"]);
        assert_eq!(
            views.iter().map(|view| view.image.is_some()).collect::<Vec<_>>(),
            [true, true, false, false, false]
        );
        let large = decoded(&views[0]);
        assert_eq!(large.dimensions(), (160, 80));
        assert_eq!(
            (large.get_pixel(10, 40).0, large.get_pixel(150, 40).0),
            ([255, 0, 0, 255], [0, 0, 255, 255])
        );
        assert_eq!(decoded(&views[1]), flag(8, 4));
        // Where nothing may be read there are only names.
        assert!(shown(paths(), &Files::None).iter().all(|view| view.image.is_none()));
        // Of many each is smaller, and there is an end.
        let many = shown(vec![Value::text("large.png"); 100], &Files::Inside(open));
        assert_eq!((many.len(), decoded(&many[0]).dimensions()), (32, (96, 48)));
    }

    #[test]
    fn meshes_and_colours_are_shown_and_the_rest_is_named() {
        let square = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 4.0), y: Interval::new(0.0, 2.0) };
        let mesh = Mesh::plane(&square, 2, 1).unwrap();
        let colours =
            mesh.vertices().iter().map(|p| if p.y > 1.0 { [0, 200, 0, 255] } else { [0, 100, 0, 255] });
        let coloured = mesh.with_colours(&colours.collect::<Vec<_>>());
        let views = shown(
            vec![
                coloured.into(),
                mesh.into(),
                Colour { a: 128, r: 1, g: 2, b: 3 }.into(),
                Value::Number(2.5),
            ],
            &Files::None,
        );
        let picture = decoded(&views[0]);
        assert_eq!(picture.dimensions(), (160, 80));
        assert!(picture.pixels().all(|p| p.0 == [0, 150, 0, 255]));
        assert_eq!((views[1].image.as_ref(), views[2].colour), (None, Some([1, 2, 3, 128])));
        assert_eq!(views[3].name, "2.5");
    }
}
