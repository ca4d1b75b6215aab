//! The identifiers of openNURBS classes, their names, and the object type that a record states (sections 6–8).

use uuid::{Uuid, uuid};

pub(crate) const POINT: Uuid = uuid!("C3101A1D-F157-11D3-BFE7-0010830122F0");
pub(crate) const POINT_CLOUD: Uuid = uuid!("2488F347-F8FA-11D3-BFEC-0010830122F0");
pub(crate) const LINE_CURVE: Uuid = uuid!("4ED7D4DB-E947-11D3-BFE5-0010830122F0");
pub(crate) const ARC_CURVE: Uuid = uuid!("CF33BE2A-09B4-11D4-BFFB-0010830122F0");
pub(crate) const POLYLINE_CURVE: Uuid = uuid!("4ED7D4E6-E947-11D3-BFE5-0010830122F0");
pub(crate) const POLY_CURVE: Uuid = uuid!("4ED7D4E0-E947-11D3-BFE5-0010830122F0");
pub(crate) const CURVE_ON_SURFACE: Uuid = uuid!("4ED7D4D8-E947-11D3-BFE5-0010830122F0");
const POLY_EDGE_CURVE: Uuid = uuid!("39FF3DD3-FE0F-4807-9D59-185F0D73C0E4");
pub(crate) const NURBS_CURVE: Uuid = uuid!("4ED7D4DD-E947-11D3-BFE5-0010830122F0");
pub(crate) const PLANE_SURFACE: Uuid = uuid!("4ED7D4DF-E947-11D3-BFE5-0010830122F0");
pub(crate) const NURBS_SURFACE: Uuid = uuid!("4ED7D4DE-E947-11D3-BFE5-0010830122F0");
pub(crate) const REVOLUTION_SURFACE: Uuid = uuid!("A16220D3-163B-11D4-8000-0010830122F0");
pub(crate) const SUM_SURFACE: Uuid = uuid!("C4CD5359-446D-4690-9FF5-29059732472B");
pub(crate) const BREP: Uuid = uuid!("60B5DBC5-E660-11D3-BFE4-0010830122F0");
pub(crate) const EXTRUSION: Uuid = uuid!("36F53175-72B8-4D47-BF1F-B4E6FC24F4B9");
/// Parts of a brep's regions.
pub(crate) const FACE_SIDE: Uuid = uuid!("30930370-0D5B-4EE4-8083-BD635C7398A4");
pub(crate) const REGION: Uuid = uuid!("CA7A0092-7EE6-4F99-B9D2-E1D6AA798AA1");
pub(crate) const MESH: Uuid = uuid!("4ED7D4E4-E947-11D3-BFE5-0010830122F0");
pub(crate) const SUBD_PROXY: Uuid = uuid!("2868B9CD-28AE-4EA7-8073-BD390B3E97C8");
pub(crate) const SUBD: Uuid = uuid!("F09BA4D9-455B-42C3-BA3B-E6CCACEF853B");
pub(crate) const TEXT_DOT: Uuid = uuid!("74198302-CDF4-4F95-9609-6D684F22AB37");
pub(crate) const BLOCK_REFERENCE: Uuid = uuid!("F9CFB638-B9D4-4340-87E3-C56E7865D96A");
pub(crate) const LIGHT: Uuid = uuid!("85A08513-F383-11D3-BFE7-0010830122F0");
pub(crate) const CLIPPING_PLANE: Uuid = uuid!("DBC5A584-CE3F-4170-98A8-497069CA5C36");
pub(crate) const HATCH: Uuid = uuid!("0559733B-5332-49D1-A936-0532AC76ADE5");
pub(crate) const DETAIL_VIEW: Uuid = uuid!("C8C66EFA-B3CB-4E00-9440-2AD66203379E");
pub(crate) const MORPH_CONTROL: Uuid = uuid!("D379E6D8-7C31-4407-A913-E3B7040D034A");
pub(crate) const NURBS_CAGE: Uuid = uuid!("06936AFB-3D3C-41AC-BF70-C9319FA480A1");
/// The dots and arrows of version 2.
pub(crate) const TEXT_DOT_2: Uuid = uuid!("8BD94E19-59E1-11D4-8018-0010830122F0");
pub(crate) const ARROW_2: Uuid = uuid!("8BD94E1A-59E1-11D4-8018-0010830122F0");
/// Annotations of version 6 and later, of versions 4 and 5, and of version 2.
pub(crate) const TEXT: Uuid = uuid!("57376349-62A9-4A16-B411-A46BCD544790");
pub(crate) const LEADER: Uuid = uuid!("945BF594-6FF9-4F5C-BFC0-B3AF528F29D2");
pub(crate) const LINEAR_DIMENSION: Uuid = uuid!("E550882B-F44D-4154-A1EF-6E50CBBBF543");
pub(crate) const ANGULAR_DIMENSION: Uuid = uuid!("D417786B-F6CD-4F12-9E1F-063F414DBEB6");
pub(crate) const RADIAL_DIMENSION: Uuid = uuid!("FC749C2F-4C00-41FD-9840-26D94F047AD3");
pub(crate) const ORDINATE_DIMENSION: Uuid = uuid!("03124828-4C9B-4D28-9A82-664DDDE7A14F");
pub(crate) const CENTRE_MARK: Uuid = uuid!("D46767BA-7E8F-4D9D-9A92-66050219A5B9");
pub(crate) const TEXT_5: Uuid = uuid!("46F75541-F46B-48BE-AA7E-B353BBE068A7");
pub(crate) const LEADER_5: Uuid = uuid!("14922B7A-5B65-4F11-8345-D415A9637129");
pub(crate) const LINEAR_DIMENSION_5: Uuid = uuid!("BD57F33B-A1B2-46E9-9C6E-AF09D30FFDDE");
pub(crate) const ANGULAR_DIMENSION_5: Uuid = uuid!("841BC40B-A971-4A8E-94E5-BBA26D67348E");
pub(crate) const RADIAL_DIMENSION_5: Uuid = uuid!("B2B683FC-7964-4E96-B1F9-9B356A76B08B");
pub(crate) const ORDINATE_DIMENSION_5: Uuid = uuid!("C8288D69-5BD8-4F50-9BAF-525A0086B0C3");
pub(crate) const LINEAR_DIMENSION_2: Uuid = uuid!("5DE6B20D-486B-11D4-8014-0010830122F0");
pub(crate) const RADIAL_DIMENSION_2: Uuid = uuid!("5DE6B20E-486B-11D4-8014-0010830122F0");
pub(crate) const ANGULAR_DIMENSION_2: Uuid = uuid!("5DE6B20F-486B-11D4-8014-0010830122F0");
pub(crate) const TEXT_2: Uuid = uuid!("5DE6B210-486B-11D4-8014-0010830122F0");
pub(crate) const LEADER_2: Uuid = uuid!("5DE6B211-486B-11D4-8014-0010830122F0");
pub(crate) const LAYER: Uuid = uuid!("95809813-E985-11D3-BFE5-0010830122F0");

