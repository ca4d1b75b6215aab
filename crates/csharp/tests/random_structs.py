#!/usr/bin/env python3
"""Random programs over structs in every kind of place, whose arguments change what their methods are called on: the
interpreter and Mono must print the same.

    cargo build -p katydid-csharp --example run
    python crates/csharp/tests/random_structs.py target/debug/examples/run 0 200

The seeds of a range; programs that differ are kept in the folder that is printed. Needs the Debian packages mono-mcs and
mono-runtime. Left out is what Mono's compiler does otherwise than the specification (C# 6.0, 12.18.2 and 12.7): it evaluates
a value before the index of the indexer that it is assigned to, and sets the first part of a tuple before it evaluates
the second.
"""

import pathlib
import random
import re
import subprocess
import sys
import tempfile

TYPES = r"""
using System; using System.Collections.Generic; using System.Linq;
struct V
{
    public int X, Y;
    public V(int x, int y) { X = x; Y = y; }
    public int Sum { get { return X + Y; } set { X = value - Y; } }
    public int this[int i] { get { return X * 2 + i; } set { X = value + i; } }
    public int AddD(int d) { X += d; return X; }
    public V Moved(int d) { Y += d; return this; }
    public void Add(V v) { X += v.X; Y += v.Y; }
    public int Put(V v) { this = v; X++; return Y; }
    public int Dot(V v) { return X * v.X + Y * v.Y; }
    public int Mix(int a, V v, int b) { return X + 3 * a - v.Y + 5 * b; }
    public V Plus(V v) { return new V(X + v.X, Y + v.Y); }
    public static V operator +(V a, V b) { return new V(a.X + b.X, a.Y - b.Y); }
    public static V operator *(V a, int k) { return new V(a.X * k, a.Y + k); }
    public static V operator ++(V a) { return new V(a.X + 1, a.Y + 2); }
    public override string ToString() { return X + "," + Y; }
}
struct Big
{
    public V A, B; public int N;
    public int Total() { return A.X + B.Y + N; }
    public int Turn(int d) { V t = A; A = B; B = t; N += d; return N; }
    public V Get(int d) { A.X += d; return B; }
    public override string ToString() { return "<" + A + "|" + B + "|" + N + ">"; }
}
class G<T> { public T Item; public T[] All = new T[3]; public T Swap(T t) { T o = Item; Item = t; return o; } public T Auto { get; set; } }
class H
{
    public V At = new V(1, 2); public Big B; public V[] Arr = { new V(3, 4), new V(5, 6), new V(7, 8) };
    public Big[] Bigs = new Big[2]; public V[,] Grid = new V[2, 2]; public static V S = new V(9, 10); public static Big T;
    public V Auto { get; set; } public List<V> L = new List<V> { new V(1, 1), new V(2, 2) }; public G<V> Gen = new G<V>();
    public V? Maybe = new V(4, 4); public readonly V Fixed = new V(6, 1);
    public override string ToString()
    {
        return At + " " + B + " " + string.Join(";", Arr) + " " + string.Join(";", Bigs) + " " + Grid[0, 1] + " " + Grid[1, 0] + " " + S
            + " " + T + " " + Auto + " " + string.Join(";", L) + " " + Gen.Item + " " + Gen.All[1] + " " + Gen.Auto + " " + Maybe + " " + Fixed;
    }
"""
HELPERS = r"""
    public static int Calls;
    public static void W(object o) { Console.WriteLine(o); }
    public static V Same(ref V v, int d) { v.X += d; return v; }
    public static int Two(ref V a, ref V b, int d) { V t = a; a = b; b = t; b.X += d; return a.Dot(b); }
    public static Big MakeBig(V a, V b) { Big n; n.A = a; n.B = b; n.N = 1; a.X = 100; return n; }
    public static int Set(H h)
    {
        h.At = new V(h.At.Y + 1, 3); h.B = new Big(); h.Arr[1] = h.At; H.S = h.Arr[0]; h.Bigs[1] = h.B; return h.At.X;
    }
"""
RUN = r"""
    static void Run(H h, V p, ref V r, ref Big rb)
    {
        V a = new V(1, 2), b = new V(3, 4), c = p, q = a, cap = new V(5, 5); Big big = new Big(), capbig = new Big();
        capbig.B = cap; int k = 0; V[] arr = { a, b, c }; object boxed = b;
        Func<int> f = () => { cap.X++; capbig = new Big { A = cap, N = 2 }; return cap.X; };
        Func<int> g = () => { cap = new V(capbig.A.X, 8); h.At = cap; h.Arr[2] = cap; return capbig.B.Y; };
        Func<V> fv = () => { V o = cap; cap = new V(o.Y, o.X); return o; };
"""
# Variables of the names that statements use, in methods that are called from within expressions.
FEW = (
    "V q = new V(2, 3), p = h.At, a = q, b = p, c = a, r = c, cap = b; int k = 1; V[] arr = h.Arr; Big big = h.B, capbig = big,"
    " rb = h.B; object boxed = a; Func<int> f = () => 2, g = f; Func<V> fv = () => new V(1, 3); "
)
# How deep expressions stand in one another.
DEEPEST = 4
STATEMENTS = 14


