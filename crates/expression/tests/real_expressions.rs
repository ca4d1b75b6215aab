//! Expressions as they stand in published definitions: each reads, prints back, and gives the value worked out
//! by hand.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

use katydid_expression::{Expression, Variant, evaluate};

fn at(source: &str, variables: &[(&str, Variant)]) -> Variant {
    let expression = Expression::parse(source).unwrap_or_else(|e| panic!("{}", e.render(source)));
    let printed = expression.to_string();
    assert_eq!(Expression::parse(&printed).as_ref(), Ok(&expression), "{source} printed as {printed}");
    let names: Vec<&str> = variables.iter().map(|v| v.0).collect();
    let values: Vec<Variant> = variables.iter().map(|v| v.1.clone()).collect();
    let program = expression.bind(&names).unwrap_or_else(|e| panic!("{}", e.render(source)));
    program.evaluate(&values).unwrap_or_else(|e| panic!("{}", e.render(source)))
}

fn numbers(source: &str, variables: &[(&str, f64)], expected: f64) {
    let variables: Vec<(&str, Variant)> = variables.iter().map(|(n, x)| (*n, Variant::Number(*x))).collect();
    let Variant::Number(x) = at(source, &variables) else { panic!("{source} is not a number") };
    assert!((x - expected).abs() <= 1e-14 * expected.abs().max(1.0), "{source} = {x}, not {expected}");
}

#[test]
fn on_parameters() {
    let x = [("x", 6.0)];
    for (source, expected) in [
        ("-X", -6.0),
        ("x-1", 5.0),
        ("x/2", 3.0),
        ("-x/2", -3.0),
        ("25 * x", 150.0),
        ("1-x", -5.0),
        ("x*3", 18.0),
    ] {
        numbers(source, &x, expected);
    }
    assert_eq!(at("x + {120,0,0}", &[("x", Variant::point(1.0, 2.0, 3.0))]), Variant::point(121.0, 2.0, 3.0));
    numbers("i-1", &[("i", 4.0)], 3.0);
    numbers("Rad(A)", &[("a", 180.0)], std::f64::consts::PI);
    numbers("A/(2*Pi)", &[("A", std::f64::consts::TAU)], 1.0);
}

#[test]
fn in_expression_components() {
    use std::f64::consts::{E, PI};
    numbers("2*π*x", &[("x", 1.5)], 3.0 * PI);
    numbers("4 / 3 * π * Pow(radius, 3)", &[("radius", 3.0)], 36.0 * PI);
    numbers("b² - 4*a*c", &[("a", 1.0), ("b", 5.0), ("c", 6.0)], 1.0);
    numbers("S * CInt(L / S)", &[("S", 2.0), ("L", 7.0)], 8.0);
    numbers("Max(S, S*CInt(L/S))", &[("S", 2.0), ("L", 0.5)], 2.0);
    numbers("Max(0, (x-1)\\2)", &[("x", 8.0)], 3.0);
    numbers("round(rV*f)/f", &[("rV", 1.26), ("f", 10.0)], 1.3);
    numbers("If(x>y,x,y)", &[("x", 2.0), ("y", 9.0)], 9.0);
    numbers("-(x+y*2)", &[("x", 1.0), ("y", 2.0)], -5.0);
    numbers("(x-y)/2", &[("x", 1.0), ("y", 2.0)], -0.5);
    numbers("x*(1-t)+y*t", &[("x", 1.0), ("y", 3.0), ("t", 0.25)], 1.5);
    numbers("a*(1+x)^r", &[("a", 2.0), ("x", 0.5), ("r", 2.0)], 4.5);
    numbers("a*sin(a^-1*x)+sin(x)", &[("a", 2.0), ("x", 1.0)], 2.0 * 0.5f64.sin() + 1f64.sin());
    numbers(
        "a*sin(b*x)*e^(-f*x)",
        &[("a", 2.0), ("b", 3.0), ("x", 0.5), ("f", 0.1)],
        2.0 * 1.5f64.sin() * E.powf(-0.05),
    );
    numbers(
        "(a * sin(b * x - c) + d) * e^(-f * x) * (a * cos(b * y - c) + d) * e^(-f * y)",
        &[("a", 1.0), ("b", 2.0), ("c", 0.0), ("d", 1.0), ("f", 0.0), ("x", 0.0), ("y", 0.0)],
        2.0,
    );
    let bell = (-0.5f64).exp() / (2.0 * PI).sqrt();
    let normal = [("x", 1.0), ("y", 0.0), ("s", 1.0)];
    numbers("e^(-(x-y)²/(2*s²))/ ((2*π)^.5*s)", &normal, bell);
    numbers("1 - e^(-(x-y)²/(2*s²))/ ((2*π)^.5*s)", &normal, 1.0 - bell);
    numbers(
        "(a1*b1) + (a2*b2) + (a3*b3)",
        &[("a1", 1.0), ("b1", 4.0), ("a2", 2.0), ("b2", 5.0), ("a3", 3.0), ("b3", 6.0)],
        32.0,
    );
    numbers("Sqrt(x^2 + y^2 + z^2)", &[("x", 2.0), ("y", 3.0), ("z", 6.0)], 7.0);
    numbers("(u0+u1)/2", &[("u0", 1.0), ("u1", 2.0)], 1.5);
    assert_eq!(at("x ≠ y", &[("x", 1.0.into()), ("y", 2.0.into())]), Variant::Boolean(true));
    let window = "if((z≥n) and (z<(n+i)), True, False)";
    let z = |z: f64| [("z", z.into()), ("n", 2.0.into()), ("i", 3.0.into())];
    assert_eq!(at(window, &z(2.0)), Variant::Boolean(true));
    assert_eq!(at(window, &z(5.0)), Variant::Boolean(false));
    assert_eq!(at("Format(\"{0:0.0}m²\",x)", &[("x", 12.34.into())]), Variant::text("12.3m²"));
    assert_eq!(at("Format(\"0 To {0}\", x-1)", &[("x", 10.0.into())]), Variant::text("0 To 9"));
}

