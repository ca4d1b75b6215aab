"""Rewrites Python 2 statements that Python 3 cannot parse. Every token keeps its line."""

import re

from .lexer import ConvertError, Token, tokens

#: Tokens that carry no meaning between others.
_QUIET = ("space", "comment", "nl", "continuation", "indent")
_OPENERS, _CLOSERS = "([{", ")]}"
#: Words after which a statement may begin within a line.
_BLOCKS = {"if", "else", "elif", "for", "while", "try", "except", "finally", "with", "def", "class", "lambda"}


def convert(source):
    """The source as Python 3 parses it; ConvertError where there is no way."""
    source = source.lstrip("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
    found = _indented(tokens(source))
    print_is_function = "print_function" in source and re.search(
        r"^\s*from\s+__future__\s+import\b.*\bprint_function\b", source, re.M) is not None
    out = []
    for statement in _statements(found):
        out.extend(_statement(statement, print_is_function))
    return "".join(token.text for token in out)


def _indented(found):
    """Tabs at the start of lines become spaces up to the next multiple of 8, as Python 2 counts them."""
    for token in found:
        if token.kind == "indent" and "\t" in token.text:
            token.text = token.text.expandtabs(8)
    return found


def _statements(found):
    """Simple statements and headers of blocks, each a list of tokens with its end (`;`, `:` or the line's end)."""
    current, lambdas, fresh, header = [], [], True, False
    for token in found:
        current.append(token)
        if token.kind in _QUIET:
            continue
        if token.kind in ("newline", "end"):
            yield current
            current, fresh, header, lambdas = [], True, False, []
            continue
        if fresh and token.kind == "name":
            header = token.text in _BLOCKS and token.text != "lambda"
        fresh = False
        if token.kind == "name" and token.text == "lambda":
            lambdas.append(token.depth)
        if token.kind != "op" or (token.depth and token.text != ":"):
            continue
        if token.text == ":" and lambdas and lambdas[-1] == token.depth:
            lambdas.pop()
        elif token.text == ";" and not token.depth or (token.text == ":" and header and not token.depth):
            yield current
            current, fresh, header = [], True, False
    if current:
        yield current


def _significant(statement):
    return [i for i, token in enumerate(statement) if token.kind not in _QUIET]


def _statement(statement, print_is_function):
    """One statement, rewritten."""
    statement = _tokens_only(_backquotes(statement))
    places = _significant(statement)
    if not places:
        return statement
    first = statement[places[0]]
    if first.kind == "name":
        if first.text == "print" and not print_is_function and _is_print(statement, places):
            return _print(statement, places)
        work = {"exec": _exec, "raise": _raise, "except": _except, "def": _def}.get(first.text)
        if work is not None:
            statement = work(statement, places)
    return _lambdas(statement)


def _tokens_only(statement):
    """What one token is enough to see: <>, octal and long numbers, string prefixes."""
    for token in statement:
        if token.kind == "op" and token.text == "<>":
            token.text = "!="
        elif token.kind == "number":
            token.text = _number(token.text)
        elif token.kind == "string":
            token.text = re.sub(r"^[uU]([rR]|(?=[\"'])|[bB])", r"\1", token.text) if token.text[0] in "uU" else token.text
            if token.text[:1] not in "bB" and token.text[:2].lower() not in ("br", "rb"):
                token.text = _escapes(token.text)
    return statement


def _number(text):
    text = text.rstrip("lL")
    if len(text) > 1 and text[0] == "0" and text.isdigit():
        # 0777 is octal; 08 and 09 are errors in Python 2, and zeros alone are zero.
        return "0o" + text[1:] if set(text) <= set("01234567") else text
    return text


def _escapes(text):
    """Escapes that Python 3 reads differently in text: \\N, \\u and \\U without their form stay as they are."""
    body = text.lstrip("rRbBuUfF")
    prefix = text[:len(text) - len(body)]
    if "r" in prefix.lower() or "\\" not in body:
        return text

    def keep(found):
        whole, letter = found.group(0), found.group(1)
        rest = body[found.end():]
        good = {"u": r"[0-9a-fA-F]{4}", "U": r"000[0-9a-fA-F]{5}|0010[0-9a-fA-F]{4}", "N": r"\{[^}]+\}",
                "x": r"[0-9a-fA-F]{2}"}.get(letter)
        return whole if good is None or re.match(good, rest) else "\\\\" + letter
    return prefix + re.sub(r"\\(.)", keep, body, flags=re.S)


def _new(kind, text, near):
    return Token(kind, text, near.line, near.depth)


def _backquotes(statement):
    """`x` is repr(x)."""
    inside = False
    for token in statement:
        if token.kind == "op" and token.text == "`":
            token.text = ")" if inside else "repr("
            inside = not inside
    if inside:
        raise ConvertError("a backquote has no end", statement[0].line)
    return statement


def _is_print(statement, places):
    """Whether `print` begins a print statement here, and is not a name that is assigned or read."""
    if len(places) < 2:
        return True
    after = statement[places[1]]
    return not (after.kind == "op" and (after.text in ("=", ".") or after.text in _augmented))


_augmented = ("+=", "-=", "*=", "/=", "//=", "%=", "**=", "&=", "|=", "^=", ">>=", "<<=")


def _body(statement, places, start):
    """First and last place of what stands between a keyword and the statement's end, or None."""
    inner = [i for i in places[start:] if not _ends(statement[i])]
    return (inner[0], inner[-1]) if inner else None


def _ends(token):
    return token.kind in ("newline", "end") or (token.kind == "op" and token.text in (";", ":") and token.depth == 0)


def _split(statement, first, last, separator=","):
    """The parts between separators outside of brackets, as (from, to) places; both inclusive."""
    depth = statement[first].depth
    parts, begin, lambdas = [], first, 0
    for i in range(first, last + 1):
        token = statement[i]
        if token.kind == "name" and token.text == "lambda" and token.depth == depth:
            lambdas += 1
        if token.kind == "op" and token.depth == depth:
            if token.text == ":" and lambdas:
                lambdas -= 1
            elif token.text == separator and not lambdas:
                parts.append((begin, i - 1))
                begin = i + 1
    parts.append((begin, last))
    return parts


def _text(statement, part):
    return "".join(token.text for token in statement[part[0]:part[1] + 1]).strip()


def _print(statement, places):
    """print a, b  ->  print(a, b); print >>f, a  ->  print(a, file=f); a comma at the end  ->  end=" "."""
    keyword = statement[places[0]]
    body = _body(statement, places, 1)
    if body is None:
        keyword.text = "print()"
        return statement
    first, last = body
    extra = ""
    if statement[first].text == ">>":
        parts = _split(statement, first + 1, last)
        extra = ", file=" + _text(statement, parts[0])
        if len(parts) == 1 or not _text(statement, parts[1]):
            keep = statement[last + 1:]
            keyword.text = "print(%s)" % extra[2:]
            return statement[:places[0] + 1] + keep
        # What stood between stays away: the file is named once, at the end.
        for token in statement[first:parts[0][1] + 2]:
            token.text = "\n" if token.kind == "nl" else ""
        first = parts[1][0]
        while statement[first].kind in _QUIET:
            first += 1
    if statement[last].text == "," and statement[last].depth == statement[first].depth:
        statement[last].text = ""
        extra += ", end=' '"
    keyword.text = "print("
    for token in statement[places[0] + 1:first]:
        if token.kind == "space":
            token.text = ""
    statement = _lambdas(statement, first)
    last = max(i for i, token in enumerate(statement)
               if token.kind not in _QUIET and not _ends(token))
    statement.insert(last + 1, _new("op", extra + ")", statement[last]))
    # `print (a, b)` printed a tuple: the brackets stay and the call's own stand around them.
    return statement


def _exec(statement, places):
    """exec code in globals, locals  ->  exec(code, globals, locals)."""
    body = _body(statement, places, 1)
    if body is None:
        return statement
    first, last = body
    for i in range(first, last + 1):
        token = statement[i]
        if token.kind == "name" and token.text == "in" and token.depth == statement[first].depth:
            token.text = ","
    statement[places[0]].text = "exec("
    statement.insert(last + 1, _new("op", ")", statement[last]))
    return statement


def _raise(statement, places):
    """raise A, "x"  ->  raise A("x"); with a traceback as the third part  ->  .with_traceback(t)."""
    body = _body(statement, places, 1)
    if body is None:
        return statement
    parts = _split(statement, *body)
    if len(parts) == 1:
        return statement
    kind, value = _text(statement, parts[0]), _text(statement, parts[1])
    made = "__py2_error__(%s, %s)" % (kind, value)
    if len(parts) > 2:
        made += ".with_traceback(%s)" % _text(statement, parts[2])
    return _put(statement, body, made)


def _put(statement, body, text):
    """Puts text in the place of some tokens; line breaks among them stay behind it."""
    first, last = body
    breaks = "".join(token.text for token in statement[first:last + 1]).count("\n") - text.count("\n")
    near = statement[first]
    tail = [_new("nl", "\\\n" * breaks, near)] if breaks > 0 else []
    return statement[:first] + [_new("name", text, near)] + tail + statement[last + 1:]


def _except(statement, places):
    """except A, e:  ->  except A as e:"""
    body = _body(statement, places, 1)
    if body is None:
        return statement
    parts = _split(statement, *body)
    if len(parts) != 2:
        return statement
    comma = statement[parts[0][1] + 1]
    comma.text = " as "
    name = _text(statement, parts[1])
    if not re.match(r"^[^\W\d]\w*$", name):
        raise ConvertError("except %s, %s: the error goes to something that is no name" % (
            _text(statement, parts[0]), name), statement[places[0]].line)
    return statement


def _def(statement, places):
    """def f(a, (b, c)):  ->  def f(a, _t1):  with the unpacking first in the body, on the same line."""
    opening = next((i for i in places if statement[i].text == "("), None)
    if opening is None:
        return statement
    closing = _closing(statement, opening)
    unpack = _tuple_parameters(statement, opening + 1, closing)
    if not unpack:
        return statement
    line = statement[places[0]].line
    raise ConvertError("a parameter that is a tuple (%s): name it and unpack it in the body" % unpack[0][1], line)


def _closing(statement, opening):
    depth = statement[opening].depth
    for i in range(opening + 1, len(statement)):
        if statement[i].text in tuple(_CLOSERS) and statement[i].kind == "op" and statement[i].depth == depth:
            return i
    raise ConvertError("a bracket has no end", statement[opening].line)


def _tuple_parameters(statement, first, last):
    """Parameters in brackets: (place, text) of each."""
    found, fresh = [], True
    if first >= last:
        return found
    depth = statement[first].depth
    for i in range(first, last):
        token = statement[i]
        if token.kind in _QUIET:
            continue
        if fresh and token.kind == "op" and token.text == "(" and token.depth == depth:
            end = _closing(statement, i)
            found.append((i, _text(statement, (i, end))))
        fresh = token.kind == "op" and token.text == "," and token.depth == depth
    return found


def _lambdas(statement, start=0):
    """lambda (a, b): a + b  ->  lambda _t: (lambda a, b: a + b)(*_t); only where it is the whole parameter list."""
    i = start
    while i < len(statement):
        token = statement[i]
        i += 1
        if token.kind != "name" or token.text != "lambda":
            continue
        inner = [k for k in range(i, len(statement)) if statement[k].kind not in _QUIET]
        if not inner or statement[inner[0]].text != "(":
            continue
        opening = inner[0]
        closing = _closing(statement, opening)
        colon = next((k for k in inner if k > closing), None)
        if colon is None or statement[colon].text != ":":
            raise ConvertError("a lambda with a tuple among other parameters", token.line)
        # The brackets become those of an inner lambda over the same names.
        end = _expression_end(statement, colon + 1, token.depth)
        statement[opening].text, statement[closing].text = "", ""
        token.text = "lambda _t2: (lambda"
        statement.insert(end, _new("op", ")(*_t2)", statement[end - 1]))
    return statement


def _expression_end(statement, start, depth):
    """The place behind an expression that began at a depth: before a comma, a closing bracket or the line's end."""
    for i in range(start, len(statement)):
        token = statement[i]
        if token.kind in ("newline", "end", "comment") and token.depth <= depth:
            return i
        if token.kind == "op" and (token.depth < depth or (token.depth == depth and token.text in (",", ";", "=", "`"))):
            return i
    return len(statement)