/// User data: attribute and object user strings.
pub(crate) const USER_STRINGS: Uuid = uuid!("CE28DE29-F4C5-4FAA-A50A-C3A6849B6329");
/// User data: the double-precision vertices of a mesh in archives before version 60.
pub(crate) const DOUBLE_VERTICES: Uuid = uuid!("17F24E75-21BE-4A7B-9F3D-7F85225247E3");
/// User data: the n-gons of a mesh in archives before version 60.
pub(crate) const MESH_NGONS: Uuid = uuid!("31F55AA3-71FB-49F5-A975-757584D937FF");
/// User data: the regions of a brep in version 5 archives.
pub(crate) const V5_REGIONS: Uuid = uuid!("7FE23D63-E536-43F1-98E2-C807A2625AFF");
/// User data: the meshes of an extrusion in version 5 archives.
pub(crate) const V5_EXTRUSION_MESHES: Uuid = uuid!("A8130A3E-E4F3-4CB0-BB8A-F10A473912D0");
/// User data: the base point of a hatch in version 5 archives.
pub(crate) const V5_HATCH_BASE: Uuid = uuid!("3FF7007C-3D04-463F-84E3-132ACEB91062");
/// The application that core openNURBS user data of version 5 names as its owner.
pub(crate) const OPENNURBS_5_APPLICATION: Uuid = uuid!("C8CDA597-D957-4625-A4B3-A0B510FC30D4");
/// The application that core openNURBS user data names as its owner.
pub(crate) const OPENNURBS_APPLICATION: Uuid = uuid!("17B3ECDA-17BA-4E45-9E67-A2B8D9BE520D");

/// The applications under which openNURBS itself has owned user data, up to version 4, and from 5 to 8.
const OPENNURBS_APPLICATIONS: &[Uuid] = &[
    OPENNURBS_APPLICATION,
    OPENNURBS_5_APPLICATION,
    uuid!("7B0B585D-7A31-45D0-925E-BDD7DDF3E4E3"),
    uuid!("523BFE6E-EF49-4B75-A8D6-253FAF5044D3"),
    uuid!("50EDE5C9-1487-4B4C-B3AA-6840B460E3CF"),
];

/// Whether an application is openNURBS.
pub(crate) fn is_opennurbs(application: Uuid) -> bool {
    OPENNURBS_APPLICATIONS.contains(&application)
}

