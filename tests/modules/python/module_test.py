# SPDX-License-Identifier: GPL-3.0-or-later
"""The stub says what the module has, everything has a docstring, and no argument crashes it."""
import ast
import inspect
import pathlib
import re
import textwrap
import unittest

import numpy as np

import brash

STUB = ast.parse((pathlib.Path(brash.__file__).parent / "_brash.pyi").read_text(encoding="utf-8"))
PUBLIC = {name: value for name, value in vars(brash).items()
          if not name.startswith("_") and not inspect.ismodule(value)}


def stubbed(body):
    """Name -> argument names of its overloads, or the body of a class."""
    names = {}
    for node in body:
        if isinstance(node, ast.ClassDef):
            names[node.name] = node.body
        elif isinstance(node, ast.FunctionDef):
            arguments = [a.arg for a in node.args.args + node.args.kwonlyargs]
            names.setdefault(node.name, []).append(arguments)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            names[node.target.id] = [["self"]]
    return names


def signatures(function):
    """Of each overload, as the docstring begins."""
    return re.findall(r"^(?:\d+\. )?\w+\((.*)\) ->", function.__doc__, re.MULTILINE)


def documented(function):
    """Argument names of each overload."""
    return [re.findall(r"(\w+): ", re.sub(r"\[[^]]*\]", "", s)) for s in signatures(function)]


def defaults_of(function):
    """Name -> default of the arguments of a function in a syntax tree, without those that are left out as ..."""
    of = function.args
    pairs = [*zip(of.args[len(of.args) - len(of.defaults):], of.defaults), *zip(of.kwonlyargs, of.kw_defaults)]
    values = {argument.arg: ast.literal_eval(default) for argument, default in pairs if default is not None}
    return {name: default for name, default in values.items() if default is not ...}


def functions_of(body, members):
    """Pairs of each function of a stub and the module's own, and of the methods of its classes."""
    overloads = {}
    for node in body:
        value = members.get(node.name) if isinstance(node, (ast.FunctionDef, ast.ClassDef)) else None
        if isinstance(node, ast.ClassDef) and inspect.isclass(value):
            yield from functions_of(node.body, {name: getattr(value, name) for name in vars(value)})
        elif inspect.isfunction(value) or inspect.ismethod(value):  # of the package's own Python
            yield node, ast.parse(textwrap.dedent(inspect.getsource(value))).body[0]
        elif callable(value) and value.__doc__:
            n = overloads[node.name] = overloads.get(node.name, -1) + 1
            yield node, ast.parse(f"def {node.name}({signatures(value)[n]}): ...").body[0]


def alike(value):
    return tuple(value) if isinstance(value, list) else value


class Stub(unittest.TestCase):
    def test_it_names_what_the_module_has(self):
        helpers = {"Floats", "Bools", "Table", "Path", "PolygonLike", "LineLike", "HistoryLike", "Number"}
        self.assertEqual(set(stubbed(STUB.body)) - helpers - {"__version__"}, set(PUBLIC))

    def test_its_arguments_are_the_module_s(self):
        for name, overloads in stubbed(STUB.body).items():
            function = PUBLIC.get(name)
            if not inspect.isbuiltin(function):
                continue
            for wanted, got in zip(overloads, documented(function), strict=True):
                with self.subTest(name):
                    self.assertTrue(got == wanted or "kwargs" in function.__doc__, (got, wanted))

    def test_its_defaults_are_the_module_s(self):
        n_compared = 0
        for wanted, got in functions_of(STUB.body, PUBLIC):
            found = defaults_of(got)
            for argument, default in defaults_of(wanted).items():
                with self.subTest(f"{wanted.name}({argument})"):
                    self.assertEqual(alike(found.get(argument, "none")), alike(default))
                    n_compared += 1
        self.assertGreater(n_compared, 40)

    def test_its_classes_have_the_members_of_the_module_s(self):
        for name, body in stubbed(STUB.body).items():
            value = PUBLIC.get(name)
            if not inspect.isclass(value) or issubclass(value, (tuple, Exception)):
                continue
            special = {"__getitem__", "__setitem__", "__call__", "__geo_interface__"}
            got = {m for m in vars(value) if not m.startswith("_") or m in special}
            with self.subTest(name):
                wanted = stubbed(body)
                wanted.pop("__init__", None)
                self.assertEqual(got, set(wanted))
                for member, overloads in wanted.items():
                    method = getattr(value, member)
                    if callable(method) and not member.startswith("__"):
                        self.assertEqual([a for a in documented(method)[0] if a != "self"],
                                         [a for a in overloads[0] if a != "self"], member)

    def test_everything_public_has_a_docstring(self):
        for name, value in PUBLIC.items():
            text = re.sub(rf"^(\d+\. )?{name}\(.*$", "", value.__doc__ or "", flags=re.MULTILINE).strip()
            self.assertTrue(text, name)


class NoCrash(unittest.TestCase):
    """Every public callable with every combination of unlikely values: an exception or an answer, never a crash."""

    VALUES = [None, -1, 0, 3, 1.5, float("nan"), float("inf"), "text", "POLYGON EMPTY", b"\xff", [], [[]], {}, [0.5, 0.5],
              [[0, 0], [1, 0], [1, 1]], np.zeros(0), np.zeros((3, 2)), np.zeros((2, 2, 2)), np.full(4, np.nan),
              np.array(["a"]), np.array([object()]), 2**70, 1j, True]
    EXPECTED = (TypeError, ValueError, RuntimeError, KeyError, IndexError, OverflowError)

    def attempt(self, call, *arguments):
        try:
            call(*arguments)
        except self.EXPECTED as error:
            self.assertNotIsInstance(error, brash.ContractViolation)

    @np.testing.suppress_warnings()
    def test_functions(self):
        draw = np.random.default_rng(7)
        for name, function in PUBLIC.items():
            if inspect.isclass(function) and issubclass(function, Exception):
                continue
            for value in self.VALUES:
                self.attempt(function, value)
            for _ in range(60):
                picked = draw.integers(len(self.VALUES), size=draw.integers(1, 6))
                self.attempt(function, *(self.VALUES[i] for i in picked))

    @np.testing.suppress_warnings()
    def test_methods_of_a_sheet(self):
        draw = np.random.default_rng(8)
        for name in ("cut", "cut_circumferential", "contacts", "within", "free_edge", "contains"):
            for _ in range(150):
                sheet = brash.IceSheet([[0, 0], [9, 0], [9, 9], [0, 9]])
                picked = draw.integers(len(self.VALUES), size=draw.integers(1, 4))
                self.attempt(getattr(sheet, name), *(self.VALUES[i] for i in picked))
                sheet.check()


if __name__ == "__main__":
    unittest.main()
