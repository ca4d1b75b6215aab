"""Primes below 5,000,000 by crossing out multiples in a list of truth values."""


def run(n):
    crossed = [False] * n
    count = 0
    for i in range(2, n):
        if crossed[i]:
            continue
        count += 1
        for j in range(i * i, n, i):
            crossed[j] = True
    return count


print(run(5000000))
