use serde::{Deserialize, Serialize};

/// The steps by which a result comes about.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct ExplanationView {
    /// `de-casteljau`, `de-boor`, `knot-insertion`, `newton`, `gram-schmidt`, `matrix-product`.
    pub algorithm: String,
    /// What it begins with.
    pub given: Vec<QuantityView>,
    /// What it does, in turn; the steps of a round do not need one another.
    pub rounds: Vec<Vec<StepView>>,
    /// What comes out.
    pub result: Vec<QuantityView>,
}

/// What has a name and numbers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct QuantityView {
    /// Its name.
    pub name: String,
    /// One number, or coordinates.
    pub numbers: Vec<NumberView>,
}

/// A number, and its fraction where it has one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct NumberView {
    /// The double.
    pub value: f64,
    /// `8/15`.
    pub exact: Option<String>,
}

/// One step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct StepView {
    /// What it gives.
    pub made: QuantityView,
    /// The rule in symbols; empty where `terms` say it.
    pub rule: String,
    /// What is added up.
    pub terms: Vec<TermView>,
}

/// A factor and what it multiplies.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct TermView {
    /// The factor.
    pub factor: NumberView,
    /// The name of the quantity.
    pub name: String,
}

/// A curve as control points and knots.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct NurbsView {
    /// The degree.
    pub degree: u32,
    /// The control points.
    pub points: Vec<[f64; 3]>,
    /// Their weights.
    pub weights: Vec<f64>,
    /// The knots as openNURBS counts them: control points + degree − 1.
    pub knots: Vec<f64>,
    /// Where the parameter begins and ends.
    pub domain: [f64; 2],
}
