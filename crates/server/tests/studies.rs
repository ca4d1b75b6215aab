//! What moves a result, inputs for a wanted one, and how places move: asked as the page asks.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use common::{Client, Studio, is_done, refusal};
use katydid_session::protocol::{
    Ask, Control, EffectsView, Event, InputPlace, ItemPlace, MotionView, SlopeView, Solved, Target, Want,
};

/// A circle of points; the last output is one number, the volume of a cylinder over it.
const TOWER: &str = r#"katydid 1
r = Number Slider(2.0000, 0.5000..10.0000)
h = Number Slider(3.0000, 1.0000..9.0000)
n = Number Slider(4, 1..8)
volume = Expression("3*r^2*h + n", r = r, h = h, n = n)
x = Series(0, r, n)
p = Construct Point(x, h, 0)
"#;

impl Ready {
    async fn start() -> Self {
        let studio = Studio::start().await;
        let client = studio.with(TOWER).await;
        Self { studio, client }
    }

    fn target(&self, name: &str, item: Option<(&str, u32)>) -> Target {
        let output = self.client.objects[&self.client.named(name)].outputs[0].id;
        Target {
            within: Vec::new(),
            output,
            item: item.map(|(path, index)| ItemPlace { path: path.to_owned(), index }),
        }
    }

    fn input(&self, name: &str) -> InputPlace {
        InputPlace { within: Vec::new(), object: self.client.named(name), gene: None }
    }

    fn value(&self, name: &str) -> f64 {
        match &self.client.objects[&self.client.named(name)].control {
            Some(Control::Slider { value, .. }) => *value,
            other => panic!("{other:?}"),
        }
    }

    async fn effects(&mut self, ranges: bool) -> EffectsView {
        let target = self.target("volume", None);
        match self.client.ask(Ask::Effects { target, with: None, ranges }).await {
            Event::Effects { effects, .. } => effects,
            other => panic!("{other:?}"),
        }
    }

    async fn solve_for(
        &mut self,
        target: Target,
        numbers: &[f64],
        with: Option<Vec<InputPlace>>,
        gesture: u64,
    ) -> Result<Solved, String> {
        let wants = vec![Want { target, numbers: numbers.to_vec() }];
        match self.client.ask(Ask::SolveFor { wants, with, quick: false, gesture }).await {
            Event::Solved { solved, .. } => Ok(solved),
            other => Err(refusal(&other).to_owned()),
        }
    }
}

struct Ready {
    studio: Studio,
    client: Client,
}

