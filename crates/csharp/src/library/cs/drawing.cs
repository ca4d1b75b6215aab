// Colours, as System.Drawing has them; the named ones are those of CSS (CSS Color Module Level 4,
// section 6.1) but for DarkSeaGreen, whose blue is 8B in .NET.
namespace System.Drawing
{
    public struct Color : IEquatable<Color>
    {
        public static readonly Color Empty = new Color();
        private uint argb;
        private string name;
        private bool set;
        Color(string name, uint rgb) { argb = 0xFF000000 | rgb; this.name = name; set = true; }
        static void Check(int part, string name) { if (part < 0 || part > 255) throw new ArgumentException("Value of '" + part + "' is not valid for '" + name + "'. '" + name + "' should be greater than or equal to 0 and less than or equal to 255."); }
        public static Color FromArgb(int argb) { Color c = new Color(); c.argb = unchecked((uint)argb); c.set = true; return c; }
        public static Color FromArgb(int red, int green, int blue) { return FromArgb(255, red, green, blue); }
        public static Color FromArgb(int alpha, int red, int green, int blue)
        {
            Check(alpha, "alpha"); Check(red, "red"); Check(green, "green"); Check(blue, "blue");
            return FromArgb(alpha << 24 | red << 16 | green << 8 | blue);
        }
        public static Color FromArgb(int alpha, Color colour) { Check(alpha, "alpha"); return FromArgb(alpha << 24 | colour.ToArgb() & 0xFFFFFF); }
        // A name that is unknown gives a colour of that name without a value, as in .NET.
        public static Color FromName(string name)
        {
            Color c;
            if (Names().TryGetValue((name ?? "").ToLowerInvariant(), out c)) return c;
            c = new Color(); c.name = name; c.set = true;
            return c;
        }
        static System.Collections.Generic.Dictionary<string, Color> names = null;
        static System.Collections.Generic.Dictionary<string, Color> Names()
        {
            if (names != null) return names;
            names = new System.Collections.Generic.Dictionary<string, Color>();
            foreach (Color c in All) names[c.name.ToLowerInvariant()] = c;
            return names;
        }
        public byte A { get { return (byte)(argb >> 24); } }
        public byte R { get { return (byte)(argb >> 16 & 255); } }
        public byte G { get { return (byte)(argb >> 8 & 255); } }
        public byte B { get { return (byte)(argb & 255); } }
        public bool IsEmpty { get { return !set; } }
        public bool IsNamedColor { get { return name != null; } }
        public string Name { get { return name != null ? name : set ? argb.ToString("x") : "0"; } }
        public int ToArgb() { return unchecked((int)argb); }
        int Most { get { return Math.Max(R, Math.Max(G, B)); } }
        int Least { get { return Math.Min(R, Math.Min(G, B)); } }
        public float GetBrightness() { return (Most + Least) / 510f; }
        public float GetSaturation()
        {
            int most = Most, least = Least, sum = most + least;
            if (most == least) return 0;
            return (most - least) / (float)(sum > 255 ? 510 - sum : sum);
        }
        public float GetHue()
        {
            int most = Most;
            if (most == Least) return 0;
            float range = most - Least, hue;
            if (R == most) hue = (G - B) / range;
            else if (G == most) hue = 2 + (B - R) / range;
            else hue = 4 + (R - G) / range;
            hue *= 60;
            return hue < 0 ? hue + 360 : hue;
        }
        // A named colour and the same one without a name are not equal in .NET.
        public static bool operator ==(Color a, Color b) { return a.argb == b.argb && a.name == b.name && a.set == b.set; }
        public static bool operator !=(Color a, Color b) { return !(a == b); }
        public bool Equals(Color other) { return this == other; }
        public override bool Equals(object other) { return other is Color && this == (Color)other; }
        public override int GetHashCode() { return argb.GetHashCode() ^ (name == null ? 0 : name.GetHashCode()); }
        public override string ToString()
        {
            if (name != null) return "Color [" + name + "]";
            return set ? "Color [A=" + A + ", R=" + R + ", G=" + G + ", B=" + B + "]" : "Color [Empty]";
        }
        public static Color Transparent { get { Color c = new Color("Transparent", 0); c.argb = 0x00FFFFFF; return c; } }
        public static Color AliceBlue { get { return new Color("AliceBlue", 0xF0F8FF); } }
        public static Color AntiqueWhite { get { return new Color("AntiqueWhite", 0xFAEBD7); } }
        public static Color Aqua { get { return new Color("Aqua", 0x00FFFF); } }
        public static Color Aquamarine { get { return new Color("Aquamarine", 0x7FFFD4); } }
        public static Color Azure { get { return new Color("Azure", 0xF0FFFF); } }
        public static Color Beige { get { return new Color("Beige", 0xF5F5DC); } }
        public static Color Bisque { get { return new Color("Bisque", 0xFFE4C4); } }
        public static Color Black { get { return new Color("Black", 0x000000); } }
        public static Color BlanchedAlmond { get { return new Color("BlanchedAlmond", 0xFFEBCD); } }
        public static Color Blue { get { return new Color("Blue", 0x0000FF); } }
        public static Color BlueViolet { get { return new Color("BlueViolet", 0x8A2BE2); } }
        public static Color Brown { get { return new Color("Brown", 0xA52A2A); } }
        public static Color BurlyWood { get { return new Color("BurlyWood", 0xDEB887); } }
        public static Color CadetBlue { get { return new Color("CadetBlue", 0x5F9EA0); } }
        public static Color Chartreuse { get { return new Color("Chartreuse", 0x7FFF00); } }
        public static Color Chocolate { get { return new Color("Chocolate", 0xD2691E); } }
        public static Color Coral { get { return new Color("Coral", 0xFF7F50); } }
        public static Color CornflowerBlue { get { return new Color("CornflowerBlue", 0x6495ED); } }
        public static Color Cornsilk { get { return new Color("Cornsilk", 0xFFF8DC); } }
        public static Color Crimson { get { return new Color("Crimson", 0xDC143C); } }
        public static Color Cyan { get { return new Color("Cyan", 0x00FFFF); } }
        public static Color DarkBlue { get { return new Color("DarkBlue", 0x00008B); } }
        public static Color DarkCyan { get { return new Color("DarkCyan", 0x008B8B); } }
        public static Color DarkGoldenrod { get { return new Color("DarkGoldenrod", 0xB8860B); } }
        public static Color DarkGray { get { return new Color("DarkGray", 0xA9A9A9); } }
        public static Color DarkGreen { get { return new Color("DarkGreen", 0x006400); } }
        public static Color DarkKhaki { get { return new Color("DarkKhaki", 0xBDB76B); } }
        public static Color DarkMagenta { get { return new Color("DarkMagenta", 0x8B008B); } }
        public static Color DarkOliveGreen { get { return new Color("DarkOliveGreen", 0x556B2F); } }
        public static Color DarkOrange { get { return new Color("DarkOrange", 0xFF8C00); } }
        public static Color DarkOrchid { get { return new Color("DarkOrchid", 0x9932CC); } }
        public static Color DarkRed { get { return new Color("DarkRed", 0x8B0000); } }
        public static Color DarkSalmon { get { return new Color("DarkSalmon", 0xE9967A); } }
        public static Color DarkSeaGreen { get { return new Color("DarkSeaGreen", 0x8FBC8B); } }
        public static Color DarkSlateBlue { get { return new Color("DarkSlateBlue", 0x483D8B); } }
        public static Color DarkSlateGray { get { return new Color("DarkSlateGray", 0x2F4F4F); } }
        public static Color DarkTurquoise { get { return new Color("DarkTurquoise", 0x00CED1); } }
        public static Color DarkViolet { get { return new Color("DarkViolet", 0x9400D3); } }
        public static Color DeepPink { get { return new Color("DeepPink", 0xFF1493); } }
        public static Color DeepSkyBlue { get { return new Color("DeepSkyBlue", 0x00BFFF); } }
        public static Color DimGray { get { return new Color("DimGray", 0x696969); } }
        public static Color DodgerBlue { get { return new Color("DodgerBlue", 0x1E90FF); } }
        public static Color Firebrick { get { return new Color("Firebrick", 0xB22222); } }
        public static Color FloralWhite { get { return new Color("FloralWhite", 0xFFFAF0); } }
        public static Color ForestGreen { get { return new Color("ForestGreen", 0x228B22); } }
        public static Color Fuchsia { get { return new Color("Fuchsia", 0xFF00FF); } }
        public static Color Gainsboro { get { return new Color("Gainsboro", 0xDCDCDC); } }
        public static Color GhostWhite { get { return new Color("GhostWhite", 0xF8F8FF); } }
        public static Color Gold { get { return new Color("Gold", 0xFFD700); } }
        public static Color Goldenrod { get { return new Color("Goldenrod", 0xDAA520); } }
        public static Color Gray { get { return new Color("Gray", 0x808080); } }
        public static Color Green { get { return new Color("Green", 0x008000); } }
        public static Color GreenYellow { get { return new Color("GreenYellow", 0xADFF2F); } }
        public static Color Honeydew { get { return new Color("Honeydew", 0xF0FFF0); } }
        public static Color HotPink { get { return new Color("HotPink", 0xFF69B4); } }
        public static Color IndianRed { get { return new Color("IndianRed", 0xCD5C5C); } }
        public static Color Indigo { get { return new Color("Indigo", 0x4B0082); } }
        public static Color Ivory { get { return new Color("Ivory", 0xFFFFF0); } }
        public static Color Khaki { get { return new Color("Khaki", 0xF0E68C); } }
        public static Color Lavender { get { return new Color("Lavender", 0xE6E6FA); } }
        public static Color LavenderBlush { get { return new Color("LavenderBlush", 0xFFF0F5); } }
        public static Color LawnGreen { get { return new Color("LawnGreen", 0x7CFC00); } }
        public static Color LemonChiffon { get { return new Color("LemonChiffon", 0xFFFACD); } }
        public static Color LightBlue { get { return new Color("LightBlue", 0xADD8E6); } }
        public static Color LightCoral { get { return new Color("LightCoral", 0xF08080); } }
        public static Color LightCyan { get { return new Color("LightCyan", 0xE0FFFF); } }
        public static Color LightGoldenrodYellow { get { return new Color("LightGoldenrodYellow", 0xFAFAD2); } }
        public static Color LightGray { get { return new Color("LightGray", 0xD3D3D3); } }
        public static Color LightGreen { get { return new Color("LightGreen", 0x90EE90); } }
        public static Color LightPink { get { return new Color("LightPink", 0xFFB6C1); } }
        public static Color LightSalmon { get { return new Color("LightSalmon", 0xFFA07A); } }
        public static Color LightSeaGreen { get { return new Color("LightSeaGreen", 0x20B2AA); } }
        public static Color LightSkyBlue { get { return new Color("LightSkyBlue", 0x87CEFA); } }
        public static Color LightSlateGray { get { return new Color("LightSlateGray", 0x778899); } }
        public static Color LightSteelBlue { get { return new Color("LightSteelBlue", 0xB0C4DE); } }
        public static Color LightYellow { get { return new Color("LightYellow", 0xFFFFE0); } }
        public static Color Lime { get { return new Color("Lime", 0x00FF00); } }
        public static Color LimeGreen { get { return new Color("LimeGreen", 0x32CD32); } }
        public static Color Linen { get { return new Color("Linen", 0xFAF0E6); } }
        public static Color Magenta { get { return new Color("Magenta", 0xFF00FF); } }
        public static Color Maroon { get { return new Color("Maroon", 0x800000); } }
        public static Color MediumAquamarine { get { return new Color("MediumAquamarine", 0x66CDAA); } }
        public static Color MediumBlue { get { return new Color("MediumBlue", 0x0000CD); } }
        public static Color MediumOrchid { get { return new Color("MediumOrchid", 0xBA55D3); } }
        public static Color MediumPurple { get { return new Color("MediumPurple", 0x9370DB); } }
        public static Color MediumSeaGreen { get { return new Color("MediumSeaGreen", 0x3CB371); } }
        public static Color MediumSlateBlue { get { return new Color("MediumSlateBlue", 0x7B68EE); } }
        public static Color MediumSpringGreen { get { return new Color("MediumSpringGreen", 0x00FA9A); } }
        public static Color MediumTurquoise { get { return new Color("MediumTurquoise", 0x48D1CC); } }
        public static Color MediumVioletRed { get { return new Color("MediumVioletRed", 0xC71585); } }
        public static Color MidnightBlue { get { return new Color("MidnightBlue", 0x191970); } }
        public static Color MintCream { get { return new Color("MintCream", 0xF5FFFA); } }
        public static Color MistyRose { get { return new Color("MistyRose", 0xFFE4E1); } }
        public static Color Moccasin { get { return new Color("Moccasin", 0xFFE4B5); } }
        public static Color NavajoWhite { get { return new Color("NavajoWhite", 0xFFDEAD); } }
        public static Color Navy { get { return new Color("Navy", 0x000080); } }
        public static Color OldLace { get { return new Color("OldLace", 0xFDF5E6); } }
        public static Color Olive { get { return new Color("Olive", 0x808000); } }
        public static Color OliveDrab { get { return new Color("OliveDrab", 0x6B8E23); } }
        public static Color Orange { get { return new Color("Orange", 0xFFA500); } }
        public static Color OrangeRed { get { return new Color("OrangeRed", 0xFF4500); } }
        public static Color Orchid { get { return new Color("Orchid", 0xDA70D6); } }
        public static Color PaleGoldenrod { get { return new Color("PaleGoldenrod", 0xEEE8AA); } }
        public static Color PaleGreen { get { return new Color("PaleGreen", 0x98FB98); } }
        public static Color PaleTurquoise { get { return new Color("PaleTurquoise", 0xAFEEEE); } }
        public static Color PaleVioletRed { get { return new Color("PaleVioletRed", 0xDB7093); } }
        public static Color PapayaWhip { get { return new Color("PapayaWhip", 0xFFEFD5); } }
        public static Color PeachPuff { get { return new Color("PeachPuff", 0xFFDAB9); } }
        public static Color Peru { get { return new Color("Peru", 0xCD853F); } }
        public static Color Pink { get { return new Color("Pink", 0xFFC0CB); } }
        public static Color Plum { get { return new Color("Plum", 0xDDA0DD); } }
        public static Color PowderBlue { get { return new Color("PowderBlue", 0xB0E0E6); } }
        public static Color Purple { get { return new Color("Purple", 0x800080); } }
        public static Color Red { get { return new Color("Red", 0xFF0000); } }
        public static Color RosyBrown { get { return new Color("RosyBrown", 0xBC8F8F); } }
        public static Color RoyalBlue { get { return new Color("RoyalBlue", 0x4169E1); } }
        public static Color SaddleBrown { get { return new Color("SaddleBrown", 0x8B4513); } }
        public static Color Salmon { get { return new Color("Salmon", 0xFA8072); } }
        public static Color SandyBrown { get { return new Color("SandyBrown", 0xF4A460); } }
        public static Color SeaGreen { get { return new Color("SeaGreen", 0x2E8B57); } }
        public static Color SeaShell { get { return new Color("SeaShell", 0xFFF5EE); } }
        public static Color Sienna { get { return new Color("Sienna", 0xA0522D); } }
        public static Color Silver { get { return new Color("Silver", 0xC0C0C0); } }
        public static Color SkyBlue { get { return new Color("SkyBlue", 0x87CEEB); } }
        public static Color SlateBlue { get { return new Color("SlateBlue", 0x6A5ACD); } }
        public static Color SlateGray { get { return new Color("SlateGray", 0x708090); } }
        public static Color Snow { get { return new Color("Snow", 0xFFFAFA); } }
        public static Color SpringGreen { get { return new Color("SpringGreen", 0x00FF7F); } }
        public static Color SteelBlue { get { return new Color("SteelBlue", 0x4682B4); } }
        public static Color Tan { get { return new Color("Tan", 0xD2B48C); } }
        public static Color Teal { get { return new Color("Teal", 0x008080); } }
        public static Color Thistle { get { return new Color("Thistle", 0xD8BFD8); } }
        public static Color Tomato { get { return new Color("Tomato", 0xFF6347); } }
        public static Color Turquoise { get { return new Color("Turquoise", 0x40E0D0); } }
        public static Color Violet { get { return new Color("Violet", 0xEE82EE); } }
        public static Color Wheat { get { return new Color("Wheat", 0xF5DEB3); } }
        public static Color White { get { return new Color("White", 0xFFFFFF); } }
        public static Color WhiteSmoke { get { return new Color("WhiteSmoke", 0xF5F5F5); } }
        public static Color Yellow { get { return new Color("Yellow", 0xFFFF00); } }
        public static Color YellowGreen { get { return new Color("YellowGreen", 0x9ACD32); } }
        static Color[] All
        {
            get
            {
                return new Color[] {
                    Transparent, AliceBlue, AntiqueWhite, Aqua, Aquamarine, Azure, Beige, Bisque, Black, BlanchedAlmond,
                    Blue, BlueViolet, Brown, BurlyWood, CadetBlue, Chartreuse, Chocolate, Coral,
                    CornflowerBlue, Cornsilk, Crimson, Cyan, DarkBlue, DarkCyan, DarkGoldenrod, DarkGray,
                    DarkGreen, DarkKhaki, DarkMagenta, DarkOliveGreen, DarkOrange, DarkOrchid, DarkRed,
                    DarkSalmon, DarkSeaGreen, DarkSlateBlue, DarkSlateGray, DarkTurquoise, DarkViolet,
                    DeepPink, DeepSkyBlue, DimGray, DodgerBlue, Firebrick, FloralWhite, ForestGreen, Fuchsia,
                    Gainsboro, GhostWhite, Gold, Goldenrod, Gray, Green, GreenYellow, Honeydew, HotPink,
                    IndianRed, Indigo, Ivory, Khaki, Lavender, LavenderBlush, LawnGreen, LemonChiffon,
                    LightBlue, LightCoral, LightCyan, LightGoldenrodYellow, LightGray, LightGreen, LightPink,
                    LightSalmon, LightSeaGreen, LightSkyBlue, LightSlateGray, LightSteelBlue, LightYellow,
                    Lime, LimeGreen, Linen, Magenta, Maroon, MediumAquamarine, MediumBlue, MediumOrchid,
                    MediumPurple, MediumSeaGreen, MediumSlateBlue, MediumSpringGreen, MediumTurquoise,
                    MediumVioletRed, MidnightBlue, MintCream, MistyRose, Moccasin, NavajoWhite, Navy, OldLace,
                    Olive, OliveDrab, Orange, OrangeRed, Orchid, PaleGoldenrod, PaleGreen, PaleTurquoise,
                    PaleVioletRed, PapayaWhip, PeachPuff, Peru, Pink, Plum, PowderBlue, Purple, Red, RosyBrown,
                    RoyalBlue, SaddleBrown, Salmon, SandyBrown, SeaGreen, SeaShell, Sienna, Silver, SkyBlue,
                    SlateBlue, SlateGray, Snow, SpringGreen, SteelBlue, Tan, Teal, Thistle, Tomato, Turquoise,
                    Violet, Wheat, White, WhiteSmoke, Yellow, YellowGreen
                };
            }
        }
    }
}
