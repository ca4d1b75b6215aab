"""What was measured, as a table of Markdown."""

from dataclasses import dataclass
from math import log

from definitions import Row
from measure import Taken

# Above this a time grows faster than the work; see `limit`.
STRAIGHT = 1.1


@dataclass
class Measured:
    """What the sizes of a row took, what start-up took, and the peer's seconds at the least and the largest size."""

    row: Row
    taken: list[Taken]
    start: Taken
    peer_seconds: list[float] | None

    def net(self):
        """Seconds without those of start-up; never nothing, for logarithms."""
        return [max(one.seconds - self.start.seconds, 1e-4) for one in self.taken]

    def exponent(self):
        """The slope of the line through the logarithms of sizes and net seconds, by least squares."""
        return slope(self.row.sizes(), self.net())

    def peer_exponent(self):
        first, *_, last = self.row.sizes()
        return slope([first, last], self.peer_seconds)

    def limit(self):
        """1.1; where n log n is the best that is known, what the logarithm adds between the sizes on top."""
        if not self.row.sorting:
            return STRAIGHT
        first, *_, last = self.row.sizes()
        return STRAIGHT + log(log(last) / log(first)) / log(last / first)

    def ratio(self):
        """To the peer, which is timed without start-up too."""
        return self.net()[-1] / self.peer_seconds[-1]

    def bytes_an_item(self):
        more = self.row.items * (self.row.sizes()[-1] - self.row.smallest)
        return (self.taken[-1].megabytes - self.start.megabytes) * 1e6 / more


def slope(sizes, seconds):
    """Of the line through the logarithms, by least squares."""
    x, y = [log(size) for size in sizes], [log(one) for one in seconds]
    middle_x, middle_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - middle_x) * (b - middle_y) for a, b in zip(x, y)) / sum((a - middle_x) ** 2 for a in x)


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
    "its exponent",
    "ratio",
    "MB at 4N",
    "bytes an item",
]


def cells(measured):
    whole = [f"{seconds(one.seconds)} ({seconds(net)})" for one, net in zip(measured.taken, measured.net())]
    exponent = measured.exponent()
    peer = ["–"] * 3
    if measured.peer_seconds:
        peer = [seconds(measured.peer_seconds[-1]), f"{measured.peer_exponent():.2f}", f"{measured.ratio():.2f}"]
    return [
        measured.row.name,
        f"{measured.row.size:,}",
        *whole,
        seconds(measured.start.seconds),
        f"{exponent:.2f}" + (" **above**" if round(exponent, 2) > measured.limit() else ""),
        measured.row.peer or "–",
        *peer,
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
