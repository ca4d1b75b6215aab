//! Measures and cuts every brep of archives and judges what comes of it: `measure_breps PATH…`
//!
//! Areas and volumes are compared with those of a mesh within a thousandth of the size, and each solid is cut by nine
//! planes, whose loops must close. Said of every brep that is wrong in some way, or takes long; and the sums.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "an example stops at the first thing wrong")]

use std::sync::Arc;
use std::time::Instant;

use katydid_geometry::brep::BrepSections;
use katydid_geometry::{Brep, MeshSettings, Plane, Tolerance, Vector3};

use breps_of::breps_of;

mod breps_of;

#[derive(Default, Debug)]
struct Sums {
    breps: usize,
    solids: usize,
    no_area: usize,
    no_volume: usize,
    area_off: usize,
    volume_off: usize,
    sections: usize,
    loops: usize,
    open: usize,
    no_section: usize,
    seconds: f64,
}

fn main() {
    let mut sums = Sums::default();
    let paths: Vec<String> = std::env::args().skip(1).collect();
    for (name, brep) in breps_of(&paths) {
        judge(&name, &brep, &mut sums);
    }
    println!("{sums:?}");
}

fn judge(name: &str, brep: &Brep, sums: &mut Sums) {
    let Some(bounds) = brep.bounds_of_faces() else { return };
    let size = bounds.diagonal().length();
    sums.breps += 1;
    let begun = Instant::now();
    let patient = || begun.elapsed().as_secs_f64() < 30.0;
    let mesh = brep.mesh(&MeshSettings::within(1e-4 * size)).and_then(|mesh| mesh.to_mesh());
    let meshed = begun.elapsed().as_secs_f64();
    let faults = brep.faults().len();
    match (brep.area_properties(1e-9, patient), &mesh) {
        (Ok(found), Ok(mesh)) => {
            let off = (found.amount - mesh.area()).abs() / found.amount;
            if off > 2e-3 {
                sums.area_off += 1;
                println!("{name}: area {} but {} of the mesh; {faults} faults", found.amount, mesh.area());
            }
        }
        (Err(why), _) => {
            sums.no_area += 1;
            println!("{name}: no area: {why}; {faults} faults");
        }
        _ => {}
    }
    let area_took = begun.elapsed().as_secs_f64() - meshed;
    if area_took > 1.0 {
        println!("{name}: {area_took:.1} s for the area of {} faces", brep.faces().len());
    }
    sums.seconds += area_took;
    if !brep.is_solid() {
        return;
    }
    sums.solids += 1;
    match (brep.volume_properties(1e-9, patient), &mesh) {
        (Ok(found), Ok(mesh)) => {
            let off = (found.amount - mesh.volume().abs()).abs() / found.amount;
            if off > 5e-3 {
                sums.volume_off += 1;
                println!(
                    "{name}: volume {} but {} of the mesh; {faults} faults",
                    found.amount,
                    mesh.volume()
                );
            }
        }
        (Err(why), _) => {
            sums.no_volume += 1;
            println!("{name}: no volume: {why}; {faults} faults");
        }
        _ => {}
    }
    let begun = Instant::now();
    let tolerance = Tolerance { absolute: 1e-4 * size, angle: 0.0175 };
    let Ok(sections) = BrepSections::new(Arc::new(brep.clone()), &tolerance) else {
        sums.no_section += 1;
        return;
    };
    for normal in [Vector3::Z, Vector3::X, Vector3::new(1.0, 2.0, 3.0)] {
        for share in [-0.21, 0.013, 0.17] {
            let middle = Plane::from_normal(bounds.center(), normal).unwrap();
            match sections.cut(&middle.offset(share * size)) {
                Ok(found) => {
                    sums.sections += 1;
                    sums.loops += found.curves.len();
                    let open = found.curves.iter().filter(|curve| !curve.is_closed()).count();
                    sums.open += open;
                    if open > 0 {
                        println!(
                            "{name}: {open} of {} loops open, {normal:?} {share}; {faults} faults",
                            found.curves.len()
                        );
                    }
                }
                Err(why) => {
                    sums.no_section += 1;
                    println!("{name}: no section: {why}; {faults} faults");
                }
            }
            if begun.elapsed().as_secs_f64() > 20.0 {
                println!("{name}: sections of {} faces take more than 20 s", brep.faces().len());
                return;
            }
        }
    }
}
