using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        char c = 'a'; c++; Console.WriteLine(c); c += (char)2; Console.WriteLine(c);
        int diff = 'z' - 'a'; Console.WriteLine(diff); Console.WriteLine('a' + 'b'); Console.WriteLine("" + 'a' + 'b'); Console.WriteLine('a' + "b" + 1 + 2); Console.WriteLine(1 + 2 + "x" + 'c');
        for (char k = 'x'; k <= 'z'; k++) Console.Write(k); Console.WriteLine();
        Console.WriteLine((char)('0' + 7)); Console.WriteLine('9' - '0'); Console.WriteLine(char.IsDigit('5') + " " + char.IsLetter('x') + " " + char.IsUpper('x') + " " + char.IsWhiteSpace('\t') + " " + char.IsLetterOrDigit('_') + " " + char.IsPunctuation('!'));
        Console.WriteLine(char.ToUpper('q') + "" + char.ToLower('Q') + " " + (int)char.MaxValue + " " + char.GetNumericValue('8'));
        Console.WriteLine('\u0041' + " " + '\x42' + '\\' + '\'' + "\"" + @"a\b""c" + "\t|\0|".Length);
        switch (c) { case 'd': Console.WriteLine("d"); break; case 'e': Console.WriteLine("e"); break; }
        string s = "hello"; int[] counts = new int[26]; foreach (char ch in s) counts[ch - 'a']++;
        Console.WriteLine(string.Join(",", counts)); Console.WriteLine(s[0] < s[1]); Console.WriteLine('a'.CompareTo('c') + " " + 'a'.Equals('a') + " " + 'x'.ToString());
    }
}