#[tokio::test(flavor = "multi_thread")]
async fn effects_are_those_worked_by_hand() {
    let mut ready = Ready::start().await;
    let effects = ready.effects(false).await;
    assert_eq!(effects.value, 40.0);
    assert!(effects.ranged.is_empty());
    let slope = |name: &str| {
        let input = ready.input(name);
        effects.here.iter().find(|here| here.input == input).unwrap().slope
    };
    // 6 r h, 3 r², and a step of a whole number.
    for (name, expected) in [("r", 36.0), ("h", 12.0)] {
        let SlopeView::Even { by } = slope(name) else { panic!("{:?}", slope(name)) };
        assert!(
            (by.value - expected).abs() < 1e-6 * expected && by.error < 1e-6 * expected,
            "{name}: {by:?}"
        );
    }
    assert_eq!(slope("n"), SlopeView::Steps { step: 1.0, down: Some(-1.0), up: Some(1.0) });
    let effects = ready.effects(true).await;
    let shares: Vec<f64> = effects.ranged.iter().map(|one| one.share.unwrap().total[0]).collect();
    // The volume goes with the square of r, from 0.5 to 10: that makes the most by far.
    assert!(shares[0] > 0.6 && shares[2] < 0.01 && effects.points[1] == 0, "{shares:?} {:?}", effects.points);
    ready.studio.server.stop().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn sliders_go_where_a_result_is_wanted_and_undo_takes_all_back() {
    let mut ready = Ready::start().await;
    let solved = ready.solve_for(ready.target("volume", None), &[100.0], None, 1).await.unwrap();
    assert!(solved.off < 0.02, "{solved:?}");
    // 3 r² h = 96, to the four digits of the sliders.
    let (r, h) = (ready.value("r"), ready.value("h"));
    assert!((3.0 * r * r * h - 96.0).abs() < 0.02 && ready.value("n") == 4.0, "{r} {h}");
    assert_eq!(solved.inputs.len(), 2, "whole numbers stay: {solved:?}");
    assert!(is_done(&ready.client.ask(Ask::Undo).await));
    assert_eq!([ready.value("r"), ready.value("h")], [2.0, 3.0], "one step of undo for both");
}

#[tokio::test(flavor = "multi_thread")]
async fn one_point_of_several_is_brought_where_it_is_dragged() {
    let mut ready = Ready::start().await;
    // The third point is (2 r, h, 0).
    let third = ready.target("p", Some(("{0;0}", 2)));
    let solved = ready.solve_for(third.clone(), &[7.0, 5.0, 0.0], None, 1).await.unwrap();
    assert!(solved.off < 2e-4, "{solved:?}");
    assert!((ready.value("r") - 3.5).abs() < 2e-4 && (ready.value("h") - 5.0).abs() < 2e-4);
    // With h alone, only the height follows.
    let with = Some(vec![ready.input("h")]);
    let solved = ready.solve_for(third, &[0.0, 6.0, 0.0], with, 2).await.unwrap();
    assert!((solved.off - 7.0).abs() < 2e-3 && (ready.value("h") - 6.0).abs() < 2e-4, "{solved:?}");
}

#[tokio::test(flavor = "multi_thread")]
async fn a_gesture_that_is_taken_back_leaves_no_slider_moved() {
    let mut ready = Ready::start().await;
    let target = ready.target("volume", None);
    for gesture in 1..=8 {
        let wants = vec![Want { target: target.clone(), numbers: vec![100.0] }];
        let found = ready.client.tell(Ask::SolveFor { wants, with: None, quick: false, gesture }).await;
        let back = ready.client.tell(Ask::Abandon { gesture }).await;
        let mut waiting = vec![found, back];
        while !waiting.is_empty() {
            let seq = match ready.client.hear().await {
                // Found before that, it was taken back; else it was ended.
                Some(Event::Refused { seq, reason }) => {
                    assert_eq!((seq, reason.as_str()), (found, "it was ended"));
                    seq
                }
                Some(Event::Solved { seq, .. } | Event::Done { seq, .. }) => seq,
                _ => continue,
            };
            waiting.retain(|other| *other != seq);
        }
        assert_eq!([ready.value("r"), ready.value("h")], [2.0, 3.0], "gesture {gesture}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn places_move_as_the_slider_moves_them() {
    let mut ready = Ready::start().await;
    let input = ready.input("r");
    let MotionView { arrows, left_out } = match ready.client.ask(Ask::Motion { input }).await {
        Event::Motion { motion, .. } => motion,
        other => panic!("{other:?}"),
    };
    assert!(left_out.is_empty());
    // Points k r: the first stands still, the others move by k.
    assert_eq!(arrows.len(), 3);
    for (arrow, k) in arrows.iter().zip([1.0, 2.0, 3.0]) {
        assert_eq!(arrow.at, [2.0 * k, 3.0, 0.0]);
        assert!((arrow.by[0] - k).abs() < 1e-6 && arrow.by[1].abs() < 1e-9, "{arrow:?}");
    }
}

/// A slider inside a cluster, and one outside.
const NESTED: &str = r#"katydid 1
a = Number Slider(3.00, 0.00..5.00)
Box = Cluster(a) -> y inside {
    k = Cluster Input()
    x = Number Slider(0.70, 0.00..2.00)
    f = Expression("k*x^2", k = k, x = x)
    y = Cluster Output(f)
}
volume = Expression("y + 1", y = Box)
"#;

#[tokio::test(flavor = "multi_thread")]
async fn inputs_inside_clusters_are_looked_at_and_moved() {
    let studio = Studio::start().await;
    let client = studio.with(NESTED).await;
    let mut ready = Ready { studio, client };
    let effects = ready.effects(false).await;
    let here: Vec<(&str, usize)> =
        effects.here.iter().map(|here| (here.name.as_str(), here.input.within.len())).collect();
    assert_eq!(here, [("a", 0), ("Box/x", 1)]);
    let SlopeView::Even { by } = effects.here[1].slope else { panic!("{:?}", effects.here[1]) };
    assert!((by.value - 4.2).abs() < 4.2e-6, "{by:?}");
    let input = effects.here[1].input.clone();
    assert_eq!(input.within, [ready.client.named("Box")]);
    let target = ready.target("volume", None);
    let solved = ready.solve_for(target.clone(), &[3.0 * 1.44 + 1.0], Some(vec![input.clone()]), 1).await;
    assert!(solved.unwrap().off < 1e-9);
    let inner = match ready.client.ask(Ask::Effects { target, with: Some(vec![input]), ranges: false }).await
    {
        Event::Effects { effects, .. } => effects,
        other => panic!("{other:?}"),
    };
    assert!((inner.value - 5.32).abs() < 1e-9 && (inner.here[0].at - 1.2).abs() < 1e-12, "{inner:?}");
    assert!(is_done(&ready.client.ask(Ask::Undo).await));
    assert!((ready.effects(false).await.value - 2.47).abs() < 1e-9, "one step of undo");
}

#[tokio::test(flavor = "multi_thread")]
async fn what_cannot_be_asked_is_refused_by_name() {
    let mut ready = Ready::start().await;
    let volume = ready.target("volume", None);
    let several = ready.target("p", None);
    let nothing = Target { within: Vec::new(), output: uuid::Uuid::from_u128(7), item: None };
    let far = ready.target("p", Some(("{0;0}", 99)));
    let odd = ready.target("p", Some(("{x", 0)));
    for (target, numbers, why) in [
        (volume.clone(), vec![1.0, 2.0], "numbers"),
        (nothing, vec![1.0], "no such output"),
        (far, vec![1.0, 2.0, 3.0], "no numbers"),
        (odd, vec![1.0, 2.0, 3.0], "no path"),
        (several, vec![1.0], "numbers"),
    ] {
        let refused = ready.solve_for(target, &numbers, None, 1).await.unwrap_err();
        assert!(refused.contains(why), "{refused} for {why}");
    }
    let whole = ready.input("n");
    let refused = ready.solve_for(volume, &[50.0], Some(vec![whole.clone()]), 1).await.unwrap_err();
    assert!(refused.contains("'n' takes whole numbers"), "{refused}");
    let refused = refusal(&ready.client.ask(Ask::Motion { input: whole }).await).to_owned();
    assert!(refused.contains("'n' takes whole numbers"), "{refused}");
    assert!(is_done(&ready.client.ask(Ask::EndStudy).await));
    assert_eq!([ready.value("r"), ready.value("h")], [2.0, 3.0], "nothing has moved");
}
