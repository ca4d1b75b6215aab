"""Python 2 source: what it gives when it runs, and that lines stay."""

import pytest
from katydid.python2 import compile_python2, convert
from katydid.python2.library import NAMES


def run(code):
    scope = dict(NAMES)
    exec(compile_python2(code, "<script>"), scope)
    return scope


@pytest.mark.parametrize("code, value", [
    ("a = 7 / 2", 3), ("a = -7 / 2", -4), ("a = 7 / 2.0", 3.5), ("a = 9\na /= 2", 4),
    ("from __future__ import division\na = 7 / 2", 3.5), ("a = 0777 + 0xFL + 10L", 511 + 15 + 10),
    ("a = `1 + 1`", "2"), ("a = 1 <> 2", True), ("a = {1: 2}.has_key(1)", True), ("a = {1: 2}.keys()[0]", 1),
    ("a = [k for k, v in {1: 2}.iteritems()]", [1]), ("a = map(None, [1], [2, 3])", [(1, 2), (None, 3)]),
    ("a = filter(lambda x: x > 1, [1, 2])", [2]), ("a = reduce(lambda x, y: x + y, xrange(5))", 10),
    ("a = round(2.5)", 3.0), ("a = round(-0.5)", -1.0), ("a = u'\\u00e9'", "é"), ("a = ur'\\d'", "\\d"),
    ("try:\n    raise ValueError, 'x'\nexcept (ValueError, TypeError), e:\n    a = str(e)", "x"),
    ("exec 'b = 4'\na = b", 4), ("d = {}\nexec('b = 4', d)\na = d['b']", 4), ("exec 'a = 4' in globals()", 4), ("a = (lambda (x, y): x * y)((3, 4))", 12),
    ("a = sorted([(1, 2), (0, 5)], key=lambda (x, y): y)", [(1, 2), (0, 5)]),
    ("a = [3, 1, 2]\na.sort(lambda x, y: cmp(y, x))", [3, 2, 1]), ("a = sorted([1, 3], cmp=lambda x, y: y - x)", [3, 1]),
    ("class C:\n    def __nonzero__(self): return False\na = not C()", True),
    ("class C:\n    def __cmp__(self, o): return -1\na = C() < C()", True),
    ("class C(object):\n    def next(self): return 5\na = C().next()", 5), ("a = long(3)", 3), ("a = unicode(3)", "3"),
    ("a = iter([4]).next()", 4), ("if 1:\n\ta = 1\n        a = 2", 2), ("a = 'C:\\users'", "C:\\users"),
    ("a = isinstance('x', basestring)", True), ("a = zip([1], [2])[0]", (1, 2)), ("a = 5; print a; a = 6", 6),
    ("a = (0.1).ToString() + True.ToString()", "0.1True"), ("a = 'a,b'.Split(',')", ["a", "b"]),
    ("a = (5).GetType().Name + 'x'.GetType().FullName", "Int32System.String"), ("a = 'abc'.Substring(1, 1).ToUpper()", "B"),
    ("class E(object):\n    def Split(self): return 3\na = E().Split()", 3), ("a = (1).Equals(1)", True),
    ("class D(object):\n    x = 9\nd = D()\nd.x /= 2\na = d.x", 4), ("a = [8]\na[0] /= 3", [2]),
])
def test_meaning(code, value):
    assert run(code)["a"] == value


@pytest.mark.parametrize("code, printed", [
    ("print 'a', 1", "a 1\n"), ("print", "\n"), ("print 'a',\nprint 'b'", "a b\n"), ("print ('a', 1)", "('a', 1)\n"),
    ("print('a')", "a\n"), ("print 'x' % ()", "x\n"), ("print (1) + 2", "3\n"), ("if 1: print 'y'\nelse: print 'n'", "y\n"),
    ("for i in range(2): print i,", "0 1 "), ("print 'a' if 1 else 'b'", "a\n"), ("print \"%s\" % (1,\n  )", "1\n"),
    ("from __future__ import print_function\nprint('a', 1)", "a 1\n"), ("print {1: 2}[1]; print [3]", "2\n[3]\n"),
    ("print 'a' # note\nprint 'b'", "a\nb\n"), ("print lambda_ if 0 else 1", "1\n"),
    ("def f(): print 'in'\nf()", "in\n"), ("print 'a' \\\n  'b'", "ab\n"), ("print (lambda x: x)(2), 3", "2 3\n"),
    ("import sys\nprint >>sys.stdout, 'q', 2", "q 2\n"), ("import sys\nprint >>sys.stdout", "\n"),
])
def test_print(code, printed, capsys):
    run(code)
    assert capsys.readouterr().out == printed


@pytest.mark.parametrize("code", [
    "print 'a'\n\nraise ValueError, (\n  'x')\n", "x = 1\nprint x, \\\n  x\n\n# c\nif x: print '''a\nb'''\n", "exec 'a' in {}, \\\n {}\n",
    "\ufeffprint 1\r\nprint 2\r\n"])
def test_lines_stay(code):
    assert convert(code).count("\n") == code.count("\n")
    compile_python2(code, "<script>")


@pytest.mark.parametrize("code, line", [("a = 1\ndef f(a, (b, c)): pass", 2), ("\n\nx = 'abc", 3), ("a = $", 1),
                                        ("b = 1\na = = 2", 2)])
def test_what_cannot_be_converted_says_which_line(code, line):
    with pytest.raises(SyntaxError) as caught:
        compile_python2(code, "<script>")
    assert caught.value.lineno == line


def test_a_name_print_is_left_alone():
    assert convert("from __future__ import print_function\nf = print\n").count("print") == 2
