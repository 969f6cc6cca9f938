# SPDX-License-Identifier: GPL-3.0-or-later
"""The built site can be put on any static host: site_test.py FOLDER. `./dev docs` calls it."""
import html.parser
import pathlib
import re
import sys
import unittest
import urllib.parse

SITE = pathlib.Path(sys.argv[1]).resolve()


class Page(html.parser.HTMLParser):
    """Targets and anchors of a page, and whether it is one of Doxygen's."""

    def __init__(self, path):
        super().__init__()
        self.targets, self.anchors = set(), set()
        text = path.read_text(encoding="utf-8")
        # Doxygen leaves out what it does not document, but links to it by names that only its own script knows.
        self.is_doxygen = path.is_relative_to(SITE / "cpp")
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        for name in ("id", "name"):
            if values.get(name):
                self.anchors.add(values[name])
        for name in ("href", "src"):
            if values.get(name):
                self.targets.add(values[name])


PAGES = {path: Page(path) for path in SITE.rglob("*.html")}


class Site(unittest.TestCase):
    def test_every_link_leads_to_a_file_and_an_anchor_that_are_there(self):
        n_checked, broken = 0, []
        for path, page in PAGES.items():
            for target in page.targets:
                url = urllib.parse.urlsplit(target)
                if url.scheme or url.netloc:
                    continue
                n_checked += 1
                file = (path.parent / urllib.parse.unquote(url.path)).resolve() if url.path else path
                anchor = urllib.parse.unquote(url.fragment)
                if not file.is_file():
                    broken.append(f"{path.relative_to(SITE)}: {target}")
                elif anchor and file in PAGES and not page.is_doxygen and anchor not in PAGES[file].anchors and anchor != "top":
                    broken.append(f"{path.relative_to(SITE)}: {target}")
        self.assertEqual(broken, [])
        self.assertGreater(n_checked, 1000)

    def test_no_path_depends_on_the_machine_or_the_place_on_the_host(self):
        absolute = re.compile(r"""(?:href|src)=["'](?:/|file:)|url\(["']?(?:/|file:)""")
        for path in [*PAGES, *SITE.rglob("*.css")]:
            found = absolute.search(path.read_text(encoding="utf-8"))
            self.assertIsNone(found, f"{path.relative_to(SITE)}: {found}")
        sources = str(pathlib.Path(__file__).resolve().parents[2])
        for path in [p for p in SITE.rglob("*") if p.suffix in (".html", ".js", ".css")]:
            self.assertNotIn(sources, path.read_text(encoding="utf-8"), path)

    def test_nothing_is_loaded_from_a_network(self):
        loaded = re.compile(r"""<(?:script|img|link|iframe)[^>]*(?:src|href)=["']https?:""")
        for path in PAGES:
            self.assertIsNone(loaded.search(path.read_text(encoding="utf-8")), path)

    def test_what_a_static_host_wants_is_there(self):
        for name in ("index.html", "404.html", ".nojekyll", "search.html", "searchindex.js", "gallery.html", "cpp/index.html"):
            self.assertTrue((SITE / name).is_file(), name)

    def test_each_experiment_stands_in_the_gallery(self):
        text = (SITE / "gallery.html").read_text(encoding="utf-8")
        experiments = [p.parent.name for p in (pathlib.Path(__file__).parents[2] / "experiments").glob("*/README.md")]
        self.assertEqual([name for name in experiments if f'href="experiments/{name}/README.html"' not in text], [])
        self.assertGreater(len(experiments), 5)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