/// Identifiers under which older programs (and Rhino itself, up to version 8) write a class.
const ALIASES: &[(Uuid, Uuid)] = &[
    (uuid!("5EAF1119-0B51-11D4-BFFE-0010830122F0"), NURBS_CURVE),
    (uuid!("76A709D5-1550-11D4-8000-0010830122F0"), NURBS_CURVE),
    (uuid!("4760C817-0BE3-11D4-BFFE-0010830122F0"), NURBS_SURFACE),
    (uuid!("FA4FD4B5-1613-11D4-8000-0010830122F0"), NURBS_SURFACE),
    (uuid!("EF638317-154B-11D4-8000-0010830122F0"), POLY_CURVE),
    (POLY_EDGE_CURVE, POLY_CURVE),
    (uuid!("0705FDEF-3E2A-11D4-800E-0010830122F0"), BREP),
    (uuid!("2D4CFEDB-3E2A-11D4-800E-0010830122F0"), BREP),
    (uuid!("F06FC243-A32A-4608-9DD8-A7D2C4CE2A36"), BREP),
    (uuid!("0A8401B6-4D34-4B99-8615-1B4E723DC4E5"), REVOLUTION_SURFACE),
    (uuid!("665F6331-2A66-4CCE-81D0-B5EEBD9B5417"), SUM_SURFACE),
];

/// Class, name, and object type of its record.
const CLASSES: &[(Uuid, &str, u32)] = &[
    (POINT, "Point", 1),
    (POINT_CLOUD, "PointCloud", 2),
    (LINE_CURVE, "LineCurve", 4),
    (ARC_CURVE, "ArcCurve", 4),
    (POLYLINE_CURVE, "PolylineCurve", 4),
    (POLY_CURVE, "PolyCurve", 4),
    (NURBS_CURVE, "NurbsCurve", 4),
    (CURVE_ON_SURFACE, "CurveOnSurface", 4),
    (NURBS_SURFACE, "NurbsSurface", 8),
    (PLANE_SURFACE, "PlaneSurface", 8),
    (REVOLUTION_SURFACE, "RevSurface", 8),
    (SUM_SURFACE, "SumSurface", 8),
    (CLIPPING_PLANE, "ClippingPlaneSurface", 0x2000_0000),
    (BREP, "Brep", 0x10),
    (MESH, "Mesh", 0x20),
    (EXTRUSION, "Extrusion", 0x4000_0000),
    (SUBD, "SubD", 0x4_0000),
    (BLOCK_REFERENCE, "InstanceReference", 0x1000),
    (HATCH, "Hatch", 0x1_0000),
    (TEXT_DOT, "TextDot", 0x2000),
    (LIGHT, "Light", 0x100),
    (DETAIL_VIEW, "DetailView", 0x8000),
    (NURBS_CAGE, "NurbsCage", 0x0800_0000),
    (MORPH_CONTROL, "MorphControl", 0x2_0000),
    (TEXT, "Text", 0x200),
    (LEADER, "Leader", 0x200),
    (LINEAR_DIMENSION, "LinearDimension", 0x200),
    (ANGULAR_DIMENSION, "AngularDimension", 0x200),
    (RADIAL_DIMENSION, "RadialDimension", 0x200),
    (ORDINATE_DIMENSION, "OrdinateDimension", 0x200),
    (CENTRE_MARK, "Centermark", 0x200),
    (TEXT_5, "Text", 0x200),
    (LEADER_5, "Leader", 0x200),
    (LINEAR_DIMENSION_5, "LinearDimension", 0x200),
    (ANGULAR_DIMENSION_5, "AngularDimension", 0x200),
    (RADIAL_DIMENSION_5, "RadialDimension", 0x200),
    (ORDINATE_DIMENSION_5, "OrdinateDimension", 0x200),
    (LINEAR_DIMENSION_2, "LinearDimension", 0x200),
    (RADIAL_DIMENSION_2, "RadialDimension", 0x200),
    (ANGULAR_DIMENSION_2, "AngularDimension", 0x200),
    (TEXT_2, "Text", 0x200),
    (LEADER_2, "Leader", 0x200),
    (TEXT_DOT_2, "AnnotationTextDot", 0x200),
    (ARROW_2, "AnnotationArrow", 0x200),
    (LAYER, "Layer", 0x40),
];

/// The class meant by an identifier: itself, or what it is another name of.
pub(crate) fn canonical(class: Uuid) -> Uuid {
    ALIASES.iter().find(|(alias, _)| *alias == class).map_or(class, |(_, meant)| *meant)
}

/// The name of a class by any of its identifiers, when it is known.
pub(crate) fn name(class: Uuid) -> Option<&'static str> {
    let class = canonical(class);
    CLASSES.iter().find(|(id, ..)| *id == class).map(|(_, name, _)| *name)
}

/// The object type a record states for a class; 0 when it is not known.
pub(crate) fn object_type(class: Uuid) -> u32 {
    let class = canonical(class);
    CLASSES.iter().find(|(id, ..)| *id == class).map_or(0, |(.., kind)| *kind)
}
