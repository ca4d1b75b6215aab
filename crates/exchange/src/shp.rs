//! Reading shapefiles: points, polylines and polygons of maps. Only the main file (.shp) is read, which has the geometry.
//!
//! "ESRI Shapefile Technical Description", an ESRI white paper, July 1998.

use katydid_geometry::Point3;

use crate::{Error, LeftOut, Result};

const FORMAT: &str = "SHP";
/// The bytes before the first record.
const HEADER: usize = 100;
/// What every file begins with.
const FILE_CODE: i32 = 9994;

/// What a shapefile holds, record by record.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Shapefile {
    /// The points, those of multipoints too.
    pub points: Vec<Point3>,
    /// The parts of polylines.
    pub lines: Vec<Vec<Point3>>,
    /// The rings of each polygon: outlines, and holes in them.
    pub polygons: Vec<Vec<Vec<Point3>>>,
    /// What is not among these.
    pub left_out: Vec<LeftOut>,
}

/// Bytes of which some are read.
struct Cursor<'a> {
    bytes: &'a [u8],
}

impl Cursor<'_> {
    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (taken, rest) = self.bytes.split_first_chunk::<N>()?;
        self.bytes = rest;
        Some(*taken)
    }

    fn little(&mut self) -> Option<i32> {
        self.take().map(i32::from_le_bytes)
    }

    fn big(&mut self) -> Option<i32> {
        self.take().map(i32::from_be_bytes)
    }

    fn number(&mut self) -> Option<f64> {
        self.take().map(f64::from_le_bytes)
    }

    fn skip(&mut self, n: usize) -> Option<()> {
        self.bytes = self.bytes.get(n..)?;
        Some(())
    }

    /// A count of things that take `size` bytes each, all of which must be there.
    fn count(&mut self, size: usize) -> Option<usize> {
        let n = usize::try_from(self.little()?).ok()?;
        (n.checked_mul(size)? <= self.bytes.len()).then_some(n)
    }
}

/// Reads a shapefile. What one of its records cannot give is left out and told.
///
/// # Errors
/// When the bytes are no shapefile.
pub fn read(bytes: &[u8]) -> Result<Shapefile> {
    let wrong = |place: &str, why: &str| Error::malformed(FORMAT, place, why);
    let code = bytes.first_chunk().copied().map(i32::from_be_bytes);
    if code != Some(FILE_CODE) {
        return Err(wrong("byte 0", "it does not begin as every shapefile does"));
    }
    let body = bytes.get(HEADER..).ok_or_else(|| wrong("byte 4", "it is shorter than a header"))?;
    let mut cursor = Cursor { bytes: body };
    let mut found = Shapefile::default();
    while !cursor.bytes.is_empty() {
        let Some(content) = record(&mut cursor) else {
            LeftOut::add(&mut found.left_out, LeftOut::new("record", 1, "the file ends before it does"));
            break;
        };
        let mut content = Cursor { bytes: content };
        let kind = content.little().unwrap_or(0);
        if let Err(why) = shape(kind, &mut content, &mut found) {
            LeftOut::add(&mut found.left_out, LeftOut::new(name(kind), 1, why));
        }
    }
    Ok(found)
}

/// The bytes of the next record.
fn record<'a>(cursor: &mut Cursor<'a>) -> Option<&'a [u8]> {
    cursor.big()?;
    // Lengths count words of 16 bits.
    let length = usize::try_from(cursor.big()?).ok()?.checked_mul(2)?;
    let (content, rest) = cursor.bytes.split_at_checked(length)?;
    cursor.bytes = rest;
    Some(content)
}

fn name(kind: i32) -> String {
    match kind {
        1 | 11 | 21 => "point".to_owned(),
        3 | 13 | 23 => "polyline".to_owned(),
        5 | 15 | 25 => "polygon".to_owned(),
        8 | 18 | 28 => "multipoint".to_owned(),
        31 => "multipatch".to_owned(),
        other => format!("shape of type {other}"),
    }
}

/// Adds the shape of a record.
fn shape(
    kind: i32,
    content: &mut Cursor<'_>,
    found: &mut Shapefile,
) -> std::result::Result<(), &'static str> {
    const SHORT: &str = "its record is too short";
    const PARTS: &str = "its parts do not follow each other";
    const FINITE: &str = "a coordinate is not finite";
    let has_heights = matches!(kind, 11 | 13 | 15 | 18);
    match kind {
        0 => {}
        1 | 11 | 21 => {
            let mut next = || content.number().ok_or(SHORT);
            let point = Point3::new(next()?, next()?, if has_heights { next()? } else { 0.0 });
            found.points.push(Some(point).filter(|p| p.is_finite()).ok_or(FINITE)?);
        }
        8 | 18 | 28 => {
            content.skip(32).ok_or(SHORT)?;
            let n = content.count(16).ok_or(SHORT)?;
            found.points.extend(points(content, n, has_heights).ok_or(SHORT)?.ok_or(FINITE)?);
        }
        3 | 5 | 13 | 15 | 23 | 25 => {
            content.skip(32).ok_or(SHORT)?;
            let parts = usize::try_from(content.little().ok_or(SHORT)?).map_err(|_| SHORT)?;
            let n = usize::try_from(content.little().ok_or(SHORT)?).map_err(|_| SHORT)?;
            if parts.checked_mul(4).is_none_or(|bytes| bytes > content.bytes.len()) {
                return Err(SHORT);
            }
            let starts: Option<Vec<usize>> =
                (0..parts).map(|_| usize::try_from(content.little()?).ok()).collect();
            let mut starts = starts.ok_or(PARTS)?;
            if n.checked_mul(16).is_none_or(|bytes| bytes > content.bytes.len()) {
                return Err(SHORT);
            }
            let all = points(content, n, has_heights).ok_or(SHORT)?.ok_or(FINITE)?;
            starts.push(n);
            let ranges = starts.windows(2).map(|w| all.get(*w.first()?..*w.last()?).map(<[Point3]>::to_vec));
            let parts: Vec<Vec<Point3>> = ranges.collect::<Option<_>>().ok_or(PARTS)?;
            match kind {
                5 | 15 | 25 => found.polygons.push(parts),
                _ => found.lines.extend(parts),
            }
        }
        31 => return Err("patches in space are not read"),
        _ => return Err("the format has no such type"),
    }
    Ok(())
}

