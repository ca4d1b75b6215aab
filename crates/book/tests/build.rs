//! The builder: pages of a small book, its faults, and Katydid's own book.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

use std::path::Path;

use katydid_book::{Book, Files, Site};

const DEFINITION: &str = "katydid 1\n\
    t = Number Slider(0.25, 0..1)\n\
    A = Construct Point(0, 0, 0)\n\
    B = Construct Point(4, 0, 0)\n\
    line = Line(A, B)\n\
    curve = Nurbs Curve([(0, 0, 0), (1, 2, 0), (3, 2, 0), (4, 0, 0)], 3)\n\
    at = Evaluate Curve(curve.Curve |reparameterize, t)\n";

const PAGE: &str = "---\ntitle: One\nsummary: A curve.\n---\n\nLook: {{ drag t }} gives {{ at.P[0].y | fraction }}.\n\n\
    ```figure\nid: main\nview: top\ncontrols: t (ratio)\ndrag: A\ncolours: line = blue\nwidgets: knots curve, basis curve at t\n\
    say: It is at {{ at.P }}.\nalt: A line and a curve.\n```\n\n## Formula\n\n\
    $$\\link{line}{\\vec a} = \\live{at.P[0].x}$$\n\n## Steps\n\n```steps\nobject: at\nalgorithm: de-casteljau\n```\n\n\
    ```predict\nHigher?\n\n( ) Yes\n(x) No\n\n---\n\nNo: $x^2$.\n```\n\n\
    ```exercise\nid: top\ntask: Find the top.\ncheck: at.P[0].y = 1.5 ± 0.001\nhint: In the middle.\nsolution: t = 0.5\n```\n\n\
    ## Sources\n\n- [Somewhere](https://example.org/): a page\n- [Formula](#formula)\n";

fn files(page: &str) -> Files {
    katydid_components::link();
    let mut files = Files::default();
    let contents = "---\ntitle: Book\nsummary: Small.\n---\n\nWords.\n\n## Chapter\n\n- one\n";
    files.put("contents.md", contents.as_bytes().to_vec());
    files.put("one/page.md", page.as_bytes().to_vec());
    files.put("one/definition.kd", DEFINITION.as_bytes().to_vec());
    files
}

fn built(files: Files) -> Result<Site, Vec<String>> {
    let told = |faults: Vec<katydid_book::Fault>| faults.iter().map(ToString::to_string).collect();
    Book::read(files).and_then(|book| book.build()).map_err(told)
}

fn page(site: &Site, path: &str) -> String {
    String::from_utf8(site.files.get(path).unwrap_or_else(|| panic!("{path}")).clone()).unwrap()
}

#[test]
fn a_page_has_values_formulas_stills_and_steps() {
    let site = built(files(PAGE)).unwrap();
    let html = page(&site, "one/index.html");
    // By hand at 1/4: (29/32, 9/8).
    assert!(html.contains(">9/8</span>") && html.contains("(0.91, 1.13, 0)"), "{html}");
    assert!(html.contains("<math") && html.contains("class=\"tie blue\"") && html.contains(">0.91</mtext>"));
    assert!(html.contains("<i>M</i> = 3/4 <i>A</i> + 1/4 <i>B</i> = <b>(1/4, 1/2, 0)</b>"));
    assert!(html.contains("<details><summary>Show the answer</summary>"));
    for name in
        ["one/main.light.svg", "one/main.dark.svg", "files/one/definition.kd", "files/one/definition.kd.svg"]
    {
        assert!(site.files[name].len() > 100, "{name}");
    }
    assert!(page(&site, "index.html").contains("one/index.html"));
    assert!(page(&site, "search.js").starts_with("window.katydidSearch = [[\"one\",\"One\""));
    assert_eq!((site.pages, site.figures), (1, 1));
}

#[test]
fn the_same_files_give_the_same_bytes() {
    assert_eq!(built(files(PAGE)).unwrap(), built(files(PAGE)).unwrap());
}

#[test]
fn every_fault_names_its_line() {
    let cases = [
        (
            "gives {{ at.P[0].y | fraction }}",
            "gives {{ nothing }}",
            "one/page.md:6: the definition has no output 'nothing'",
        ),
        ("{{ drag t }}", "{{ drag line }}", "one/page.md:6: 'line' is no slider"),
        ("controls: t (ratio)", "controls: line", "one/page.md:11: 'line' is no slider and no toggle"),
        ("drag: A", "drag: line", "one/page.md:12: 'line' is no point that can be dragged"),
        ("line = blue", "line = mauve", "one/page.md:13: 'line = mauve': colours are blue"),
        ("view: top", "view: below", "one/page.md:10: view: 'below' is none of"),
        ("alt: A line and a curve.", "caption: x", "one/page.md:8: it has no alt"),
        ("\\vec a}", "\\nosuch a}", "one/page.md:21: formula:"),
        ("{line}{", "{lines}{", "one/page.md:21: formula: the definition has no object 'lines'"),
        ("object: at\n", "object: line\n", "the steps of this object cannot be told"),
        ("algorithm: de-casteljau", "algorithm: newton", "it does not work by newton"),
        ("solution: t = 0.5", "solution: t = 0.4", "the solution does not pass the checks"),
        (
            "= 1.5 ±",
            "= 1.125 ±",
            "the checks hold before anything is done|the solution does not pass the checks",
        ),
        ("(x) No", "( ) No", "one of the choices is right"),
        ("(#formula)", "(#nowhere)", "the page 'one' has no part '#nowhere'"),
        ("(#formula)", "(two)", "there is no page 'two'"),
        ("https://example.org/", "http://example.org/", "links go to https addresses"),
        ("## Sources", "<b>bold</b>", "HTML is not supported"),
        ("title: One", "name: One", "there is no key 'name'"),
        ("id: top", "name: top", "there is no key 'name' here"),
    ];
    for (from, to, expected) in cases {
        assert!(PAGE.contains(from), "{from}");
        let faults = built(files(&PAGE.replacen(from, to, 1))).expect_err(to).join("\n");
        assert!(expected.split('|').any(|one| faults.contains(one)), "{from} → {to}: {faults}");
    }
}

