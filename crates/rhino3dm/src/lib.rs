//! .3dm archives, read and written in safe Rust.
//!
//! A [`Model`] is what an archive holds: units, tolerances, notes, objects with their attributes, and the tables
//! they refer to: layers, materials, linetypes, groups, hatch patterns, block definitions. What is not taken apart
//! (styles, views, history, embedded files) is kept and written back, in other versions too where that can be done;
//! [`Model::losses`] names beforehand what a version cannot carry.
//! Points, point clouds, curves, surfaces, Breps, meshes and SubD nets come as types of [`katydid_geometry`], with
//! what the format says beyond them beside them; hatches, annotations, blocks, lights and the like as plain data. A
//! class that is not known is kept byte for byte as a [`RawObject`] and written back as it was where the archive
//! version allows. Archives of version 1 to 80 are read, 4 to 80 written. [`Object::from_on_data`] reads the single
//! objects that Grasshopper files and rhino3dm's JSON carry.
//!
//! What belongs here: the layout of the format, and nothing that computes geometry. Every length is checked
//! before anything is allocated, nesting and inflation are bounded by [`Limits`], and broken bytes give an
//! [`Error`] or a [`Warning`] with their offset, never a panic.
//!
//! ```
//! use katydid_3dm::{Limits, Model, Object};
//! use katydid_geometry::{Line, Point3};
//!
//! let line = Line::new(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0));
//! let mut model = Model::default();
//! model.objects.push(Object::Curve(line.into()).into());
//! let bytes = model.write(70)?;
//! let back = Model::read(&bytes, &Limits::default())?;
//! assert_eq!(back.counts()["LineCurve"], 1);
//! # Ok::<(), katydid_3dm::Error>(())
//! ```

mod attributes;
mod build;
mod choices;
mod chunk;
mod chunk_path;
mod class_ids;
mod class_object;
mod colour;
mod compressed;
mod crc;
mod earth;
mod error;
mod ids;
mod items;
mod limits;
mod loss;
mod model;
mod object;
mod outline;
mod overlay;
mod places;
mod planar;
mod primitives;
mod properties;
mod read;
mod recode;
mod render_settings;
mod settings;
mod styles;
mod tables;
mod typecode;
mod unit_scale;
mod user_table;
mod v1;
mod validity;
mod values;
mod version;
mod views;
mod write;

pub use attributes::{Attributes, StringsHistory};
pub use choices::{ActiveSpace, Arrowheads, Clipping, LinetypeChoice, ObjectMode, Source};
pub use chunk_path::ChunkPath;
pub use class_object::UserData;
pub use compressed::StoredBuffer;
pub use error::{Error, Result, Warning, WarningKind};
pub use limits::Limits;
pub use loss::Loss;
pub use model::{Model, ModelObject};
pub use object::{
    Annotation, Annotation2, Annotation2Kind, Annotation5, Annotation5Kind, AnnotationKind, BareSurface,
    BlockReference, BrepEdge, BrepObject, BrepSummary, CachedMesh, ClippingPlane, CurvatureStatistics,
    CurveForm, CurveOnSurface, DetailView, Dimension, Extrusion, ExtrusionMesh, Hatch, HatchLoop, Light,
    LightStyle, Localizer, MappingTag, MeshObject, MeshParameters, MorphControl, MorphShape, Ngon, NurbsCage,
    NurbsForm, NurbsSurfaceForm, Object, OnData, PackRectangle, Participants, PointCloud, RawObject,
    Solidity, StoredEdge, StoredFace, StoredPart, StoredVertex, StyleOverrides, SubDLevel, SubDMeshing,
    SubDObject, SubDPacking, SubDReference, SurfaceForm, TextContent, TextDot,
};
pub use outline::{Outline, OutlineChunk, OutlineContent, OutlineCrc, outline};
pub use overlay::{
    DimensionStyle, EarthAnchor, EmbeddedFile, EmbeddedForm, HistoryRecord, HistoryValue, HistoryValues,
    MappingKind, ObjectReference, PageSettings, TextStyle, TextureMapping,
};
pub use planar::StoredPlane;
pub use properties::{NotesWindow, Preview, Properties, Revision, Time};
pub use render_settings::RenderSettings;
pub use settings::Settings;
pub use tables::{
    Block, BlockSource, Checksum, ContentHash, FileReference, Group, HatchFill, HatchLine, HatchPattern,
    KeptRecord, Layer, LineCap, LineJoin, Linetype, LinetypeSegment, LinkedBlock, MappingReference, Material,
    MaterialReference, Rendering, SectionStyle, Table, Texture, TextureKind,
};
pub use unit_scale::UnitScale;
pub use user_table::UserTable;
pub use validity::Validity;
pub use views::{ConstructionPlane, View, ViewProjection};
