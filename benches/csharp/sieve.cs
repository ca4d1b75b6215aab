// Primes below 5,000,000 by crossing out multiples in an array of truth values.
class P
{
    static int Run(int n)
    {
        var crossed = new bool[n];
        int count = 0;
        for (int i = 2; i < n; i++)
        {
            if (crossed[i]) continue;
            count++;
            for (long j = (long)i * i; j < n; j += i) crossed[(int)j] = true;
        }
        return count;
    }
    static void Main() { System.Console.WriteLine(Run(5000000)); }
}
