"""Katydid for Python: script components, and the modules that scripts expect.

`katydid.rhino.install()` makes `import Rhino`, `rhinoscriptsyntax` and the rest work in a notebook or a program.
"""
