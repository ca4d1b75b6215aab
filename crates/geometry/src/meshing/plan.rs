//! What a mesh will take, known before it is made.

use super::brep::{FacePlan, Job};
use super::result::BrepMesh;
use super::settings::MeshSettings;
use crate::Result;
use crate::brep::Brep;

/// So many places of a trim tell what part of its face it encloses.
const SAMPLES: u32 = 16;

/// A Brep whose faces are divided into cells, before they are meshed.
pub struct MeshPlan<'a> {
    job: Job<'a>,
    faces: Vec<FacePlan<'a>>,
}

impl std::fmt::Debug for MeshPlan<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "MeshPlan({} faces, {} cells)", self.faces.len(), self.cells())
    }
}

impl Brep {
    /// The first step of [`Brep::mesh_unless`]: the faces divided into cells as the settings ask. It takes a small part of
    /// the time, and tells about how large the mesh will be.
    ///
    /// # Errors
    /// As [`Brep::mesh_unless`].
    pub fn mesh_plan<'a>(
        &'a self,
        settings: &MeshSettings,
        stop: &'a (dyn Fn() -> bool + Sync),
    ) -> Result<MeshPlan<'a>> {
        settings.check()?;
        let size = self.bounds_of_faces().map_or(0.0, |b| b.diagonal().length());
        let limits = settings.limits(size);
        let job = Job { brep: self, limits, jagged: settings.jagged_seams, stop };
        let faces = job.plans()?;
        Ok(MeshPlan { job, faces })
    }
}

impl MeshPlan<'_> {
    /// About how many polygons the mesh will have: the cells of all faces, each face's in the proportion of its rectangle
    /// of parameters that its trims enclose. Triangles between cells and trims are not counted.
    pub fn cells(&self) -> usize {
        self.faces.iter().map(|face| self.cells_of(face)).sum::<f64>().ceil() as usize
    }

    fn cells_of(&self, face: &FacePlan<'_>) -> f64 {
        let sides = face.grid.lines.each_ref().map(|lines| match lines.as_slice() {
            [first, .., last] => last - first,
            _ => 0.0,
        });
        let share = (self.enclosed(face) / (sides[0] * sides[1])).clamp(0.0, 1.0);
        face.grid.cell_count() as f64 * if share.is_finite() { share } else { 1.0 }
    }

    /// The area in parameters that the trims of a face enclose.
    fn enclosed(&self, face: &FacePlan<'_>) -> f64 {
        let brep = self.job.brep;
        let mut area = 0.0;
        for plan in &face.trims {
            let (Some(trim), Some(curve)) = (brep.trims().get(plan.trim), brep.trim_curve(plan.trim)) else {
                continue;
            };
            let at = |k: u32| {
                let x = f64::from(k) / f64::from(SAMPLES);
                curve.point_at(trim.part.range.at(if trim.part.reversed { 1.0 - x } else { x }))
            };
            area += (0..SAMPLES)
                .map(|k| {
                    let (p, q) = (at(k), at(k + 1));
                    0.5 * (p.x * q.y - q.x * p.y)
                })
                .sum::<f64>();
        }
        area.abs()
    }

    /// The mesh.
    ///
    /// # Errors
    /// As [`Brep::mesh_unless`].
    pub fn mesh(&self) -> Result<BrepMesh> {
        self.job.run(&self.faces)
    }
}

#[cfg(test)]
mod tests {
    use crate::{Brep, MeshSettings, Plane, Sphere, Torus};

    fn counts(brep: &Brep, settings: &MeshSettings) -> [usize; 2] {
        let plan = brep.mesh_plan(settings, &|| false).unwrap();
        let made: usize = plan.mesh().unwrap().faces().iter().map(|face| face.faces.len()).sum();
        [plan.cells(), made]
    }

    #[test]
    fn a_mesh_is_about_as_large_as_was_said() {
        let ball = Brep::from_surface(Sphere { plane: Plane::XY, radius: 3.0 }.into()).unwrap();
        let ring = Brep::from_surface(Torus::new(Plane::XY, 5.0, 1.0).unwrap().into()).unwrap();
        for brep in [ball, ring] {
            for finest in [0.01, 0.001, 0.0001] {
                let [said, made] = counts(&brep, &MeshSettings::within(finest));
                assert!(said <= made + 8 && made <= 3 * said + 64, "{said} for {made} at {finest}");
            }
        }
    }
}
