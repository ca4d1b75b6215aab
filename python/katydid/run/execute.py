"""Runs one component's script: all iterations of one message."""

import hashlib
import io
import sys
import time
from collections import OrderedDict

from .. import document
from ..grasshopper import DataTree
from ..packages import advice
from ..values.netlist import NetList
from . import instance
from .component import Component, Environment, set_current
from .outputs import output
from .report import SCRIPT, describe, line_of, show_source

#: How much a script may print in one iteration, in characters.
MOST_PRINTED = 1 << 20
#: How many components keep their variables.
MOST_SCOPES = 2000

_compiled = OrderedDict()
_scopes = OrderedDict()


class Collector(io.TextIOBase):
    """sys.stdout of a script: the text of one iteration."""

    encoding = "utf-8"

    def __init__(self):
        self.parts, self.length = [], 0

    def write(self, text):
        room = MOST_PRINTED - self.length
        if room > 0:
            self.parts.append(text[:room])
            self.length += len(text)
            if self.length > MOST_PRINTED:
                self.parts.append("\n... the rest of the output is left out")
        return len(text)

    def writable(self):
        return True

    def take(self):
        text = "".join(self.parts)
        self.parts, self.length = [], 0
        return text


def compile_script(code, language):
    """The code object of a script, kept by its text."""
    key = (language, hashlib.sha1(code.encode("utf-8", "replace")).digest())
    found = _compiled.get(key)
    if found is None:
        if language == "python2":
            from ..python2 import compile_python2
            found = compile_python2(code, SCRIPT)
        else:
            found = compile(code, SCRIPT, "exec", dont_inherit=True)
        _compiled[key] = found
        if len(_compiled) > 500:
            _compiled.popitem(last=False)
    _compiled.move_to_end(key)
    return key, found


class Scope:
    """What a component keeps between runs: its variables, its own object, what ghenv shows."""

    def __init__(self, key):
        self.key, self.variables, self.component, self.instance = key, None, None, None


def scope_of(message, key):
    """The scope of a component; a new one when its code has changed."""
    name = message.get("key")
    found = _scopes.get(name) if name else None
    if found is None or found.key != key:
        found = Scope(key)
        if name:
            _scopes[name] = found
            if len(_scopes) > MOST_SCOPES:
                _scopes.popitem(last=False)
    if name:
        _scopes.move_to_end(name)
    if found.component is None:
        found.component = Component(message)
    else:
        found.component._begin(message)
    return found


def variables_of(scope, language):
    """The global names of a script."""
    if scope.variables is None:
        scope.variables = {"__name__": "__main__", "__doc__": None, "__file__": SCRIPT,
                           "__builtins__": __builtins__}
        if language == "python2":
            from ..python2.library import NAMES
            scope.variables.update(NAMES)
    return scope.variables


def run(message, objects):
    """Runs all iterations of a message; gives the map that answers it.

    The message: `code`, `language` ("python2" or "python3"), `key` (the component's id), `name`, `nickname`, `inputs` and
    `outputs` (each with `name`, inputs with `access`, `hint`, `optional`, `description`), `iterations` (a list of values
    for each, by input), `doc` (`tolerance`, `angle_tolerance`, `units`, and where they are known `path` and `name`).
    The answer: `iterations` (values by output), `out` (what each printed), `messages` ([level, text, line or -1]), `error`
    ("cancelled", what kept the worker from running it, or None), `texts` (how Python writes the objects of its own that are
    among the values, by their tokens; where there are any) and `seconds`. A script's own exception is a message.
    """
    began = time.perf_counter()
    iterations = message.get("iterations") or []
    names = [port["name"] for port in message.get("outputs") or []]
    result = {"iterations": [], "out": [], "messages": [], "error": None, "seconds": 0.0}
    solved = document.begin(message.get("doc"))
    _point_scriptcontext(solved)
    collector = Collector()
    in_model = len(document.model().Objects)
    kept = sys.stdout, sys.stderr
    sys.stdout = sys.stderr = collector
    component, before = None, None
    try:
        code = message.get("code") or ""
        language = message.get("language") or "python3"
        show_source(code)
        key, compiled = compile_script(code, language)
        scope = scope_of(message, key)
        component = scope.component
        before = set_current(component)
        job = _Job(message, scope, compiled, language, solved, objects)
        for number, row in enumerate(iterations):
            component.Iteration = number
            values = job.iteration(row, names, result["messages"])
            result["iterations"].append(values)
            result["out"].append(collector.take())
        texts = objects.texts()
        if texts:
            result["texts"] = texts
    except KeyboardInterrupt:
        result["error"] = "cancelled"
    except Exception as error:
        # A script that does not compile: each iteration says so.
        told(error, result["messages"])
        result["out"] = [collector.take()] * len(iterations)
    finally:
        sys.stdout, sys.stderr = kept
        if component is not None:
            set_current(before)
            for one in component._messages:
                _add(result["messages"], one)
    if len(document.model().Objects) > in_model:
        _add(result["messages"], ["warning", "objects added to the Rhino document are not kept: there is no model", -1])
    # Every iteration has its outputs, those that were not reached too.
    while len(result["iterations"]) < len(iterations):
        result["iterations"].append([None] * len(names))
    while len(result["out"]) < len(iterations):
        result["out"].append(collector.take())
    result["seconds"] = time.perf_counter() - began
    return result


