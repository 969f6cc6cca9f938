# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulas by KaTeX in the reader's browser, from files of the site itself; each is tried with Node when it is built."""
import html
import json
import pathlib
import shutil
import subprocess

from docutils import nodes
from sphinx.errors import ExtensionError

KATEX = pathlib.Path("/usr/share/javascript/katex")  # Debian's libjs-katex
FORMULAS = []

RENDER = """document.querySelectorAll(".formula").forEach(e => katex.render(e.textContent, e,
  {displayMode: e.tagName === "DIV", throwOnError: false}));
"""
CHECK = """const katex = require(process.argv[1]);
const bad = JSON.parse(require("fs").readFileSync(0)).flatMap(([page, text, displayMode]) => {
  try { katex.renderToString(text, {displayMode, strict: "ignore"}); return []; }
  catch (error) { return [page + ": " + text + "\\n  " + error.message]; }
});
console.log(bad.join("\\n"));
process.exit(bad.length ? 1 : 0);
"""


def visit(self, node, tag):
    FORMULAS.append((self.builder.current_docname, node.astext(), tag == "div"))
    self.body.append(f'<{tag} class="formula">{html.escape(node.astext())}</{tag}>')
    raise nodes.SkipNode


def copy_katex(app):
    target = pathlib.Path(app.outdir) / "_static/katex"
    target.mkdir(parents=True, exist_ok=True)
    for name in ("katex.min.js", "katex.min.css"):
        shutil.copy(KATEX / name, target)
    shutil.copytree(KATEX / "fonts", target / "fonts", dirs_exist_ok=True)
    (target / "render.js").write_text(RENDER)
    (target / "size.css").write_text(".formula .katex { font-size: 1.08em; }\n")


def check(app, exception):
    if exception is not None or app.builder.name != "html":
        return
    done = subprocess.run(["node", "-e", CHECK, str(KATEX / "katex.min.js")], input=json.dumps(FORMULAS), text=True,
                          capture_output=True)
    if done.returncode != 0:
        raise ExtensionError("KaTeX refuses formulas:\n" + done.stdout + done.stderr)


def setup(app):
    app.add_html_math_renderer("katex", (lambda self, node: visit(self, node, "span"), None),
                               (lambda self, node: visit(self, node, "div"), None))
    app.add_css_file("katex/katex.min.css")
    app.add_css_file("katex/size.css")
    app.add_js_file("katex/katex.min.js", loading_method="defer")
    app.add_js_file("katex/render.js", loading_method="defer")
    app.connect("builder-inited", copy_katex)
    app.connect("build-finished", check)
