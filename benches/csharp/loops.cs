// A nested loop: 10^8 additions of whole numbers.
class P
{
    static int Run(int n)
    {
        int sum = 0;
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++)
                sum += j;
        return sum;
    }
    static void Main() { System.Console.WriteLine(Run(10000)); }
}
