# SPDX-License-Identifier: GPL-3.0-or-later
"""The documents as a site: `./dev docs` builds it offline into build/docs.

The sources are a folder of links, build/docs/source: all that is in docs/, and experiments/ as a folder beside it.
"""
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
TOP = HERE.parent
BRASH = TOP / "build/release/bin/brash"
sys.path.insert(0, str(HERE / "_extensions"))

project = "brash"
author = "The brash authors"
copyright = author
release = re.search(r"project\(brash VERSION ([\d.]+)", (TOP / "CMakeLists.txt").read_text())[1]

extensions = ["myst_parser", "sphinx.ext.autodoc", "brash_furo", "brash_gallery", "brash_katex", "brash_redirects"]
exclude_patterns = ["_*"]
myst_enable_extensions = ["dollarmath", "amsmath", "attrs_image", "colon_fence"]
myst_heading_anchors = 4
autodoc_member_order = "groupwise"
html_theme = "furo"
html_title = f"brash {release}"
html_short_title = "brash"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_extra_path = ["_extra"]
# Blues of the ice in the report's page; the second set is for dark pages.
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#1f5a7a", "color-brand-content": "#1f5a7a"},
    "dark_css_variables": {"color-brand-primary": "#8cc4e0", "color-brand-content": "#8cc4e0"},
}
pygments_style = "friendly"
pygments_dark_style = "monokai"
html_math_renderer = "katex"
html_copy_source = False
html_show_sphinx = False


def place_of(docname):
    """Where the source of a page lies in the repository."""
    return (TOP if docname.startswith("experiments/") else HERE) / f"{docname}.md"


def follow_links(app, docname, source):
    """Links lead to the pages of the site; where there is none, the path in the sources stands in their place.

    A page without a title is a recorded table. It gets the name of its folder, and no table of contents lists it.
    """
    folder = place_of(docname).parent
    if not re.search(r"^# ", source[0], re.MULTILINE):
        source[0] = f"---\norphan: true\n---\n# {folder.name.capitalize()}\n\n{source[0]}"

    def resolved(match):
        path = (folder / match[2]).resolve()
        if path.is_relative_to(HERE):
            target = path.relative_to(HERE)
        elif path.is_relative_to(TOP / "experiments") and (path.is_file() and path.suffix in (".md", ".png", ".svg")):
            target = path.relative_to(TOP)
        else:
            return f"{match[1].removeprefix('!')} (`{path.relative_to(TOP)}`)"
        up = "../" * docname.count("/")
        return f"[{match[1]}]({up}{target}{match[3] or ''})"

    source[0] = re.sub(r"\[([^]]*)\]\((\.\.[^)#\s]*)(#[^)\s]*)?\)", resolved, source[0])


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


def without_field_numbers(app, what, name, value, options, lines):
    """Fields of named tuples say nothing of themselves; their class does."""
    if lines and lines[0].startswith("Alias for field number"):
        lines.clear()


def with_overloads_as_code(app, what, name, value, options, lines):
    """The signatures in the list of a function's overloads are code: their stars are no marks of emphasis."""
    lines[:] = [re.sub(r"^(\d+\. )(\w+\(.*)$", r"\1``\2``", line.replace("brash._brash.", "")) for line in lines]


def setup(app):
    app.connect("source-read", follow_links)
    app.connect("source-read", add_the_help_of_each_command)
    app.connect("autodoc-process-docstring", without_field_numbers)
    app.connect("autodoc-process-docstring", with_overloads_as_code)
    app.connect("autodoc-process-signature", without_the_inner_module)
