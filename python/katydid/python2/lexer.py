"""Tokens of Python 2 source, in the grammar of its language reference, chapter 2.

Python's own tokenizer is not used: that of 3.12 and later refuses what is only good in Python 2.
"""

import re


class ConvertError(Exception):
    """Source that cannot be converted, with its line."""

    def __init__(self, text, line):
        Exception.__init__(self, "line %d: %s" % (line, text))
        self.text, self.line = text, line


class Token:
    """A piece of source: `kind` is name, number, string, op, newline, nl, comment, indent (white space at a line's start),
    space, continuation or end."""

    __slots__ = ("kind", "text", "line", "depth")

    def __init__(self, kind, text, line, depth):
        self.kind, self.text, self.line, self.depth = kind, text, line, depth

    def __repr__(self):
        return "%s(%r)@%d" % (self.kind, self.text, self.line)


_SPACE = re.compile(r"[ \t\f]+")
_CONTINUATION = re.compile(r"\\[ \t]*(\r\n|\r|\n)")
_NEWLINE = re.compile(r"\r\n|\r|\n")
_COMMENT = re.compile(r"#[^\r\n]*")
_NAME = re.compile(r"[^\W\d]\w*")
_NUMBER = re.compile(r"0[xX][0-9a-fA-F_]+[lL]?|0[oO][0-7_]+[lL]?|0[bB][01_]+[lL]?"
                     r"|(\d[\d_]*\.?\d*|\.\d+)([eE][-+]?\d+)?[jJ]?[lL]?")
_PREFIX = re.compile(r"([uU]?[bB]?[rR]?|[rR][bBuU]?|[fF][rR]?|[rR][fF])(\"\"\"|'''|\"|')")
_OP = re.compile(r"<>|\*\*=|//=|>>=|<<=|\.\.\.|->|:=|[-+*/%&|^@=!<>]=|\*\*|//|<<|>>|[-+*/%@&|^~<>()\[\]{},:.;=`]|!")


def tokens(source):
    """All tokens: their texts joined are the source."""
    found, at, line, depth, fresh = [], 0, 1, 0, True
    size = len(source)

    def add(kind, text):
        found.append(Token(kind, text, line, depth))

    while at < size:
        letter = source[at]
        match = _SPACE.match(source, at)
        if match:
            add("indent" if fresh and depth == 0 else "space", match.group())
            at = match.end()
            continue
        match = _CONTINUATION.match(source, at)
        if match:
            add("continuation", match.group())
            at, line = match.end(), line + 1
            fresh = False
            continue
        match = _NEWLINE.match(source, at)
        if match:
            add("newline" if depth == 0 and not fresh else "nl", match.group())
            at, line = match.end(), line + 1
            fresh = depth == 0
            continue
        if letter == "#":
            match = _COMMENT.match(source, at)
            add("comment", match.group())
            at = match.end()
            continue
        fresh = False
        match = _PREFIX.match(source, at)
        if match:
            end = _string_end(source, match, line)
            add("string", source[at:end])
            line += len(_NEWLINE.findall(source[at:end]))
            at = end
            continue
        match = _NUMBER.match(source, at) if letter.isdigit() or (
            letter == "." and source[at + 1:at + 2].isdigit()) else None
        kind = "number"
        if match is None:
            match, kind = _NAME.match(source, at), "name"
        if match is None:
            match, kind = _OP.match(source, at), "op"
        if match is None:
            raise ConvertError("unexpected character %r" % letter, line)
        text = match.group()
        if kind == "op" and text in ")]}":
            depth = max(0, depth - 1)
        add(kind, text)
        if kind == "op" and text in "([{":
            depth += 1
        at = match.end()
    if not fresh:
        add("newline", "")
    add("end", "")
    return found


def _string_end(source, match, line):
    """Where a string that begins at a match ends."""
    quote, at = match.group(2), match.end()
    # A backslash keeps a quote from ending a raw string too.
    while at < len(source):
        if source[at] == "\\":
            at += 3 if source[at + 1:at + 3] == "\r\n" else 2
        elif source.startswith(quote, at):
            return at + len(quote)
        elif len(quote) == 1 and source[at] in "\r\n":
            break
        else:
            at += 1
    raise ConvertError("a string has no end", line)
