//! Files that nobody vouches for: an error or a part of what they say, never a panic, and quickly.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use common::sample;
use katydid_exchange::{Format, Options, pdb, read, shp, write};
use proptest::prelude::*;

const READ: [Format; 5] = [Format::Obj, Format::Stl, Format::Ply, Format::Glb, Format::Gltf];

fn whole(format: Format, ascii: bool) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(&sample(), format, &Options { ascii, ..Options::default() }, &mut bytes).unwrap();
    bytes
}

#[test]
fn every_beginning_of_a_file_ends_well() {
    for format in READ {
        for ascii in [false, true] {
            let bytes = whole(format, ascii);
            for length in 0..bytes.len() {
                let _ = read(&bytes[..length], format);
            }
        }
    }
}

#[test]
fn counts_that_lie_are_refused_before_room_is_made() {
    let binary = "format binary_little_endian 1.0";
    for header in [
        "element vertex 18446744073709551615\nproperty double x\n",
        "element vertex 4000000000\nproperty char x\n",
        "element face 1\nproperty list uint double vertex_indices\n",
        "element nothing 18446744073709551615\n",
        "element vertex -1\nproperty char x\n",
        "element vertex 99999999999999999999999\nproperty char x\n",
    ] {
        let mut bytes = format!("ply\n{binary}\n{header}end_header\n").into_bytes();
        bytes.extend_from_slice(&[255; 16]);
        let result = read(&bytes, Format::Ply);
        assert!(result.is_err() || header.contains("nothing"), "{header}");
    }
    let mut stl = vec![b' '; 80];
    stl.extend_from_slice(&u32::MAX.to_le_bytes());
    stl.extend_from_slice(&[0; 50]);
    let scene = read(&stl, Format::Stl).unwrap();
    assert_eq!((scene.things.len(), scene.left_out[0].count), (1, u32::MAX as usize - 1));
    for (json, reason) in [
        (r#"{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"children":[0]}]}"#, "no tree"),
        (r#"{"asset":{"version":"2.0"},"scenes":[{"nodes":[7]}]}"#, "not there"),
        (r#"{"asset":{"version":"1.0"}}"#, "version '1.0'"),
        (r#"{"asset":{"version":"2.0"},"extensionsRequired":["KHR_draco_mesh_compression"]}"#, "KHR_draco"),
        (
            r#"{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
               "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
               "accessors":[{"componentType":5126,"count":18446744073709551615,"type":"VEC3"}]}"#,
            "no numbers",
        ),
        (
            r#"{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
               "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
               "accessors":[{"bufferView":0,"componentType":5126,"count":4611686018427387905,"type":"VEC3"}],
               "bufferViews":[{"buffer":0,"byteLength":12}],
               "buffers":[{"byteLength":12,"uri":"data:;base64,AAAAAAAAAAAAAAAA"}]}"#,
            "do not fit",
        ),
        (
            r#"{"asset":{"version":"2.0"},"buffers":[{"byteLength":1,"uri":"../secret"}]}"#,
            "another file, ../secret",
        ),
    ] {
        let error = read(json.as_bytes(), Format::Gltf).unwrap_err();
        assert!(error.to_string().contains(reason), "{reason}: {error}");
    }
}

#[test]
fn odd_but_lawful_files_are_read() {
    let obj = "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nv 0.5 2 0\r\nf -5 -4 \\\n -3 -1 -2\r\nl 1 1 2/7 \n# note\nusemtl x\n";
    let scene = read(obj.as_bytes(), Format::Obj).unwrap();
    assert_eq!(scene.things.len(), 2);
    let ply = "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n\
               property list uchar int near\r\nelement tristrips 1\r\nproperty list int int vertex_indices\r\nend_header\r\n\
               0 0 0 2 1 2\r\n1 0 0 0\r\n0 1 0 1 0\r\n4 0 1 2 -1\r\n";
    assert_eq!(read(ply.as_bytes(), Format::Ply).unwrap().things.len(), 1);
    // A binary file whose header begins with the word of the text form.
    let mut stl = b"solid but binary".to_vec();
    stl.resize(80, 0);
    stl.extend_from_slice(&1_u32.to_le_bytes());
    let corners = [0.0_f32, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    stl.extend(corners.iter().flat_map(|x| x.to_le_bytes()));
    stl.extend_from_slice(&[0, 0]);
    assert_eq!(read(&stl, Format::Stl).unwrap().things.len(), 1);
    for (line, reason) in
        [("f 1 2 3", "none of the 0"), ("v 1 2", "3 numbers"), ("v 1 nan 2", "'nan' is no number")]
    {
        let error = read(line.as_bytes(), Format::Obj).unwrap_err();
        assert!(error.to_string().contains("line 1") && error.to_string().contains(reason), "{error}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn changed_bytes_end_well(
        format in prop::sample::select(READ.to_vec()),
        ascii in any::<bool>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..12),
    ) {
        let mut bytes = whole(format, ascii);
        for (place, value) in changes {
            let place = place.index(bytes.len());
            bytes[place] = value;
        }
        let _ = read(&bytes, format);
    }

    #[test]
    fn any_text_ends_well(text in "(v|vn|f|l|p|o|g|solid|vertex|endloop| |-|/|[0-9]|\n|\\\\|e|\\.){0,200}") {
        let _ = read(text.as_bytes(), Format::Obj);
        let _ = read(format!("solid {text}").as_bytes(), Format::Stl);
        let _ = read(format!("ply\nformat ascii 1.0\n{text}").as_bytes(), Format::Ply);
    }
}

#[test]
fn messages_name_the_line_of_a_ply_file() {
    let head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
                element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    let points = "0 0 0\n1 0 0\n0 1 0\n";
    for (body, place) in [
        ("0 0 0\n1 zero 0\n", "line 11: it is no number"),
        ("0 0 0\n1 0 0\n\n0 inf 0\n", "line 13, vertex 2"),
        ("0 0 0\n1 0", "line 11: the file ends"),
        (&format!("{points}3 0 1 7\n"), "line 13: it refers to vertex 7, but there are 3"),
        (&format!("{points}3 0 1 1.5\n"), "line 13: 1.5 is no place in a list"),
        (&format!("{points}3 0\n1 -2\n"), "line 14: -2 is no place"),
    ] {
        let error = read(format!("{head}{body}").as_bytes(), Format::Ply).unwrap_err().to_string();
        assert!(error.contains(place), "{body}: {error}");
    }
    assert_eq!(read(format!("{head}{points}3 0 1 2").as_bytes(), Format::Ply).unwrap().things.len(), 1);
}

#[test]
fn messages_name_the_buffer_of_a_gltf_file() {
    let file = |buffers: &str| {
        format!(
            r#"{{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],
               "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
               "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}}],
               "bufferViews":[{{"buffer":1,"byteLength":36}}],"buffers":{buffers}}}"#
        )
    };
    let empty = r#"{"byteLength":0,"uri":"data:;base64,"}"#;
    for (buffers, wanted) in [
        (format!("[{empty},{{}}]"), "buffer 1: its bytes are not in the file"),
        (format!(r#"[{empty},{{"name":"points"}}]"#), "buffer 1 'points': its bytes"),
        (format!(r#"[{empty},{{"uri":"data:;base64,%%"}}]"#), "buffer 1: Invalid"),
        (format!(r#"[{empty},{{"name":"p","uri":"data:,x"}}]"#), "buffer 1 'p': data that is not in base 64"),
        (format!(r#"[{empty},{{"name":"p","uri":"p.bin"}}]"#), "buffer 1 'p': "),
        (format!("[{empty},{empty}]"), "accessor 0: its bytes are beyond the end of buffer 1"),
        (format!("[{empty}]"), "accessor 0: its bytes are in buffer 1, which is not there"),
    ] {
        let error = read(file(&buffers).as_bytes(), Format::Gltf).unwrap_err().to_string();
        assert!(error.contains(wanted), "{buffers}: {error}");
    }
}

/// A shapefile of records with these bytes.
fn shapefile(records: &[Vec<u8>]) -> Vec<u8> {
    let length = 100 + records.iter().map(|record| 8 + record.len()).sum::<usize>();
    let mut file: Vec<u8> = 9994_i32.to_be_bytes().to_vec();
    file.extend([0; 20]);
    file.extend((length as i32 / 2).to_be_bytes());
    file.extend([1000_i32, 5].into_iter().flat_map(i32::to_le_bytes));
    file.extend([0.0_f64, 0.0, 4.0, 4.0, 0.0, 0.0, 0.0, 0.0].into_iter().flat_map(f64::to_le_bytes));
    for (k, record) in records.iter().enumerate() {
        file.extend((k as i32 + 1).to_be_bytes());
        file.extend((record.len() as i32 / 2).to_be_bytes());
        file.extend(record);
    }
    file
}

/// Shapefiles of one polygon, and of every kind of shape that is read.
fn maps() -> [Vec<u8>; 2] {
    let record = |kind: i32, counts: &[i32], numbers: &[f64]| {
        let mut body: Vec<u8> = kind.to_le_bytes().to_vec();
        if !counts.is_empty() {
            body.extend([0.0_f64, 0.0, 4.0, 4.0].into_iter().flat_map(f64::to_le_bytes));
        }
        body.extend(counts.iter().flat_map(|n| n.to_le_bytes()));
        body.extend(numbers.iter().flat_map(|x| x.to_le_bytes()));
        body
    };
    let corners = [0.0, 0.0, 0.0, 4.0, 4.0, 4.0, 4.0, 0.0, 0.0, 0.0];
    let polygon = record(5, &[1, 5, 0], &corners);
    let all = [
        record(1, &[], &[1.0, 2.0]),
        record(11, &[], &[1.0, 2.0, 3.0, 0.0]),
        record(18, &[1], &[5.0, 6.0, 7.0, 7.0, 7.0]),
        record(3, &[2, 5, 0, 2], &corners),
        record(15, &[1, 3, 0], &[0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 9.0, 9.0, 9.0, 9.0, 9.0]),
        polygon.clone(),
    ];
    [shapefile(&[polygon]), shapefile(&all)]
}

/// Four atoms and their bonds, and the same twice, as models.
fn molecules() -> [Vec<u8>; 2] {
    let atom = |k: i32| {
        let x = f64::from(k) * 1.5;
        format!("ATOM  {k:5}  C   ALA A   1    {x:8.3}{x:8.3}{x:8.3}  1.00  0.00           C1-\n")
    };
    let atoms: String = (1..5).map(atom).collect();
    let bonds = "CONECT    1    2\nCONECT    2    3\nCONECT    3    4\nEND\n";
    let models = format!("MODEL        1\n{atoms}ENDMDL\nMODEL        2\n{atoms}ENDMDL\n{bonds}");
    [format!("{atoms}{bonds}").into_bytes(), models.into_bytes()]
}

/// Damages a file in a few places.
fn damaged(sound: &[u8], random: &mut impl FnMut() -> usize) -> Vec<u8> {
    const ODD: [&[u8]; 8] =
        [&[0xff; 4], &[0xff, 0xff, 0xff, 0x7f], &[0; 8], b"NaN", b"1e999", b"99999", b"-", b"CONECT"];
    let mut file = sound.to_vec();
    for _ in 0..1 + random() % 4 {
        let at = random() % (file.len() + 1);
        match random() % 5 {
            0 => file.truncate(at),
            1 => file.splice(at..at, ODD[random() % ODD.len()].iter().copied()).for_each(drop),
            2 => {
                let odd = ODD[random() % ODD.len()];
                let end = (at + odd.len()).min(file.len());
                file.splice(at..end, odd.iter().copied()).for_each(drop);
            }
            3 => {
                let piece = file[at..(at + random() % 80).min(file.len())].to_vec();
                file.splice(at..at, piece).for_each(drop);
            }
            _ => {
                if let Some(byte) = file.get_mut(at) {
                    *byte ^= 1 << (random() % 8);
                }
            }
        }
    }
    file
}

/// Reads damaged shapefiles and molecules, so many of each. Other seeds damage them otherwise.
fn read_damaged(count: usize, seed: u64) {
    let mut state = 88_172_645_463_325_252_u64 ^ seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let mut random = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state as usize
    };
    let (maps, molecules) = (maps(), molecules());
    let read = maps.each_ref().map(|map| shp::read(map).unwrap());
    assert_eq!(
        read.each_ref().map(|map| (map.points.len(), map.lines.len(), map.polygons.len())),
        [(0, 0, 1), (3, 2, 2)]
    );
    assert!(read.iter().all(|map| map.left_out.is_empty()));
    let read = molecules.each_ref().map(|molecule| pdb::read(molecule).unwrap());
    assert_eq!(
        read.each_ref().map(|molecule| (molecule.atoms.len(), molecule.bonds.len())),
        [(4, 3), (8, 6)]
    );
    for k in 0..count {
        let file = damaged(&maps[k % 2], &mut random);
        if let Ok(map) = shp::read(&file) {
            let lines = map.lines.iter().chain(map.polygons.iter().flatten()).map(Vec::len).sum::<usize>();
            assert!((map.points.len() + lines) * 16 <= file.len(), "{file:?}");
        }
        let file = damaged(&molecules[k % 2], &mut random);
        if let Ok(molecule) = pdb::read(&file) {
            let text = String::from_utf8_lossy(&file);
            assert!(molecule.atoms.iter().all(|atom| atom.point.is_finite()), "{text}");
            assert!(molecule.bonds.iter().all(|[a, b]| a < b && *b < molecule.atoms.len()), "{text}");
        }
    }
}

#[test]
fn damaged_maps_and_molecules_end_well() {
    read_damaged(5_000, 0);
}

/// As the targets in `fuzz/`, where there is no fuzzer: some minutes, or as many seeds as `KATYDID_SEEDS` says.
#[test]
#[ignore = "it takes minutes"]
fn many_damaged_maps_and_molecules_end_well() {
    let seeds = std::env::var("KATYDID_SEEDS").ok().and_then(|n| n.parse().ok()).unwrap_or(200_u64);
    (1..=seeds).for_each(|seed| read_damaged(100_000, seed));
}