class Program:
    """A program of a seed."""

    def __init__(self, seed):
        self.dice = random.Random(seed)
        self.depth = 0
        self.names = 0

    def pick(self, *choices):
        return self.dice.choice(choices)

    def digit(self):
        return str(self.dice.randrange(10))

    def index(self):
        return self.pick("0", "1", "2", "k", "k++ % 3", "(k = 1)") if self.depth < 3 else self.pick("0", "1", "2")

    def place(self):
        """Where a V is."""
        return self.pick(
            "h.At", "h.B.A", "h.B.B", f"h.Arr[{self.index()}]", f"h.Bigs[{self.pick('0', '1')}].A", "h.Bigs[1].B", "h.Grid[0, 1]",
            f"h.Grid[{self.pick('0', '1')}, 0]", "H.S", "H.T.A", "H.T.B", "h.Gen.Item", "h.Gen.All[1]", "a", "b", "c", "big.A",
            "big.B", "cap", "capbig.A", "r", "rb.A", f"arr[{self.index()}]", "p", "q",
        )  # fmt: skip

    def big_place(self):
        return self.pick("h.B", "h.Bigs[0]", "h.Bigs[1]", "H.T", "big", "capbig", "rb")

    def vector(self):
        if self.depth >= DEEPEST:
            return self.pick(self.place(), f"new V({self.digit()}, {self.digit()})")
        self.depth += 1
        made = self.dice.choice(
            [
                self.place, self.place, self.place, self.place,
                lambda: f"new V({self.number()}, {self.number()})",
                lambda: f"({self.place()} = {self.vector()})",
                lambda: f"({self.vector()} + {self.vector()})",
                lambda: f"{self.place()}.Moved({self.number()})",
                lambda: f"{self.place()}.Plus({self.vector()})",
                lambda: self.pick("h.At", "h.B.A", "a", "cap", "H.S", "r", "h.Arr[1]", "big.A", "h.Auto", "h.L[1]") + "++",
                lambda: f"({self.place()} += {self.vector()})",
                lambda: f"({self.number()} > 5 ? {self.vector()} : {self.vector()})",
                lambda: self.pick(
                    "h.Auto", "h.L[0]", "h.L[k % 2]", "h.Gen.Auto", "h.Maybe.Value", "h.Fixed", "(V)boxed", "h.Arr.First()",
                    "arr.Last()", "fv()", "Change(h)", f"h.Gen.Swap({self.place()})",
                ),
                lambda: f"{self.big_place()}.Get({self.number()})",
                lambda: f"Same(ref {self.place()}, {self.number()})",
                lambda: f"({self.vector()} * {self.number()})",
                lambda: f"({self.big_place()} = {self.big()}).A",
            ]
        )()  # fmt: skip
        self.depth -= 1
        return made

    def big(self):
        return self.pick(
            self.big_place(), "new Big()", f"new Big {{ A = {self.vector()}, N = {self.number()} }}",
            f"MakeBig({self.vector()}, {self.vector()})",
        )  # fmt: skip

    def number(self):
        if self.depth >= DEEPEST:
            return self.digit()
        self.depth += 1
        made = self.dice.choice(
            [
                self.digit, self.digit,
                lambda: f"{self.place()}.{self.pick('X', 'Y')}",
                lambda: f"{self.place()}.AddD({self.number()})",
                lambda: f"{self.place()}.Dot({self.vector()})",
                lambda: f"{self.place()}.Put({self.vector()})",
                lambda: f"{self.place()}.Mix({self.number()}, {self.vector()}, {self.number()})",
                lambda: f"({self.place()}.{self.pick('X', 'Y', 'Sum')} {self.pick('=', '+=', '-=')} {self.number()})",
                lambda: f"{self.place()}[{self.number()}]",
                lambda: f"({self.place()}[{self.digit()}] {self.pick('=', '+=')} {self.number()})",
                lambda: f"{self.big_place()}.Turn({self.number()})",
                lambda: self.pick("f()", "g()", "Set(h)", f"h.Own({self.number()})", f"{self.big_place()}.Total()"),
                lambda: f"({self.number()} {self.pick('+', '-', '^')} {self.number()})",
                lambda: f"Two(ref {self.place()}, ref {self.place()}, {self.number()})",
                lambda: f"{self.pick('h.Auto', 'h.L[0]', 'h.Fixed', '(h.At = a)')}.Plus({self.vector()}).Dot({self.vector()})",
                lambda: f"{self.vector()}.Sum",
            ]
        )()  # fmt: skip
        self.depth -= 1
        return made

    def block(self, level):
        self.names += 1
        t, e = f"t{self.names}", f"e{self.names}"
        if self.dice.random() < 0.5:
            return f"{{ V {t} = {self.vector()}; {self.statement(level)} {t}.X += {self.number()}; W({t}); {self.statement(level)} }}"
        source = self.pick("h.Arr", "arr", "h.L.ToArray()")
        return f"foreach (V {e} in {source}) {{ V {t} = {e}; {self.statement(level)} W({e}); W({t}); }}"

    def statement(self, level=0):
        made = [
            lambda: f"{self.place()} = {self.vector()};",
            lambda: f"{self.place()} = {self.vector()};",
            lambda: f"{self.place()}.Add({self.vector()});",
            lambda: f"{self.place()}.{self.pick('X', 'Y', 'Sum')} = {self.number()};",
            lambda: f"{self.big_place()} = {self.big()};",
            lambda: f"{self.big_place()}.N = {self.number()};",
            lambda: f"W({self.number()});",
            lambda: f"W({self.vector()});",
            lambda: f"{self.place()} += {self.vector()};",
            lambda: f"{self.place()}.AddD({self.number()});",
            lambda: self.pick("h.Auto", "h.L[0]", "h.L[k % 2]", "h.Gen.Auto", "h.Maybe", "boxed") + f" = {self.vector()};",
            lambda: f"h.L.Add({self.vector()});",
        ]
        if level < 2:
            made += [lambda: self.block(level + 1)] * 2
        return self.dice.choice(made)()

    def few(self, otherwise):
        """Two short statements for a method that expressions call, and what it gives after many calls."""
        self.depth = DEEPEST - 1
        text = f"if (++P.Calls > 40) return {otherwise}; {FEW}{self.statement(1)} {self.statement(1)} "
        self.depth = 0
        return text

    def text(self):
        own = self.few("1") + "return a.X + h.At.Y + z;"
        own = re.sub(r"(?<![.\w])(W|Same|Two|MakeBig|Set|Change)\(", r"P.\1(", own)
        change = self.few("new V()") + "return c;"
        body = "\n".join(f"        {self.statement()}" for _ in range(STATEMENTS))
        first = self.pick("h.At", "h.Arr[1]", "H.S", "h.B.A", "h.Bigs[0].B", "h.Grid[0, 1]")
        second = self.pick("h.B", "h.Bigs[1]", "H.T")
        shown = '" " '.join(["a + ", "+ b + ", "+ c + ", "+ q + ", "+ p + ", "+ cap + ", "+ big + ", "+ capbig + ", "+ r + ", "+ rb + ", "+ k"])
        return (
            f"{TYPES}    public int Own(int z) {{ H h = this; {own} }}\n}}\nclass P\n{{{HELPERS}    public static V Change(H h) {{ {change} }}\n"
            f"{RUN}{body}\n        W(h); W({shown} + string.Join(\";\", arr) + boxed);\n    }}\n"
            f"    static void Main()\n    {{\n        H h = new H(); Run(h, new V(2, 9), ref {first}, ref {second});\n"
            "        V m = new V(1, 1); Big n = new Big(); Calls = 0; Run(h, m, ref m, ref n); W(m); W(n);\n    }\n}\n"
        )


def printed(command):
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=False).stdout


def main():
    ours, first, last = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    folder = pathlib.Path(tempfile.mkdtemp(prefix="random-structs-"))
    compared = different = 0
    for seed in range(first, last):
        source, program = folder / f"{seed}.cs", folder / f"{seed}.exe"
        source.write_text(Program(seed).text())
        made = subprocess.run(["mcs", "-langversion:latest", "-warn:0", f"-out:{program}", str(source)], capture_output=True, text=True, check=False)
        if made.returncode:
            # An operand such as `k++` of nothing that may be changed.
            print(f"{seed}: Mono refuses it: {(made.stdout + made.stderr).splitlines()[0]}")
            continue
        compared += 1
        mono, own = printed(["mono", str(program)]), printed([ours, str(source)])
        program.unlink()
        if mono == own:
            source.unlink()
            continue
        different += 1
        line = next((pair for pair in zip(mono.splitlines(), own.splitlines()) if pair[0] != pair[1]), "one is longer")
        print(f"{seed}: {source}: {line}")
    print(f"{compared} programs, {different} differ")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
