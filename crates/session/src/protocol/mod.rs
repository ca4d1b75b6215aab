//! What a client, such as the studio's page, and the session say to each other: plain data, in JSON.
//!
//! A client sends [`Request`]s, each with a number of its own; the session answers each with an [`Event::Done`] or
//! [`Event::Refused`] of that number, and tells all clients what has changed: the document ([`Event::Patch`]), the
//! results ([`Event::Results`]) and the geometry ([`Event::Preview`]). Objects and ports go by the ids that the file
//! has for them. Edits say what shall be, not what is to be done with what is there: an edit that arrives twice does
//! no more than one that arrives once.
//!
//! The types of the TypeScript client are made from these: `cargo test -p katydid-session --features typescript`.

#![allow(missing_docs, reason = "the fields of a variant are told of in its own line")]

mod analysis;
mod control;
mod edit;
mod event;
mod explain;
mod geometry;
mod model;
mod preview;
mod request;
mod study;
mod view;

pub use analysis::{
    AnalysisView, BendView, CircleView, CombMeasure, CombView, IsocurvesView, Probe, ProbePlace, Probed,
};
pub use control::{
    Control, GraphView, GripView, HeldPoint, ListItemView, ListModeView, RoundingView, Setting,
};
pub use edit::{
    AccessView, Alignment, Connection, Edit, GroupChange, Initial, ObjectChange, PanelChange, PortChange,
};
pub use event::{
    DocumentState, Event, MessageView, ModelLackView, Notice, OutputView, Page, PictureView, Problem,
    Restored, ResultView, Row, ScriptView, Structure,
};
pub use explain::{ExplanationView, NumberView, NurbsView, QuantityView, StepView, TermView};
pub use geometry::{Drawing, GeometrySource, PlaneView};
pub use model::{ModelLayerView, ModelObjectView, ModelView};
pub use preview::{PREVIEW_MAGIC, PREVIEW_VERSION, Part, PartKind, Piece, PreviewHeader, Slice, SliceType};
pub use request::{Ask, Request, SaveFormat};
pub use study::{
    ArrowView, DerivativeView, EffectsView, EndView, HereView, InputPlace, ItemPlace, MotionView, RangedView,
    ShareView, SlopeView, Solved, SolvedInput, Target, Want,
};
pub use view::{
    BorderView, Colour, DocumentView, MappingView, ObjectKindView, ObjectView, PlayerInput, PortView,
    ScriptPermission, ScriptsView, Support, WireView,
};
