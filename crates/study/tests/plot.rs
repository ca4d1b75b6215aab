//! Plots as SVG: each point has its mark, and columns are found by their names.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail loudly")]

use std::fs;
use std::path::Path;

use katydid_study::{Goal, Plot, PlotOptions, StudyFolder, plot};
use quick_xml::Reader;
use quick_xml::events::Event;

/// Twenty points: `a` from 0 to 19, `b` its square, `c` falling, `kind` one of two words; the last four without results.
fn folder(at: &Path) -> StudyFolder {
    let mut text = "in:a,in:kind,out:b,out:c,status,reason\n".to_owned();
    for a in 0..20 {
        let kind = if a % 2 == 0 { "even" } else { "odd" };
        let row = if a < 16 {
            format!("{a},{kind},{},{},ok,\n", a * a, 40 - a)
        } else {
            format!("{a},{kind},,,error,why\n")
        };
        text.push_str(&row);
    }
    opened(at, &text)
}

fn opened(at: &Path, text: &str) -> StudyFolder {
    fs::write(at.join("data.csv"), text).unwrap();
    let mut folder = StudyFolder::open(at, 1000).unwrap();
    folder.refresh().unwrap();
    folder
}

/// The names of the elements of a picture with their attributes, and its texts.
#[derive(Default)]
struct Drawn {
    elements: Vec<(String, Vec<(String, String)>)>,
    texts: Vec<String>,
}

impl Drawn {
    fn count(&self, name: &str) -> usize {
        self.elements.iter().filter(|(found, _)| found == name).count()
    }

    fn says(&self, text: &str) -> bool {
        self.texts.iter().any(|found| found == text)
    }
}

fn named(x: &str, y: &str) -> PlotOptions {
    PlotOptions { x: Some(x.to_owned()), y: Some(y.to_owned()), ..PlotOptions::default() }
}

fn drawn(folder: &StudyFolder, which: Plot, options: &PlotOptions) -> Drawn {
    let text = plot(folder, which, options).unwrap();
    let mut reader = Reader::from_str(&text);
    let (mut found, mut open) = (Drawn::default(), 0);
    loop {
        let event = reader.read_event().unwrap_or_else(|error| panic!("{error}: {text}"));
        match &event {
            Event::Start(element) | Event::Empty(element) => {
                open += i32::from(matches!(event, Event::Start(_)));
                let name = element.name().as_ref().to_owned();
                let attributes = element.attributes().map(|attribute| {
                    let attribute = attribute.unwrap();
                    let [key, value] = [attribute.key.as_ref(), attribute.value.as_ref()].map(str::to_owned);
                    (key, value)
                });
                found.elements.push((name, attributes.collect()));
            }
            Event::End(_) => open -= 1,
            Event::Text(said) => {
                let said = said.as_ref().trim().to_owned();
                found.texts.extend((!said.is_empty()).then_some(said));
            }
            Event::Eof => break,
            _ => {}
        }
    }
    assert_eq!(open, 0, "{text}");
    assert_eq!(found.elements[0].0, "svg");
    found
}

#[test]
fn a_scatter_has_a_circle_for_each_point_and_says_which_have_none() {
    let at = tempfile::tempdir().unwrap();
    let folder = folder(at.path());
    let text = drawn(&folder, Plot::Scatter, &named("a", "b"));
    assert_eq!(text.count("circle"), 16);
    assert!(text.says("b over a"), "{:?}", text.texts);
    assert!(
        text.says("20 points, 4 of these without results; 4 have no value here and are not drawn"),
        "{:?}",
        text.texts
    );
    // Inputs are known where results are not: those points are crosses, two lines each.
    let plain =
        drawn(&opened(at.path(), "in:a,in:b\n0,0\n19,19\n"), Plot::Scatter, &named("a", "b")).count("line");
    let failed = "in:a,in:b,out:c,status\n0,0,1,ok\n19,19,,error\n";
    let text = drawn(&opened(at.path(), failed), Plot::Scatter, &named("a", "b"));
    assert_eq!((text.count("circle"), text.count("line")), (1, plain + 2));
    // Words stand on an axis too.
    let folder = self::folder(at.path());
    let text = drawn(
        &folder,
        Plot::Scatter,
        &PlotOptions { colour: Some("c".to_owned()), ..named("kind", "out.b") },
    );
    assert_eq!(text.count("circle"), 16);
    assert!(["even", "odd", "c"].iter().all(|word| text.says(word)), "{:?}", text.texts);
}

