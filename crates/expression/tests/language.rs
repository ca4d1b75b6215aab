//! The rules of the language, one by one.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

use katydid_expression::{EvalErrorKind, Expression, ParseErrorKind, Variant, evaluate, functions};
use katydid_geometry::{Plane, Point3};

fn value(source: &str) -> Variant {
    evaluate(source).unwrap_or_else(|e| panic!("{source}: {e}"))
}

/// With variables x = 3 (Number), n = 7 (Integer), t = "text", p = (1, 2, 3), b = True, o = a plane, nil = null.
fn with(source: &str) -> Variant {
    try_with(source).unwrap_or_else(|e| panic!("{source}: {e}"))
}

fn try_with(source: &str) -> Result<Variant, katydid_expression::Error> {
    let plane = Plane { origin: Point3::new(5.0, 6.0, 7.0), ..Plane::XY };
    let program = Expression::parse(source)?.bind(&["x", "n", "t", "p", "b", "o", "nil"])?;
    Ok(program.evaluate(&[
        3.0.into(),
        7.into(),
        "text".into(),
        Point3::new(1.0, 2.0, 3.0).into(),
        true.into(),
        plane.into(),
        Variant::Null,
    ])?)
}

fn number(source: &str) -> f64 {
    match with(source) {
        Variant::Number(x) => x,
        other => panic!("{source} gives {other:?}"),
    }
}

fn truth(source: &str) -> bool {
    match with(source) {
        Variant::Boolean(b) => b,
        other => panic!("{source} gives {other:?}"),
    }
}

fn text(source: &str) -> String {
    match with(source) {
        Variant::Text(t) => t.to_string(),
        other => panic!("{source} gives {other:?}"),
    }
}

fn parse_error(source: &str) -> (ParseErrorKind, String) {
    let error = match Expression::parse(source) {
        Err(error) => error,
        Ok(expression) => expression.bind(&["x", "radius"]).unwrap_err(),
    };
    let place = error.span.text(source).to_string();
    (error.kind, place)
}

#[test]
fn integers_stay_integers_until_they_do_not_fit() {
    assert_eq!(value("2+3*4-1"), Variant::Integer(13));
    assert_eq!(value("7/2"), Variant::Number(3.5));
    assert_eq!(value("6/2"), Variant::Number(3.0));
    assert_eq!(value("2147483647+1"), Variant::Number(2147483648.0));
    assert_eq!(value("-2147483647-1"), Variant::Integer(i32::MIN));
    assert_eq!(value("65536*65536"), Variant::Number(4294967296.0));
    assert_eq!(value("1+1.0"), Variant::Number(2.0));
    assert_eq!(value("2²-1"), Variant::Integer(3));
    assert_eq!(value("2³"), Variant::Integer(8));
    assert_eq!(value("2^3"), Variant::Number(8.0));
    assert_eq!(value("-(-2147483647-1)"), Variant::Number(2147483648.0));
    assert_eq!(value("(-2147483647-1)\\-1"), Variant::Number(2147483648.0));
    assert_eq!(value("(-2147483647-1)%-1"), Variant::Integer(0));
}

#[test]
fn division_and_remainder() {
    assert_eq!(value("7\\2"), Variant::Integer(3));
    assert_eq!(value("-7\\2"), Variant::Integer(-3));
    assert_eq!(value("-7%3"), Variant::Integer(-1));
    assert_eq!(number("-7.5%2"), -1.5);
    assert_eq!(number("(x+4.9)\\2"), 3.0);
    for source in ["1/0", "1\\0", "1%0", "x/0.0", "p/0", "HMean(1,0)"] {
        let error = try_with(source).unwrap_err();
        assert!(error.to_string().contains("division by zero"), "{source}: {error}");
    }
}

#[test]
fn precedence() {
    assert_eq!(number("-x^2"), -9.0);
    assert_eq!(number("2^-1"), 0.5);
    assert_eq!(number("2^-1*4"), 2.0);
    assert_eq!(number("2^3^2"), 64.0);
    assert_eq!(number("2^x²"), 512.0);
    assert_eq!(number("-x²"), -9.0);
    assert_eq!(number("2*-x"), -6.0);
    assert_eq!(number("10-x-2"), 5.0);
    assert_eq!(number("2+x*2"), 8.0);
    assert_eq!(value("3!!"), Variant::Integer(720));
    assert!(truth("1+1=2 and not (1>2)"));
    // `not` is a sign like the minus, and binds as tightly.
    assert!(truth("not 1 = False"));
    assert!(truth("True or False and False"));
    assert!(truth("1 < 2 = True"));
    assert_eq!(text("\"a\" & 1 + 2"), "a12");
}

