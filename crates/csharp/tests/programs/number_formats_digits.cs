using System;
class P { static void Main() {
 foreach (var x in new double[]{0.1, 2.675, 1e22/3, 123456.789, 5e-324})
  foreach (var f in new string[]{"E14","E15","E16","E17","E20","F20","G18","G20","N17","F16","0.####################","#.##E+00","P20"}) Console.Write(x.ToString(f)+" | ");
 Console.WriteLine();
 foreach (var x in new float[]{0.1f, 2.675f, 1e22f/3, 123456.789f})
  foreach (var f in new string[]{"E6","E7","E5","E9","E12","F20","G8","G10","G20","N17","F7","0.####################","#.##E+00","R","C3","P3"}) Console.Write(x.ToString(f)+" | ");
 Console.WriteLine();
 foreach (var f in new string[]{"R","X","D3","Q","G0","E0","F0","G1","Z2"}) { try { Console.Write(5.ToString(f)+" | "); } catch (Exception e) { Console.Write(e.Message+" | "); } try { Console.Write((5.5).ToString(f)+" | "); } catch (Exception e) { Console.Write(e.Message+" | "); } }
 float q=0.1f; Console.WriteLine((decimal)q);
}}