#[test]
fn with_vectors() {
    let p = |x: f64, y: f64, z: f64| Variant::point(x, y, z);
    // De Casteljau's steps.
    assert_eq!(
        at("A + t*(B-A)", &[("A", p(0.0, 0.0, 0.0)), ("B", p(4.0, 8.0, 0.0)), ("t", 0.25.into())]),
        p(1.0, 2.0, 0.0)
    );
    assert_eq!(at("A + 0.5*(D-A)", &[("A", p(2.0, 0.0, 0.0)), ("D", p(0.0, 0.0, 0.0))]), p(1.0, 0.0, 0.0));
    // The curvature of a circle of radius 2 from its derivatives.
    let (first, second) = (p(0.0, 2.0, 0.0), p(-2.0, 0.0, 0.0));
    let tangent = at("[d1]", &[("d1", first.clone())]);
    assert_eq!(tangent, p(0.0, 1.0, 0.0));
    assert_eq!(
        at("(d2-(d2 • T) *T)/(d1•d1)", &[("d1", first), ("d2", second), ("T", tangent)]),
        p(-0.5, 0.0, 0.0)
    );
    assert_eq!(at("[v] * r * 0.5", &[("v", p(3.0, 0.0, 0.0)), ("r", 4.0.into())]), p(2.0, 0.0, 0.0));
}

#[test]
fn in_value_lists_and_buttons() {
    assert_eq!(evaluate("0").unwrap(), Variant::Integer(0));
    assert_eq!(evaluate("-2008013").unwrap(), Variant::Integer(-2008013));
    assert_eq!(evaluate("0.0625").unwrap(), Variant::Number(0.0625));
    assert_eq!(evaluate("\"ur10e_gripper_one_beam\"").unwrap(), Variant::text("ur10e_gripper_one_beam"));
    assert_eq!(evaluate("2² - 1").unwrap(), Variant::Integer(3));
    assert_eq!(evaluate("Sqrt(16)").unwrap(), Variant::Number(4.0));
    assert_eq!(evaluate("False").unwrap(), Variant::Boolean(false));
}

#[test]
fn in_path_mappers() {
    let path = [("a", 1.into()), ("b", 2.into()), ("c", 3.into())];
    for (source, expected) in [("c+1", 4), ("2*c", 6), ("if(c=0,-1,c)", 3), ("path_count", 9)] {
        let mut names = path.to_vec();
        names.push(("path_count", 9.into()));
        assert_eq!(at(source, &names), Variant::Integer(expected), "{source}");
    }
    assert_eq!(at("pow(c,3)", &path), Variant::Number(27.0));
}
