using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

interface I { } class P { static void Main() { new I(); } }