/// So many points, with the heights that stand behind them; `None` inside when one is not finite.
fn points(content: &mut Cursor<'_>, n: usize, has_heights: bool) -> Option<Option<Vec<Point3>>> {
    let mut all = Vec::with_capacity(n);
    for _ in 0..n {
        all.push(Point3::new(content.number()?, content.number()?, 0.0));
    }
    if has_heights {
        content.skip(16)?;
        for point in &mut all {
            point.z = content.number()?;
        }
    }
    Some(all.iter().all(|p| p.is_finite()).then_some(all))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file of records, written by hand after the white paper.
    fn file(records: &[Vec<u8>]) -> Vec<u8> {
        let mut bytes = vec![0; HEADER];
        bytes[..4].copy_from_slice(&FILE_CODE.to_be_bytes());
        for (k, content) in records.iter().enumerate() {
            bytes.extend((k as i32 + 1).to_be_bytes());
            bytes.extend((content.len() as i32 / 2).to_be_bytes());
            bytes.extend(content);
        }
        bytes
    }

    fn content(kind: i32, counts: &[i32], numbers: &[f64]) -> Vec<u8> {
        let mut bytes = kind.to_le_bytes().to_vec();
        if !counts.is_empty() {
            bytes.extend([0; 32]);
        }
        bytes.extend(counts.iter().flat_map(|n| n.to_le_bytes()));
        bytes.extend(numbers.iter().flat_map(|x| x.to_le_bytes()));
        bytes
    }

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    #[test]
    fn points_lines_and_polygons() {
        let read = read(&file(&[
            content(1, &[], &[1.0, 2.0]),
            content(11, &[], &[1.0, 2.0, 3.0, 0.0]),
            content(0, &[], &[]),
            content(8, &[2], &[0.0, 1.0, 2.0, 3.0]),
            content(18, &[1], &[5.0, 6.0, 7.0, 7.0, 7.0]),
            // Two parts, of two and three points.
            content(3, &[2, 5, 0, 2], &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 1.0]),
            content(15, &[1, 3, 0], &[0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 9.0, 9.0, 9.0, 9.0, 9.0]),
        ]))
        .unwrap();
        let points =
            [p(1.0, 2.0, 0.0), p(1.0, 2.0, 3.0), p(0.0, 1.0, 0.0), p(2.0, 3.0, 0.0), p(5.0, 6.0, 7.0)];
        assert_eq!(read.points, points);
        assert_eq!(read.lines.iter().map(Vec::len).collect::<Vec<_>>(), [2, 3]);
        assert_eq!(read.lines[1][2], p(2.0, 1.0, 0.0));
        assert_eq!(read.polygons, [[[p(0.0, 0.0, 9.0), p(1.0, 0.0, 9.0), p(0.0, 0.0, 9.0)]]]);
        assert!(read.left_out.is_empty());
    }

    #[test]
    fn what_is_broken_is_left_out() {
        let good = content(1, &[], &[1.0, 2.0]);
        let why = |record: Vec<u8>| {
            let read = read(&file(&[record, good.clone()])).unwrap();
            assert_eq!(read.points, [p(1.0, 2.0, 0.0)]);
            read.left_out.iter().map(ToString::to_string).collect::<String>()
        };
        assert_eq!(why(content(1, &[], &[f64::NAN, 2.0])), "1 × point: a coordinate is not finite");
        assert_eq!(why(content(1, &[], &[1.0])), "1 × point: its record is too short");
        // Counts that the record cannot hold.
        assert_eq!(why(content(8, &[i32::MAX], &[])), "1 × multipoint: its record is too short");
        assert_eq!(why(content(8, &[-1], &[])), "1 × multipoint: its record is too short");
        assert_eq!(why(content(3, &[i32::MAX, 1], &[])), "1 × polyline: its record is too short");
        assert_eq!(why(content(5, &[1, i32::MAX, 0], &[])), "1 × polygon: its record is too short");
        let backwards = content(3, &[2, 2, 2, 0], &[0.0, 0.0, 1.0, 0.0]);
        assert_eq!(why(backwards), "1 × polyline: its parts do not follow each other");
        assert_eq!(why(content(31, &[0, 0], &[])), "1 × multipatch: patches in space are not read");
        assert_eq!(why(content(77, &[], &[])), "1 × shape of type 77: the format has no such type");
        let mut cut = file(&[good.clone(), good.clone()]);
        cut.truncate(cut.len() - 4);
        let read_cut = read(&cut).unwrap();
        assert_eq!((read_cut.points.len(), read_cut.left_out.len()), (1, 1));
        assert!(read(b"").is_err() && read(&[0; 200]).is_err() && read(&FILE_CODE.to_be_bytes()).is_err());
    }
}
