"""Python 2 source, as IronPython components hold it, run by Python 3.

In two steps: `statements` rewrites what Python 3 cannot parse, token by token and line by line, so that line numbers
stay; `rewrite` gives the parsed tree Python 2's meaning where that differs (division of integers, lists of dictionaries).
`library` has the names that Python 3 lost.
"""

import ast

from .lexer import ConvertError
from .rewrite import rewrite
from .statements import convert


def compile_python2(code, filename):
    """The code object of a Python 2 script; a SyntaxError names the line that could not be converted."""
    try:
        converted = convert(code)
    except ConvertError as error:
        raise SyntaxError(error.text, (filename, error.line, None, None))
    tree = ast.parse(converted, filename)
    return compile(rewrite(tree), filename, "exec", dont_inherit=True)


__all__ = ["ConvertError", "compile_python2", "convert"]
