//! Enumerations of RhinoCommon that functions take.

use katydid_geometry::brep::{FilletBlend, FilletRail};
use katydid_geometry::construct::{LoftStyle, Miter, PipeCap};
use katydid_geometry::{Direction, ExtensionStyle, OffsetCorner};
use serde_json::Value as Json;

use super::argument::choice;
use crate::wire::Read;
use crate::{Fault, Value};

/// Declares a type that is read from the number or the name of a choice.
macro_rules! choices {
    ($($(#[$doc:meta])* $name:ident($inner:ty) = $class:literal, $what:literal [$($text:literal => $value:expr),* $(,)?];)*) => {
        $($(#[$doc])*
        #[derive(Clone, Copy)]
        pub(super) struct $name(pub(super) $inner);

        impl Read for $name {
            fn read(json: &Json) -> Result<Self, Fault> {
                choice(json, $what, &[$(($text, $value)),*]).map(Self)
            }

            /// A script's number with a fraction is no choice: `Trim(2.0, 5.0)` means two parameters.
            fn of_value(value: &Value) -> Result<Self, Fault> {
                match value {
                    Value::Number(_) => Err(Fault::bad_request(concat!("is no ", $what))),
                    other => Self::read(&other.to_json(0)?),
                }
            }

            fn type_name() -> String {
                $class.into()
            }
        })*
    };
}

choices! {
    /// `LoftType`.
    Loft(LoftStyle) = "LoftType", "loft type" [
        "Normal" => LoftStyle::Normal,
        "Loose" => LoftStyle::Loose,
        "Tight" => LoftStyle::Tight,
        "Straight" => LoftStyle::Straight,
        "Developable" => LoftStyle::Developable,
        "Uniform" => LoftStyle::Uniform,
    ];
    /// `PipeCapMode`.
    Cap(PipeCap) = "PipeCapMode", "pipe cap" ["None" => PipeCap::None, "Flat" => PipeCap::Flat, "Round" => PipeCap::Round];
    /// `CurveOffsetCornerStyle`.
    Corner(OffsetCorner) = "CurveOffsetCornerStyle", "corner style" [
        "None" => OffsetCorner::None,
        "Sharp" => OffsetCorner::Sharp,
        "Round" => OffsetCorner::Round,
        "Smooth" => OffsetCorner::Smooth,
        "Chamfer" => OffsetCorner::Chamfer,
    ];
    /// `CurveEnd`: whether the start and the end are meant.
    End([bool; 2]) = "CurveEnd", "curve end" [
        "None" => [false, false],
        "Start" => [true, false],
        "End" => [false, true],
        "Both" => [true, true],
    ];
    /// `CurveExtensionStyle`.
    Extension(ExtensionStyle) = "CurveExtensionStyle", "extension style" [
        "Line" => ExtensionStyle::Line,
        "Arc" => ExtensionStyle::Arc,
        "Smooth" => ExtensionStyle::Smooth,
    ];
    /// `BlendContinuity`: the derivatives that agree.
    Blend(u8) = "BlendContinuity", "blend continuity" ["Position" => 0, "Tangency" => 1, "Curvature" => 2];
    /// `BlendType`: what takes the place of an edge.
    Rounding(FilletBlend) = "BlendType", "blend type" [
        "Chamfer" => FilletBlend::Chamfer,
        "Fillet" => FilletBlend::Arc,
        "Blend" => FilletBlend::Smooth,
    ];
    /// `RailType`: what the radius of a rounded edge measures.
    Rail(FilletRail) = "RailType", "rail type" [
        "DistanceFromEdge" => FilletRail::DistanceFromEdge,
        "RollingBall" => FilletRail::RollingBall,
        "DistanceBetweenRails" => FilletRail::DistanceBetweenRails,
    ];
    /// `NurbsCurveEndConditionType`: the derivatives that are set; nothing at all.
    EndCondition(Option<u8>) = "NurbsCurveEndConditionType", "end condition" [
        "Nothing" => None,
        "Position" => Some(0),
        "Tangency" => Some(1),
        "Curvature" => Some(2),
    ];
    /// `SweepMiter`.
    SweepMiter(Miter) = "SweepMiter", "sweep miter" ["None" => Miter::None, "Trimmed" => Miter::Trim, "Untrimmed" => Miter::Rotate];
    /// `SweepFrame`: whether sections stand upright.
    Roadlike(bool) = "SweepFrame", "sweep frame" ["Freeform" => false, "Roadlike" => true];
    /// A direction of a surface's parameters.
    Along(Direction) = "Int32", "direction" ["U" => Direction::U, "V" => Direction::V];
}
