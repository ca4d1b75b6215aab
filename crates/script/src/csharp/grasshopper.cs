namespace Grasshopper.Kernel
{
    public enum GH_RuntimeMessageLevel { Blank = 0, Warning = 10, Error = 20, Remark = 255 }
    public class GH_Component
    {
        public List<string> Messages = new List<string>();
        public List<int> Levels = new List<int>();
        public string Name = ""; public string NickName = ""; public string Message = "";
        public void AddRuntimeMessage(GH_RuntimeMessageLevel level, string text) { Levels.Add((int)level); Messages.Add(text); }
    }
}
namespace Grasshopper.Kernel.Types { }
namespace Grasshopper.Kernel.Data
{
    public class GH_Path
    {
        int[] indices;
        public GH_Path() { indices = new int[0]; }
        public GH_Path(params int[] own) { indices = own; }
        public int Length { get { return indices.Length; } }
        public int[] Indices { get { return indices; } }
        public int this[int i] { get { return indices[i]; } }
        public GH_Path AppendElement(int i)
        {
            int[] more = new int[indices.Length + 1];
            for (int k = 0; k < indices.Length; k++) more[k] = indices[k];
            more[indices.Length] = i;
            return new GH_Path(more);
        }
        public static bool operator ==(GH_Path a, GH_Path b) { return object.ReferenceEquals(a, null) ? object.ReferenceEquals(b, null) : a.Equals(b); }
        public static bool operator !=(GH_Path a, GH_Path b) { return !(a == b); }
        public override bool Equals(object o)
        {
            GH_Path p = o as GH_Path;
            if (object.ReferenceEquals(p, null) || p.indices.Length != indices.Length) return false;
            for (int i = 0; i < indices.Length; i++) if (indices[i] != p.indices[i]) return false;
            return true;
        }
        public override int GetHashCode() { int h = 17; foreach (int i in indices) h = unchecked(h * 31 + i); return h; }
        public override string ToString() { return "{" + string.Join(";", indices) + "}"; }
    }
}
namespace Grasshopper
{
    using Grasshopper.Kernel.Data;
    public class DataTree<T>
    {
        List<GH_Path> paths = new List<GH_Path>();
        List<List<T>> branches = new List<List<T>>();
        public int BranchCount { get { return paths.Count; } }
        public List<GH_Path> Paths { get { return paths; } }
        public List<List<T>> Branches { get { return branches; } }
        public int DataCount { get { int n = 0; foreach (List<T> b in branches) n += b.Count; return n; } }
        public GH_Path Path(int i) { return paths[i]; }
        public List<T> Branch(int i) { return branches[i]; }
        public List<T> Branch(GH_Path p) { int i = Find(p); return i < 0 ? null : branches[i]; }
        public bool PathExists(GH_Path p) { return Find(p) >= 0; }
        public List<T> AllData() { List<T> all = new List<T>(); foreach (List<T> b in branches) all.AddRange(b); return all; }
        public void Add(T item) { Ensure(paths.Count == 0 ? new GH_Path(0) : paths[paths.Count - 1]).Add(item); }
        public void Add(T item, GH_Path p) { Ensure(p).Add(item); }
        public void AddRange(IEnumerable<T> items, GH_Path p) { Ensure(p).AddRange(items); }
        public List<T> EnsurePath(GH_Path p) { return Ensure(p); }
        public void Clear() { paths.Clear(); branches.Clear(); }
        int Find(GH_Path p) { for (int i = 0; i < paths.Count; i++) if (paths[i].Equals(p)) return i; return -1; }
        List<T> Ensure(GH_Path p)
        {
            int i = Find(p);
            if (i >= 0) return branches[i];
            paths.Add(p);
            List<T> own = new List<T>();
            branches.Add(own);
            return own;
        }
    }
}
public class GH_ScriptInstance
{
    public Grasshopper.Kernel.GH_Component Component = new Grasshopper.Kernel.GH_Component();
    protected int Iteration = 0;
    public void Print(string text) { Console.WriteLine(text); }
    public void Print(string format, params object[] args) { Console.WriteLine(string.Format(format, args)); }
    public void AddRuntimeMessage(Grasshopper.Kernel.GH_RuntimeMessageLevel level, string text) { Component.AddRuntimeMessage(level, text); }
}
