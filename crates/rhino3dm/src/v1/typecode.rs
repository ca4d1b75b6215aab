//! The typecodes of version 1.

use crate::typecode::SHORT;

pub(super) const LAYER: u32 = 0x0040_0010;
pub(super) const LAYER_NAME: u32 = 0x0040_0011;
pub(super) const LAYER_STATE: u32 = SHORT | 0x0040_0033;
pub(super) const NAME: u32 = 0x0200_0001;
/// What a view shows, and its construction plane.
pub(super) const VIEW: u32 = 0x0200_0002;
pub(super) const PLANE: u32 = 0x0200_0003;
pub(super) const NAMED_PLANE: u32 = 0x0200_0004;
pub(super) const NAMED_VIEW: u32 = 0x0200_0005;
pub(super) const VIEWPORT: u32 = 0x0200_0006;
pub(super) const SHOWS_GRID: u32 = SHORT | 0x0200_0007;
pub(super) const SHOWS_GRID_AXES: u32 = SHORT | 0x0200_0008;
pub(super) const SHOWS_WORLD_AXES: u32 = SHORT | 0x0200_0009;
pub(super) const VIEW_POSITION: u32 = 0x0200_000A;
pub(super) const TRACE: u32 = 0x0200_000B;
pub(super) const HIDE_TRACE: u32 = 0x0200_000E;
pub(super) const MAXIMISED: u32 = SHORT | 0x0200_0011;
pub(super) const WALLPAPER: u32 = 0x0200_0012;
pub(super) const DISPLAY_MODE: u32 = SHORT | 0x0200_0015;
pub(super) const NOTES: u32 = 0x0200_000F;
pub(super) const UNITS: u32 = 0x0200_0010;
pub(super) const SUMMARY: u32 = 0x0200_0013;
pub(super) const PREVIEW: u32 = 0x0200_0014;
/// A mark of the end of the file that a program took for something unknown and wrote back.
pub(super) const ROGUE_END: u32 = 0x0000_7FFE;

pub(super) const POINT: u32 = 0x0010_0001;
pub(super) const MESH: u32 = 0x0010_0015;
pub(super) const MESH_GEOMETRY: u32 = 0x0010_0017;
pub(super) const SPOTLIGHT: u32 = 0x0080_0001;

pub(super) const TEXT_BLOCK: u32 = 0x0020_0004;
pub(super) const LEADER: u32 = 0x0020_0005;
pub(super) const LINEAR_DIMENSION: u32 = 0x0020_0006;
pub(super) const ANGULAR_DIMENSION: u32 = 0x0020_0007;
pub(super) const RADIAL_DIMENSION: u32 = 0x0020_0008;

/// Geometry of the modeller's own kernel. Each kind is a chunk with attributes in it, and then a chunk of its
/// substance.
pub(super) const SHELL: u32 = 0x0001_0003;
pub(super) const FACE: u32 = 0x0001_0004;
pub(super) const LOOP: u32 = 0x0001_0005;
pub(super) const TRIM: u32 = 0x0001_0006;
pub(super) const SURFACE: u32 = 0x0001_0007;
pub(super) const CURVE: u32 = 0x0001_0008;
pub(super) const SPLINE: u32 = 0x0001_0009;
/// The bit by which a substance differs from its kind.
pub(super) const SUBSTANCE: u32 = 0x0100;

/// Objects of the toolkit that came before openNURBS.
pub(super) const TOOLKIT_CURVE: u32 = 0x0002_0008;
pub(super) const TOOLKIT_SURFACE: u32 = 0x0002_0009;
pub(super) const TOOLKIT_BREP: u32 = 0x0002_000B;
pub(super) const TOOLKIT_DATA: u32 = 0x0002_FFFE;
pub(super) const TOOLKIT_END: u32 = 0x0002_FFFF;

pub(super) const OBJECT_UUID: u32 = 0x0002_FFFD;
pub(super) const LAYER_REFERENCE: u32 = SHORT | 0x2000_0001;
pub(super) const COLOUR: u32 = SHORT | 0x0040_0001;
pub(super) const TEXTURE: u32 = 0x0040_0002;
pub(super) const BUMP: u32 = 0x0040_0003;
pub(super) const TRANSPARENCY: u32 = SHORT | 0x0040_0004;
pub(super) const DISPLAY_COLOUR: u32 = SHORT | 0x0040_0006;
pub(super) const MATERIAL_NAME: u32 = 0x0040_0007;
pub(super) const WIRE_DENSITY: u32 = SHORT | 0x0040_0022;
pub(super) const EXTRA: u32 = 0x4000_0001;

/// Whether a chunk of version 1 can stand before the tables of version 2: summary, preview, units, viewports,
/// layers, mesh parameters, the current layer, annotation settings, notes, named planes and views.
pub(crate) fn may_precede_tables(typecode: u32) -> bool {
    const OTHERS: [u32; 3] = [0x0040_0020, SHORT | 0x0040_0025, 0x0020_0001];
    matches!(typecode, UNITS | LAYER | NOTES | SUMMARY | PREVIEW | VIEWPORT | NAMED_VIEW | NAMED_PLANE)
        || OTHERS.contains(&typecode)
}
