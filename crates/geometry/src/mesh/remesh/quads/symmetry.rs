use super::QuadOptions;
use crate::{Error, Mesh, Plane, Result, Vector3, Xform};

impl Mesh {
    /// As [`Mesh::quad_remeshed`], symmetric about planes across the axes x, y and z through the middle of the mesh's
    /// box: the part on the side of growing coordinates is made of quads, and mirrored.
    ///
    /// # Errors
    /// As [`Mesh::quad_remeshed`].
    pub fn quad_remeshed_symmetric(
        &self,
        options: &QuadOptions,
        axes: [bool; 3],
        tolerance: f64,
    ) -> Result<Self> {
        let empty = Error::degenerate("mesh to remesh", "it has no faces with an area");
        let middle = self.bounding_box().map(|b| b.center()).ok_or(empty)?;
        let directions = [Vector3::X, Vector3::Y, Vector3::Z];
        let wanted = axes.iter().zip(directions).filter(|(wanted, _)| **wanted).map(|(_, d)| d);
        let mirrors = wanted.map(|d| Plane::from_normal(middle, d)).collect::<Result<Vec<_>>>()?;
        let mut part = self.clone();
        for mirror in &mirrors {
            let [above, _] = part.split_by_plane(mirror, tolerance)?;
            // A part on one side only has no mirror image of its own to meet.
            if !above.faces().is_empty() {
                part = above;
            }
        }
        let share = part.area() / self.area().max(f64::MIN_POSITIVE);
        let count = ((options.count as f64 * share).round() as usize).max(1);
        let mut made = part.quad_remeshed(&QuadOptions { count, ..options.clone() })?;
        for mirror in &mirrors {
            let image = made.transformed(&Xform::mirror(mirror))?;
            made = Self::join(&[made, image])?;
        }
        let (aligned, _) = made.with_aligned_vertices(tolerance)?;
        Ok(if mirrors.is_empty() { made } else { aligned.welded(std::f64::consts::PI) })
    }
}
