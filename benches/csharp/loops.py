"""A nested loop: 10^8 additions of whole numbers, to 32 bits in the end."""


def run(n):
    sum = 0
    for i in range(n):
        for j in range(n):
            sum += j
    return (sum + 2**31) % 2**32 - 2**31


print(run(10000))
