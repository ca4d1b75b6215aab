//! Chunk typecodes: the four bytes that say what a chunk is (sections 1, 2, 5, 6, 7).

/// Bit of a short chunk: the value is data and there is no body.
pub(crate) const SHORT: u32 = 0x8000_0000;
/// Bit of a long chunk whose body ends in a CRC-32.
pub(crate) const CRC: u32 = 0x8000;

pub(crate) const COMMENT: u32 = 0x0000_0001;
pub(crate) const END_OF_FILE: u32 = 0x0000_7FFF;
pub(crate) const END_OF_TABLE: u32 = 0xFFFF_FFFF;

pub(crate) const PROPERTIES_TABLE: u32 = 0x1000_0014;
pub(crate) const SETTINGS_TABLE: u32 = 0x1000_0015;
pub(crate) const BITMAP_TABLE: u32 = 0x1000_0016;
pub(crate) const TEXTURE_MAPPING_TABLE: u32 = 0x1000_0025;
pub(crate) const MATERIAL_TABLE: u32 = 0x1000_0010;
pub(crate) const LINETYPE_TABLE: u32 = 0x1000_0023;
pub(crate) const LAYER_TABLE: u32 = 0x1000_0011;
pub(crate) const GROUP_TABLE: u32 = 0x1000_0018;
pub(crate) const FONT_TABLE: u32 = 0x1000_0019;
pub(crate) const DIMENSION_STYLE_TABLE: u32 = 0x1000_0020;
pub(crate) const LIGHT_TABLE: u32 = 0x1000_0012;
pub(crate) const HATCH_PATTERN_TABLE: u32 = 0x1000_0022;
pub(crate) const INSTANCE_DEFINITION_TABLE: u32 = 0x1000_0021;
pub(crate) const OBJECT_TABLE: u32 = 0x1000_0013;
pub(crate) const HISTORY_TABLE: u32 = 0x1000_0026;
pub(crate) const USER_TABLE: u32 = 0x1000_0017;

pub(crate) const OPENNURBS_VERSION: u32 = 0xA000_0026;
pub(crate) const REVISION: u32 = 0x2000_8021;
pub(crate) const NOTES: u32 = 0x2000_8022;
pub(crate) const APPLICATION: u32 = 0x2000_8024;
pub(crate) const PREVIEW: u32 = 0x2000_8025;
pub(crate) const FILE_NAME: u32 = 0x2000_8027;

pub(crate) const UNITS: u32 = 0x2000_8031;
pub(crate) const RENDER_MESH: u32 = 0x2000_8032;
pub(crate) const ANALYSIS_MESH: u32 = 0x2000_8033;
pub(crate) const ANNOTATION_SETTINGS: u32 = 0x2000_8034;
pub(crate) const NAMED_PLANES: u32 = 0x2000_8035;
pub(crate) const NAMED_VIEWS: u32 = 0x2000_8036;
pub(crate) const VIEWS: u32 = 0x2000_8037;
pub(crate) const CURRENT_LAYER: u32 = 0xA000_0038;
pub(crate) const CURRENT_MATERIAL: u32 = 0x2000_8039;
pub(crate) const CURRENT_COLOUR: u32 = 0x2000_803A;
pub(crate) const CURRENT_WIRE_DENSITY: u32 = 0xA000_003C;
pub(crate) const RENDER_SETTINGS: u32 = 0x2000_803D;
pub(crate) const GRID: u32 = 0x2000_803F;
pub(crate) const CURRENT_TEXT_STYLE: u32 = 0xA000_0132;
pub(crate) const CURRENT_DIMENSION_STYLE: u32 = 0xA000_0133;
pub(crate) const SETTINGS_ATTRIBUTES: u32 = 0x2000_8134;
pub(crate) const PLUG_IN_LIST: u32 = 0x2000_8135;

