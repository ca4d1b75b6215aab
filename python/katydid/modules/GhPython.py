"""GhPython, the assembly of the old Python component: scripts import it and use nothing of it."""
