//! The archive against real files, hostile bytes and random trees.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod shared;

use std::io::Write;
use std::time::Instant;

use flate2::Compression;
use flate2::write::DeflateEncoder;
use katydid_definition::archive::{
    self, Archive, Chunk, Colour, DEEPEST, Decimal, Encoding, Item, ItemValue, Limits, Version,
};
use katydid_definition::{Error, Place};
use proptest::prelude::*;
use uuid::Uuid;

fn read(bytes: &[u8]) -> Result<Archive, Error> {
    archive::read(bytes, &Limits::default())
}

fn deflate(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn inflate(bytes: &[u8]) -> Vec<u8> {
    use std::io::Read;
    let mut out = Vec::new();
    flate2::read::DeflateDecoder::new(bytes).read_to_end(&mut out).unwrap();
    out
}

/// All byte arrays of this name in the tree.
fn streams<'a>(chunk: &'a Chunk, name: &str, found: &mut Vec<&'a [u8]>) {
    found.extend(chunk.bytes(name));
    chunk.chunks.iter().for_each(|child| streams(child, name, found));
}

#[test]
fn real_files_survive_both_encodings() {
    let mut clusters = 0;
    let (mut binary, mut xml) = (0, 0);
    for path in shared::definitions() {
        let bytes = std::fs::read(&path).unwrap();
        let archive = read(&bytes).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        let gh = archive::write_gh(&archive.root).unwrap();
        let ghx = archive::write_ghx(&archive.root).unwrap();
        match archive.encoding {
            Encoding::Binary => {
                binary += 1;
                assert!(inflate(&bytes) == inflate(&gh), "{}: other bytes", path.display());
            }
            Encoding::Xml => xml += 1,
        }
        assert!(read(&gh).unwrap().root == archive.root, "{} as .gh", path.display());
        let again = read(ghx.as_bytes()).unwrap();
        assert!(again.root == archive.root, "{} as .ghx", path.display());
        assert_eq!(again.notes, Vec::<String>::new());
        clusters += nested(&archive.root);
    }
    println!("{binary} binary, {xml} XML, {clusters} clusters");
    if binary > 0 {
        assert_eq!((binary, xml), (194, 79));
        assert!(clusters >= 70);
    }
}

/// Reads every cluster in the tree, and those inside them.
fn nested(chunk: &Chunk) -> usize {
    let mut found = Vec::new();
    streams(chunk, "ClusterDocument", &mut found);
    let mut count = found.len();
    for bytes in found {
        let cluster = read(bytes).unwrap();
        assert_eq!(cluster.root.name, "Document");
        assert!(inflate(bytes) == archive::write_binary_tree(&cluster.root).unwrap());
        count += nested(&cluster.root);
    }
    count
}

#[test]
fn cut_short_anywhere_is_an_error() {
    let files = shared::definitions();
    let small = files.iter().filter(|p| std::fs::metadata(p).unwrap().len() < 12_000).take(12);
    for path in small {
        let bytes = std::fs::read(path).unwrap();
        for end in (0..bytes.len()).step_by(bytes.len() / 200 + 1) {
            assert!(read(&bytes[..end]).is_err(), "{} cut at {end}", path.display());
        }
        if sniffed(&bytes) == Encoding::Binary {
            let tree = inflate(&bytes);
            for end in (0..tree.len()).step_by(tree.len() / 500 + 1) {
                let error = archive::read_binary_tree(&tree[..end], &Limits::default()).unwrap_err();
                assert!(matches!(error, Error::Archive { .. }), "{error}");
            }
        }
    }
}

fn sniffed(bytes: &[u8]) -> Encoding {
    archive::sniff(bytes).unwrap()
}