pub(crate) const MATERIAL_RECORD: u32 = 0x2000_8040;
pub(crate) const GROUP_RECORD: u32 = 0x2000_8073;
pub(crate) const TEXT_STYLE_RECORD: u32 = 0x2000_8074;
pub(crate) const DIMENSION_STYLE_RECORD: u32 = 0x2000_8075;
pub(crate) const INSTANCE_DEFINITION_RECORD: u32 = 0x2000_8076;
pub(crate) const HATCH_PATTERN_RECORD: u32 = 0x2000_8077;
pub(crate) const LINETYPE_RECORD: u32 = 0x2000_8078;
pub(crate) const TEXTURE_MAPPING_RECORD: u32 = 0x2000_807A;
pub(crate) const HISTORY_RECORD: u32 = 0x2000_807B;
pub(crate) const BITMAP_RECORD: u32 = 0x2000_8090;
pub(crate) const USER_TABLE_HEADER: u32 = 0x2000_8080;
pub(crate) const USER_TABLE_BODY: u32 = 0x2000_0081;
pub(crate) const USER_TABLE_VERSION: u32 = 0x2000_8082;

pub(crate) const LAYER_RECORD: u32 = 0x2000_8050;
pub(crate) const LIGHT_RECORD: u32 = 0x2000_8060;
pub(crate) const LIGHT_ATTRIBUTES: u32 = 0x0200_8061;
pub(crate) const LIGHT_USER_DATA: u32 = 0x0200_0062;
pub(crate) const LIGHT_RECORD_END: u32 = 0x8200_006F;
pub(crate) const OBJECT_RECORD: u32 = 0x2000_8070;
pub(crate) const OBJECT_RECORD_TYPE: u32 = 0x8200_0071;
pub(crate) const OBJECT_ATTRIBUTES: u32 = 0x0200_8072;
pub(crate) const OBJECT_USER_DATA: u32 = 0x0200_0073;
pub(crate) const OBJECT_HISTORY: u32 = 0x0200_8074;
pub(crate) const OBJECT_RECORD_END: u32 = 0x8200_007F;

pub(crate) const CLASS: u32 = 0x0002_7FFA;
pub(crate) const CLASS_UUID: u32 = 0x0002_FFFB;
pub(crate) const CLASS_DATA: u32 = 0x0002_FFFC;
pub(crate) const CLASS_USER_DATA: u32 = 0x0002_7FFD;
pub(crate) const USER_DATA_HEADER: u32 = 0x0002_FFF9;
pub(crate) const CLASS_END: u32 = 0x8002_7FFF;
pub(crate) const ANONYMOUS: u32 = 0x4000_8000;

/// Whether a chunk of a version 1 archive can end in a CRC-16: geometry of the old modeller, the summary, and the
/// identifier of an object.
pub(crate) fn has_crc16(typecode: u32) -> bool {
    const LEGACY_GEOMETRY: u32 = 0x0001_0000;
    const SUMMARY: u32 = 0x0200_0013;
    const OBJECT_UUID: u32 = 0x0002_FFFD;
    typecode & LEGACY_GEOMETRY != 0 || matches!(typecode, SUMMARY | OBJECT_UUID)
}

/// Whether the value of this short chunk counts as unsigned when it takes 4 bytes.
pub(crate) fn is_unsigned_short(typecode: u32) -> bool {
    matches!(typecode, OPENNURBS_VERSION | OBJECT_RECORD_TYPE | 0x8040_0001 | 0x8040_0006)
}

