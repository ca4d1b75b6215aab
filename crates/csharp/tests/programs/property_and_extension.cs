using System;
using System.Collections.Generic;
using System.Linq;

class Bag
{
    List<int> items = new List<int> { 3, 1, 2 };
    public int Count { get { return -1; } }
    public IEnumerable<int> Items { get { return items; } }
}

static class More
{
    public static int Count(this Bag bag) { return bag.Items.Count() * 10; }
}

class P
{
    static void Main()
    {
        var list = new List<string> { "a", "b", "b" };
        Console.WriteLine(list.Count + " " + list.Count() + " " + list.Count(x => x == "b"));
        var bag = new Bag();
        Console.WriteLine(bag.Count + " " + bag.Count());
        IList<int> own = new List<int> { 1, 2 };
        Console.WriteLine(own.Count() + own.Count);
    }
}
