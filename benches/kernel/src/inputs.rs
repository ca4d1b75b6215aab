//! The inputs, in the text form that `README.md` beside them describes.

use std::collections::HashMap;
use std::error::Error;
use std::path::PathBuf;

use katydid_geometry::{NurbsCurve, NurbsSurface, Point3};

/// A curve as it stands in the file: textbook knots, points in space with weights.
#[derive(Debug, Clone)]
pub struct CurveRecord {
    /// The degree.
    pub degree: usize,
    /// Whether weights matter.
    pub rational: bool,
    /// Control points + degree + 1 knots.
    pub knots: Vec<f64>,
    /// x, y, z, w of each control point; x, y, z are not multiplied by w.
    pub points: Vec<[f64; 4]>,
}

/// A surface as it stands in the file.
#[derive(Debug, Clone)]
pub struct SurfaceRecord {
    /// The degrees in u and v.
    pub degrees: [usize; 2],
    /// The numbers of control points in u and v.
    pub counts: [usize; 2],
    /// Whether weights matter.
    pub rational: bool,
    /// Textbook knots in u and v.
    pub knots: [Vec<f64>; 2],
    /// x, y, z, w of each control point, v fastest.
    pub points: Vec<[f64; 4]>,
}

/// All records by name.
#[derive(Debug, Default)]
pub struct Inputs {
    /// Curves.
    pub curves: HashMap<String, CurveRecord>,
    /// Surfaces.
    pub surfaces: HashMap<String, SurfaceRecord>,
    /// Sets of points.
    pub points: HashMap<String, Vec<Point3>>,
    /// Rows of parameters.
    pub parameters: HashMap<String, Vec<Vec<f64>>>,
}

/// The folder of the inputs: `../shared/data/kernel-bench` beside the repository.
pub fn folder() -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "..", "..", "..", "shared", "data", "kernel-bench"].iter().collect()
}

impl Inputs {
    /// Reads the file.
    ///
    /// # Errors
    /// The file is absent, or is not of the form that its README describes.
    pub fn read() -> Result<Self, Box<dyn Error>> {
        let path = folder().join("inputs.txt");
        let text = std::fs::read_to_string(&path).map_err(|e| {
            format!("{}: {e}; the benchmark inputs belong beside the repository, in shared/", path.display())
        })?;
        let mut words = text.split_whitespace();
        let mut inputs = Self::default();
        while let Some(kind) = words.next() {
            let name = words.next().ok_or("a record has no name")?.to_owned();
            let mut count = || -> Result<usize, Box<dyn Error>> {
                Ok(words.next().ok_or_else(|| format!("{name} ends early"))?.parse()?)
            };
            match kind {
                "curve" => {
                    let (degree, n, rational) = (count()?, count()?, count()? == 1);
                    let knots = numbers(&mut words, n + degree + 1)?;
                    let points = rows(&numbers(&mut words, 4 * n)?);
                    inputs.curves.insert(name, CurveRecord { degree, rational, knots, points });
                }
                "surf" => {
                    let (degrees, counts) = ([count()?, count()?], [count()?, count()?]);
                    let rational = count()? == 1;
                    let u = numbers(&mut words, counts[0] + degrees[0] + 1)?;
                    let v = numbers(&mut words, counts[1] + degrees[1] + 1)?;
                    let points = rows(&numbers(&mut words, 4 * counts[0] * counts[1])?);
                    let record = SurfaceRecord { degrees, counts, rational, knots: [u, v], points };
                    inputs.surfaces.insert(name, record);
                }
                "pts" => {
                    let n = count()?;
                    let points = rows(&numbers(&mut words, 3 * n)?).into_iter().map(Point3::from).collect();
                    inputs.points.insert(name, points);
                }
                "prm" => {
                    let (n, k) = (count()?, count()?);
                    let all = numbers(&mut words, n * k)?;
                    inputs.parameters.insert(name, all.chunks(k.max(1)).map(<[f64]>::to_vec).collect());
                }
                _ => return Err(format!("there is no kind of record {kind}").into()),
            }
        }
        Ok(inputs)
    }

    /// The curve of a name.
    ///
    /// # Errors
    /// There is none.
    pub fn curve(&self, name: &str) -> Result<&CurveRecord, Box<dyn Error>> {
        self.curves.get(name).ok_or_else(|| format!("the inputs have no curve {name}").into())
    }

    /// The surface of a name.
    ///
    /// # Errors
    /// There is none.
    pub fn surface(&self, name: &str) -> Result<&SurfaceRecord, Box<dyn Error>> {
        self.surfaces.get(name).ok_or_else(|| format!("the inputs have no surface {name}").into())
    }

    /// The points of a name.
    ///
    /// # Errors
    /// There are none.
    pub fn points(&self, name: &str) -> Result<&[Point3], Box<dyn Error>> {
        Ok(self.points.get(name).ok_or_else(|| format!("the inputs have no points {name}"))?)
    }

    /// The parameters on curves, in no order.
    ///
    /// # Errors
    /// There are none.
    pub fn t(&self) -> Result<Vec<f64>, Box<dyn Error>> {
        let rows = self.parameters.get("t").ok_or("the inputs have no parameters t")?;
        Ok(rows.iter().filter_map(|r| r.first().copied()).collect())
    }

    /// The parameters on surfaces, in no order.
    ///
    /// # Errors
    /// There are none.
    pub fn uv(&self) -> Result<Vec<[f64; 2]>, Box<dyn Error>> {
        let rows = self.parameters.get("uv").ok_or("the inputs have no parameters uv")?;
        Ok(rows.iter().filter_map(|r| r.first_chunk().copied()).collect())
    }
}

impl CurveRecord {
    /// The curve in this kernel.
    ///
    /// # Errors
    /// The record is no valid curve.
    pub fn katydid(&self) -> katydid_geometry::Result<NurbsCurve> {
        let knots = inner(&self.knots);
        let points: Vec<_> = self.points.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect();
        if !self.rational {
            return NurbsCurve::new(self.degree, points, knots);
        }
        let weights: Vec<_> = self.points.iter().map(|p| p[3]).collect();
        NurbsCurve::with_weights(self.degree, &points, &weights, knots)
    }
}

impl SurfaceRecord {
    /// The surface in this kernel.
    ///
    /// # Errors
    /// The record is no valid surface.
    pub fn katydid(&self) -> katydid_geometry::Result<NurbsSurface> {
        let knots = [inner(&self.knots[0]), inner(&self.knots[1])];
        let points: Vec<_> = self.points.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect();
        if !self.rational {
            return NurbsSurface::new(self.degrees, self.counts, points, knots);
        }
        let weights: Vec<_> = self.points.iter().map(|p| p[3]).collect();
        NurbsSurface::with_weights(self.degrees, self.counts, &points, &weights, knots)
    }
}

/// Textbook knots without the first and the last.
pub(crate) fn inner(knots: &[f64]) -> Vec<f64> {
    knots.get(1..knots.len().saturating_sub(1)).unwrap_or(&[]).to_vec()
}

fn numbers<'a>(words: &mut impl Iterator<Item = &'a str>, n: usize) -> Result<Vec<f64>, Box<dyn Error>> {
    let all: Vec<f64> = words.take(n).map(str::parse).collect::<Result<_, _>>()?;
    if all.len() == n { Ok(all) } else { Err("the inputs end early".into()) }
}

fn rows<const N: usize>(numbers: &[f64]) -> Vec<[f64; N]> {
    numbers.as_chunks().0.to_vec()
}