#[test]
fn parallel_coordinates_have_a_line_for_each_point() {
    let at = tempfile::tempdir().unwrap();
    let text = drawn(&folder(at.path()), Plot::Parallel, &PlotOptions::default());
    let corners =
        |points: &(String, String)| points.0 == "points" && points.1.split_whitespace().count() == 4;
    let lines = text.elements.iter().filter(|(name, given)| name == "polyline" && given.iter().any(corners));
    assert_eq!(lines.count(), 16);
    for word in ["a", "kind", "b", "c", "no value", "even", "input", "output"] {
        assert!(text.says(word), "{word}: {:?}", text.texts);
    }
}

#[test]
fn the_bars_of_a_histogram_hold_all_points() {
    let at = tempfile::tempdir().unwrap();
    let options = PlotOptions { x: Some("b".to_owned()), ..PlotOptions::default() };
    let text = drawn(&folder(at.path()), Plot::Histogram, &options);
    // Six bars for sixteen points; over each one stands how many it holds. The ground is a rectangle too.
    let squares: Vec<f64> = (0..16).map(|a| f64::from(a * a)).collect();
    let (low, high) = (-0.03 * 225.0, 1.03 * 225.0);
    let mut wanted = [0; 6];
    for x in squares {
        wanted[((x - low) / (high - low) * 6.0) as usize] += 1;
    }
    assert_eq!(text.count("rect"), 1 + wanted.iter().filter(|count| **count > 0).count());
    for count in wanted.iter().filter(|count| **count > 0) {
        assert!(text.says(&count.to_string()), "{count}: {:?}", text.texts);
    }
    let words = PlotOptions { x: Some("kind".to_owned()), ..PlotOptions::default() };
    assert_eq!(drawn(&folder(at.path()), Plot::Histogram, &words).count("rect"), 3);
}

#[test]
fn a_front_marks_what_no_other_is_better_than() {
    let at = tempfile::tempdir().unwrap();
    let folder = folder(at.path());
    let goal = |name: &str, goal| (name.to_owned(), goal);
    // b rises and c falls with a: small b against small c is everybody; large c too is the first alone.
    for (second, front) in [(Goal::Least, 16), (Goal::Most, 1)] {
        let goals = vec![goal("b", Goal::Least), goal("c", second)];
        let text = drawn(&folder, Plot::Front, &PlotOptions { goals, ..PlotOptions::default() });
        assert_eq!((text.count("polygon"), text.count("circle")), (front, 16 - front));
    }
    let why = plot(&folder, Plot::Front, &PlotOptions::default()).unwrap_err().to_string();
    assert!(why.contains("--minimise"), "{why}");
}

#[test]
fn a_column_that_is_not_there_is_named_with_those_that_are() {
    let at = tempfile::tempdir().unwrap();
    let folder = opened(at.path(), "in:height,out:Area,out:Volume,in:size,out:size\n1,2,3,4,5\n");
    let why = |options: &PlotOptions| plot(&folder, Plot::Scatter, options).unwrap_err().to_string();
    let unknown = why(&named("height", "Aera"));
    assert!(unknown.contains("'Aera'") && unknown.contains("do you mean 'Area'?"), "{unknown}");
    assert!(unknown.contains("height, Area, Volume"), "{unknown}");
    let far = why(&named("height", "zzzzzzzzzz"));
    assert!(far.contains("no column 'zzzzzzzzzz'. It has height"), "{far}");
    assert!(why(&named("size", "Area")).contains("in.size or out.size"));
    assert_eq!(drawn(&folder, Plot::Scatter, &named("in:size", "out.size")).count("circle"), 1);
    let empty = tempfile::tempdir().unwrap();
    let mut none = StudyFolder::open(empty.path(), 9).unwrap();
    none.refresh().unwrap();
    assert!(
        plot(&none, Plot::Parallel, &PlotOptions::default()).unwrap_err().to_string().contains("no point")
    );
}

#[test]
fn names_and_numbers_of_any_kind_are_drawn_or_refused() {
    let at = tempfile::tempdir().unwrap();
    let hostile =
        "in:<script>&\"'\u{1},out:]]>,status\n1,NaN,ok\n1e308,-1e308,ok\n-1e308,inf,<b>\n,,\n5e-324,7,ok\n";
    let folder = opened(at.path(), hostile);
    for which in [Plot::Parallel, Plot::Scatter, Plot::Histogram] {
        let text = drawn(&folder, which, &PlotOptions::default());
        assert!(text.elements.iter().all(|(name, _)| name != "script" && name != "b"));
    }
    let one = opened(at.path(), "out:x\n3\n3\n");
    for which in [Plot::Parallel, Plot::Scatter, Plot::Histogram] {
        drawn(&one, which, &PlotOptions::default());
    }
    let words = opened(at.path(), "out:x\nword\n");
    assert!(plot(&words, Plot::Scatter, &PlotOptions::default()).is_err());
}
