//! What the objects that hold values or settings of their own say: sliders, panels, lists, graphs.

mod annotation;
mod automation;
mod colours;
mod contextual;
mod dials;
mod graph_mapper;
mod image_sampler;
mod moments;
mod panel;
mod slider;
mod toggles;
mod trees;
mod value_list;

pub use annotation::{Border, Group, Mark, Scribble, Sketch};
pub use automation::{DataDam, Galapagos, Trigger};
pub use colours::{Gradient, Grip};
pub use contextual::Contextual;
pub use dials::{DigitScroller, GenePool, Knob, MdSlider};
pub use graph_mapper::{Graph, GraphMapper};
pub use image_sampler::{ImageSampler, Wrap};
pub use moments::{Calendar, Clock};
pub use panel::Panel;
pub use slider::{Rounding, Slider};
pub use toggles::Button;
pub use trees::{CherryPicker, DataRecorder, PathMapper};
pub use value_list::{ListMode, ValueList, ValueListItem};

use super::{Object, ids};
use crate::archive::Colour;

/// The settings of an object that has some of its own kind.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Special {
    /// Number Slider.
    Slider(Slider),
    /// Panel.
    Panel(Panel),
    /// Boolean Toggle, of either kind.
    Toggle(bool),
    /// Button.
    Button(Button),
    /// Colour Swatch or Colour Picker.
    Colour(Colour),
    /// Value List.
    ValueList(ValueList),
    /// MD Slider.
    MdSlider(MdSlider),
    /// Control Knob.
    Knob(Knob),
    /// Digit Scroller.
    DigitScroller(DigitScroller),
    /// Calendar.
    Calendar(Calendar),
    /// Clock.
    Clock(Clock),
    /// Gene Pool.
    GenePool(GenePool),
    /// Graph Mapper.
    GraphMapper(GraphMapper),
    /// Gradient.
    Gradient(Gradient),
    /// Path Mapper.
    PathMapper(PathMapper),
    /// Cherry Picker.
    CherryPicker(CherryPicker),
    /// Data Dam.
    DataDam(DataDam),
    /// Data Recorder.
    DataRecorder(DataRecorder),
    /// Image Sampler.
    ImageSampler(ImageSampler),
    /// An input that a command, Hops or a server asks for.
    Contextual(Contextual),
    /// The text of an Expression component.
    Expression(String),
    /// Trigger.
    Trigger(Trigger),
    /// Galapagos.
    Galapagos(Galapagos),
    /// Group.
    Group(Group),
    /// Scribble.
    Scribble(Scribble),
    /// Sketch.
    Sketch(Sketch),
}

impl Object {
    /// The object's own settings, when it is one of those that have some and the file holds them.
    pub fn special(&self) -> Option<Special> {
        let c = self.container();
        Some(match self.component {
            ids::NUMBER_SLIDER => Special::Slider(Slider::read(c)?),
            ids::PANEL => Special::Panel(Panel::read(c)),
            ids::BOOLEAN_TOGGLE | ids::BOOLEAN_TOGGLE_2 => Special::Toggle(toggles::read(c)?),
            ids::BUTTON => Special::Button(Button::read(c)),
            ids::COLOUR_SWATCH | ids::COLOUR_PICKER => Special::Colour(colours::read(c)?),
            ids::VALUE_LIST => Special::ValueList(ValueList::read(c)),
            ids::MD_SLIDER => Special::MdSlider(MdSlider::read(c)?),
            ids::CONTROL_KNOB => Special::Knob(Knob::read(c)?),
            ids::DIGIT_SCROLLER => Special::DigitScroller(DigitScroller::read(c)?),
            ids::CALENDAR => Special::Calendar(Calendar::read(c)?),
            ids::CLOCK => Special::Clock(Clock::read(c)?),
            ids::GENE_POOL => Special::GenePool(GenePool::read(c)?),
            ids::GRAPH_MAPPER => Special::GraphMapper(GraphMapper::read(c)?),
            ids::GRADIENT => Special::Gradient(Gradient::read(c)?),
            ids::PATH_MAPPER => Special::PathMapper(PathMapper::read(c)),
            ids::CHERRY_PICKER => Special::CherryPicker(CherryPicker::read(c)?),
            ids::DATA_DAM => Special::DataDam(DataDam::read(c)),
            ids::DATA_RECORDER => Special::DataRecorder(DataRecorder::read(c)),
            ids::IMAGE_SAMPLER => Special::ImageSampler(ImageSampler::read(c)),
            ids::EXPRESSION => Special::Expression(c.str("Expression")?.to_owned()),
            ids::TRIGGER => Special::Trigger(Trigger::read(c)),
            ids::GALAPAGOS => Special::Galapagos(Galapagos::read(c)?),
            ids::GROUP => Special::Group(Group::read(c)),
            ids::SCRIBBLE => Special::Scribble(Scribble::read(c)),
            ids::SKETCH => Special::Sketch(Sketch::read(c)),
            _ => Special::Contextual(Contextual::read(c)?),
        })
    }
}
