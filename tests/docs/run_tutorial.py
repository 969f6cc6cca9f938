# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs what a tutorial tells its reader to run: files are written, commands and scripts run, in the order of the page.

run_tutorial.py TUTORIAL.md SOURCES FOLDER

A fence `sh` is a script of commands, each of which must succeed, and of `sh refused` each line must be refused with exit code 2;
`python` is a script, and all of a page are one session; `toml NAME`, `text NAME` are files. Other fences and indented blocks are not run.
A picture of docs/figures has as its title the file that the page makes, and that file must be there at the end.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

FIGURE = re.compile(r'!\[[^]]*\]\(\.\./figures/[^ )]+(?: "([^"]*)")?\)')
FENCE = re.compile(r"^```(\w+)[ ]*([^\n]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def main():
    page, sources, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "experiments").symlink_to(sources / "experiments")
    os.chdir(folder)
    os.environ["MPLBACKEND"] = "agg"
    session = {"__name__": "__main__"}
    n_run = 0
    lines = page.read_text(encoding="utf-8")
    for kind, name, text in FENCE.findall(lines):
        if kind == "sh":
            print(text, flush=True)
        if kind == "sh" and name == "refused":
            for line in text.splitlines():
                code = subprocess.run(["bash", "-c", line]).returncode
                assert code == 2, f"exit code {code}, expected 2: {line}"
        elif kind == "sh":
            subprocess.run(["bash", "-euo", "pipefail", "-c", text], check=True)
        elif kind == "python":
            exec(compile(text, page.name, "exec"), session)
        elif kind in ("toml", "text") and name:
            pathlib.Path(name).write_text(text, encoding="utf-8")
        else:
            continue
        n_run += 1
    if n_run == 0:
        sys.exit(f"{page}: nothing to run")
    for file in FIGURE.findall(lines):
        assert pathlib.Path(file).is_file(), f"{page}: no command makes the picture '{file}'"


if __name__ == "__main__":
    main()
