"""A text of 2,000,000 numbers and signs, and a look at every character of it."""


def main():
    built = []
    for i in range(1000000):
        built.append(str(i % 1000))
        built.append(";" if i % 3 == 0 else ",")
    text = "".join(built)
    sum = 0
    for i in range(len(text)):
        if text[i] == ";":
            sum += i % 7
    print(len(text), sum)


main()
