# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the cells of a notebook in their order, as a kernel does, without Jupyter: run_notebook.py NOTEBOOK SOURCES FOLDER

The value of a cell's last line is printed, and its figures are written as cell-1.png and so on. A notebook holds no output, so
that its text alone is compared between versions. What the numbers must be, the cells assert themselves.
"""
import ast
import json
import os
import pathlib
import shutil
import sys

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt  # noqa: E402


def run(cell, name, session):
    """Runs a cell and returns the value of its last line, if that is an expression."""
    tree = ast.parse(cell, name)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, name, "exec"), session)
    return eval(compile(ast.Expression(last.value), name, "eval"), session) if last else None


def main():
    notebook, sources, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    cells = [cell for cell in json.loads(notebook.read_text(encoding="utf-8"))["cells"] if cell["cell_type"] == "code"]
    assert cells, f"{notebook}: nothing to run"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "experiments").symlink_to(sources / "experiments")
    os.chdir(folder)
    session = {"__name__": "__main__"}
    for number, cell in enumerate(cells, 1):
        assert not cell["outputs"], f"cell {number} holds an output: clear all outputs"
        value = run("".join(cell["source"]), f"{notebook.name}, cell {number}", session)
        if value is not None:
            print(f"[{number}]", value, flush=True)
        for figure in plt.get_fignums():  # a notebook begins each cell without a figure
            plt.figure(figure).savefig(f"cell-{number}.png")
        plt.close("all")


if __name__ == "__main__":
    main()