#[test]
fn another_language_has_words_alone() {
    let mut all = files(PAGE);
    all.put("de/contents.md", b"---\ntitle: Buch\nsummary: Klein.\n---\n\n## Kapitel\n\n- one\n".to_vec());
    all.put("de/words.txt", "language = de\nname-of-language = Deutsch\nnext = Weiter\n".as_bytes().to_vec());
    let german = "---\ntitle: Eins\nsummary: Eine Kurve.\n---\n\nWort.\n\n```figure\nid: main\ncontrols: t (Teil)\n\
        say: Sie ist bei {{ at.P }}.\nalt: Eine Linie.\n```\n\n```exercise\nid: top\ntask: Oben?\n```\n";
    all.put("de/one/page.md", german.as_bytes().to_vec());
    let site = built(all).unwrap();
    let html = page(&site, "de/one/index.html");
    assert!(
        html.contains("lang=\"de\"") && html.contains("Sie ist bei") && html.contains("(0.91, 1.13, 0)"),
        "{html}"
    );
    assert!(html.contains("href=\"../../one/index.html\""), "the English page is linked");
    assert!(page(&site, "one/index.html").contains("href=\"../de/one/index.html\""));
    assert_eq!(site.pages, 2);
}

#[test]
fn wild_pages_are_faults_and_never_panics() {
    let texts = [
        "",
        "---",
        "---\n---\n",
        "---\ntitle: a\nsummary: b\n---\n{{ }}",
        "---\ntitle: a\nsummary: b\n---\n```figure\n",
    ];
    for text in texts {
        let _ = built(files(text));
    }
    let wild = "---\ntitle: a\nsummary: b\n---\n{{ \u{e000}9\u{e001} }} \u{e000}7\u{e001} $\\live{$ $$\\link{a$$ {{ a[99999999999999999999].x | 99 }}\n";
    assert!(built(files(wild)).is_err());
    katydid_components::link();
    assert!(Book::read(Files::default()).is_err());
}

/// Katydid's own book builds, and its pages are well-formed where a machine can tell.
#[test]
fn our_own_book() {
    katydid_components::link();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book");
    let site =
        built(Files::folder(&folder).unwrap()).unwrap_or_else(|faults| panic!("{}", faults.join("\n")));
    for (name, bytes) in site.files.iter().filter(|(name, _)| name.ends_with(".svg")) {
        let text = std::str::from_utf8(bytes).unwrap();
        let mut reader = quick_xml::Reader::from_str(text);
        loop {
            match reader.read_event() {
                Ok(quick_xml::events::Event::Eof) => break,
                Ok(_) => {}
                Err(error) => panic!("{name}: {error}"),
            }
        }
    }
    let html = site.files.iter().filter(|(name, _)| name.ends_with(".html"));
    for (name, bytes) in html {
        let text = std::str::from_utf8(bytes).unwrap();
        assert!(!text.contains("rgb(") && !text.contains('\0') && !text.contains("{{ "), "{name}");
        assert_eq!(text.matches("<h1>").count(), 1, "{name}");
    }
}

/// Every row of the book has its page with a figure, a formula or steps, and an exercise; every figure of the guide is on some page.
#[test]
fn no_page_and_no_figure_is_missing() {
    katydid_components::link();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book");
    let files = Files::folder(&folder).unwrap();
    let rows = [("V", 14), ("M", 9), ("C", 10), ("N", 13), ("S", 4)];
    for (letter, count) in rows {
        for number in 1..=count {
            let page = files.get(&format!("{letter}{number}/page.md"));
            let page =
                String::from_utf8(page.unwrap_or_else(|| panic!("{letter}{number}")).to_vec()).unwrap();
            for part in ["```figure", "```exercise", "```predict", "## Sources"] {
                assert!(page.contains(part), "{letter}{number} has no {part}");
            }
        }
    }
    let book = Book::read(files).unwrap_or_else(|faults| panic!("{faults:?}"));
    let pages = book.pages();
    for (letter, count) in rows {
        for number in 1..=count {
            assert!(
                pages.contains(&format!("{letter}{number}").as_str()),
                "{letter}{number} is not among the contents"
            );
        }
    }
    assert_eq!(book.numbers(), (1..=75).collect());
}