#[test]
fn other_formats_are_named() {
    for (bytes, what) in [
        (&b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR"[..], "a PNG picture"),
        (b"PK\x03\x04\x14\0\0\0", "a zip file"),
        (b"\x1f\x8b\x08\0\0\0\0\0", "a gzip file"),
        (b"3D Geometry File Format        5", "a Rhino model (.3dm)"),
        (b"hello there, this is my definition", "plain text"),
        (b"katydid 1\nunits millimetres\n", "plain text"),
    ] {
        assert_eq!(read(bytes), Err(Error::Foreign(what)));
    }
    assert!(read(b"").unwrap_err().to_string().contains("it is empty"));
    assert!(read(b"<svg/>").unwrap_err().to_string().contains("<svg>"));
    assert!(read(b"\xef\xbb\xbf").is_err());
    assert!(read(&[0xff; 50]).is_err());
}

#[test]
fn a_bomb_stops_at_the_limit() {
    // A gigabyte of zeros in a megabyte.
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    let zeros = vec![0; 1 << 20];
    for _ in 0..1024 {
        encoder.write_all(&zeros).unwrap();
    }
    let bomb = encoder.finish().unwrap();
    assert!(bomb.len() < 2 << 20);
    let start = Instant::now();
    assert!(matches!(read(&bomb), Err(Error::Limit { .. })));
    println!("refused after {:?}", start.elapsed());
    let tight = Limits { max_inflated: 1000, ..Limits::default() };
    let refused = archive::read(&deflate(&[0; 5000]), &tight);
    assert!(matches!(refused, Err(Error::Limit { what: "the inflated size in bytes", limit: 1000, .. })));
}

/// The head of a chunk: name, index and counts.
fn head(name: &str, items: i32, chunks: i32) -> Vec<u8> {
    let mut out = vec![u8::try_from(name.len()).unwrap()];
    out.extend(name.bytes());
    for n in [-1, items, chunks] {
        out.extend(n.to_le_bytes());
    }
    out
}

/// The head of an item without index.
fn item(code: i32) -> Vec<u8> {
    let mut out = head("Root", 1, 0);
    out.extend(b"\x01x");
    out.extend((-1_i32).to_le_bytes());
    out.extend(code.to_le_bytes());
    out
}

fn message(tree: &[u8]) -> String {
    read(&deflate(tree)).unwrap_err().to_string()
}

#[test]
fn lying_numbers_are_errors() {
    assert!(message(&head("Root", -1, 0)).contains("negative"));
    assert!(message(&head("Root", 0, -1)).contains("negative"));
    assert!(message(&head("Root", i32::MAX, 0)).contains("more than the rest"));
    assert!(message(&head("Root", 0, i32::MAX)).contains("more than the rest"));
    assert!(message(&[0xff, 0xff, 0xff, 0xff, 0x07, b'R']).contains("needs 2147483647 bytes"));
    assert!(message(&[0xff, 0xff, 0xff, 0xff, 0xff, 0x01]).contains("31 bits"));
    assert!(message(&[item(1), vec![2]].concat()).contains("a boolean is 2"));
    assert!(message(&[item(10), vec![2, 0xc3, 0x28]].concat()).contains("UTF-8"));
    assert!(message(&[item(11), vec![0; 20]].concat()).contains("11 is not a known item type"));
    for code in [20, 21, 37] {
        assert!(message(&[item(code), (-1_i32).to_le_bytes().to_vec()].concat()).contains("negative"));
        assert!(read(&deflate(&[item(code), i32::MAX.to_le_bytes().to_vec()].concat())).is_err());
    }
    assert_eq!(
        message(&[item(6), vec![0; 7]].concat()),
        "broken at byte 27 of the inflated data: a number needs 8 bytes, but only 7 remain"
    );
}

#[test]
fn depth_is_bounded_both_ways() {
    let deep: Vec<u8> = (0..100_000).flat_map(|_| head("a", 0, 1)).collect();
    assert!(matches!(read(&deflate(&deep)), Err(Error::Limit { limit: 200, .. })));
    for [open, close] in [
        ["<chunks><chunk name=\"a\">", "</chunk></chunks>"],
        ["<x>", "</x>"],
        ["<items><item name='a' type_code='3'>", "</item></items>"],
    ] {
        let text =
            format!("<Archive name=\"Root\">{}{}</Archive>", open.repeat(100_000), close.repeat(100_000));
        assert!(read(text.as_bytes()).is_err());
    }
    assert!(read("<a>".repeat(100_000).as_bytes()).is_err());
    let greedy = Limits { max_depth: usize::MAX, ..Limits::default() };
    assert!(matches!(archive::read(&deflate(&deep), &greedy), Err(Error::Limit { limit: DEEPEST, .. })));
    let mut tree = Chunk::new("a");
    for _ in 1..DEEPEST {
        tree = Chunk { name: "a".to_owned(), chunks: vec![tree], ..Chunk::default() };
    }
    let bytes = archive::write_gh(&tree).unwrap();
    assert!(archive::read(&bytes, &greedy).unwrap().root == tree);
    let ghx = archive::write_ghx(&tree).unwrap();
    assert!(archive::read(ghx.as_bytes(), &greedy).unwrap().root == tree);
    let deeper = Chunk { name: "a".to_owned(), chunks: vec![tree], ..Chunk::default() };
    assert!(matches!(archive::write_gh(&deeper), Err(Error::Unwritable(_))));
    assert!(matches!(archive::write_ghx(&deeper), Err(Error::Unwritable(_))));
}

#[test]
fn nodes_are_bounded() {
    let mut tree = head("Root", 0, 3_000);
    (0..3_000).for_each(|_| tree.extend(head("a", 0, 0)));
    let limits = Limits { max_nodes: 1000, ..Limits::default() };
    // The head of the root and of each chunk: a byte of length, the name, and three numbers of four bytes.
    let offset = 17 + 999 * 14;
    let (place, what) = (Place::Inflated, "the number of chunks and items");
    assert_eq!(
        archive::read_binary_tree(&tree, &limits),
        Err(Error::Limit { place, offset, what, limit: 1000 })
    );
}

#[test]
fn bytes_after_the_end_are_noted() {
    let mut tree = head("Root", 0, 0);
    tree.extend([1, 2, 3]);
    let mut bytes = deflate(&tree);
    bytes.extend([4, 5]);
    assert_eq!(read(&bytes).unwrap().notes.len(), 2);
}

#[test]
fn xml_as_people_write_it() {
    let text = "<?xml version='1.0'?>\n<!-- mine -->\n<Archive name='Root'>\r\n\
        <items count='9'><item name='a' index='-1' type_code='1'> TRUE </item>\
        <item name='b' index='7' type_name='gh_string'>x &lt; &#x41;&#66;\r\n<![CDATA[<&>]]></item>\
        <item name='c' type_code='36'><ARGB>255; 1;2;3</ARGB></item>\
        <item name='d' type_code='20'><stream length='3'>AQ\nID</stream></item>\
        <item name='e' type_code='20'><stream length='0'/></item>\
        <item name='f' type_code='6'>1.79769313486232E+308</item>\
        <item name='g&quot;' type_code='10'/></items><junk><more/></junk></Archive>\n";
    let check = |bytes: &[u8]| {
        let archive = read(bytes).unwrap();
        let root = &archive.root;
        assert_eq!(root.bool("a"), Some(true));
        assert_eq!(root.str_at("b", 7), Some("x < AB\n<&>"));
        assert_eq!(root.colour("c"), Some(Colour::new(255, 1, 2, 3)));
        assert_eq!(root.bytes("d"), Some(&[1, 2, 3][..]));
        assert_eq!(root.bytes("e"), Some(&[][..]));
        assert_eq!(root.f64("f"), Some(f64::MAX));
        assert_eq!(root.str("g\""), Some(""));
        assert_eq!(archive.notes.len(), 2, "{:?}", archive.notes);
    };
    check(text.as_bytes());
    check(format!("\u{feff}  {text}").as_bytes());
    let utf16 = |unit: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(unit).collect::<Vec<u8>>();
    check(&utf16(u16::to_le_bytes));
    check(&[&[0xff, 0xfe], utf16(u16::to_le_bytes).as_slice()].concat());
    check(&[&[0xfe, 0xff], utf16(u16::to_be_bytes).as_slice()].concat());
    check(&deflate(text.as_bytes()));
}

#[test]
fn hostile_xml_is_refused() {
    let wrap = |inside: &str| format!("<Archive name='Root'><items>{inside}</items></Archive>");
    for text in [
        "<!DOCTYPE a [<!ENTITY b \"c\">]><Archive name='Root'/>".to_owned(),
        wrap("<item name='a' type_code='10'>&b;</item>"),
        wrap("<item name='a' type_code='10'>&#xD800;</item>"),
        wrap("<item name='a' type_code='3'>x</item>"),
        wrap("<item name='a' type_code='3'>99999999999</item>"),
        wrap("<item name='a' type_code='99'>x</item>"),
        wrap("<item name='a'>x</item>"),
        wrap("<item type_code='10'>x</item>"),
        wrap("<item name='a' type_code='51'><X>1</X><Y>2</Y></item>"),
        wrap("<item name='a' type_code='36'><ARGB>1;2;3</ARGB></item>"),
        wrap("<item name='a' type_code='36'><ARGB>1;2;3;256</ARGB></item>"),
        wrap("<item name='a' type_code='20'><stream>!!</stream></item>"),
        wrap("<item name='a' type_code='9'>{not a guid}</item>"),
        wrap("<item name='a' index='x' type_code='10'/>"),
        "<Archive name='Root'/><Archive name='Root'/>".to_owned(),
        "<Archive name='Root'>".to_owned(),
        "<Archive name='Root'></chunk>".to_owned(),
        "<Archive name='a' name='b'/>".to_owned(),
        "< ".to_owned(),
        format!("<Archive {}/>", (0..300_000).map(|k| format!("a{k}='' ")).collect::<String>()),
    ] {
        let text: &str = &text;
        let error = read(text.as_bytes()).expect_err(text);
        assert!(matches!(error, Error::Archive { .. }), "{text}: {error}");
    }
}

#[test]
fn setters_keep_the_order() {
    let mut chunk = Chunk::new("Container");
    for name in ["Delta", "Alpha", "Charlie"] {
        chunk.set(name, 1);
    }
    chunk.set_at("Charlie", 1, 2);
    chunk.set_at("Charlie", 0, 3.5);
    chunk.set("Alpha", "text");
    let names: Vec<_> = chunk.items.iter().map(|i| (i.name.as_str(), i.index)).collect();
    assert_eq!(
        names,
        [("Alpha", None), ("Charlie", None), ("Charlie", Some(0)), ("Charlie", Some(1)), ("Delta", None)]
    );
    assert_eq!((chunk.str("Alpha"), chunk.f64_at("Charlie", 0)), (Some("text"), Some(3.5)));
    chunk.set_child(Chunk::indexed("Source", 1));
    chunk.set_child(Chunk::indexed("Source", 0));
    assert_eq!(chunk.children("Source").len(), 2);
    assert!(chunk.chunks[0].index == Some(0) && chunk.child_at("Source", 1).is_some());
    assert!(chunk.remove("Charlie") && !chunk.remove("Charlie"));
    assert_eq!(chunk.items.len(), 2);
}

#[test]
fn decimals_keep_their_digits() {
    for text in ["0", "-12.50", "0.0000000000000000000000000001", "79228162514264337593543950335"] {
        assert_eq!(text.parse::<Decimal>().unwrap().to_string(), text);
    }
    for text in ["", ".", "-", "1e3", "1.2.3", "79228162514264337593543950336", "é"] {
        assert!(text.parse::<Decimal>().is_err(), "{text}");
    }
    assert_eq!("6.42".parse::<Decimal>().unwrap().to_f64(), 6.42);
    assert_eq!(Decimal::from_f64(2.345, 2).unwrap().to_string(), "2.35");
    assert_eq!(Decimal::from_f64(f64::NAN, 2), None);
}

fn doubles<const N: usize>() -> impl Strategy<Value = [f64; N]> {
    proptest::collection::vec(any::<f64>(), N).prop_map(|v| v.try_into().unwrap())
}

fn singles<const N: usize>() -> impl Strategy<Value = [f32; N]> {
    proptest::collection::vec(any::<f32>(), N).prop_map(|v| v.try_into().unwrap())
}

fn wholes<const N: usize>() -> impl Strategy<Value = [i32; N]> {
    proptest::collection::vec(any::<i32>(), N).prop_map(|v| v.try_into().unwrap())
}

fn decimal() -> impl Strategy<Value = Decimal> {
    (any::<[u32; 3]>(), 0_u32..29, any::<bool>()).prop_map(|([low, middle, high], scale, minus)| Decimal {
        low,
        middle,
        high,
        flags: scale << 16 | u32::from(minus) << 31,
    })
}

fn value() -> impl Strategy<Value = ItemValue> {
    let text = prop_oneof![".{0,12}", "[ -~\\r\\n\\t<>&\"']{0,12}", "\\PC*"];
    let bytes = || proptest::collection::vec(any::<u8>(), 0..20);
    let simple = prop_oneof![
        any::<bool>().prop_map(ItemValue::Bool),
        any::<u8>().prop_map(ItemValue::Byte),
        any::<i32>().prop_map(ItemValue::Int32),
        any::<i64>().prop_map(ItemValue::Int64),
        any::<f32>().prop_map(ItemValue::Single),
        any::<f64>().prop_map(ItemValue::Double),
        decimal().prop_map(ItemValue::Decimal),
        any::<i64>().prop_map(ItemValue::Date),
        any::<u128>().prop_map(|n| ItemValue::Guid(Uuid::from_u128(n))),
        text.prop_map(ItemValue::String),
        bytes().prop_map(ItemValue::ByteArray),
        proptest::collection::vec(any::<f64>(), 0..5).prop_map(ItemValue::DoubleArray),
        bytes().prop_map(ItemValue::Bitmap),
        any::<[u8; 4]>().prop_map(|[a, r, g, b]| ItemValue::Colour(Colour { a, r, g, b })),
    ];
    let shapes = prop_oneof![
        wholes().prop_map(ItemValue::Point),
        singles().prop_map(ItemValue::PointF),
        wholes().prop_map(ItemValue::Size),
        singles().prop_map(ItemValue::SizeF),
        wholes().prop_map(ItemValue::Rectangle),
        singles().prop_map(ItemValue::RectangleF),
        doubles().prop_map(ItemValue::Point2d),
        doubles().prop_map(ItemValue::Point3d),
        doubles().prop_map(ItemValue::Point4d),
        doubles().prop_map(ItemValue::Interval1d),
        doubles().prop_map(ItemValue::Interval2d),
        doubles().prop_map(|v| ItemValue::Line(Box::new(v))),
        doubles().prop_map(|v| ItemValue::BoundingBox(Box::new(v))),
        doubles().prop_map(|v| ItemValue::Plane(Box::new(v))),
        wholes().prop_map(|[major, minor, revision]| ItemValue::Version(Version { major, minor, revision })),
    ];
    prop_oneof![simple, shapes]
}

fn index() -> impl Strategy<Value = Option<i32>> {
    prop_oneof![Just(None), (0_i32..5).prop_map(Some), (i32::MIN..-1).prop_map(Some)]
}

fn tree() -> impl Strategy<Value = Chunk> {
    let items = || {
        let item = (".{0,6}", index(), value()).prop_map(|(name, index, value)| Item { name, index, value });
        proptest::collection::vec(item, 0..5)
    };
    let leaf = (".{0,6}", index(), items()).prop_map(|(name, index, items)| Chunk {
        name,
        index,
        items,
        chunks: Vec::new(),
    });
    let tree = leaf.prop_recursive(5, 40, 4, move |inner| {
        (".{0,6}", index(), items(), proptest::collection::vec(inner, 0..4))
            .prop_map(|(name, index, items, chunks)| Chunk { name, index, items, chunks })
    });
    tree.prop_map(|mut tree| {
        tree.name = "Root".to_owned();
        tree
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_trees_survive_both_encodings(tree in tree()) {
        let gh = read(&archive::write_gh(&tree).unwrap()).unwrap();
        prop_assert_eq!(&gh.root, &tree);
        let ghx = read(archive::write_ghx(&tree).unwrap().as_bytes()).unwrap();
        prop_assert_eq!(&ghx.root, &tree);
        prop_assert!(ghx.notes.is_empty());
    }

    #[test]
    fn nan_bits_survive_binary(bits in any::<u64>()) {
        let mut tree = Chunk::new("Root");
        tree.set("x", f64::from_bits(bits | 0x7ff0_0000_0000_0000));
        prop_assert_eq!(&read(&archive::write_gh(&tree).unwrap()).unwrap().root, &tree);
    }

    #[test]
    fn random_bytes_never_panic(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        let _ = read(&bytes);
        let _ = read(&deflate(&bytes));
        let _ = archive::read_binary_tree(&bytes, &Limits::default());
        let _ = read(&[b"<Archive name='Root'>", bytes.as_slice()].concat());
    }
}