/// A chunk that is no table in words, for messages.
pub(crate) fn name(typecode: u32) -> Option<&'static str> {
    Some(match typecode {
        COMMENT => "comment",
        END_OF_FILE => "end of file",
        NOTES => "notes",
        APPLICATION => "application",
        UNITS => "units",
        LAYER_RECORD => "layer record",
        LIGHT_RECORD => "light record",
        OBJECT_RECORD => "object record",
        MATERIAL_RECORD => "material record",
        GROUP_RECORD => "group record",
        0x2000_8074 => "text style record",
        0x2000_8075 => "dimension style record",
        INSTANCE_DEFINITION_RECORD => "block definition record",
        HATCH_PATTERN_RECORD => "hatch pattern record",
        LINETYPE_RECORD => "linetype record",
        0x2000_807A => "texture mapping record",
        0x2000_807B => "history record",
        0x2000_8090 => "bitmap record",
        0x2000_003B..=0x2000_FFFF if typecode & 0xFF == 0x3B => "view",
        LIGHT_ATTRIBUTES | OBJECT_ATTRIBUTES => "attributes",
        OBJECT_HISTORY => "history",
        LIGHT_USER_DATA | OBJECT_USER_DATA => "attribute user data",
        CLASS => "class",
        CLASS_UUID => "class identifier",
        CLASS_DATA => "class data",
        CLASS_USER_DATA => "user data",
        USER_DATA_HEADER => "user data header",
        ANONYMOUS => "part",
        // Version 1.
        0x0001_0003 => "shell",
        0x0001_0004 => "face",
        0x0001_0005 => "loop",
        0x0001_0006 => "trim",
        0x0001_0007 => "surface",
        0x0001_0008 => "curve",
        0x0001_0009 => "spline",
        0x0001_0103..=0x0001_0109 => "substance",
        0x0010_0001 => "point",
        0x0010_0015 => "mesh",
        0x0010_0017 => "mesh geometry",
        0x0040_0010 => "layer",
        0x0080_0001 => "spotlight",
        _ => return None,
    })
}

/// The table in words, for counts and messages; nothing for a typecode that is no table.
pub(crate) fn table_name(typecode: u32) -> Option<&'static str> {
    Some(match typecode {
        PROPERTIES_TABLE => "properties",
        SETTINGS_TABLE => "settings",
        BITMAP_TABLE => "bitmap",
        TEXTURE_MAPPING_TABLE => "texture mapping",
        MATERIAL_TABLE => "material",
        LINETYPE_TABLE => "linetype",
        LAYER_TABLE => "layer",
        GROUP_TABLE => "group",
        FONT_TABLE => "text style",
        DIMENSION_STYLE_TABLE => "dimension style",
        LIGHT_TABLE => "light",
        HATCH_PATTERN_TABLE => "hatch pattern",
        INSTANCE_DEFINITION_TABLE => "block definition",
        OBJECT_TABLE => "object",
        HISTORY_TABLE => "history",
        USER_TABLE => "user",
        _ => return None,
    })
}

/// A record in words, for messages; nothing for a typecode that no table here holds.
pub(crate) fn record_name(typecode: u32) -> Option<&'static str> {
    Some(match typecode {
        RENDER_MESH => "render mesh parameters",
        ANALYSIS_MESH => "analysis mesh parameters",
        ANNOTATION_SETTINGS => "annotation settings",
        NAMED_PLANES => "named construction planes",
        NAMED_VIEWS => "named views",
        VIEWS => "views",
        RENDER_SETTINGS => "render settings",
        GRID => "grid",
        CURRENT_TEXT_STYLE => "current text style",
        CURRENT_DIMENSION_STYLE => "current dimension style",
        SETTINGS_ATTRIBUTES => "page units, earth anchor and current styles",
        PLUG_IN_LIST => "list of plug-ins",
        MATERIAL_RECORD => "material",
        GROUP_RECORD => "group",
        TEXT_STYLE_RECORD => "text style",
        DIMENSION_STYLE_RECORD => "dimension style",
        INSTANCE_DEFINITION_RECORD => "block definition",
        HATCH_PATTERN_RECORD => "hatch pattern",
        LINETYPE_RECORD => "linetype",
        TEXTURE_MAPPING_RECORD => "texture mapping",
        HISTORY_RECORD => "history record",
        OBJECT_HISTORY => "history of an object",
        BITMAP_RECORD => "bitmap or embedded file",
        _ => return None,
    })
}
