// Tuples of two to seven elements.
using System.Collections.Generic;

namespace System
{
    public struct ValueTuple<A, B> : IComparable, IComparable<ValueTuple<A, B>>, IEquatable<ValueTuple<A, B>>
    {
        public A Item1; public B Item2;
        public ValueTuple(A a, B b) { Item1 = a; Item2 = b; }
        public int CompareTo(ValueTuple<A, B> t) { int c; c = Comparer<A>.Order(Item1, t.Item1); if (c != 0) return c; c = Comparer<B>.Order(Item2, t.Item2); return c; }
        int IComparable.CompareTo(object o) { if (o == null) return 1; if (!(o is ValueTuple<A, B>)) throw new ArgumentException("Argument must be of type ValueTuple.", "other"); return CompareTo((ValueTuple<A, B>)o); }
        public bool Equals(ValueTuple<A, B> t) { return EqualityComparer<A>.Same(Item1, t.Item1) && EqualityComparer<B>.Same(Item2, t.Item2); }
        public override bool Equals(object o) { return o is ValueTuple<A, B> && Equals((ValueTuple<A, B>)o); }
        public override int GetHashCode() { return EqualityComparer<A>.Hash(Item1) * 31 + EqualityComparer<B>.Hash(Item2); }
        public override string ToString() { return "(" + Item1 + ", " + Item2 + ")"; }
    }
    public class Tuple<A, B> : IComparable
    {
        public A Item1 { get; private set; } public B Item2 { get; private set; }
        public Tuple(A a, B b) { Item1 = a; Item2 = b; }
        int IComparable.CompareTo(object o) { if (o == null) return 1; var t = o as Tuple<A, B>; if (t == null) throw new ArgumentException("Argument must be of type Tuple.", "other"); int c; c = Comparer<A>.Order(Item1, t.Item1); if (c != 0) return c; c = Comparer<B>.Order(Item2, t.Item2); return c; }
        public override bool Equals(object o) { var t = o as Tuple<A, B>; return t != null && EqualityComparer<A>.Same(Item1, t.Item1) && EqualityComparer<B>.Same(Item2, t.Item2); }
        public override int GetHashCode() { return EqualityComparer<A>.Hash(Item1) * 31 + EqualityComparer<B>.Hash(Item2); }
        public override string ToString() { return "(" + Item1 + ", " + Item2 + ")"; }
    }
    public struct ValueTuple<A, B, C> : IComparable, IComparable<ValueTuple<A, B, C>>, IEquatable<ValueTuple<A, B, C>>
    {
        public A Item1; public B Item2; public C Item3;
        public ValueTuple(A a, B b, C c) { Item1 = a; Item2 = b; Item3 = c; }
        public int CompareTo(ValueTuple<A, B, C> t) { int c; c = Comparer<A>.Order(Item1, t.Item1); if (c != 0) return c; c = Comparer<B>.Order(Item2, t.Item2); if (c != 0) return c; c = Comparer<C>.Order(Item3, t.Item3); return c; }
        int IComparable.CompareTo(object o) { if (o == null) return 1; if (!(o is ValueTuple<A, B, C>)) throw new ArgumentException("Argument must be of type ValueTuple.", "other"); return CompareTo((ValueTuple<A, B, C>)o); }
        public bool Equals(ValueTuple<A, B, C> t) { return EqualityComparer<A>.Same(Item1, t.Item1) && EqualityComparer<B>.Same(Item2, t.Item2) && EqualityComparer<C>.Same(Item3, t.Item3); }
        public override bool Equals(object o) { return o is ValueTuple<A, B, C> && Equals((ValueTuple<A, B, C>)o); }
        public override int GetHashCode() { return (EqualityComparer<A>.Hash(Item1) * 31 + EqualityComparer<B>.Hash(Item2)) * 31 + EqualityComparer<C>.Hash(Item3); }
        public override string ToString() { return "(" + Item1 + ", " + Item2 + ", " + Item3 + ")"; }
    }
    public class Tuple<A, B, C> : IComparable
    {
        public A Item1 { get; private set; } public B Item2 { get; private set; } public C Item3 { get; private set; }
        public Tuple(A a, B b, C c) { Item1 = a; Item2 = b; Item3 = c; }
        int IComparable.CompareTo(object o) { if (o == null) return 1; var t = o as Tuple<A, B, C>; if (t == null) throw new ArgumentException("Argument must be of type Tuple.", "other"); int c; c = Comparer<A>.Order(Item1, t.Item1); if (c != 0) return c; c = Comparer<B>.Order(Item2, t.Item2); if (c != 0) return c; c = Comparer<C>.Order(Item3, t.Item3); return c; }
        public override bool Equals(object o) { var t = o as Tuple<A, B, C>; return t != null && EqualityComparer<A>.Same(Item1, t.Item1) && EqualityComparer<B>.Same(Item2, t.Item2) && EqualityComparer<C>.Same(Item3, t.Item3); }
        public override int GetHashCode() { return (EqualityComparer<A>.Hash(Item1) * 31 + EqualityComparer<B>.Hash(Item2)) * 31 + EqualityComparer<C>.Hash(Item3); }
        public override string ToString() { return "(" + Item1 + ", " + Item2 + ", " + Item3 + ")"; }
    }
    public struct ValueTuple<A, B, C, D> : IComparable, IComparable<ValueTuple<A, B, C, D>>, IEquatable<ValueTuple<A, B, C, D>>
    {
        public A Item1; public B Item2; public C Item3; public D Item4;
        public ValueTuple(A a, B b, C c, D d) { Item1 = a; Item2 = b; Item3 = c; Item4 = d; }
        public int CompareTo(ValueTuple<A, B, C, D> t) { int c; c = Comparer<A>.Order(Item1, t.Item1); if (c != 0) return c; c = Comparer<B>.Order(Item2, t.Item2); if (c != 0) return c; c = Comparer<C>.Order(Item3, t.Item3); if (c != 0) return c; c = Comparer<D>.Order(Item4, t.Item4); return c; }
        int IComparable.CompareTo(object o) { if (o == null) return 1; if (!(o is ValueTuple<A, B, C, D>)) throw new ArgumentException("Argument must be of type ValueTuple.", "other"); return CompareTo((ValueTuple<A, B, C, D>)o); }
        public bool Equals(ValueTuple<A, B, C, D> t) { return EqualityComparer<A>.Same(Item1, t.Item1) && EqualityComparer<B>.Same(Item2, t.Item2) && EqualityComparer<C>.Same(Item3, t.Item3) && EqualityComparer<D>.Same(Item4, t.Item4); }
        public override bool Equals(object o) { return o is ValueTuple<A, B, C, D> && Equals((ValueTuple<A, B, C, D>)o); }
        public override int GetHashCode() { return ((EqualityComparer<A>.Hash(Item1) * 31 + EqualityComparer<B>.Hash(Item2)) * 31 + EqualityComparer<C>.Hash(Item3)) * 31 + EqualityComparer<D>.Hash(Item4); }
        public override string ToString() { return "(" + Item1 + ", " + Item2 + ", " + Item3 + ", " + Item4 + ")"; }
    }
    public class Tuple<A, B, C, D> : IComparable
    {
        public A Item1 { get; private set; } public B Item2 { get; private set; } public C Item3 { get; private set; } public D Item4 { get; private set; }
        public Tuple(A a, B b, C c, D d) { Item1 = a; Item2 = b; Item3 = c; Item4 = d; }
        int IComparable.CompareTo(object o) { if (o == null) return 1; var t = o as Tuple<A, B, C, D>; if (t == null) throw new ArgumentException("Argument must be of type Tuple.", "other"); int c; c = Comparer<A>.Order(Item1, t.Item1); if (c != 0) return c; c = Comparer<B>.Order(Item2, t.Item2); if (c != 0) return c; c = Comparer<C>.Order(Item3, t.Item3); if (c != 0) return c; c = Comparer<D>.Order(Item4, t.Item4); return c; }
        public override bool Equals(object o) { var t = o as Tuple<A, B, C, D>; return t != null && EqualityComparer<A>.Same(Item1, t.Item1) && EqualityComparer<B>.Same(Item2, t.Item2) && EqualityComparer<C>.Same(Item3, t.Item3) && EqualityComparer<D>.Same(Item4, t.Item4); }
        public override int GetHashCode() { return ((EqualityComparer<A>.Hash(Item1) * 31 + EqualityComparer<B>.Hash(Item2)) * 31 + EqualityComparer<C>.Hash(Item3)) * 31 + EqualityComparer<D>.Hash(Item4); }
        public override string ToString() { return "(" + Item1 + ", " + Item2 + ", " + Item3 + ", " + Item4 + ")"; }
    }
    public struct ValueTuple<A, B, C, D, E> : IComparable, IComparable<ValueTuple<A, B, C, D, E>>, IEquatable<ValueTuple<A, B, C, D, E>>
    {
        public A Item1; public B Item2; public C Item3; public D Item4; public E Item5;
        public ValueTuple(A a, B b, C c, D d, E e) { Item1 = a; Item2 = b; Item3 = c; Item4 = d; Item5 = e; }
        public int CompareTo(ValueTuple<A, B, C, D, E> t) { int c; c = Comparer<A>.Order(Item1, t.Item1); if (c != 0) return c; c = Comparer<B>.Order(Item2, t.Item2); if (c != 0) return c; c = Comparer<C>.Order(Item3, t.Item3); if (c != 0) return c; c = Comparer<D>.Order(Item4, t.Item4); if (c != 0) return c; c = Comparer<E>.Order(Item5, t.Item5); return c; }
        int IComparable.CompareTo(object o) { if (o == null) return 1; if (!(o is ValueTuple<A, B, C, D, E>)) throw new ArgumentException("Argument must be of type ValueTuple.", "other"); return CompareTo((ValueTuple<A, B, C, D, E>)o); }
        public bool Equals(ValueTuple<A, B, C, D, E> t) { return EqualityComparer<A>.Same(Item1, t.Item1) && EqualityComparer<B>.Same(Item2, t.Item2) && EqualityComparer<C>.Same(Item3, t.Item3) && EqualityComparer<D>.Same(Item4, t.Item4) && EqualityComparer<E>.Same(Item5, t.Item5); }
        public override bool Equals(object o) { return o is ValueTuple<A, B, C, D, E> && Equals((ValueTuple<A, B, C, D, E>)o); }
        public override int GetHashCode() { return (((EqualityComparer<A>.Hash(Item1) * 31 + EqualityComparer<B>.Hash(Item2)) * 31 + EqualityComparer<C>.Hash(Item3)) * 31 + EqualityComparer<D>.Hash(Item4)) * 31 + EqualityComparer<E>.Hash(Item5); }
        public override string ToString() { return "(" + Item1 + ", " + Item2 + ", " + Item3 + ", " + Item4 + ", " + Item5 + ")"; }
    }
    public class Tuple<A, B, C, D, E> : IComparable
    {
        public A Item1 { get; private set; } public B Item2 { get; private set; } public C Item3 { get; private set; } public D Item4 { get; private set; } public E Item5 { get; private set; }
        public Tuple(A a, B b, C c, D d, E e) { Item1 = a; Item2 = b; Item3 = c; Item4 = d; Item5 = e; }
        int IComparable.CompareTo(object o) { if (o == null) return 1; var t = o as Tuple<A, B, C, D, E>; if (t == null) throw new ArgumentException("Argument must be of type Tuple.", "other"); int c; c = Comparer<A>.Order(Item1, t.Item1); if (c != 0) return c; c = Comparer<B>.Order(Item2, t.Item2); if (c != 0) return c; c = Comparer<C>.Order(Item3, t.Item3); if (c != 0) return c; c = Comparer<D>.Order(Item4, t.Item4); if (c != 0) return c; c = Comparer<E>.Order(Item5, t.Item5); return c; }
        public override bool Equals(object o) { var t = o as Tuple<A, B, C, D, E>; return t != null && EqualityComparer<A>.Same(Item1, t.Item1) && EqualityComparer<B>.Same(Item2, t.Item2) && EqualityComparer<C>.Same(Item3, t.Item3) && EqualityComparer<D>.Same(Item4, t.Item4) && EqualityComparer<E>.Same(Item5, t.Item5); }
        public override int GetHashCode() { return (((EqualityComparer<A>.Hash(Item1) * 31 + EqualityComparer<B>.Hash(Item2)) * 31 + EqualityComparer<C>.Hash(Item3)) * 31 + EqualityComparer<D>.Hash(Item4)) * 31 + EqualityComparer<E>.Hash(Item5); }
        public override string ToString() { return "(" + Item1 + ", " + Item2 + ", " + Item3 + ", " + Item4 + ", " + Item5 + ")"; }
    }
    public struct ValueTuple<A, B, C, D, E, F> : IComparable, IComparable<ValueTuple<A, B, C, D, E, F>>, IEquatable<ValueTuple<A, B, C, D, E, F>>
    {
        public A Item1; public B Item2; public C Item3; public D Item4; public E Item5; public F Item6;
        public ValueTuple(A a, B b, C c, D d, E e, F f) { Item1 = a; Item2 = b; Item3 = c; Item4 = d; Item5 = e; Item6 = f; }
        public int CompareTo(ValueTuple<A, B, C, D, E, F> t) { int c; c = Comparer<A>.Order(Item1, t.Item1); if (c != 0) return c; c = Comparer<B>.Order(Item2, t.Item2); if (c != 0) return c; c = Comparer<C>.Order(Item3, t.Item3); if (c != 0) return c; c = Comparer<D>.Order(Item4, t.Item4); if (c != 0) return c; c = Comparer<E>.Order(Item5, t.Item5); if (c != 0) return c; c = Comparer<F>.Order(Item6, t.Item6); return c; }
        int IComparable.CompareTo(object o) { if (o == null) return 1; if (!(o is ValueTuple<A, B, C, D, E, F>)) throw new ArgumentException("Argument must be of type ValueTuple.", "other"); return CompareTo((ValueTuple<A, B, C, D, E, F>)o); }
        public bool Equals(ValueTuple<A, B, C, D, E, F> t) { return EqualityComparer<A>.Same(Item1, t.Item1) && EqualityComparer<B>.Same(Item2, t.Item2) && EqualityComparer<C>.Same(Item3, t.Item3) && EqualityComparer<D>.Same(Item4, t.Item4) && EqualityComparer<E>.Same(Item5, t.Item5) && EqualityComparer<F>.Same(Item6, t.Item6); }
        public override bool Equals(object o) { return o is ValueTuple<A, B, C, D, E, F> && Equals((ValueTuple<A, B, C, D, E, F>)o); }
        public override int GetHashCode() { return ((((EqualityComparer<A>.Hash(Item1) * 31 + EqualityComparer<B>.Hash(Item2)) * 31 + EqualityComparer<C>.Hash(Item3)) * 31 + EqualityComparer<D>.Hash(Item4)) * 31 + EqualityComparer<E>.Hash(Item5)) * 31 + EqualityComparer<F>.Hash(Item6); }
        public override string ToString() { return "(" + Item1 + ", " + Item2 + ", " + Item3 + ", " + Item4 + ", " + Item5 + ", " + Item6 + ")"; }
    }
    public class Tuple<A, B, C, D, E, F> : IComparable
    {
        public A Item1 { get; private set; } public B Item2 { get; private set; } public C Item3 { get; private set; } public D Item4 { get; private set; } public E Item5 { get; private set; } public F Item6 { get; private set; }
        public Tuple(A a, B b, C c, D d, E e, F f) { Item1 = a; Item2 = b; Item3 = c; Item4 = d; Item5 = e; Item6 = f; }
        int IComparable.CompareTo(object o) { if (o == null) return 1; var t = o as Tuple<A, B, C, D, E, F>; if (t == null) throw new ArgumentException("Argument must be of type Tuple.", "other"); int c; c = Comparer<A>.Order(Item1, t.Item1); if (c != 0) return c; c = Comparer<B>.Order(Item2, t.Item2); if (c != 0) return c; c = Comparer<C>.Order(Item3, t.Item3); if (c != 0) return c; c = Comparer<D>.Order(Item4, t.Item4); if (c != 0) return c; c = Comparer<E>.Order(Item5, t.Item5); if (c != 0) return c; c = Comparer<F>.Order(Item6, t.Item6); return c; }
        public override bool Equals(object o) { var t = o as Tuple<A, B, C, D, E, F>; return t != null && EqualityComparer<A>.Same(Item1, t.Item1) && EqualityComparer<B>.Same(Item2, t.Item2) && EqualityComparer<C>.Same(Item3, t.Item3) && EqualityComparer<D>.Same(Item4, t.Item4) && EqualityComparer<E>.Same(Item5, t.Item5) && EqualityComparer<F>.Same(Item6, t.Item6); }
        public override int GetHashCode() { return ((((EqualityComparer<A>.Hash(Item1) * 31 + EqualityComparer<B>.Hash(Item2)) * 31 + EqualityComparer<C>.Hash(Item3)) * 31 + EqualityComparer<D>.Hash(Item4)) * 31 + EqualityComparer<E>.Hash(Item5)) * 31 + EqualityComparer<F>.Hash(Item6); }
        public override string ToString() { return "(" + Item1 + ", " + Item2 + ", " + Item3 + ", " + Item4 + ", " + Item5 + ", " + Item6 + ")"; }
    }
    public struct ValueTuple<A, B, C, D, E, F, G> : IComparable, IComparable<ValueTuple<A, B, C, D, E, F, G>>, IEquatable<ValueTuple<A, B, C, D, E, F, G>>
    {
        public A Item1; public B Item2; public C Item3; public D Item4; public E Item5; public F Item6; public G Item7;
        public ValueTuple(A a, B b, C c, D d, E e, F f, G g) { Item1 = a; Item2 = b; Item3 = c; Item4 = d; Item5 = e; Item6 = f; Item7 = g; }
        public int CompareTo(ValueTuple<A, B, C, D, E, F, G> t) { int c; c = Comparer<A>.Order(Item1, t.Item1); if (c != 0) return c; c = Comparer<B>.Order(Item2, t.Item2); if (c != 0) return c; c = Comparer<C>.Order(Item3, t.Item3); if (c != 0) return c; c = Comparer<D>.Order(Item4, t.Item4); if (c != 0) return c; c = Comparer<E>.Order(Item5, t.Item5); if (c != 0) return c; c = Comparer<F>.Order(Item6, t.Item6); if (c != 0) return c; c = Comparer<G>.Order(Item7, t.Item7); return c; }
        int IComparable.CompareTo(object o) { if (o == null) return 1; if (!(o is ValueTuple<A, B, C, D, E, F, G>)) throw new ArgumentException("Argument must be of type ValueTuple.", "other"); return CompareTo((ValueTuple<A, B, C, D, E, F, G>)o); }
        public bool Equals(ValueTuple<A, B, C, D, E, F, G> t) { return EqualityComparer<A>.Same(Item1, t.Item1) && EqualityComparer<B>.Same(Item2, t.Item2) && EqualityComparer<C>.Same(Item3, t.Item3) && EqualityComparer<D>.Same(Item4, t.Item4) && EqualityComparer<E>.Same(Item5, t.Item5) && EqualityComparer<F>.Same(Item6, t.Item6) && EqualityComparer<G>.Same(Item7, t.Item7); }
        public override bool Equals(object o) { return o is ValueTuple<A, B, C, D, E, F, G> && Equals((ValueTuple<A, B, C, D, E, F, G>)o); }
        public override int GetHashCode() { return (((((EqualityComparer<A>.Hash(Item1) * 31 + EqualityComparer<B>.Hash(Item2)) * 31 + EqualityComparer<C>.Hash(Item3)) * 31 + EqualityComparer<D>.Hash(Item4)) * 31 + EqualityComparer<E>.Hash(Item5)) * 31 + EqualityComparer<F>.Hash(Item6)) * 31 + EqualityComparer<G>.Hash(Item7); }
        public override string ToString() { return "(" + Item1 + ", " + Item2 + ", " + Item3 + ", " + Item4 + ", " + Item5 + ", " + Item6 + ", " + Item7 + ")"; }
    }
    public class Tuple<A, B, C, D, E, F, G> : IComparable
    {
        public A Item1 { get; private set; } public B Item2 { get; private set; } public C Item3 { get; private set; } public D Item4 { get; private set; } public E Item5 { get; private set; } public F Item6 { get; private set; } public G Item7 { get; private set; }
        public Tuple(A a, B b, C c, D d, E e, F f, G g) { Item1 = a; Item2 = b; Item3 = c; Item4 = d; Item5 = e; Item6 = f; Item7 = g; }
        int IComparable.CompareTo(object o) { if (o == null) return 1; var t = o as Tuple<A, B, C, D, E, F, G>; if (t == null) throw new ArgumentException("Argument must be of type Tuple.", "other"); int c; c = Comparer<A>.Order(Item1, t.Item1); if (c != 0) return c; c = Comparer<B>.Order(Item2, t.Item2); if (c != 0) return c; c = Comparer<C>.Order(Item3, t.Item3); if (c != 0) return c; c = Comparer<D>.Order(Item4, t.Item4); if (c != 0) return c; c = Comparer<E>.Order(Item5, t.Item5); if (c != 0) return c; c = Comparer<F>.Order(Item6, t.Item6); if (c != 0) return c; c = Comparer<G>.Order(Item7, t.Item7); return c; }
        public override bool Equals(object o) { var t = o as Tuple<A, B, C, D, E, F, G>; return t != null && EqualityComparer<A>.Same(Item1, t.Item1) && EqualityComparer<B>.Same(Item2, t.Item2) && EqualityComparer<C>.Same(Item3, t.Item3) && EqualityComparer<D>.Same(Item4, t.Item4) && EqualityComparer<E>.Same(Item5, t.Item5) && EqualityComparer<F>.Same(Item6, t.Item6) && EqualityComparer<G>.Same(Item7, t.Item7); }
        public override int GetHashCode() { return (((((EqualityComparer<A>.Hash(Item1) * 31 + EqualityComparer<B>.Hash(Item2)) * 31 + EqualityComparer<C>.Hash(Item3)) * 31 + EqualityComparer<D>.Hash(Item4)) * 31 + EqualityComparer<E>.Hash(Item5)) * 31 + EqualityComparer<F>.Hash(Item6)) * 31 + EqualityComparer<G>.Hash(Item7); }
        public override string ToString() { return "(" + Item1 + ", " + Item2 + ", " + Item3 + ", " + Item4 + ", " + Item5 + ", " + Item6 + ", " + Item7 + ")"; }
    }
    public static class Tuple
    {
        public static Tuple<A, B> Create<A, B>(A a, B b) { return new Tuple<A, B>(a, b); }
        public static Tuple<A, B, C> Create<A, B, C>(A a, B b, C c) { return new Tuple<A, B, C>(a, b, c); }
        public static Tuple<A, B, C, D> Create<A, B, C, D>(A a, B b, C c, D d) { return new Tuple<A, B, C, D>(a, b, c, d); }
        public static Tuple<A, B, C, D, E> Create<A, B, C, D, E>(A a, B b, C c, D d, E e) { return new Tuple<A, B, C, D, E>(a, b, c, d, e); }
        public static Tuple<A, B, C, D, E, F> Create<A, B, C, D, E, F>(A a, B b, C c, D d, E e, F f) { return new Tuple<A, B, C, D, E, F>(a, b, c, d, e, f); }
        public static Tuple<A, B, C, D, E, F, G> Create<A, B, C, D, E, F, G>(A a, B b, C c, D d, E e, F f, G g) { return new Tuple<A, B, C, D, E, F, G>(a, b, c, d, e, f, g); }
    }
    public struct ValueTuple
    {
        public static ValueTuple<A, B> Create<A, B>(A a, B b) { return new ValueTuple<A, B>(a, b); }
        public static ValueTuple<A, B, C> Create<A, B, C>(A a, B b, C c) { return new ValueTuple<A, B, C>(a, b, c); }
        public static ValueTuple<A, B, C, D> Create<A, B, C, D>(A a, B b, C c, D d) { return new ValueTuple<A, B, C, D>(a, b, c, d); }
        public static ValueTuple<A, B, C, D, E> Create<A, B, C, D, E>(A a, B b, C c, D d, E e) { return new ValueTuple<A, B, C, D, E>(a, b, c, d, e); }
        public static ValueTuple<A, B, C, D, E, F> Create<A, B, C, D, E, F>(A a, B b, C c, D d, E e, F f) { return new ValueTuple<A, B, C, D, E, F>(a, b, c, d, e, f); }
        public static ValueTuple<A, B, C, D, E, F, G> Create<A, B, C, D, E, F, G>(A a, B b, C c, D d, E e, F f, G g) { return new ValueTuple<A, B, C, D, E, F, G>(a, b, c, d, e, f, g); }
    }
}