#[test]
fn every_spelling() {
    for (a, b) in [
        ("x>=3", "x≥3"),
        ("x<=3", "x≤3"),
        ("x<>4", "x≠4"),
        ("x!=4", "x ≠ 4"),
        ("x==3", "x=3"),
        ("pi", "π"),
        ("PHI", "φ"),
        ("x-1", "x−1"),
        ("x^2", "X²"),
        ("x/2", "x÷2"),
        ("x*2", "x×2"),
        ("x*2", "x·2"),
        ("SIN(x)", "sin(X)"),
        ("b AND b", "b and B"),
        ("rad(180)", "180°"),
        ("p*p", "p•p"),
        ("CrossProduct(p,{0,0,1})", "p×{0,0,1}"),
        ("angle(p,{0,0,1})", "p∠{0,0,1}"),
        ("unitize(p)", "[p]"),
    ] {
        assert_eq!(with(a), with(b), "{a} and {b}");
    }
    assert!(truth("0.1+0.2 ≈ 0.3") && !truth("0.1+0.2 = 0.3"));
}

#[test]
fn constants_and_variables_that_hide_them() {
    assert_eq!(value("pi"), Variant::Number(std::f64::consts::PI));
    assert_eq!(value("e"), Variant::Number(std::f64::consts::E));
    assert_eq!(value("phi"), Variant::Number((1.0 + 5f64.sqrt()) / 2.0));
    let expression = Expression::parse("E + Radius + pi + radius + k_1").unwrap();
    assert_eq!(expression.variables(), ["radius", "k_1"]);
    let program = expression.bind(&["e", "RADIUS", "k_1"]).unwrap();
    assert_eq!(
        program.evaluate(&[1.0.into(), 2.0.into(), 3.0.into()]).unwrap(),
        Variant::Number(1.0 + 2.0 + std::f64::consts::PI + 2.0 + 3.0)
    );
    assert!(matches!(program.evaluate(&[]).unwrap_err().kind, EvalErrorKind::MissingVariable(n) if n == "e"));
}

#[test]
fn points_and_planes() {
    assert_eq!(with("p + {120,0,0}"), Variant::point(121.0, 2.0, 3.0));
    assert_eq!(with("{1,2}"), Variant::point(1.0, 2.0, 0.0));
    assert_eq!(with("p*2 - 2*p"), Variant::point(0.0, 0.0, 0.0));
    assert_eq!(with("-p/2"), Variant::point(-0.5, -1.0, -1.5));
    assert_eq!(number("p*p"), 14.0);
    assert_eq!(number("p.x + p.Y*10 + P.Z*100"), 321.0);
    assert_eq!(with("o.O"), Variant::point(5.0, 6.0, 7.0));
    assert_eq!(with("o.z"), Variant::point(0.0, 0.0, 1.0));
    assert_eq!(number("Distance({0,0,0},{3,4,0})"), 5.0);
    assert_eq!(number("DistanceXY({0,0,9},{3,4,0})"), 5.0);
    assert_eq!(number("Length({2,3,6})"), 7.0);
    assert_eq!(with("[{0,0,5}]"), Variant::point(0.0, 0.0, 1.0));
    assert_eq!(with("{1,0,0}×{0,1,0}"), Variant::point(0.0, 0.0, 1.0));
    assert_eq!(number("{1,0,0}∠{0,2,0}"), std::f64::consts::FRAC_PI_2);
    assert!(truth("p = {1,2,3}") && truth("p ≠ {1,2,4}"));
    assert_eq!(text("\"at \" & p"), "at {1, 2, 3}");
}

