//! Writes what the kernel finds on the benchmark's inputs, in the form that `check.py` beside them judges:
//! `cargo run --release -p katydid-kernel-bench --bin judge OUTDIR`, then `python check.py OUTDIR`.

use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;

use katydid_geometry::{ClosestOnCurve, ClosestOnSurface, Curve, Quadrant, Vector3, intersect};
use katydid_kernel_bench::Inputs;

/// How many parameters the judge looks at.
const EVALUATIONS: usize = 64;

fn main() -> Result<(), Box<dyn Error>> {
    let out = std::env::args_os().nth(1).ok_or("usage: judge OUTDIR")?;
    let out = Path::new(&out);
    std::fs::create_dir_all(out).map_err(|e| format!("{}: {e}", out.display()))?;
    let write = |name: String, text: String| {
        let path = out.join(name);
        std::fs::write(&path, text).map_err(|e| format!("{}: {e}", path.display()))
    };
    let inputs = Inputs::read()?;
    for name in ["c_nr", "c_r"] {
        let curve = inputs.curve(name)?.katydid()?;
        let t: Vec<f64> = inputs.t()?.into_iter().take(EVALUATIONS).collect();
        let rows = t.iter().map(|&t| curve.jet_at::<3>(t, false));
        write(format!("eval_katydid_{name}.txt"), vectors(rows))?;
        let curve = Curve::from(curve);
        let queries = inputs.points("q_curve")?;
        let ready = ClosestOnCurve::new(&curve);
        let mut text = String::new();
        for &q in queries {
            writeln!(text, "{:?}", ready.nearest(q)?.distance)?;
        }
        write(format!("cp_katydid_{name}.txt"), text)?;
    }
    for name in ["s_nr", "s_r"] {
        let surface = inputs.surface(name)?.katydid()?;
        let uv: Vec<[f64; 2]> = inputs.uv()?.into_iter().take(EVALUATIONS).collect();
        let rows = uv.iter().map(|&[u, v]| surface.partials_at(u, v, Quadrant::NorthEast));
        write(format!("eval_katydid_{name}.txt"), vectors(rows))?;
        let ready = ClosestOnSurface::of_nurbs(&surface);
        let mut text = String::new();
        for &q in inputs.points("q_surf")? {
            writeln!(text, "{:?}", ready.nearest(q)?.distance)?;
        }
        write(format!("cp_katydid_{name}.txt"), text)?;
    }
    for (case, a, b) in [("cc", "cc_a", "cc_b"), ("weave", "wv_a", "wv_b")] {
        let curve = |name| -> Result<Curve, Box<dyn Error>> { Ok(inputs.curve(name)?.katydid()?.into()) };
        let found = intersect::curve_curve(&curve(a)?, &curve(b)?, 1e-9)?;
        let mut text = String::new();
        for c in &found.crossings {
            writeln!(text, "{:?} {:?}", c.a, c.b)?;
        }
        write(format!("cci_katydid_{case}.txt"), text)?;
    }
    Ok(())
}

fn vectors(rows: impl Iterator<Item = [Vector3; 3]>) -> String {
    let row = |r: [Vector3; 3]| {
        let numbers: Vec<String> = r.iter().flat_map(|v| [v.x, v.y, v.z]).map(|x| format!("{x:?}")).collect();
        numbers.join(" ") + "\n"
    };
    rows.map(row).collect()
}
