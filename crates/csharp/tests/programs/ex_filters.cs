using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class MyEx : Exception { public int Code; public MyEx(int code) : base("my " + code) { Code = code; } }
class P {
 static bool Log(string s) { Console.WriteLine("log " + s); return false; }
 static void Try(int n) { try { try { if (n < 0) throw new ArgumentException("neg", "n"); if (n == 0) throw new DivideByZeroException(); throw new MyEx(n); } catch (MyEx e) when (e.Code == 1) { Console.WriteLine("one"); } catch (MyEx e) when (Log(e.Message) || e.Code == 2) { Console.WriteLine("two"); } catch (ArithmeticException e) { Console.WriteLine(e.GetType().Name + " " + e.Message); } finally { Console.WriteLine("fin " + n); } } catch (Exception e) { Console.WriteLine("outer " + e.GetType() + ": " + e.Message); } }
 static int Ret() { try { return 1; } finally { Console.WriteLine("cleanup"); } }
 static int Deep(int n) { if (n == 0) throw new InvalidOperationException("deep"); try { return Deep(n - 1); } finally { Console.Write(n + " "); } }
 static void Main() { for (int i = -1; i < 4; i++) Try(i); Console.WriteLine(Ret()); try { Deep(3); } catch (InvalidOperationException e) { Console.WriteLine(e.Message); }
  try { try { throw new Exception("a"); } finally { Console.WriteLine("f"); } } catch (Exception e) { Console.WriteLine(e.Message); } try { try { throw new Exception("x"); } catch (Exception e) { throw new Exception("y", e); } } catch (Exception e) { Console.WriteLine(e.Message + " " + e.InnerException.Message + " " + (e.GetBaseException() == e.InnerException)); }
  try { try { throw new MyEx(5); } catch { throw; } } catch (MyEx e) { Console.WriteLine(e.Code); } for (int i = 0; i < 3; i++) { try { if (i == 1) continue; Console.WriteLine(i); } finally { Console.WriteLine("f" + i); } } try { object o = "s"; int k = (int)o; } catch (InvalidCastException) { Console.WriteLine("cast"); } try { string s = null; s.Trim(); } catch (NullReferenceException) { Console.WriteLine("null"); } try { int[] a = new int[2]; a[2] = 1; } catch (IndexOutOfRangeException e) { Console.WriteLine(e.Message); } try { new List<int>()[0] = 1; } catch (ArgumentOutOfRangeException) { Console.WriteLine("range"); } try { new Dictionary<string, int>()["q"]++; } catch (KeyNotFoundException) { Console.WriteLine("key"); } try { int.Parse("x"); } catch (FormatException) { Console.WriteLine("format"); } try { Enumerable.Empty<int>().First(); } catch (InvalidOperationException e) { Console.WriteLine(e.Message); } try { throw null; } catch (NullReferenceException) { Console.WriteLine("nullthrow"); } } }
