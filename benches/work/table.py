"""What was measured, as a table of Markdown."""

from dataclasses import dataclass
from math import log

from definitions import Row

# Above this a time grows faster than the work; see `limit`.
STRAIGHT = 1.1


@dataclass
class Measured:
    """The sizes of a row, what each took, and what start-up took."""

    row: Row
    sizes: list
    taken: list
    start: object
    peer_seconds: float | None

    def net(self):
        """Seconds without those of start-up; never nothing, for logarithms."""
        return [max(one.seconds - self.start.seconds, 1e-4) for one in self.taken]

    def exponent(self):
        """The slope of the line through the logarithms of sizes and net seconds, by least squares."""
        x, y = [log(size) for size in self.sizes], [log(seconds) for seconds in self.net()]
        middle_x, middle_y = sum(x) / len(x), sum(y) / len(y)
        return sum((a - middle_x) * (b - middle_y) for a, b in zip(x, y)) / sum((a - middle_x) ** 2 for a in x)

    def limit(self):
        """1.1; where n log n is the best that is known, what the logarithm adds between the sizes on top."""
        if not self.row.sorting:
            return STRAIGHT
        first, last = self.sizes[0], self.sizes[-1]
        return STRAIGHT + log(log(last) / log(first)) / log(last / first)

    def ratio(self):
        """To the peer, which is timed without start-up too."""
        return self.net()[-1] / self.peer_seconds if self.peer_seconds else None

    def bytes_an_item(self):
        more = self.row.items(self.sizes[-1]) - self.row.items(self.row.smallest)
        return (self.taken[-1].megabytes - self.start.megabytes) * 1e6 / more


def seconds(value):
    return f"{value:.3f}" if value < 10 else f"{value:.1f}"


HEAD = [
    "row",
    "N",
    "s at N",
    "2N",
    "4N",
    "start-up",
    "exponent",
    "peer",
    "its s at 4N",
    "ratio",
    "MB at 4N",
    "bytes an item",
]


def cells(measured):
    whole = [f"{seconds(one.seconds)} ({seconds(net)})" for one, net in zip(measured.taken, measured.net())]
    exponent = measured.exponent()
    ratio = measured.ratio()
    return [
        measured.row.name,
        f"{measured.sizes[0]:,}",
        *whole,
        seconds(measured.start.seconds),
        f"{exponent:.2f}" + (" **above**" if exponent > measured.limit() else ""),
        measured.row.peer or "–",
        "–" if ratio is None else seconds(measured.peer_seconds),
        "–" if ratio is None else f"{ratio:.2f}",
        f"{measured.taken[-1].megabytes:.0f}",
        f"{measured.bytes_an_item():,.0f}",
    ]


def line(parts):
    return "| " + " | ".join(parts) + " |"


def head():
    return line(HEAD) + "\n" + line(["---"] * len(HEAD))


def failed(row, why):
    """The line of a row that is not timed."""
    return line([row.name, f"{row.size:,}", f"**{why}**", *[""] * (len(HEAD) - 3)])
