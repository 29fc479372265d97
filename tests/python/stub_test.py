# SPDX-License-Identifier: GPL-3.0-or-later
"""The type stub names what the module has, and the module documents all of it."""

import ast
import inspect
import pathlib
import re
import unittest

import dewpoint

STUB = pathlib.Path(dewpoint.__file__).with_name("__init__.pyi")
OF_EXCEPTIONS = {"args", "with_traceback", "add_note"}
OF_EVERY_OBJECT = set(dir(object)) | {"__module__", "__dict__", "__weakref__", "__hash__"}


def arguments_in_stub(function):
    arguments = function.args
    return [one.arg for one in arguments.args + arguments.kwonlyargs if one.arg != "self"]


def arguments_in_doc(documentation):
    """Names in the signature that begins the documentation of what is compiled."""
    inside = re.match(r"\w+\((.*)\) -> ", documentation.splitlines()[0]).group(1)
    depth, flat = 0, ""
    for letter in inside:  # types hold commas too
        depth += letter in "[(<{"
        depth -= letter in "])>}"
        flat += letter if depth == 0 else ""
    names = [part.split(":")[0].split("=")[0].strip() for part in flat.split(",")]
    return [name for name in names if name and name not in ("self", "*")]


def in_stub():
    """Names of the stub: classes with {name: function or None}, and functions."""
    classes, functions = {}, {}
    for node in ast.parse(STUB.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.ClassDef):
            classes[node.name] = {}
            for member in node.body:
                if isinstance(member, ast.AnnAssign):
                    classes[node.name][member.target.id] = None
                else:
                    isProperty = bool(member.decorator_list)
                    classes[node.name][member.name] = None if isProperty else member
        elif isinstance(node, ast.FunctionDef):
            functions[node.name] = node
    return classes, functions


def members(kind):
    names = {name for name in vars(kind) if name not in OF_EVERY_OBJECT}
    names |= {name for name in ("__init__", "__eq__") if name in vars(kind)}
    return {name for name in names if not name.startswith("_pybind11")}


class Stub(unittest.TestCase):
    def test_names_are_those_of_the_module(self):
        classes, functions = in_stub()
        self.assertEqual(set(classes) | set(functions) | {"__version__"}, set(dewpoint.__all__))
        self.assertTrue(STUB.with_name("py.typed").exists())

    def test_members_are_those_of_the_classes(self):
        for name, stubbed in in_stub()[0].items():
            if name in ("Error", "ErrorCode"):
                continue  # attributes of objects, and pybind11's own
            kind = getattr(dewpoint, name)
            real = members(kind)
            if "__init__" not in stubbed:
                real.discard("__init__")  # made by other functions
            self.assertEqual(set(stubbed), real - {"__repr__"}, name)
        real = set(dewpoint.ErrorCode.__members__)
        self.assertEqual(set(in_stub()[0]["ErrorCode"]) - {"name", "value"}, real)

    def test_arguments_are_those_of_the_functions(self):
        classes, functions = in_stub()
        for name, function in functions.items():
            documentation = getattr(dewpoint, name).__doc__
            self.assertEqual(arguments_in_stub(function), arguments_in_doc(documentation), name)
        for name, stubbed in classes.items():
            for member, function in stubbed.items():
                if function is not None and not member.startswith("__"):
                    documentation = getattr(getattr(dewpoint, name), member).__doc__
                    self.assertEqual(arguments_in_stub(function), arguments_in_doc(documentation),
                                     f"{name}.{member}")

    def test_an_error_has_what_the_stub_says(self):
        with self.assertRaises(dewpoint.Error) as caught:
            dewpoint.open("gone.toml")
        stubbed = set(in_stub()[0]["Error"])
        self.assertEqual(stubbed, set(vars(caught.exception)))

    def test_everything_is_documented(self):
        for name in set(dewpoint.__all__) - {"__version__"}:
            value = getattr(dewpoint, name)
            self.assertTrue(value.__doc__, name)
            for member, what in inspect.getmembers(value) if inspect.isclass(value) else []:
                if not member.startswith("_") and name != "ErrorCode" and member not in OF_EXCEPTIONS:
                    self.assertTrue(what.__doc__, f"{name}.{member}")
            self.assertEqual(value.__module__.split(".")[0], "dewpoint", name)


if __name__ == "__main__":
    unittest.main()
