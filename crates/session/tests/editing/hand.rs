//! What only a hand does: a particle of a solver is dragged, and the document is as it was.

use katydid_data::Value;
use katydid_definition::kd;
use katydid_geometry::Point3;
use katydid_session::protocol::{Edit, HeldPoint, ObjectChange, Setting};
use katydid_session::{Refusal, Registry};
use katydid_solver::Options;
use uuid::Uuid;

use crate::common::Studio;

const ROPE: &str = "katydid 1
rope = Line((0, 0, 0), (8, 0, 0)) hidden
points = Divide Curve(rope, 8) -> Points |hidden
chain = PolyLine(points) hidden
links = Explode(chain) hidden
springs = `Length(Line)`(links.Segments, 1.1, 20)
weight = Load(points, (0, 0, -1))
held = Anchor([(0, 0, 0), (8, 0, 0)]) hidden
grab = Grab()
solved = Solver([springs, weight, held, grab.Goal])
";

struct Rope {
    studio: Studio,
    grab: Uuid,
}

impl Rope {
    fn new() -> Self {
        katydid_components::link();
        let mut studio = Studio::new(kd::read(ROPE, &Registry).unwrap().document);
        let options = Options { kept: Some(Default::default()), ..Options::default() };
        *studio.engine.options_mut() = options;
        let grab =
            studio.editor.document().objects.iter().find(|object| object.title() == "grab").unwrap().id;
        Self { studio, grab }
    }

    /// As the server and the page's own engine do it.
    fn hold(&mut self, held: Option<HeldPoint>) {
        let difference = self.studio.editor.grab(self.grab, held, &[]).unwrap();
        self.studio.engine.apply(&difference).unwrap();
        difference.put.iter().for_each(|(at, _)| self.studio.engine.expire(*at));
    }

    fn points(&mut self) -> Vec<Point3> {
        self.studio.engine.solve();
        let objects = &self.studio.editor.document().objects;
        let at = objects.iter().position(|object| object.title() == "solved").unwrap();
        let vertices = self.studio.engine.report(at).unwrap().outputs[1].column();
        vertices.iter().map(|v| if let Some(Value::Point(p)) = v { p } else { panic!("{v:?}") }).collect()
    }
}

fn held(from: Point3, to: Point3) -> Option<HeldPoint> {
    Some(HeldPoint { from: [from.x, from.y, from.z], to: [to.x, to.y, to.z], reach: 0.1 })
}

#[test]
fn a_dragged_particle_follows_and_nothing_is_kept() {
    let mut rope = Rope::new();
    let before = rope.studio.editor.document().to_gh().unwrap();
    let rest = rope.points();
    let low = (0..rest.len()).min_by(|a, b| rest[*a].z.total_cmp(&rest[*b].z)).unwrap();
    let to = rest[low] + katydid_geometry::Vector3::new(0.0, 0.5, 2.0);
    for _ in 0..200 {
        rope.hold(held(rest[low], to));
        rope.points();
    }
    let dragged = rope.points();
    assert!(dragged[low].distance_to(to) < 0.1, "{:?} {to:?}", dragged[low]);
    let editor = &rope.studio.editor;
    assert!(editor.revision() == 0 && !editor.is_changed() && editor.undo_name().is_none());
    assert_eq!(editor.document().to_gh().unwrap(), before);
    rope.hold(None);
    let back = rope.points();
    let far = back.iter().zip(&rest).map(|(a, b)| a.distance_to(*b)).fold(0.0, f64::max);
    assert!(far < 1e-4, "{far}");
    assert_eq!(rope.studio.engine.document(), &**rope.studio.editor.document());
}

#[test]
fn what_is_edited_meanwhile_lets_go() {
    let mut rope = Rope::new();
    let rest = rope.points();
    rope.hold(held(rest[3], rest[3] + katydid_geometry::Vector3::new(0.0, 0.0, 2.0)));
    assert!(rope.points()[3].distance_to(rest[3]) > 0.5);
    let rename = ObjectChange::Nickname { text: "hand".to_owned() };
    rope.studio.make(Edit::Change { objects: vec![rope.grab], change: rename });
    let far = rope.points()[3].distance_to(rest[3]);
    assert!(far < 1e-4, "{far}");
}

#[test]
fn nonsense_is_refused_by_name() {
    let mut rope = Rope::new();
    let solver = rope.studio.editor.document().objects.last().unwrap().id;
    let editor = &rope.studio.editor;
    let good = HeldPoint { from: [0.0; 3], to: [1.0; 3], reach: 1.0 };
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for bad in [
            HeldPoint { from: [x, 0.0, 0.0], ..good },
            HeldPoint { to: [0.0, 0.0, x], ..good },
            HeldPoint { reach: x, ..good },
        ] {
            let told = editor.grab(rope.grab, Some(bad), &[]).unwrap_err();
            assert_eq!(told, Refusal::Senseless("a number must be finite".to_owned()));
        }
    }
    let nobody = Uuid::from_u128(0xdead);
    assert_eq!(editor.grab(nobody, Some(good), &[]).unwrap_err(), Refusal::NoObject(nobody));
    assert!(editor.grab(solver, None, &[]).unwrap_err().to_string().contains("not a Grab"));
    assert!(editor.grab(rope.grab, Some(good), &[nobody]).is_err());
    // As an edit it changes nothing, and is refused where there is no Grab.
    let set = |object| Edit::Set { object, to: Setting::Grab { held: Some(good) } };
    assert!(rope.studio.editor.apply(&set(rope.grab), None, &[]).unwrap().is_empty());
    assert!(rope.studio.editor.apply(&set(solver), None, &[]).is_err());
    // Numbers that are huge are no fault.
    let far = HeldPoint { from: [1e300; 3], to: [-1e300; 3], reach: 1e308 };
    rope.hold(Some(far));
    assert!(rope.points().iter().all(|p| p.is_finite()));
    rope.hold(Some(HeldPoint { reach: -1.0, ..good }));
    rope.points();
}
