# SPDX-License-Identifier: GPL-3.0-or-later
"""Old addresses of the site lead to new ones: docs/redirects.txt has a line `old-page new-page` for each."""
import os
import pathlib

TABLE = pathlib.Path(__file__).resolve().parents[1] / "redirects.txt"
PAGE = """<!DOCTYPE html>
<meta charset="utf-8">
<title>This page has moved</title>
<meta http-equiv="refresh" content="0; url={to}">
<p>This page has moved to <a href="{to}">{to}</a>.</p>
"""


def redirects():
    """(old page, new page) of each line, without their endings."""
    lines = TABLE.read_text(encoding="utf-8").splitlines()
    return [tuple(line.split()) for line in lines if line and not line.startswith("#")]


def write_redirects(app, exception):
    if exception or app.builder.format != "html":
        return
    for old, new in redirects():
        page = pathlib.Path(app.outdir) / f"{old}.html"
        to = os.path.relpath(f"{new}.html", pathlib.PurePosixPath(old).parent)
        page.parent.mkdir(parents=True, exist_ok=True)
        page.write_text(PAGE.format(to=to), encoding="utf-8")


def setup(app):
    app.connect("build-finished", write_redirects)
    return {"parallel_read_safe": True}
