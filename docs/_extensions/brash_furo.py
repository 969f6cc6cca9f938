# SPDX-License-Identifier: GPL-3.0-or-later
"""Mends Debian 12's furo in the finished site.

Its script is not bundled and so no browser runs it, its style lost the rules for systems that are dark, and it asks
the server's root for normalize.css. Parts that a newer furo has in order are left as they are.
"""
import pathlib
import re

NORMALIZE = pathlib.Path("/usr/share/javascript/normalize.css/normalize.css")
DARK = re.compile(r'@media not print \{\s*body\[data-theme="dark"\] \{([^}]*)\}')


def mend_style(path):
    style = path.read_text(encoding="utf-8")
    style = re.sub(r"@import url\(/javascript/normalize\.css/[^)]*\);", lambda _: NORMALIZE.read_text(encoding="utf-8"), style)
    if "prefers-color-scheme" not in style:
        dark = DARK.search(style)[1]
        style += "\n@media not print {\n@media (prefers-color-scheme: dark) {\n" \
                 f'body:not([data-theme="light"]) {{{dark}}}\n' \
                 'html body:not([data-theme="light"]) .only-light { display: none !important; }\n' \
                 'body:not([data-theme="light"]) .only-dark { display: block !important; }\n}\n}\n'
    path.write_text(style, encoding="utf-8")


def mend_script(path):
    script = path.read_text(encoding="utf-8")
    line = re.compile(r'^import Gumshoe from "\./gumshoe-patched\.js";$', re.MULTILINE)
    if line.search(script):
        gumshoe = (path.parent / "gumshoe-patched.js").read_text(encoding="utf-8")
        path.write_text(gumshoe + line.sub("", script), encoding="utf-8")


def mend(app, exception):
    if exception is None and app.builder.name == "html":
        static = pathlib.Path(app.outdir) / "_static"
        mend_style(static / "styles/furo.css")
        mend_script(static / "scripts/furo.js")


def setup(app):
    app.connect("build-finished", mend)
    return {"parallel_read_safe": True}
