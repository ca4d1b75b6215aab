"""Gives a parsed tree the meaning that Python 2 gives it, through the functions of `library`."""

import ast

from .net import NAMES as NET_METHODS

#: Methods of dictionaries that gave lists, and those that have another name now.
_LISTS = {"keys", "values", "items"}
_RENAMED = {"iterkeys": "keys", "itervalues": "values", "iteritems": "items", "viewkeys": "keys", "viewvalues": "values",
            "viewitems": "items"}


def rewrite(tree):
    """The tree, changed in place. Line numbers stay."""
    division = any(isinstance(node, ast.ImportFrom) and node.module == "__future__"
                   and any(name.name == "division" for name in node.names) for node in ast.walk(tree))
    tree = _Rewriter(not division).visit(tree)
    return ast.fix_missing_locations(tree)


def _call(name, *arguments):
    return ast.Call(func=ast.Name(id=name, ctx=ast.Load()), args=list(arguments), keywords=[])


class _Rewriter(ast.NodeTransformer):
    def __init__(self, divides):
        self.divides = divides

    def visit_ImportFrom(self, node):
        if node.module == "__future__":
            # What Python 3 does anyway; unknown names of it would be errors.
            node.names = [name for name in node.names if name.name == "annotations"]
            return node if node.names else ast.copy_location(ast.Pass(), node)
        return node

    def visit_BinOp(self, node):
        self.generic_visit(node)
        if self.divides and isinstance(node.op, ast.Div):
            return ast.copy_location(_call("__py2_divide__", node.left, node.right), node)
        return node

    def visit_AugAssign(self, node):
        """x /= y  ->  x = divide(x, y): for names, attributes and items alike."""
        self.generic_visit(node)
        if not (self.divides and isinstance(node.op, ast.Div)):
            return node
        import copy
        read = copy.deepcopy(node.target)
        read.ctx = ast.Load()
        return ast.copy_location(ast.Assign(targets=[node.target], value=_call("__py2_divide__", read, node.value)), node)

    def visit_Call(self, node):
        self.generic_visit(node)
        method = node.func.attr if isinstance(node.func, ast.Attribute) else None
        bare = not node.args and not node.keywords
        if isinstance(node.func, ast.Name) and node.func.id == "exec" and len(node.args) == 1 and \
                isinstance(node.args[0], ast.Tuple) and len(node.args[0].elts) in (2, 3):
            # `exec (code, names)` is the statement with a tuple: code, global and local names.
            node.args = node.args[0].elts
            return node
        if method in _LISTS and bare:
            return ast.copy_location(_call("__py2_list__", node), node)
        if method in _RENAMED and bare:
            return ast.copy_location(_call("__py2_view__", node.func.value, ast.Constant(_RENAMED[method]),
                                           ast.Constant(method)), node)
        if method in NET_METHODS:
            node.func = ast.copy_location(_call("__py2_method__", node.func.value, ast.Constant(method)), node.func)
            return node
        if method == "has_key" and len(node.args) == 1:
            return ast.copy_location(_call("__py2_has_key__", node.func.value, node.args[0]), node)
        if method == "next" and bare:
            return ast.copy_location(_call("__py2_next__", node.func.value), node)
        if method == "sort" and (node.args or any(key.arg == "cmp" for key in node.keywords)):
            made = _call("__py2_sort__", node.func.value, *node.args)
            made.keywords = node.keywords
            return ast.copy_location(made, node)
        return node

    def visit_ClassDef(self, node):
        """__metaclass__ becomes the class's metaclass; __nonzero__, __div__ and next get their new names too."""
        self.generic_visit(node)
        for statement in list(node.body):
            if isinstance(statement, ast.Assign) and len(statement.targets) == 1 and isinstance(
                    statement.targets[0], ast.Name) and statement.targets[0].id == "__metaclass__":
                node.keywords.append(ast.keyword(arg="metaclass", value=statement.value))
                node.body.remove(statement)
        names = {statement.name for statement in node.body if isinstance(statement, ast.FunctionDef)}
        for old, new in (("__nonzero__", "__bool__"), ("__div__", "__truediv__"), ("next", "__next__"),
                         ("__unicode__", "__str__"), ("__cmp__", "__lt__")):
            if old in names and new not in names and old != "__cmp__":
                node.body.append(ast.copy_location(ast.Assign(
                    targets=[ast.Name(id=new, ctx=ast.Store())], value=ast.Name(id=old, ctx=ast.Load())), node))
        if "__cmp__" in names:
            for new, sign in (("__lt__", "lt"), ("__le__", "le"), ("__gt__", "gt"), ("__ge__", "ge"), ("__eq__", "eq")):
                if new not in names:
                    node.body.append(ast.copy_location(ast.Assign(
                        targets=[ast.Name(id=new, ctx=ast.Store())],
                        value=_call("__py2_compare__", ast.Constant(sign))), node))
        if not node.body:
            node.body.append(ast.copy_location(ast.Pass(), node))
        return node
