//! Bytes that nobody vouches for: an error or a document, never a panic, and never for long.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

use katydid_geometry::{Brep, Cylinder, Interval, Plane, Point3, Sphere};
use katydid_step::{Document, Part, Shape, read, write};
use proptest::prelude::*;

fn sample() -> Vec<u8> {
    let ball = Brep::from_surface(Sphere::around(Point3::ORIGIN, 5.0).unwrap().into()).unwrap();
    let pipe = Cylinder::new(Plane::XY, 2.0, Interval::new(0.0, 3.0)).unwrap();
    let pipe = Brep::from_surface(pipe.into()).unwrap();
    let parts = [ball, pipe].map(|brep| Part::named("part", Shape::Brep(brep.into()))).to_vec();
    let mut file = Vec::new();
    write(&Document { parts, ..Document::default() }, &mut file).unwrap();
    file
}

fn data(text: &str) -> String {
    format!("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n{text}\nENDSEC;\nEND-ISO-10303-21;\n")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn cut_files_are_errors_or_less(share in 0.0..1.0_f64) {
        let file = sample();
        let end = (file.len() as f64 * share) as usize;
        let _ = read(&file[..end]);
    }

    #[test]
    fn flipped_bytes_are_errors_or_something_else(
        flips in prop::collection::vec((0.0..1.0_f64, any::<u8>()), 1..8),
    ) {
        let mut file = sample();
        for (share, byte) in flips {
            let place = (file.len() as f64 * share) as usize;
            file[place] = byte;
        }
        let _ = read(&file);
    }

    #[test]
    fn references_that_lead_elsewhere_do_no_harm(swaps in prop::collection::vec((0..200_u64, 0..200_u64), 1..6)) {
        let mut text = String::from_utf8(sample()).unwrap();
        for (a, b) in swaps {
            text = text.replace(&format!("#{a},"), &format!("#{b},"));
            text = text.replace(&format!("#{a})"), &format!("#{b})"));
        }
        let _ = read(text.as_bytes());
    }
}

#[test]
fn what_is_wrong_is_told_by_entity() {
    let told = |items: &str| {
        let text = data(&format!(
            "#1=SHAPE_REPRESENTATION('',(#2),#9);\n#9=(GEOMETRIC_REPRESENTATION_CONTEXT(3)REPRESENTATION_CONTEXT('',''));\n{items}"
        ));
        let document = read(text.as_bytes()).unwrap();
        assert!(document.parts.is_empty());
        document
            .left_out
            .iter()
            .map(|one| format!("{}: {}", one.what, one.why))
            .collect::<Vec<_>>()
            .join("; ")
    };
    assert_eq!(told(""), "item: #2: it is named, but does not exist");
    assert!(told("#2=MANIFOLD_SOLID_BREP('',#3);\n#3=CLOSED_SHELL('',(#2));").contains("#2: "));
    assert!(told("#2=MANIFOLD_SOLID_BREP('',7);").contains("names no entity"));
    assert!(told("#2=TRIMMED_CURVE('',#2,(0.),(1.),.T.,.PARAMETER.);").contains("in a circle"));
    assert!(told("#2=ICE_CREAM('',7);").contains("not supported"));
    assert!(told("#2=CARTESIAN_POINT('',(1.E308,1.E308,'x'));").contains("no number"));
    let knots =
        "#2=B_SPLINE_CURVE_WITH_KNOTS('',3,(#3,#3),.UNSPECIFIED.,.F.,.F.,(99999999999),(0.),.UNSPECIFIED.);";
    assert!(told(&format!("{knots}\n#3=CARTESIAN_POINT('',(0.,0.,0.));")).contains("too few"));
}

#[test]
fn assemblies_in_a_circle_end() {
    let text = data(
        "#1=SHAPE_REPRESENTATION('a',(#5,#6),#9);\n#2=SHAPE_REPRESENTATION('b',(#5,#7),#9);\n\
         #3=REPRESENTATION_MAP(#5,#1);\n#4=REPRESENTATION_MAP(#5,#2);\n\
         #5=AXIS2_PLACEMENT_3D('',#8,$,$);\n#6=MAPPED_ITEM('',#4,#5);\n#7=MAPPED_ITEM('',#3,#5);\n\
         #8=CARTESIAN_POINT('',(0.,0.,0.));\n#10=SHAPE_REPRESENTATION('c',(#6),#9);\n\
         #9=(GEOMETRIC_REPRESENTATION_CONTEXT(3)REPRESENTATION_CONTEXT('',''));",
    );
    let document = read(text.as_bytes()).unwrap();
    assert!(document.parts.is_empty());
    assert!(document.left_out.iter().any(|one| one.why.contains("holds itself")), "{:?}", document.left_out);
}
