"""Ways to damage a file."""

import re
import struct
import zlib

# Numbers that readers trip over, as their bytes.
EXTREMES = [
    struct.pack(form, value)
    for form, values in {
        "<I": [0, 1, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x10000000],
        ">I": [1, 0x7FFFFFFF, 0x00FFFFFF],
        "<Q": [0x7FFFFFFFFFFFFFFF, 0xFFFFFFFFFFFFFFFF, 1 << 40],
        "<d": [float("nan"), float("inf"), -1e308, 1e308, 5e-324],
        "<H": [0xFFFF, 0x8000],
    }.items()
    for value in values
]
# The same as text.
WORDS = [b"1e999", b"-1", b"4294967295", b"2147483648", b"NaN", b"inf", b"1e-320", b"9" * 300, b"", b"-0", b"0x10", b"1e308"]
NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?")


def flipped(data, dice):
    """Bits here and there."""
    out = bytearray(data)
    for _ in range(dice.choice([1, 2, 8, 64])):
        out[dice.randrange(len(out))] ^= 1 << dice.randrange(8)
    return bytes(out)


def cut(data, dice):
    """The end is missing."""
    return data[: dice.randrange(len(data))]


def extreme(data, dice):
    """A number of some width is replaced."""
    out = bytearray(data)
    for _ in range(dice.choice([1, 1, 3])):
        value = dice.choice(EXTREMES)
        at = dice.randrange(len(out))
        out[at : at + len(value)] = value
    return bytes(out)


def moved(data, dice):
    """A piece is taken out, doubled, or put elsewhere."""
    a, b = sorted(dice.randrange(len(data) + 1) for _ in range(2))
    b = min(b, a + 4096)
    piece, rest = data[a:b], data[:a] + data[b:]
    at = dice.randrange(len(rest) + 1)
    return dice.choice([rest, data[:b] + piece * dice.choice([1, 3, 20]) + data[b:], rest[:at] + piece + rest[at:]])


def noisy(data, dice):
    """A piece is replaced by noise."""
    at = dice.randrange(len(data))
    noise = dice.randbytes(dice.choice([1, 4, 16, 256]))
    return data[:at] + noise + data[at + len(noise) :]


def reworded(data, dice):
    """Numbers of a text are replaced."""
    places = list(NUMBER.finditer(data))
    if not places:
        return extreme(data, dice)
    chosen = sorted(dice.sample(places, min(len(places), dice.choice([1, 2, 10]))), key=lambda m: m.start(), reverse=True)
    for place in chosen:
        data = data[: place.start()] + dice.choice(WORDS) + data[place.end() :]
    return data


def relined(data, dice):
    """Lines of a text are left out, doubled or mixed."""
    lines = data.split(b"\n")
    at = dice.randrange(len(lines))
    way = dice.randrange(4)
    if way == 0:
        del lines[at]
    elif way == 1:
        lines[at:at] = [lines[at]] * dice.choice([1, 100, 1000])
    elif way == 2:
        dice.shuffle(lines)
    else:
        lines[at] = lines[at] * dice.choice([2, 50])
    return b"\n".join(lines)


def nested(data, dice):
    """Brackets without end."""
    at = dice.randrange(len(data) + 1)
    opening = dice.choice([b"(", b"[", b"{", b"<a>", b"((", b'"', b"<chunk name=\"a\"><chunks>"])
    return data[:at] + opening * dice.choice([50, 5000, 100_000]) + data[at:]


BINARY = [flipped, cut, extreme, moved, noisy]
TEXT = [*BINARY, reworded, reworded, relined, nested]
TEXTS = {"kd", "ghx", "step", "obj", "svg", "gltf", "pdb"}


def damaged(suffix, seeds, dice):
    """A damaged file of a format."""
    data = dice.choice(seeds)
    inside = suffix == "gh" and dice.random() < 0.8
    if inside:
        try:
            data = zlib.decompress(data, -15)
        except zlib.error:
            inside = False
    for _ in range(dice.choice([1, 1, 2, 4])):
        if data:
            data = dice.choice(TEXT if suffix in TEXTS else BINARY)(data, dice)
    if dice.random() < 0.05:
        other = dice.choice(seeds)
        data = data[: len(data) // 2] + other[len(other) // 2 :]
    if inside:
        packer = zlib.compressobj(6, zlib.DEFLATED, -15)
        data = packer.compress(data) + packer.flush()
    return data
