//! Chunk typecodes in words (sections 1, 2, 5, 6 and 7; those of version 1 in section 11).

/// The typecodes and what they mean.
const NAMES: &[(u32, &str)] = &[
    (0x0000_0001, "comment"),
    (0x0000_7FFF, "end of file"),
    (0x1000_0010, "material table"),
    (0x1000_0011, "layer table"),
    (0x1000_0012, "light table"),
    (0x1000_0013, "object table"),
    (0x1000_0014, "properties table"),
    (0x1000_0015, "settings table"),
    (0x1000_0016, "bitmap table"),
    (0x1000_0017, "user table"),
    (0x1000_0018, "group table"),
    (0x1000_0019, "text style table"),
    (0x1000_0020, "dimension style table"),
    (0x1000_0021, "block definition table"),
    (0x1000_0022, "hatch pattern table"),
    (0x1000_0023, "linetype table"),
    (0x1000_0025, "texture mapping table"),
    (0x1000_0026, "history table"),
    (0xFFFF_FFFF, "end of table"),
    (0xA000_0026, "openNURBS version"),
    (0x2000_8020, "preview image"),
    (0x2000_8021, "revision history"),
    (0x2000_8022, "notes"),
    (0x2000_8024, "application"),
    (0x2000_8025, "compressed preview image"),
    (0x2000_8027, "file name"),
    (0x2000_8031, "units and tolerances"),
    (0x2000_8032, "render mesh parameters"),
    (0x2000_8033, "analysis mesh parameters"),
    (0x2000_8034, "annotation settings"),
    (0x2000_8035, "named construction planes"),
    (0x2000_8036, "named views"),
    (0x2000_8037, "views"),
    (0xA000_0038, "current layer"),
    (0x2000_8039, "current material"),
    (0x2000_803A, "current colour"),
    (0xA000_003C, "wire density"),
    (0x2000_803D, "render settings"),
    (0x2000_803F, "grid settings"),
    (0x2000_803B, "view"),
    (0x2000_813B, "construction plane"),
    (0x2000_8134, "settings attributes"),
    (0x2000_8135, "plug-in list"),
    (0x2000_8040, "material record"),
    (0x2000_8050, "layer record"),
    (0x2000_8060, "light record"),
    (0x0200_8061, "light attributes"),
    (0x0200_0062, "light attributes' user data"),
    (0x8200_006F, "end of light record"),
    (0x2000_8070, "object record"),
    (0x8200_0071, "object type"),
    (0x0200_8072, "object attributes"),
    (0x0200_0073, "object attributes' user data"),
    (0x0200_8074, "object history"),
    (0x8200_007F, "end of object record"),
    (0x2000_8073, "group record"),
    (0x2000_8074, "text style record"),
    (0x2000_8075, "dimension style record"),
    (0x2000_8076, "block definition record"),
    (0x2000_8077, "hatch pattern record"),
    (0x2000_8078, "linetype record"),
    (0x2000_807A, "texture mapping record"),
    (0x2000_807B, "history record"),
    (0x2000_8090, "bitmap record"),
    (0x2000_8080, "user table identifier"),
    (0x2000_8082, "user table header"),
    (0x2000_0081, "user table data"),
    (0x0002_7FFA, "class object"),
    (0x0002_FFFB, "class identifier"),
    (0x0002_FFFC, "class data"),
    (0x0002_7FFD, "user data"),
    (0x0002_FFF9, "user data header"),
    (0x8002_7FFF, "end of class object"),
    (0x4000_8000, "anonymous chunk"),
    (0x4000_8002, "component attributes"),
    (0x4000_8010, "dictionary"),
    (0x4000_8011, "dictionary identifier"),
    (0x4000_8012, "dictionary entry"),
    (0xC000_0013, "end of dictionary"),
    (0x0010_0001, "point of version 1"),
    (0x0010_0015, "mesh of version 1"),
    (0x0010_0017, "compressed mesh geometry of version 1"),
    (0x0001_0003, "shell of version 1"),
    (0x0001_0004, "face of version 1"),
    (0x0001_0008, "curve of version 1"),
    (0x0040_0010, "layer of version 1"),
    (0x0040_0020, "render mesh of version 1"),
    (0x0200_0006, "viewport of version 1"),
    (0x0200_000F, "notes of version 1"),
    (0x0200_0010, "units of version 1"),
    (0x0200_0013, "summary of version 1"),
];

/// A typecode in words.
pub(super) fn name_of(typecode: u32) -> Option<&'static str> {
    NAMES.iter().find(|(code, _)| *code == typecode).map(|(_, name)| *name)
}

/// Whether the body of a chunk is nothing but chunks.
pub(super) fn holds_chunks(typecode: u32) -> bool {
    // User data lies behind a version byte, and views behind a count: they are looked for.
    matches!(
        typecode,
        0x1000_0010..=0x1000_0026 | 0x2000_8040..=0x2000_807B | 0x2000_8090 | 0x0002_7FFA | 0x0200_0062 | 0x0200_0073
    )
}

/// Whether a body is another program's business, in a version of its own.
pub(super) fn is_opaque(typecode: u32) -> bool {
    matches!(typecode, 0x0000_0001 | 0x0002_7FFD | 0x2000_0081)
}

/// The typecodes that are looked for in bodies which hold other bytes as well.
pub(super) const NESTED: [u32; 7] =
    [0x4000_8000, 0x4000_8002, 0x0002_7FFA, 0x2000_803B, 0x2000_813B, 0x2000_8082, 0x4000_8010];
