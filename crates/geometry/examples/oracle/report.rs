//! Counting agreements and errors.

use std::io::Write;

use katydid_geometry::{Point3, Vector3};

/// Evaluation: the part of the magnitude that may differ.
pub(crate) const EVALUATION: f64 = 1e-13;
/// Constructions: knots and control points.
pub(crate) const CONSTRUCTION: f64 = 1e-14;

/// So many disagreements of a case are shown.
const SHOWN: usize = 6;

/// The comparisons of one case.
#[derive(Default)]
pub(crate) struct Case {
    misses: Vec<String>,
    largest: f64,
    largest_field: String,
    compared: usize,
    by_source: usize,
}

impl Case {
    /// The reference is less exact than what it was made from, which decided instead.
    pub(crate) fn decided_by_source(&mut self) {
        self.by_source += 1;
    }

    /// A number against the reference, where `scale` is the magnitude that errors are measured by.
    pub(crate) fn number(&mut self, field: &str, got: f64, want: f64, scale: f64, tolerance: f64) {
        self.compared += 1;
        let scale = scale.max(f64::MIN_POSITIVE);
        let error = if got == want { 0.0 } else { (got - want).abs() / scale };
        if error > self.largest || error.is_nan() {
            self.largest = error;
            self.largest_field = field.to_owned();
        }
        if error > tolerance || error.is_nan() {
            self.misses.push(format!("{field}: {got} instead of {want} (error {error:.1e} of {scale:.3})"));
        }
    }

    /// Vectors of numbers of equal length, each within `tolerance` of a common scale.
    pub(crate) fn numbers(&mut self, field: &str, got: &[f64], want: &[f64], scale: f64, tolerance: f64) {
        if got.len() != want.len() {
            return self.miss(field, format!("{} numbers instead of {}", got.len(), want.len()));
        }
        for (i, (a, b)) in got.iter().zip(want).enumerate() {
            self.number(&format!("{field}[{i}]"), *a, *b, scale, tolerance);
        }
    }

    /// A point: the scale is its distance from the origin, at least 1, unless `scale` is larger.
    pub(crate) fn point(&mut self, field: &str, got: Point3, want: Point3, scale: f64, tolerance: f64) {
        self.vector(field, got.to_vector(), want.to_vector(), scale, tolerance);
    }

    /// A vector, as [`Case::point`].
    pub(crate) fn vector(&mut self, field: &str, got: Vector3, want: Vector3, scale: f64, tolerance: f64) {
        let scale = scale.max(1.0).max(want.length());
        self.number(field, (got - want).length(), 0.0, scale, tolerance);
        if !got.is_finite() {
            self.miss(field, "not finite".into());
        }
    }

    /// Anything that must be equal.
    pub(crate) fn equal<T: PartialEq + std::fmt::Debug>(&mut self, field: &str, got: T, want: T) {
        self.compared += 1;
        if got != want {
            self.misses.push(format!("{field}: {got:?} instead of {want:?}"));
        }
    }

    /// A disagreement in words.
    pub(crate) fn miss(&mut self, field: &str, why: String) {
        self.compared += 1;
        self.misses.push(format!("{field}: {why}"));
    }

    /// A result that the kernel refused is a disagreement.
    pub(crate) fn made<T, E: std::fmt::Display>(&mut self, field: &str, result: Result<T, E>) -> Option<T> {
        result.map_err(|e| self.miss(field, e.to_string())).ok()
    }
}

/// All cases of one kind.
#[derive(Default)]
pub(crate) struct Kind {
    cases: usize,
    agreed: usize,
    compared: usize,
    by_source: usize,
    largest: f64,
    where_largest: String,
    disagreements: Vec<(String, Vec<String>)>,
}

impl Kind {
    /// Runs the comparison of one case.
    pub(crate) fn run(&mut self, id: String, compare: impl FnOnce(&mut Case) -> Result<(), String>) {
        let mut case = Case::default();
        if let Err(why) = compare(&mut case) {
            case.miss("file", why);
        }
        if case.compared == 0 {
            case.miss("case", "nothing in it could be compared".into());
        }
        self.cases += 1;
        self.compared += case.compared;
        self.by_source += case.by_source;
        if case.largest > self.largest || case.largest.is_nan() {
            self.largest = case.largest;
            self.where_largest = format!("{id} {}", case.largest_field);
        }
        if case.misses.is_empty() {
            self.agreed += 1;
        } else {
            self.disagreements.push((id, case.misses));
        }
    }

    /// Writes the line of this kind and its disagreements; whether there are none.
    ///
    /// # Errors
    /// Nobody reads the output any more.
    pub(crate) fn write(&self, name: &str, out: &mut impl Write) -> std::io::Result<bool> {
        writeln!(
            out,
            "{name:>16}: {:4} cases, {:4} agreed, {:6} comparisons, largest error {:.1e} {}",
            self.cases, self.agreed, self.compared, self.largest, self.where_largest
        )?;
        if self.by_source > 0 {
            writeln!(
                out,
                "{:>18}in {} constructions the reference is less exact than ours",
                "", self.by_source
            )?;
        }
        for (id, misses) in &self.disagreements {
            for miss in misses.iter().take(SHOWN) {
                writeln!(out, "{:>18}{id}: {miss}", "")?;
            }
            if let Some(more) = misses.len().checked_sub(SHOWN).filter(|&more| more > 0) {
                writeln!(out, "{:>18}{id}: {more} more", "")?;
            }
        }
        Ok(self.disagreements.is_empty())
    }
}
