using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

using System.Text.RegularExpressions;
class P { static void Main() {
 Match m = Regex.Match("key=val; k2=v2", @"(\w+)=(\w+)"); Console.WriteLine(m.Success + " " + m.Value + " " + m.Index + " " + m.Length + " " + m.Groups[1].Value + " " + m.Groups[2] + " " + m.Groups.Count); m = m.NextMatch(); Console.WriteLine(m.Value); m = m.NextMatch(); Console.WriteLine(m.Success + "[" + m.Value + "]");
 foreach (Match x in Regex.Matches("a1b22c333", @"\d+")) Console.Write(x.Value + "@" + x.Index + " "); Console.WriteLine();
 Console.WriteLine(Regex.Replace("hello world", "o", "0")); Console.WriteLine(Regex.Replace("John Smith", @"(\w+) (\w+)", "$2, $1")); Console.WriteLine(Regex.Replace("a-b-c", "-", m2 => "[" + m2.Index + "]")); Console.WriteLine(Regex.Replace("abc", "(?<x>b)", "<${x}>$$$&$`$'")); Console.WriteLine(new Regex("a").Replace("aaaa", "b", 2));
 Console.WriteLine(string.Join("|", Regex.Split("a, b;c", @"[,;]\s*"))); Console.WriteLine(string.Join("|", Regex.Split("1a2b3", "([a-z])"))); Console.WriteLine(string.Join("|", new Regex(",").Split("a,b,c,d", 2))); Console.WriteLine(string.Join("|", Regex.Split("abc", "")));
 Console.WriteLine(Regex.IsMatch("Hello", "^h", RegexOptions.IgnoreCase) + " " + Regex.IsMatch("Hello", "^h") + " " + Regex.IsMatch("a\nb", "^b$", RegexOptions.Multiline) + " " + Regex.IsMatch("a\nb", "a.b") + " " + Regex.IsMatch("a\nb", "a.b", RegexOptions.Singleline) + " " + Regex.IsMatch("ab\n", "b$") + " " + Regex.IsMatch("ab\n", @"b\z"));
 Match n = Regex.Match("2024-03-15", @"(?<y>\d{4})-(?<m>\d\d)-(?<d>\d\d)"); Console.WriteLine(n.Groups["y"].Value + n.Groups["m"] + n.Groups["d"] + " " + n.Groups["zz"].Success); Console.WriteLine(Regex.Match("xx<b>q</b>", @"<(\w+)>(.*?)</\1>").Groups[2]); Console.WriteLine(Regex.Match("foobar", "foo(?=bar)").Value + Regex.Match("foobaz", "foo(?!bar)").Value + Regex.Match("price $50", @"(?<=\$)\d+").Value);
 Console.WriteLine(Regex.Escape("a.b*c[d]")); Console.WriteLine(Regex.Match("aaa", "a+?").Value + Regex.Match("aaa", "a{2}").Value + Regex.Match("aaab", "a*b").Value); Console.WriteLine(Regex.Matches("aaa", "a*").Count + " " + Regex.Matches("ab", "a*").Count + " " + Regex.Matches("", "x*").Count);
 Console.WriteLine(Regex.Replace("x y", @"(?<first>\w) (\w)", "$1-$2")); Regex r = new Regex(@"(a)(?<n>b)?(c)"); Console.WriteLine(string.Join(",", r.GetGroupNames()) + " " + r.Match("ac").Groups["n"].Success + r + r.Options); Console.WriteLine(Regex.Match("abc", @"B", RegexOptions.IgnoreCase | RegexOptions.CultureInvariant).Value); Console.WriteLine(Regex.Match("a b", @"a \s b", RegexOptions.IgnorePatternWhitespace).Value + Regex.Match("[x]", @"[\[\]x]+").Value + Regex.Match("bcd", "[a-z-[bc]]").Value + Regex.Match("é€", @"\u20ac").Index + Regex.Match("a{,3}", "a{,3}").Length);
 try { new Regex("(a"); } catch (ArgumentException) { Console.WriteLine("bad"); } try { new Regex("*a"); } catch (ArgumentException) { Console.WriteLine("bad2"); } try { Regex.IsMatch(null, "a"); } catch (ArgumentNullException) { Console.WriteLine("null"); }
 Console.WriteLine(Regex.Replace("CamelCaseText", "([a-z])([A-Z])", "$1 $2")); Console.WriteLine(Regex.Replace("  a   b ", @"\s+", " ").Trim()); Console.WriteLine(Regex.Match("12.5mm", @"^-?\d+(\.\d+)?").Value); Console.WriteLine(string.Join(";", Regex.Matches("{1, 2, 3}", @"-?\d+").Cast<Match>().Select(q => int.Parse(q.Value) * 2)));
} }
