//! A small host: a struct with operators, a class whose objects the host holds, an enum; and a script in three parts.

#![allow(clippy::unwrap_used, reason = "a test that meets an error fails")]

use katydid_csharp::{Cx, Engine, Host, Limits, Parts, Raise, Source, Value};
use std::sync::{Arc, Mutex};

const DECLARATIONS: &str = "
using System.Collections.Generic;
namespace Geo {
    public enum Side { Left, Right = 4 }
    public struct Vec3 {
        public double X; public double Y; public double Z;
        public Vec3(double x, double y, double z) { X = x; Y = y; Z = z; }
        public extern double Length { get; }
        public extern bool Unitize();
        public static Vec3 Zero { get { return new Vec3(0, 0, 0); } }
        public static extern Vec3 operator +(Vec3 a, Vec3 b);
        public static extern Vec3 operator *(Vec3 a, double k);
        public static extern double operator *(Vec3 a, Vec3 b);
        public static implicit operator Vec3(double x) { return new Vec3(x, x, x); }
        public override string ToString() { return X + \",\" + Y + \",\" + Z; }
        public extern double Missing();
    }
    [Native] public class Path : IEnumerable<Vec3> {
        public extern Path();
        public extern void Add(Vec3 v);
        public extern int Count { get; }
        public extern Vec3 this[int i] { get; }
        public extern bool Closest(Vec3 v, out int index, out double distance);
        public IEnumerator<Vec3> GetEnumerator() { for (int i = 0; i < Count; i++) yield return this[i]; }
        System.Collections.IEnumerator System.Collections.IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public class Script {
        protected List<string> lines = new List<string>();
        public string Lines { get { return string.Join(\"|\", lines); } }
        protected void Print(string s) { lines.Add(s); }
        protected void Print(string s, params object[] args) { lines.Add(string.Format(s, args)); }
    }
}
";

#[derive(Default)]
struct Geo(Arc<Mutex<String>>);

const MEMBERS: &[&str] = &[
    "Vec3.get_Length()",
    "Vec3.Unitize()",
    "Vec3.op_Addition(Vec3,Vec3)",
    "Vec3.op_Multiply(Vec3,Double)",
    "Vec3.op_Multiply(Vec3,Vec3)",
    "Path.new()",
    "Path.Add(Vec3)",
    "Path.get_Count()",
    "Path.get_Item(Int32)",
    "Path.Closest(Vec3,Int32,Double)",
];

type Points = Vec<[f64; 3]>;

fn vec(cx: &Cx<'_>, i: usize) -> [f64; 3] {
    let v = cx.arg(i);
    [0, 1, 2].map(|k| if let Value::F64(x) = cx.field(v, k) { x } else { f64::NAN })
}

fn made(cx: &mut Cx<'_>, v: [f64; 3]) -> Value {
    let ty = cx.type_named("Geo", "Vec3").unwrap();
    cx.instance(ty, &v.map(Value::F64))
}

fn length(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

impl Host for Geo {
    fn declarations(&self) -> &str {
        DECLARATIONS
    }

    fn member(&self, key: &str) -> Option<u32> {
        MEMBERS.iter().position(|m| *m == key).map(|i| i as u32)
    }

    fn call(&mut self, member: u32, cx: &mut Cx<'_>) -> Result<Value, Raise> {
        Ok(match MEMBERS[member as usize] {
            "Vec3.get_Length()" => Value::F64(length(vec(cx, 0))),
            "Vec3.Unitize()" => {
                let v = vec(cx, 0);
                let n = length(v);
                if n == 0.0 {
                    return Ok(Value::Bool(false));
                }
                let object = cx.arg(0);
                cx.set_fields(object, &v.map(|x| Value::F64(x / n)));
                Value::Bool(true)
            }
            "Vec3.op_Addition(Vec3,Vec3)" => {
                let (a, b) = (vec(cx, 0), vec(cx, 1));
                made(cx, [a[0] + b[0], a[1] + b[1], a[2] + b[2]])
            }
            "Vec3.op_Multiply(Vec3,Double)" => {
                let (a, k) = (vec(cx, 0), cx.real(1));
                made(cx, a.map(|x| x * k))
            }
            "Vec3.op_Multiply(Vec3,Vec3)" => {
                let (a, b) = (vec(cx, 0), vec(cx, 1));
                Value::F64(a.iter().zip(b).map(|(x, y)| x * y).sum())
            }
            "Path.new()" => {
                let ty = cx.ty;
                cx.host_object(ty, Box::new(Points::new()))
            }
            "Path.Add(Vec3)" => {
                let (object, v) = (cx.arg(0), vec(cx, 1));
                cx.host_data_mut::<Points>(object).unwrap().push(v);
                Value::Null
            }
            "Path.get_Count()" => Value::I32(cx.host_data::<Points>(cx.arg(0)).unwrap().len() as i32),
            "Path.get_Item(Int32)" => {
                let i = cx.int(1);
                let Some(v) = cx.host_data::<Points>(cx.arg(0)).unwrap().get(i as usize).copied() else {
                    return Err(Raise::new("ArgumentOutOfRangeException", "No such point"));
                };
                made(cx, v)
            }
            _ => {
                let v = vec(cx, 1);
                let distance = |p: &[f64; 3]| length([p[0] - v[0], p[1] - v[1], p[2] - v[2]]);
                let best = cx
                    .host_data::<Points>(cx.arg(0))
                    .unwrap()
                    .iter()
                    .map(distance)
                    .enumerate()
                    .min_by(|a, b| a.1.total_cmp(&b.1));
                let (index, distance) = best.unwrap_or((0, f64::NAN));
                cx.set(2, Value::I32(index as i32));
                cx.set(3, Value::F64(distance));
                Value::Bool(best.is_some())
            }
        })
    }

    fn write(&mut self, text: &str) {
        self.0.lock().unwrap().push_str(text);
    }
}

fn printed(body: &str) -> Result<String, String> {
    let host = Geo::default();
    let text = host.0.clone();
    let source = format!(
        "using System; using System.Collections.Generic; using System.Linq; using Geo;\nclass P {{ static void Main() {{\n{body}\n}} }}"
    );
    let mut engine = Engine::new(&Source::File(&source), Box::new(host), Limits::default())
        .map_err(|e| e[0].to_string())?;
    engine.run_main().map_err(|e| e.to_string())?;
    let text = text.lock().unwrap().clone();
    Ok(text)
}

#[test]
fn structs_of_the_host() {
    let body = "Vec3 a = new Vec3(3, 4, 0); var b = a; b.Unitize(); Console.WriteLine(a.Length + \" \" + b + \" \" + a * b + \" \" + (a + 1.0) * 2);
        var l = new List<Vec3> { a, b }; l[0].Unitize(); Console.WriteLine(l[0]); Console.WriteLine(l.Select(v => v.Length).Sum()); Console.WriteLine(Vec3.Zero + \" \" + Side.Right + (int)Side.Right);";
    assert_eq!(printed(body).unwrap(), "5 0.6,0.8,0 5 8,10,2\n3,4,0\n6\n0,0,0 Right4\n");
}

#[test]
fn objects_of_the_host() {
    let body = "var p = new Path(); p.Add(new Vec3(1, 0, 0)); p.Add(new Vec3(0, 5, 0)); int i; double d; Console.WriteLine(p.Closest(new Vec3(0, 4, 0), out i, out d) + \" \" + i + \" \" + d + \" \" + p.Count);
        foreach (Vec3 v in p) Console.Write(v + \";\"); Console.WriteLine(p.Max(v => v.Length)); try { Console.WriteLine(p[7]); } catch (ArgumentOutOfRangeException e) { Console.WriteLine(e.Message); }";
    assert_eq!(printed(body).unwrap(), "True 1 1 2\n1,0,0;0,5,0;5\nNo such point\n");
}

#[test]
fn members_of_dynamic_values_of_the_host() {
    let body = "dynamic v = new Vec3(3, 4, 0), k = 2; Console.WriteLine(v.Length + \" \" + (v + v) + \" \" + v * k + \" \" + v * v); v.X = 0; v.Unitize(); Console.WriteLine(v);
        dynamic p = new Path(); p.Add(v); p.Add(new Vec3(0, 0, 7)); Console.WriteLine(p.Count + \" \" + p[1].Z); foreach (var q in p) Console.Write(q.Length + \";\"); Vec3 back = p[0]; Console.WriteLine(back.Y);
        try { p.Nope(); } catch (Exception e) { Console.WriteLine(e.GetType().Name); }";
    assert_eq!(printed(body).unwrap(), "5 6,8,0 6,8,0 25\n0,1,0\n2 7\n1;7;1\nRuntimeBinderException\n");
}

#[test]
fn a_member_that_the_host_does_not_have_is_named() {
    let failure = printed("Console.WriteLine(new Vec3(1, 2, 3).Missing());").unwrap_err();
    assert!(failure.contains("Vec3.Missing() is not supported"), "{failure}");
}

#[test]
fn a_component_in_three_parts() {
    let source = Source::Parts(Parts {
        usual: "using System; using System.Collections.Generic; using Geo;",
        using: "using System.Linq;",
        body: "int n = 0;\nforeach (var v in x) n += (int)v.Length;\ncount++;\nPrint(\"{0} {1}\", n, count);\nA = Twice(n);",
        additional: "int count = 0;\nint Twice(int n) { return n * 2; }",
        parameters: "List<Vec3> x, double y, ref object A",
        base: "Geo.Script",
    });
    let mut engine = Engine::new(&source, Box::new(Geo::default()), Limits::default())
        .map_err(|e| e[0].to_string())
        .unwrap();
    let script = engine.create("Script_Instance").map_err(|e| e.to_string()).unwrap();
    let run = engine.method("Script_Instance", "RunScript").unwrap();
    let owner = engine.type_named("", "Script_Instance").unwrap();
    let vec = engine.type_named("Geo", "Vec3").unwrap();
    for (turn, expected) in [(1, "14"), (2, "14")] {
        let v = engine.instance(vec, &[Value::F64(3.0), Value::F64(4.0), Value::F64(0.0)]);
        let w = engine.instance(vec, &[Value::F64(0.0), Value::F64(2.5), Value::F64(0.0)]);
        let list = engine.list(vec, vec![v, w]);
        let (_, outs) = engine
            .call_with_refs(run, owner, &[script, list, Value::F64(0.0)], &[Value::Null])
            .map_err(|e| e.to_string())
            .unwrap();
        assert_eq!(engine.text_of(outs[0]), expected, "turn {turn}");
    }
}

#[test]
fn faults_of_a_part_have_the_lines_of_that_part() {
    let source = Source::Parts(Parts {
        usual: "using System;",
        using: "",
        body: "int a = 1;\nint b = \"x\";",
        additional: "",
        parameters: "ref object A",
        base: "",
    });
    let errors = Engine::new(&source, Box::new(Geo::default()), Limits::default()).err().unwrap();
    assert_eq!(
        errors[0].to_string(),
        "script(2,9): error CS0029: Cannot implicitly convert type 'string' to 'int'"
    );
}
