//! What is read from files: texts, points and pictures.

use std::sync::Arc;

use katydid_component::{Context, Message, component};
use katydid_geometry::{Mesh, Point3, Rectangle};

use super::picture::{Outside, Picture};

/// The text of a file: UTF-8 or UTF-16 by its mark, else UTF-8 with what is not replaced.
fn text(context: &Context<'_>, path: &str) -> Result<String, Message> {
    let bytes = context.read_file(path)?;
    let wide = |bytes: &[u8], unit: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = bytes.chunks_exact(2).filter_map(|p| p.try_into().ok()).map(unit).collect();
        String::from_utf16_lossy(&units)
    };
    Ok(match bytes.as_slice() {
        [0xef, 0xbb, 0xbf, rest @ ..] => String::from_utf8_lossy(rest).into_owned(),
        [0xff, 0xfe, rest @ ..] => wide(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => wide(rest, u16::from_be_bytes),
        rest => String::from_utf8_lossy(rest).into_owned(),
    })
}

/// Reads a text file, line by line or as one text.
///
/// A path that is not absolute starts where the definition lies. It is an error when there is no such file or it may not
/// be read.
#[component("6587fcbf-e3cf-480a-b2f5-641794474194", name = "Read File", nick = "File", at = "Params/Input")]
#[output("Content", "C", "The lines, or the whole text.", kind = Generic)]
fn read_file(
    context: &Context<'_>,
    /// The path of the file.
    #[port("File", "F")]
    file: Arc<str>,
    /// Whether each line is an item of its own.
    #[port("Lines", "L", optional)]
    lines: Option<bool>,
) -> Result<Vec<Arc<str>>, Message> {
    let text = text(context, &file)?;
    // Early files keep the switch in the object.
    let lines = lines.or_else(|| context.settings().bool("PerLineParse")).unwrap_or(true);
    if !lines {
        return Ok(vec![Arc::from(text)]);
    }
    context.items(text.lines().count())?;
    Ok(text.lines().map(Arc::from).collect())
}

/// Reads points from a text file, one a line.
///
/// Empty lines and comments are left out; a line without numbers in its columns is left out with a warning.
#[component(
    "b8a66384-fc66-4574-a8a9-ad18e610d623",
    name = "Import Coordinates",
    nick = "Coords",
    at = "Params/Input"
)]
#[output("Points", "P", "The points in order.")]
fn import_coordinates(
    context: &Context<'_>,
    /// The path of the file; one that is not absolute starts where the definition lies.
    #[port("File", "F")]
    file: Arc<str>,
    /// What stands between the columns. A blank stands for any number of blanks and tabs.
    #[port("Separator", "S", default = ",")]
    separator: Arc<str>,
    /// What comments begin with.
    #[port("Comment", "C", default = "#")]
    comment: Arc<str>,
    /// The column of x, from 0.
    #[port("X Index", "X", default = 0)]
    x: i32,
    /// The column of y.
    #[port("Y Index", "Y", default = 1)]
    y: i32,
    /// The column of z; z is 0 when it is negative.
    #[port("Z Index", "Z", default = 2)]
    z: i32,
) -> Result<Vec<Point3>, Message> {
    let column = |i: i32, port: &str| crate::sets::count(i, port);
    let (x, y, z) = (column(x, "X Index")?, column(y, "Y Index")?, usize::try_from(z).ok());
    let text = text(context, &file)?;
    let mut points = Vec::new();
    for (i, line) in text.lines().enumerate() {
        if i % 1024 == 1023 {
            context.check()?;
            context.items(points.len())?;
        }
        let line = line.trim();
        if line.is_empty() || (!comment.is_empty() && line.starts_with(&*comment)) {
            continue;
        }
        let cells: Vec<&str> = if separator.trim().is_empty() {
            line.split_whitespace().collect()
        } else {
            line.split(&*separator).collect()
        };
        let number = |i: usize| cells.get(i)?.trim().parse().ok().filter(|x: &f64| x.is_finite());
        let height = z.map_or(Some(0.0), number);
        match (number(x), number(y), height) {
            (Some(x), Some(y), Some(z)) => points.push(Point3::new(x, y, z)),
            _ => context.warn(format!("Line {} holds no point", i + 1)),
        }
    }
    Ok(points)
}

