//! Programs in VB, with what they print by the rules of the language.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that meets an error fails")]

use crate::{Engine, Limits, Parts, Printing, Source};

fn printed(body: &str, additional: &str) -> Result<String, String> {
    let host = Printing::default();
    let text = host.text.clone();
    let source = Source::Basic(Parts {
        using: "",
        body,
        additional,
        parameters: "",
        usual: "using System; using System.Collections.Generic; using System.Linq;",
        base: "",
    });
    let all = |faults: Vec<crate::Diagnostic>| {
        faults.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
    };
    let mut engine = Engine::new(&source, Box::new(host), Limits::default()).map_err(all)?;
    let script = engine.create("Script_Instance").map_err(|e| e.to_string())?;
    let run = engine.method("Script_Instance", "RunScript").unwrap();
    let owner = engine.type_named("", "Script_Instance").unwrap();
    engine.call(run, owner, &[script]).map_err(|e| e.to_string())?;
    let text = text.lock().unwrap().trim_end().replace('\n', " ");
    Ok(text)
}

#[test]
fn programs_print_what_vb_says() {
    let cases = [
        ("Console.WriteLine(7 / 2 & \" \" & 7 \\ 2 & \" \" & 7 Mod 4 & \" \" & 2 ^ 3)", "", "3.5 3 3 8"),
        ("Dim i As Integer = 2.5\nDim j As Integer = 3.5\nConsole.WriteLine(i & \" \" & j)", "", "2 4"),
        ("Dim s As Integer\nFor i As Integer = 1 To 4\n  s += i\nNext\nConsole.WriteLine(s)", "", "10"),
        (
            "Dim i, s As Integer\nFor i = 10 To 0 Step -5\n s = s * 100 + i\nNext i\nConsole.WriteLine(s)",
            "",
            "100500",
        ),
        (
            "Dim a(2) As Double\na(1) = 4\nA(2) = a(1) + 1\nConsole.WriteLine(a.length & \" \" & a(2))",
            "",
            "3 5",
        ),
        (
            "Dim l As New List(Of Integer) From {3, 1, 2}\nl.Sort\nConsole.WriteLine(l(0) & l.count())",
            "",
            "13",
        ),
        (
            "Dim n = 0\nDo While n < 5\n n = n + 1\n If n = 2 Then Continue Do\n If n = 4 Then Exit Do\n Console.Write(n)\nLoop",
            "",
            "13",
        ),
        ("Dim n = 0\nDo\n n += 1\nLoop Until n >= 3\nConsole.WriteLine(n)", "", "3"),
        (
            "For Each w In {\"a\", \"b\"}\n Select Case w\n  Case \"a\", \"c\"\n   Console.Write(1)\n  Case Else\n   Console.Write(2)\n End Select\nNext",
            "",
            "12",
        ),
        (
            "Select Case 7\n Case 1 To 5\n  Console.Write(\"low\")\n Case Is > 6\n  Console.Write(\"high\")\nEnd Select",
            "",
            "high",
        ),
        ("Dim x = 5\nDim ok = x > 3 AndAlso Not x = 4 Or False\nConsole.WriteLine(ok)", "", "True"),
        ("Console.WriteLine(If(1 = 1, \"yes\", \"no\") & If(Nothing, \"none\"))", "", "yesnone"),
        ("Dim v = 0\nInteger.TryParse(\"42\", v)\nConsole.WriteLine(v)", "", "42"),
        (
            "Try\n Throw New Exception(\"bad\")\nCatch ex As Exception\n Console.WriteLine(ex.message)\nFinally\n Console.WriteLine(\"end\")\nEnd Try",
            "",
            "bad end",
        ),
        (
            "Console.WriteLine(Twice(4))\nDim k = 1\nBump(k)\nConsole.WriteLine(k)",
            "Function Twice(x As Integer) As Integer\n Twice = x * 2\nEnd Function\nSub Bump(ByRef n As Integer)\n n += 10\nEnd Sub",
            "8 11",
        ),
        // On Error: what fails is left out, and `Err` tells of it.
        (
            "On Error Resume Next\nDim a() As Integer = {1, 2}\nDim x As Integer = 5\nx = a(7)\nConsole.Write(x & \" \" & Err.Number & \" \")\nErr.Clear()\nConsole.Write(Err.Number)\nDim y As Integer = a(9)\nConsole.WriteLine(\" \" & y & \" \" & Err.Description)",
            "",
            "5 9 0 0 Index was outside the bounds of the array.",
        ),
        (
            "Console.WriteLine(Half(0) & Half(2))",
            "Function Half(n As Integer) As String\n On Error GoTo Wrong\n Dim q As Integer = 10 \\ n\n Return \"q\" & q\nWrong:\n Return \"e\" & Err.Number & \" \"\nEnd Function",
            "e11 q5",
        ),
        (
            "On Error GoTo 10\nDim s = \"\"\nFor i As Integer = 0 To 3\n Dim q As Integer = 12 \\ (i - 1)\n s &= q & \",\"\nNext\nConsole.WriteLine(s)\nExit Sub\n10: s &= \"!\"\nResume Next",
            "",
            "-12,!0,12,6,",
        ),
        (
            "Dim n As Integer = 0\nOn Error GoTo Mend\nConsole.WriteLine(8 \\ n)\nReturn\nMend:\n n = 4\n Resume",
            "",
            "2",
        ),
        (
            "On Error Resume Next\nDim o As Object = Nothing\nIf o.Length > 3 Then\n Console.Write(\"in \")\nEnd If\nConsole.Write(Err.Number & \" \")\nErr.Raise(513, \"me\", \"own\")\nConsole.WriteLine(Err.Number & Err.Source & Err.Description)\nOn Error GoTo 0\nTry\n Throw New Exception(\"bad\")\nCatch ex As Exception\n Console.WriteLine(ex.Message)\nEnd Try",
            "",
            "in 91 513meown bad",
        ),
        ("Dim i As Integer = 0\nAgain:\ni += 1\nIf i < 4 Then GoTo Again\nConsole.WriteLine(i)", "", "4"),
        // Loops that are not the innermost.
        (
            "For i As Integer = 0 To 3\n Dim j As Integer = 0\n While j < 9\n  j += 1\n  If j = 2 Then Continue For\n  If i = 2 Then Exit For\n  Console.Write(i & j & \" \")\n End While\nNext\nConsole.WriteLine(\"end\")",
            "",
            "01 11 end",
        ),
        (
            "Dim n As Integer = 0\nDo\n n += 1\n If n < 3 Then Continue Do\n Console.Write(n)\nLoop While n < 5",
            "",
            "345",
        ),
        ("Dim d As Decimal = 1.10D\nConsole.WriteLine(d * 2 & \" \" & CDec(\"0.50\") + 1D)", "", "2.20 1.50"),
        ("count += 1\nConsole.WriteLine(Count)", "Dim count As Integer = 4", "5"),
        ("Console.WriteLine({1, 2, 3}.Select(Function(x) x * x).Sum()) ' a comment\nREM another", "", "14"),
        ("Dim t As String = \"say \"\"hi\"\"\" & _\n \"!\"\nConsole.WriteLine(t)", "", "say \"hi\"!"),
        (
            "Dim o As Object = \"abc\"\nConsole.WriteLine(TypeOf o Is String)\nDim b As Boolean\nIf Not b Then Console.WriteLine(\"no\") Else Console.WriteLine(\"yes\")",
            "",
            "True no",
        ),
        ("Dim x As Object = 3\nDim y As Object = 4.5\nConsole.WriteLine(x + y)", "", "7.5"),
        // `+` of two texts joins, as text and as object; a text beside a number is a number (Option Strict Off).
        (
            "Dim x As Object = \"10.5\"\nDim y As Object = \"15.5\"\nDim n As Object = 2.5\nConsole.WriteLine(x + y)\nConsole.WriteLine(x + n)\nConsole.WriteLine(x * 2)",
            "",
            "10.515.5 13 21",
        ),
        (
            "Dim x As String = \"10.5\"\nDim y As String = \"15.5\"\nConsole.WriteLine(x + y)\nConsole.WriteLine(x + 1)\nConsole.WriteLine(x & 1)",
            "",
            "10.515.5 11.5 10.51",
        ),
        (
            "Dim l As New List(Of Integer)\nWith l\n .Add(1)\n .Add(2)\n Console.WriteLine(.Count)\nEnd With",
            "",
            "2",
        ),
        (
            "Dim p As New Pt\nWith p\n .X = 3\n .Y = .X + 1\nEnd With\nConsole.WriteLine(p.X & p.Y)",
            "Structure Pt\n Public X As Double\n Public Y As Double\nEnd Structure",
            "34",
        ),
        (
            "Dim a(1) As Integer\na(1) = 7\nReDim Preserve a(3)\na(3) = 1\nConsole.WriteLine(UBound(a) & \" \" & a(1) & a(3))\nReDim a(0)\nConsole.WriteLine(a(0) & a.Length)",
            "",
            "3 71 01",
        ),
        (
            "Dim m(1, 2) As Double\nm(1, 2) = 5\nConsole.WriteLine(m.Length & UBound(m, 2) & m(1, 2))\nReDim m(3, 3)\nConsole.WriteLine(m.Length)",
            "",
            "625 16",
        ),
        (
            "Dim b As New Box(4)\nb.Size += 1\nConsole.WriteLine(b.Size & b.Twice & b.Name)",
            "Class Box\n Private s As Double\n Public Property Name As String = \"n\"\n Public Sub New(v As Double)\n  s = v\n End Sub\n Public Property Size() As Double\n  Get\n   Return s\n  End Get\n  Set(ByVal v As Double)\n   s = v\n  End Set\n End Property\n ReadOnly Property Twice As Double\n  Get\n   Twice = s * 2\n  End Get\n End Property\nEnd Class",
            "510n",
        ),
        (
            "Dim d As New Derived(3)\nConsole.WriteLine(d.V)",
            "Class Base\n Public V As Integer\n Sub New(x As Integer)\n  V = x\n End Sub\nEnd Class\nClass Derived\n Inherits Base\n Sub New(x As Integer)\n  MyBase.New(x * 2)\n  V += 1\n End Sub\nEnd Class",
            "7",
        ),
        ("Console.WriteLine(Kind.B & \" \" & CInt(Kind.C))", "Enum Kind\n A\n B\n C = 7\nEnd Enum", "B 7"),
        (
            "Console.WriteLine(Left(\"hello\", 2) & Mid(\"hello\", 2, 3) & Right(\"hello\", 1) & Len(\"abc\") & InStr(\"hello\", \"l\"))\nConsole.WriteLine(UCase(\"a\") & Trim(\"  b \") & Val(\" 12.5abc\") & Chr(65) & Asc(\"B\") & StrReverse(\"xy\"))",
            "",
            "heello33 Ab12.5A66yx",
        ),
        (
            "Console.WriteLine(Join(Split(\"a,b,c\", \",\"), \"-\") & IIf(1 > 2, 1, 2) & IsNumeric(\"3.5\") & IsNumeric(\"x\") & IsNothing(Nothing))",
            "",
            "a-b-c2TrueFalseTrue",
        ),
        (
            "Console.WriteLine((\"abc\" Like \"a*\") & (\"abc\" Like \"a?d\") & (\"a1\" Like \"a#\") & (\"ab\" Like \"[a-c][!a]\"))",
            "",
            "TrueFalseTrueTrue",
        ),
        (
            "Console.WriteLine((Not 5) & \" \" & (Not True) & \" \" & (6 And 3) & (6 Xor 3) & \" \" & 7.6 \\ 2)",
            "",
            "-6 False 25 4",
        ),
        (
            "Dim f As Action(Of Integer) = Sub(x) Console.WriteLine(x + 1)\nf(1)\nDim g As Action = Sub()\n Console.WriteLine(2)\n Console.WriteLine(3)\nEnd Sub\ng()\nDim h As Func(Of Integer, Integer) = Function(x)\n If x > 1 Then Return 10\n Return 20\nEnd Function\nConsole.WriteLine(h(1) + h(2))",
            "",
            "2 2 3 30",
        ),
        (
            "Console.WriteLine(Sum(1) + Sum(1, 5))",
            "Function Sum(a As Integer, Optional b As Integer = 10) As Integer\n Return a + b\nEnd Function",
            "17",
        ),
    ];
    let mut wrong = Vec::new();
    for (body, additional, expected) in cases {
        match printed(body, additional) {
            Ok(given) if given == expected => {}
            given => wrong.push(format!("{body}\n  gave {given:?}, not {expected}")),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn what_is_not_there_is_said_by_name_and_line() {
    let failure = printed("Dim a = 1\nStatic b = 2", "").unwrap_err();
    assert_eq!(failure, "script(2,1): error: 'static' is not supported in VB");
    let failure = printed("Dim a = 1\nFor i = 0 To 1\n Do\n Exit While\n Loop\nNext", "").unwrap_err();
    assert!(failure.starts_with("script(4,") && failure.contains("Exit while"), "{failure}");
    let failure = printed("Dim a = 1\nDim b As Integer = a.Foo", "").unwrap_err();
    assert!(failure.starts_with("script(2,") && failure.contains("Foo"), "{failure}");
}

/// Text without end is refused, and nothing overflows the stack.
#[test]
fn deep_texts_are_refused() {
    let cases = [
        ("a = ", "-"),
        ("a = ", "Not "),
        ("a = ", "("),
        ("a = ", "{"),
        ("", "If a Then "),
        ("a = ", "CInt("),
        ("Dim a As ", "List(Of "),
        ("a = ", "If("),
        ("a = ", "AddressOf "),
        ("a = 2", " ^ 2"),
    ];
    for (head, again) in cases {
        assert!(printed(&format!("{head}{}", again.repeat(20_000)), "").is_err(), "{again}");
    }
}

/// No text of words and signs makes the front panic or hang.
#[test]
fn any_text_is_read_or_refused() {
    let words = [
        "Dim",
        "a",
        "As",
        "Integer",
        "=",
        "(",
        ")",
        "{",
        "}",
        "If",
        "Then",
        "Else",
        "End",
        "For",
        "Each",
        "In",
        "To",
        "Next",
        "1",
        "2.5",
        "\"t\"",
        "\n",
        ":",
        ",",
        ".",
        "New",
        "List",
        "Of",
        "Function",
        "Sub",
        "Select",
        "Case",
        "Do",
        "Loop",
        "While",
        "Not",
        "-",
        "&",
        "'",
        "_",
        "Class",
        "Try",
        "Catch",
        "Exit",
        "Return",
        "With",
        "ReDim",
        "Property",
        "Get",
        "Set",
        "Structure",
        "Enum",
        "\u{e9}",
        "[",
        "#",
    ];
    let mut state = 7_u64;
    for _ in 0..3_000 {
        let mut text = String::new();
        for _ in 0..40 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            text.push_str(words[(state >> 33) as usize % words.len()]);
            text.push(' ');
        }
        let _ = super::body(&text, &[]);
        let _ = super::members(&text, &[]);
    }
}
