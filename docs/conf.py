# SPDX-License-Identifier: GPL-3.0-or-later
"""The documents as a site: `./dev docs` builds it offline into build/docs."""
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
BRASH = HERE.parent / "build/release/bin/brash"
sys.path.insert(0, str(HERE / "_extensions"))

project = "brash"
author = "The brash authors"
copyright = author
release = re.search(r"project\(brash VERSION ([\d.]+)", (HERE.parent / "CMakeLists.txt").read_text())[1]

extensions = ["myst_parser", "sphinx.ext.autodoc", "brash_katex"]
myst_enable_extensions = ["dollarmath", "amsmath"]
myst_heading_anchors = 4
autodoc_member_order = "groupwise"
html_theme = "alabaster"
html_theme_options = {"description": "How a structure breaks level ice", "page_width": "1280px", "sidebar_width": "240px"}
html_sidebars = {"**": ["about.html", "navigation.html", "searchbox.html"]}
html_math_renderer = "katex"
html_copy_source = False


def name_what_is_not_in_the_site(app, docname, source):
    """Links to files outside docs/ become their paths in the sources."""
    def plain(match):
        path = (HERE / docname).parent.joinpath(match[2]).resolve()
        return match[0] if path.is_relative_to(HERE) else f"{match[1]} (`{path.relative_to(HERE.parent)}`)"

    source[0] = re.sub(r"\[([^]]*)\]\((\.\.[^)#\s]*)\)", plain, source[0])


def helps_of(path=()):
    """The help of the command at `path` and of those below it, each as a section."""
    text = subprocess.run([BRASH, *path, "--help"], check=True, capture_output=True, text=True).stdout
    yield f"## brash {' '.join(path)}\n\n```text\n{text}```\n" if path else ""
    for command in re.findall(r"^  ([a-z]+) +\S", text.partition("Subcommands:")[2], re.MULTILINE):
        yield from helps_of((*path, command))


def add_the_help_of_each_command(app, docname, source):
    if docname == "reference/command":
        source[0] += "\n" + "\n".join(helps_of())


def without_the_inner_module(app, what, name, value, options, signature, returned):
    return [text and text.replace("brash._brash.", "") for text in (signature, returned)]


def setup(app):
    app.connect("source-read", name_what_is_not_in_the_site)
    app.connect("source-read", add_the_help_of_each_command)
    app.connect("autodoc-process-signature", without_the_inner_module)