/// Makes a picture a mesh: a grid over a rectangle with the colour of the picture at each vertex.
#[component("c2c0c6cf-f362-4047-a159-21a72e7c272a", name = "Import Image", nick = "IMG", at = "Params/Input")]
#[output("Image", "I", "The coloured mesh.")]
fn import_image(
    context: &Context<'_>,
    /// The path of the picture, PNG, JPEG, BMP or GIF; one that is not absolute starts where the definition lies.
    #[port("File", "F")]
    file: Arc<str>,
    /// Where the picture shall lie.
    #[port("Rectangle", "R")]
    rectangle: Rectangle,
    /// The number of vertices along x, at least 2.
    #[port("X Samples", "X", default = 50)]
    x: i32,
    /// The number of vertices along y, at least 2.
    #[port("Y Samples", "Y", default = 50)]
    y: i32,
) -> Result<Arc<Mesh>, Message> {
    let cells = |n: i32, port: &str| match usize::try_from(n) {
        Ok(n) if n >= 2 => Ok(n - 1),
        _ => Err(Message::error(format!("{port} is {n}, which must be at least 2"))),
    };
    let (nx, ny) = (cells(x, "X Samples")?, cells(y, "Y Samples")?);
    context.bytes((nx + 1).saturating_mul(ny + 1).saturating_mul(128))?;
    let picture = Picture::read(&context.read_file(&file)?)?;
    let mesh = Mesh::plane(&rectangle, nx, ny)?;
    // Vertices go row by row from below.
    let place = |i: usize, n: usize| i as f64 / n as f64;
    let byte = |x: f64| (x * 255.0).round().clamp(0.0, 255.0) as u8;
    let colours: Vec<[u8; 4]> = (0..=ny)
        .flat_map(|j| (0..=nx).map(move |i| (i, j)))
        .map(|(i, j)| {
            let [a, r, g, b] = picture.at(place(i, nx), place(j, ny), Outside::Clamp, true).map(byte);
            [r, g, b, a]
        })
        .collect();
    Ok(Arc::new(mesh.with_colours(&colours)))
}

#[cfg(test)]
mod tests {
    use katydid_component::{Files, testing::Trial};

    /// A folder with one file; it is removed when the test is done.
    struct Folder(std::path::PathBuf);

    impl Folder {
        fn with(name: &str, file: &str, bytes: &[u8]) -> Self {
            let folder = std::env::temp_dir().join(format!("katydid-{name}-{}", std::process::id()));
            std::fs::create_dir_all(&folder).unwrap();
            std::fs::write(folder.join(file), bytes).unwrap();
            Self(folder)
        }

        fn trial(&self, name: &str, file: &str) -> Trial {
            Trial::of(name).files(Files::Inside(self.0.clone())).item(file)
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = std::fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn texts() {
        let folder = Folder::with("texts", "a.txt", "\u{feff}one\r\ntwo\n\nfour".as_bytes());
        let read = || folder.trial("Read File", "a.txt");
        assert_eq!(read().texts(0), ["{0;0}: one, two, , four"]);
        assert_eq!(read().item(false).run().outputs[0].item_count(), 1);
        assert_eq!(read().setting("PerLineParse", false).run().outputs[0].item_count(), 1);
        assert!(folder.trial("Read File", "b.txt").message().contains("b.txt cannot be read"));
        assert!(Trial::of("Read File").item("/etc/hostname").message().contains("may not be read here"));
        let wide: Vec<u8> =
            [0xff, 0xfe].into_iter().chain("ab".encode_utf16().flat_map(u16::to_le_bytes)).collect();
        let folder = Folder::with("wide", "w.txt", &wide);
        assert_eq!(folder.trial("Read File", "w.txt").texts(0), ["{0;0}: ab"]);
    }

    #[test]
    fn points() {
        let folder = Folder::with("points", "p.csv", b"# x, y, z\n1, 2, 3\n\n4,5,six\n-1,0.5,1e2\n");
        let read = || folder.trial("Import Coordinates", "p.csv");
        assert_eq!(read().texts(0), ["{0;0}: {1, 2, 3}, {-1, 0.5, 100}"]);
        assert_eq!(read().message(), "Line 4 holds no point");
        let flat = read().item(",").item("#").item(1).item(0).item(-1);
        assert_eq!(flat.texts(0), ["{0;0}: {2, 1, 0}, {5, 4, 0}, {0.5, -1, 0}"]);
        assert!(read().item(",").item("#").item(-1).message().contains("X Index"));
    }

    #[cfg(feature = "pictures")]
    #[test]
    fn pictures() {
        use katydid_data::Value;
        use katydid_geometry::{Interval, Plane, Rectangle};
        let mut bytes = std::io::Cursor::new(Vec::new());
        let picture = image::RgbImage::from_raw(1, 2, vec![255, 0, 0, 0, 0, 255]).unwrap();
        picture.write_to(&mut bytes, image::ImageFormat::Bmp).unwrap();
        let folder = Folder::with("pictures", "p.bmp", &bytes.into_inner());
        let rectangle =
            Rectangle { plane: Plane::XY, x: Interval::new(0.0, 1.0), y: Interval::new(0.0, 2.0) };
        let import = || folder.trial("Import Image", "p.bmp").item(rectangle);
        let out = import().item(2).item(3).run().outputs[0].column().get(0);
        let Some(Value::Mesh(mesh)) = out else { panic!("{out:?}") };
        assert_eq!((mesh.vertices().len(), mesh.faces().len()), (6, 2));
        assert_eq!(mesh.colours()[0], [0, 0, 255, 255]);
        assert_eq!(mesh.colours()[5], [255, 0, 0, 255]);
        assert!(import().item(1).message().contains("at least 2"));
    }
}
