using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { static void Main() { var l = new System.Collections.Generic.List<int>(); l.Add("x"); } }
