using System;

enum Sort { A, B }
struct S { public int N; public S(int n) { N = n; } }

class P
{
    static void Set(ref double x) { x += 0.5; }
    static void Fill(out byte b) { b = 250; }

    static void Main()
    {
        var bools = new bool[3]; bools[1] = true;
        var bytes = new byte[3]; bytes[0] = 255; bytes[0]++; bytes[1] += 200; Fill(out bytes[2]);
        var chars = new char[3]; chars[1] = 'x'; chars[1]++;
        var ints = new int[3]; ints[1]--; ints[2] = ints[1] << 4;
        var longs = new long[2]; longs[0] = long.MaxValue; longs[0]++;
        var floats = new float[2]; floats[0] = 0.1f; floats[1] = floats[0] * 3;
        var doubles = new double[2]; Set(ref doubles[1]); doubles[0] = doubles[1] / 0;
        var shorts = new short[2]; shorts[0] = 32767; shorts[0]++;
        Console.WriteLine(string.Join(" ", bools) + " " + string.Join(" ", bytes) + " " + new string(chars, 1, 1) + (int)chars[0]);
        Console.WriteLine(string.Join(" ", ints) + " " + string.Join(" ", longs) + " " + floats[1] + " " + doubles[1] + " " + doubles[0] + " " + shorts[0]);
        var grid = new double[2, 3]; grid[1, 2] = 4; grid[0, 1] -= 1.5; Set(ref grid[1, 0]);
        foreach (double x in grid) Console.Write(x + " ");
        var jagged = new int[2][]; jagged[0] = new[] { 1, 2 }; Console.WriteLine(jagged[1] == null);
        var sorts = new Sort[2]; sorts[1] = Sort.B; Console.WriteLine(sorts[0] + " " + sorts[1]);
        object[] boxes = { 1, 2, 3 }; boxes[1] = "two"; boxes[2] = null;
        Console.WriteLine(boxes[0] + "," + boxes[1] + "," + boxes[2]);
        int?[] maybe = { 1, 2 }; maybe[0] = null; Console.WriteLine(maybe[0].HasValue + " " + maybe[1]);
        var structs = new S[2]; structs[0].N = 5; structs[1] = structs[0]; structs[1].N++; Console.WriteLine(structs[0].N + " " + structs[1].N);
        var copy = (int[])ints.Clone(); copy[0] = 9; Array.Reverse(copy); Array.Sort(copy);
        Console.WriteLine(ints[0] + " " + string.Join(" ", copy));
        Array.Copy(copy, 0, ints, 1, 2); Array.Resize(ref ints, 5); Array.Clear(copy, 0, 2);
        Console.WriteLine(string.Join(" ", ints) + " " + string.Join(" ", copy) + " " + Array.IndexOf(ints, 9));
        try { ints[5] = 1; } catch (IndexOutOfRangeException) { Console.WriteLine("range"); }
        try { Console.WriteLine(bools[-1]); } catch (IndexOutOfRangeException) { Console.WriteLine("range"); }
        try { grid[2, 0] = 1; } catch (IndexOutOfRangeException) { Console.WriteLine("range"); }
        double sum = 0;
        foreach (float f in floats) sum += f;
        foreach (char c in "abc".ToCharArray()) sum += c;
        Console.WriteLine(sum > 294.39 && sum < 294.41);
        Array any = doubles; any.SetValue(2.5, 0); Console.WriteLine(any.GetValue(0) + " " + any.Length);
    }
}