#[test]
fn texts() {
    assert_eq!(value(r#""say ""hi""""#), Variant::text("say \"hi\""));
    assert_eq!(text("t & x & n & b"), "text37True");
    assert_eq!(text("t + 1"), "text1");
    assert_eq!(text("1 + t"), "1text");
    assert_eq!(number("\"2\" * x"), 6.0);
    assert_eq!(text("Format(\"{0} To {1}\", x-1, n)"), "2 To 7");
    assert_eq!(text("Format(\"{0:0.0}m²\",x)"), "3.0m²");
    assert_eq!(text("Concat(1, \"-\", 2.5)"), "1-2.5");
    assert!(truth("Contains(t, \"ex\")") && !truth("Contains(t, \"EX\")"));
    assert!(truth("StartsWith(t, \"te\")") && truth("EndsWith(t, \"xt\")"));
    assert_eq!(with("IndexOf(t, \"x\")"), Variant::Integer(2));
    assert_eq!(with("IndexOf(t, \"q\")"), Variant::Integer(-1));
    assert_eq!(
        text("Left(t,2) & \"|\" & Right(t,3) & \"|\" & Mid(t,1,2) & \"|\" & Mid(t,3) & Left(t,99)"),
        "te|ext|ex|ttext"
    );
    assert_eq!(text("Trim(\"  a \") & UCase(t) & LCase(\"ABC\")"), "aTEXTabc");
    assert_eq!(text("Replace(t, \"t\", \"--\")"), "--ex--");
    assert_eq!(with("Length(\"αβγ\")"), Variant::Integer(3));
    assert_eq!(text("Mid(\"αβγ\",1,1)"), "β");
    assert!(
        truth("\"a\" = \"a\"") && truth("\"a\" ≠ \"A\"") && truth("\"a\" < \"B\"") && truth("\"a\" < \"A\"")
    );
}

#[test]
fn truth_and_if() {
    assert_eq!(with("if(x=3, True, False)"), Variant::Boolean(true));
    assert_eq!(with("if(x=true, 0, -1)"), Variant::Integer(-1));
    assert_eq!(with("if(b=true, 0, -1)"), Variant::Integer(0));
    assert_eq!(with("If(x, \"yes\", 0)"), Variant::text("yes"));
    assert_eq!(with("if(0, 1, p)"), Variant::point(1.0, 2.0, 3.0));
    assert!(truth("x and 1") && !truth("x xor 1") && truth("0 or b") && truth("not 0"));
    // Both branches are computed.
    assert!(try_with("if(b, 1, 1/0)").is_err());
}

#[test]
fn null_passes_through() {
    for source in [
        "nil+1",
        "-nil",
        "nil & t",
        "sin(nil)",
        "nil.x",
        "{nil,1,2}",
        "nil=nil",
        "[nil]",
        "nil!",
        "Max(1,nil)",
        "if(nil,1,2)",
    ] {
        assert_eq!(with(source), Variant::Null, "{source}");
    }
    assert_eq!(with("IsNothing(nil)"), Variant::Boolean(true));
    assert_eq!(with("IsNothing(x)"), Variant::Boolean(false));
    assert_eq!(with("if(IsNothing(nil), x, nil)"), Variant::Number(3.0));
    assert_eq!(with("if(b, nil, x)"), Variant::Null);
    assert_eq!(with("Null()"), Variant::Null);
}

#[test]
fn mathematics() {
    let near = |source: &str, expected: f64| {
        let x = number(source);
        assert!((x - expected).abs() <= 1e-15 * expected.abs().max(1.0), "{source} = {x}, not {expected}");
    };
    near("sin(pi/6)", 0.5);
    near("Cos(60°)", 0.5);
    near("tan(0.5)", 0.5f64.tan());
    near("asin(1)", std::f64::consts::FRAC_PI_2);
    near("acos(0)", std::f64::consts::FRAC_PI_2);
    near("atan2(1,1)", std::f64::consts::FRAC_PI_4);
    near("sec(0.3)*cos(0.3)", 1.0);
    near("csc(0.3)*sin(0.3)", 1.0);
    near("cot(0.3)*tan(0.3)", 1.0);
    near("sinc(0)+sinc(pi/2)", 1.0 + 2.0 / std::f64::consts::PI);
    near("cosh(1)^2-sinh(1)^2", 1.0);
    near("tanh(0.5)", 0.5f64.tanh());
    near("Sqrt(16)", 4.0);
    near("Log(1000)", 3.0);
    near("Log10(0.01)", -2.0);
    near("Ln(e)", 1.0);
    near("LogN(8,2)", 3.0);
    near("Exp(1)-e", 0.0);
    near("Pow10(3)", 1000.0);
    near("Pow(2,10)", 1024.0);
    near("Floor(-1.2)+Ceiling(-1.2)+Fix(-1.7)+Int(-1.2)+Trunc(1.7)", -2.0 - 1.0 - 1.0 - 2.0 + 1.0);
    near("Round(2.5)+Round(3.5)+Round(-0.5)", 6.0);
    near("Round(2.7654, 2)", 2.77);
    near("Mean(1,2,6)+Median(5,1,3)+GMean(2,8)+HMean(1,3)", 3.0 + 3.0 + 4.0 + 1.5);
    near("Deg(pi)", 180.0);
    assert_eq!(value("Min(3,1,2)"), Variant::Integer(1));
    assert_eq!(value("Max(3,1.5)"), Variant::Number(3.0));
    assert_eq!(value("Sum(1,2,3)"), Variant::Integer(6));
    assert_eq!(value("Abs(-3)"), Variant::Integer(3));
    assert_eq!(value("Sign(-2.5)"), Variant::Integer(-1));
    assert_eq!(value("CInt(2.5)+CInt(3.5)"), Variant::Integer(6));
    assert_eq!(value("CDbl(\"1.5\")"), Variant::Number(1.5));
    assert_eq!(value("CBool(\"true\")"), Variant::Boolean(true));
    assert_eq!(value("CStr(0.1)"), Variant::text("0.1"));
    assert_eq!(value("5!"), Variant::Integer(120));
    assert_eq!(value("20!"), Variant::Number(2_432_902_008_176_640_000.0));
}

#[test]
fn complex_numbers() {
    assert_eq!(value("(1+2i)*(3-1i)"), Variant::Complex { re: 5.0, im: 5.0 });
    assert_eq!(value("2i*2i"), Variant::Complex { re: -4.0, im: 0.0 });
    assert_eq!(value("(5+5i)/(1+2i)"), Variant::Complex { re: 3.0, im: -1.0 });
    assert_eq!(value("Abs(3+4i)"), Variant::Number(5.0));
    assert_eq!(value("Sqrt(-4+0i)"), Variant::Complex { re: 0.0, im: 2.0 });
    assert_eq!(value("\"\" & (1-2i)"), Variant::text("1-2i"));
    assert_eq!(value("(2+0i)=2"), Variant::Boolean(true));
}

#[test]
fn infinity_may_pass_but_not_arrive() {
    assert_eq!(number("1/(1+Exp(1000*x))"), 0.0);
    let error = Expression::parse("1 + Exp(1000*x)").unwrap().bind(&["x"]).unwrap().evaluate(&[1.0.into()]);
    let error = error.unwrap_err();
    assert_eq!(
        error.render("1 + Exp(1000*x)"),
        "the result is not a finite number: 'Exp' gives infinity\n  1 + Exp(1000*x)\n      ^^^"
    );
    for source in ["Sqrt(-x)", "Ln(-x)", "acos(x)", "1e308*x*10", "{0,Sqrt(-x),0}"] {
        assert!(try_with(source).is_err(), "{source}");
    }
}

#[test]
fn errors_name_types_and_place() {
    let message = |source: &str| try_with(source).unwrap_err().to_string();
    assert_eq!(message("o + x"), "'+' cannot join a Plane and a Number");
    assert_eq!(message("n + p"), "'+' cannot join an Integer and a Point");
    assert_eq!(message("p < p"), "'<' cannot join a Point and a Point");
    assert_eq!(message("t * 2"), "'*' cannot join a Text and an Integer");
    assert_eq!(message("-o"), "'-' cannot be applied to a Plane");
    assert_eq!(message("x.y"), "'.Y' cannot be applied to a Number");
    assert_eq!(message("sin(p)"), "argument 1 of Sin must be a number, not a Point");
    assert_eq!(message("CInt(1e10)"), "CInt: 10000000000 does not fit an Integer");
    assert_eq!(message("(-1)!"), "!: a factorial needs a whole number of 0 to 170, not -1");
    assert_eq!(message("Format(\"{2}\", 1)"), "Format: the item {2} at character 1 has no value: 1 is given");
    let source = "x + 1/(x-3)";
    let error = Expression::parse(source).unwrap().bind(&["x"]).unwrap().evaluate(&[3.0.into()]).unwrap_err();
    assert_eq!(error.render(source), "division by zero\n  x + 1/(x-3)\n       ^");
}

#[test]
fn parse_errors_in_plain_words() {
    let message = |source: &str| {
        let (kind, place) = parse_error(source);
        format!("{place}|{kind}")
    };
    assert_eq!(message("2*sinn(x)"), "sinn|unknown function 'sinn': did you mean 'sin'?");
    assert_eq!(message("2*(x+1"), "(|closing bracket missing for the '(' opened here");
    assert_eq!(message("sin(x"), "(|closing bracket missing for the '(' opened here");
    assert_eq!(message("{1,2,3"), "{|closing bracket missing for the '{' opened here");
    assert_eq!(message("(x]"), "]|'(' is closed by ']'");
    assert_eq!(message("x)"), ")|this ')' closes nothing");
    assert_eq!(message("2 x"), "x|an operator is missing before 'x'");
    assert_eq!(message("2*"), "|a value is missing: found the end of the expression instead");
    assert_eq!(message("2*/3"), "/|a value is missing: found '/' instead");
    assert_eq!(message("()"), ")|a value is missing: found ')' instead");
    assert_eq!(
        message("(1,2)"),
        ",|a comma may only separate the arguments of a function or the coordinates of a point"
    );
    assert_eq!(message("max()"), "max()|Max(a, b, …) takes at least 1 argument, not 0");
    assert_eq!(message("sin(1,2)"), "sin(1,2)|Sin(x) takes 1 argument, not 2");
    assert_eq!(message("{1}"), "{1}|a point has two or three coordinates, not 1");
    assert_eq!(message("2*radus"), "radus|unknown name 'radus': did you mean 'radius'?");
    assert_eq!(message("sin + 1"), "sin|'sin' is a function: write Sin(x)");
    assert_eq!(message("x # 2"), "#|the character '#' has no meaning here");
    assert_eq!(message("\"abc"), "\"|closing quote missing for the text opened here");
    assert_eq!(message("x.w"), ".w|unknown member '.w': there are .X, .Y, .Z and .O");
    assert_eq!(parse_error("   ").0, ParseErrorKind::Empty);
}

#[test]
fn hostile_texts_are_errors_not_crashes() {
    for open in ["(", "[", "{", "-", "not ", "sin(", "2^-", "1+(", "x^("] {
        let source = open.repeat(100_000 / open.len());
        assert!(Expression::parse(&source).is_err());
        let source = open.repeat(20_000 / open.len());
        assert!(Expression::parse(&source).is_err());
    }
    // Half a megabyte of stack is enough for the deepest text.
    let deepest = || {
        for open in ["(", "max(", "-", "2^-", "{1,", "0 xor 0 or 0 and 0=0+0*("] {
            assert!(Expression::parse(&open.repeat(65_000 / open.len())).is_err());
        }
    };
    std::thread::Builder::new().stack_size(1 << 19).spawn(deepest).unwrap().join().unwrap();
    // Long chains are not deep.
    let chain = format!("x{}", "+x".repeat(30_000));
    let program = Expression::parse(&chain).unwrap().bind(&["x"]).unwrap();
    assert_eq!(program.evaluate(&[1.0.into()]).unwrap(), Variant::Number(30_001.0));
    assert_eq!(program.evaluate_numbers(&[&[1.0]], 1).unwrap().unwrap(), [30_001.0]);
    assert!(!Expression::parse(&chain).unwrap().to_string().is_empty());
    let deep = format!("{}x{}", "(".repeat(100), ")".repeat(100));
    assert!(Expression::parse(&deep).is_ok());
    let wide = format!("max(x{})", ",x".repeat(30_000));
    let program = Expression::parse(&wide).unwrap().bind(&["x"]).unwrap();
    assert_eq!(program.evaluate(&[1.0.into()]).unwrap(), Variant::Number(1.0));
    // A text cannot be grown without end.
    let big = Variant::text("a".repeat(1 << 23));
    let program = Expression::parse("x & x & x & x").unwrap().bind(&["x"]).unwrap();
    assert!(matches!(program.evaluate(&[big]).unwrap_err().kind, EvalErrorKind::TextTooLong(_)));
}

#[test]
fn the_table_of_functions_is_complete_and_callable() {
    for help in functions() {
        // Too few and too many arguments are named with the signature.
        if help.least > 0 {
            assert!(matches!(
                parse_error(&format!("{}()", help.name)).0,
                ParseErrorKind::ArgumentCount { .. }
            ));
        }
        if help.most != usize::MAX {
            let many = vec!["1"; help.most + 1].join(",");
            let source = format!("{}({many})", help.name.to_uppercase());
            assert!(matches!(parse_error(&source).0, ParseErrorKind::ArgumentCount { .. }), "{source}");
        }
        // Any mix of types gives a value or an error that is not our fault.
        for arguments in ["1", "x", "p", "t", "o", "b", "nil", "2i"] {
            for count in help.least..=help.most.min(help.least + 2) {
                let source = format!("{}({})", help.name, vec![arguments; count].join(","));
                if let Err(error) = try_with(&source) {
                    assert!(!error.to_string().contains("damaged"), "{source}: {error}");
                }
            }
        }
    }
}
