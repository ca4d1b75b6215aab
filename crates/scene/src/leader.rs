//! Leaders: arrows with a text at their end.

use katydid_3dm::{Annotation, AnnotationKind};
use katydid_geometry::Point3;

use crate::Form;

/// The height of texts in the style that a model begins with, in its units.
const HEIGHT: f64 = 1.0;

/// A leader as the head of its arrow, its line and its text; none for another annotation.
///
/// Its style stands in a model, which is not known here: the text has the height of the style that models begin with.
pub(crate) fn of(annotation: &Annotation) -> Option<Vec<Form>> {
    let AnnotationKind::Leader { points } = &annotation.kind else { return None };
    let frame = annotation.plane.frame;
    let path: Vec<Point3> = points.iter().map(|p| frame.at(p.x, p.y, 0.0)).collect();
    let ([tip, behind, ..], [.., before, end]) = (path.as_slice(), path.as_slice()) else {
        return Some(Vec::new());
    };
    let mut forms = vec![Form::Tip(*tip, *tip - *behind)];
    let text = annotation.plain_text();
    if !text.is_empty() {
        // The text goes on where the line ends: to the left of it when it runs to the left.
        let (side, justification) =
            if (*end - *before).dot(frame.x_axis) < 0.0 { (-0.5, 6) } else { (0.5, 4) };
        let plane = frame.with_origin(*end + frame.x_axis * (side * HEIGHT));
        forms.push(Form::Writing { plane, text, size: HEIGHT, justification });
    }
    forms.push(Form::Lines(path));
    Some(forms)
}

#[cfg(test)]
mod tests {
    use katydid_3dm::{StoredPlane, TextContent};
    use katydid_geometry::{Plane, Point2, Vector2};

    use super::*;

    fn leader(points: &[[f64; 2]], text: &str) -> Annotation {
        Annotation {
            kind: AnnotationKind::Leader { points: points.iter().map(|p| Point2::new(p[0], p[1])).collect() },
            text: TextContent::new(text),
            style: Default::default(),
            overrides: None,
            plane: StoredPlane { frame: Plane::XY.with_origin(Point3::new(0.0, 0.0, 5.0)), equation: None },
            horizontal: Vector2::X,
            scales_text: true,
        }
    }

    #[test]
    fn a_leader_points_and_says() {
        let forms = of(&leader(&[[0.0, 0.0], [2.0, 2.0], [4.0, 2.0]], "here")).unwrap();
        let [Form::Tip(tip, way), Form::Writing { plane, text, justification, .. }, Form::Lines(path)] =
            forms.as_slice()
        else {
            panic!("{forms:?}");
        };
        assert_eq!((*tip, path.len()), (Point3::new(0.0, 0.0, 5.0), 3));
        assert!(way.x < 0.0 && way.y < 0.0);
        assert_eq!((text.as_str(), *justification), ("here", 4));
        assert_eq!(plane.origin, Point3::new(4.5, 2.0, 5.0));
        let left = of(&leader(&[[0.0, 0.0], [-3.0, 0.0]], "there")).unwrap();
        assert!(matches!(&left[1], Form::Writing { justification: 6, .. }));
        assert_eq!(of(&leader(&[[0.0, 0.0], [1.0, 0.0]], "")).unwrap().len(), 2);
        assert!(of(&leader(&[[0.0, 0.0]], "no way")).unwrap().is_empty());
        assert!(of(&Annotation { kind: AnnotationKind::Text, ..leader(&[], "") }).is_none());
    }
}
