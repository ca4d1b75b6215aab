"""Trees as nested lists and back."""

from katydid.grasshopper import DataTree as _DataTree
from katydid.grasshopper import GH_Path as _GH_Path


def list_to_tree(input, none_and_holes=True, source=[0]):
    """A tree of nested lists: each list is a path, its items lie in its branch.

    Without `none_and_holes`, None and empty lists leave no trace. `source` begins every path.
    """
    tree = _DataTree()

    def fill(values, path):
        if none_and_holes and not values:
            tree.EnsurePath(path)
        for i, value in enumerate(values):
            if hasattr(value, "__iter__") and not isinstance(value, (str, bytes)) and _is_list(value):
                fill(value, path.AppendElement(i))
            elif none_and_holes:
                tree.Insert(value, path, i)
            elif value is not None:
                tree.Add(value, path)
    if input is not None:
        fill(input, _GH_Path(*source))
    return tree


def _is_list(value):
    from katydid.run.outputs import is_list
    return is_list(value)


def tree_to_list(input, retrieve_base=lambda x: x[0]):
    """Nested lists of a tree; by default what lies below the first index. Indices that are not there become None."""
    root = []

    def place(holder, index, make):
        while len(holder) <= index:
            holder.append(None)
        if make and holder[index] is None:
            holder[index] = []
        return holder[index]

    for path in input.Paths:
        holder = root
        for index in path._indices:
            holder = place(holder, index, True)
        holder.extend(input.Branch(path))
    if retrieve_base is None:
        return root
    return retrieve_base(root)