def told(error, messages, advise=None):
    """Tells an exception of the script: as a message, and behind what was printed, as `out` shows it."""
    text = describe(error, advise)
    _add(messages, ["error", text, line_of(error)])
    print(text)


def _add(messages, one):
    """A message once, however many iterations repeat it."""
    if one not in messages:
        messages.append(one)


def _point_scriptcontext(solved):
    module = sys.modules.get("scriptcontext")
    if module is not None:
        module.doc = solved


class _Job:
    def __init__(self, message, scope, compiled, language, solved, objects):
        self.scope, self.compiled, self.objects = scope, compiled, objects
        self.ports = message.get("inputs") or []
        self.document = solved
        settings = message.get("doc") or {}
        self.advise = lambda module: advice(module, message.get("code") or "", settings.get("path") or "")
        self.variables = variables_of(scope, language)
        self.variables["ghenv"] = Environment(scope.component)
        self.variables["ghdoc"] = solved

    def iteration(self, row, names, messages):
        """The outputs of one iteration; an exception is a message, and the rest goes on."""
        try:
            inputs = [self.input(port, value) for port, value in zip(self.ports, row)]
            values = self.values(inputs, names)
            return [output(value, self.objects) for value in values]
        except Exception as error:
            told(error, messages, self.advise)
            return [None] * len(names)

    def values(self, inputs, names):
        variables = self.variables
        for port, value in zip(self.ports, inputs):
            variables[port["name"]] = value
        own = {port["name"] for port in self.ports}
        if self.scope.instance is not None:
            return instance.outputs(self.scope.instance, self.scope.component, inputs, names)
        for name in names:
            # An output that has an input's name keeps the input's value until the script sets it.
            if name not in own:
                variables[name] = None
        try:
            exec(self.compiled, variables)
        except SystemExit:
            # The script ends here; what it has set counts.
            pass
        made = instance.find(variables, self.scope.component)
        if made is not None:
            self.scope.instance = made
            return instance.outputs(made, self.scope.component, inputs, names)
        return [variables.get(name) for name in names]

    def input(self, port, value):
        """An input as the script's variable: .NET lists for lists, Guids where the hint asks for them."""
        if is_document_hint(port.get("hint")):
            value = self.to_document(value)
        if isinstance(value, list) and not isinstance(value, NetList) and port.get("access") == "list":
            return NetList(value)
        return value

    def to_document(self, value):
        if isinstance(value, DataTree):
            for items in value._branches.values():
                items[:] = [self.to_document(one) for one in items]
            return value
        if type(value) in (list, NetList):
            return NetList(self.to_document(one) for one in value)
        return self.document.Objects.Add(value) if document.is_geometry(value) else value


def is_document_hint(hint):
    """Whether a type hint is "ghdoc Object (Guid when geometry)", by name or by its id."""
    text = str(hint or "").lower()
    return "ghdoc" in text or text.startswith("87f87f55")
