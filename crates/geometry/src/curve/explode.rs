//! A curve taken apart.

use super::{Continuity, Curve};
use crate::{Line, Result, Tolerance};

impl Curve {
    /// The segments in order: poly-curves give their segments, straight chains single lines, and other curves are
    /// cut at their kinks. Lines and arcs stay whole. With `recursive` the parts are taken apart again; without it a
    /// poly-curve only gives its own segments.
    ///
    /// # Errors
    /// A part is too short to be a curve.
    pub fn explode(&self, recursive: bool) -> Result<Vec<Self>> {
        if let Self::Poly(c) = self {
            let mut out = Vec::new();
            for segment in c.segments() {
                if recursive {
                    out.extend(segment.explode(true)?);
                } else {
                    out.push(segment.clone());
                }
            }
            return Ok(out);
        }
        if let Self::Line(_) | Self::Arc(_) = self {
            return Ok(vec![self.clone()]);
        }
        if let Some(points) = self.as_polyline() {
            return Ok(points
                .windows(2)
                .filter(|w| w[0] != w[1])
                .map(|w| Line::new(w[0], w[1]).into())
                .collect());
        }
        let mut kinks = self.discontinuities(Continuity::G1, &Tolerance::default());
        let domain = self.domain();
        // The seam is an end already: cutting there keeps a closed curve from being joined over it.
        kinks.push(domain.start);
        self.split_at(&kinks)
    }
}
