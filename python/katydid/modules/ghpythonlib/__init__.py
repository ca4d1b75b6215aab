"""ghpythonlib: components as functions, trees as lists, parallel loops, component classes."""
