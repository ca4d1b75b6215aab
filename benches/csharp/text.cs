// A text of 2,000,000 numbers and signs, and a look at every character of it.
using System;
using System.Text;

class P
{
    static void Main()
    {
        var built = new StringBuilder();
        for (int i = 0; i < 1000000; i++)
        {
            built.Append(i % 1000);
            built.Append(i % 3 == 0 ? ';' : ',');
        }
        string text = built.ToString();
        int sum = 0;
        for (int i = 0; i < text.Length; i++) if (text[i] == ';') sum += i % 7;
        Console.WriteLine(text.Length + " " + sum);
    }
}
