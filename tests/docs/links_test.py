# SPDX-License-Identifier: GPL-3.0-or-later
"""What documents and headers refer to is there: pages, headings, numbered equations."""
import os
import pathlib
import re
import unittest

SOURCE = pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
ROOMS = [SOURCE / name for name in ("geometry", "failure", "modules")]
PAGES = {page.name: page for page in (SOURCE / "docs/theory").glob("*.md")}
CODE = [file for room in ROOMS for pattern in ("*.hpp", "*.cpp") for file in room.rglob(pattern)]
LABEL = r"[A-Z]?\d+[a-z]?"


def equations_of(page):
    """Numbers that stand at the end of a displayed equation: `(C1)` after blanks, or \\tag{C1}."""
    text = page.read_text(encoding="utf-8")
    plain = re.findall(rf"^ {{4,}}\S.* {{2,}}\(({LABEL})\)$", text, re.MULTILINE)
    table = re.findall(rf"^\|.* {{2,}}\(({LABEL})\) \|$", text, re.MULTILINE)
    return set(plain) | set(table) | set(re.findall(r"\\tag\{([^}]*)\}", text))


def headings_of(page):
    return {h.strip() for h in re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)}


def anchors_of(page):
    """The anchors that GitHub and the site make of headings: small letters, hyphens for blanks, no other marks."""
    headings = [re.sub(r"\[([^]]*)\]\([^)]*\)|`", r"\1", heading) for heading in headings_of(page)]
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def comment_text(file):
    """A file with its comments' line breaks undone, so that a reference may run over a line's end."""
    return re.sub(r"\n\s*///? ?", " ", file.read_text(encoding="utf-8"))


def references(file):
    """(page, what): `docs/theory/x.md`, followed by `, (C1), (C2)` or `, Heading`, in the comments of a source."""
    for match in re.finditer(r"(?:docs/theory/)?([a-z-]+\.md)((?:, \(?" + LABEL + r"\)?|, [A-Z][a-z]+)*)", comment_text(file)):
        if match[1] in PAGES:
            yield match[1], re.findall(rf"(?<=, )\(?({LABEL}|[A-Z][a-z]+)\b", match[2])


class Links(unittest.TestCase):
    def test_pages_headings_and_equations_that_code_refers_to_exist(self):
        n_found = 0
        for file in CODE:
            for path in re.findall(r"docs/[\w/.-]+\.md", file.read_text(encoding="utf-8")):
                self.assertTrue((SOURCE / path).is_file(), f"{file}: {path}")
            for page, what in references(file):
                known, headings = equations_of(PAGES[page]), headings_of(PAGES[page])
                for label in what:
                    n_found += 1
                    self.assertTrue(label in known or any(h.startswith(label) for h in headings),
                                    f"{file}: {page}, {label}")
        self.assertGreater(n_found, 10)

    def test_every_numbered_equation_is_cited_by_the_code_or_the_test_that_uses_it(self):
        cited = {}
        for file in [*CODE, *(SOURCE / "tests").rglob("*.?pp"), *(SOURCE / "tests").rglob("*.py")]:
            for page, what in references(file):
                cited.setdefault(page, set()).update(what)
        not_cited = {name: equations_of(page) - cited.get(name, set()) for name, page in PAGES.items()}
        self.assertEqual({name: labels for name, labels in not_cited.items() if labels}, {})

    def test_links_between_documents_resolve(self):
        for page in [*SOURCE.glob("*.md"), *(SOURCE / "docs").rglob("*.md"), *(SOURCE / "experiments").rglob("*.md")]:
            text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
            for target, anchor in re.findall(r"\]\(([^)#\s]*)(?:#([^)\s]*))?\)", text):
                if target.startswith(("http:", "https:")):
                    continue
                file = page.parent / target if target else page
                self.assertTrue(file.exists(), f"{page}: {target}")
                if page.is_relative_to(SOURCE / "docs"):
                    self.assertFalse(file.is_dir(), f"{page}: {target} is a folder, for which the site has no page")
                if anchor:
                    self.assertIn(anchor, anchors_of(file), f"{page}: {target}#{anchor}")

    def test_every_titled_page_is_in_a_table_of_contents_of_the_site(self):
        shown = []
        for page in (SOURCE / "docs").rglob("*.md"):
            for tree in re.findall(r"```{toctree}\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL):
                folder = page.parent.relative_to(SOURCE / "docs")
                shown += [(folder / entry).as_posix() for entry in re.findall(r"^[^:\n].*$", tree, re.MULTILINE)]
        pattern = re.compile("|".join(re.escape(entry).replace(r"\*", "[^/]*") for entry in shown))
        pages = {page.relative_to(SOURCE / "docs").as_posix(): page for page in (SOURCE / "docs").rglob("*.md")}
        pages |= {page.relative_to(SOURCE).as_posix(): page for page in (SOURCE / "experiments").rglob("*.md")}
        missing = [name for name, page in pages.items()
                   if name != "index.md" and not pattern.fullmatch(name.removesuffix(".md"))
                   and re.search("^# ", page.read_text(encoding="utf-8"), re.MULTILINE)]
        self.assertEqual(missing, [])

    def test_old_addresses_lead_to_pages_that_are_there(self):
        lines = (SOURCE / "docs/redirects.txt").read_text(encoding="utf-8").splitlines()
        for old, new in (line.split() for line in lines if not line.startswith("#")):
            self.assertFalse((SOURCE / f"docs/{old}.md").exists(), f"{old} is a page, and no redirect may hide it")
            place = SOURCE if new.startswith("experiments/") else SOURCE / "docs"
            self.assertTrue((place / f"{new}.md").is_file(), f"{old} leads to {new}, which is not there")


if __name__ == "__main__":
    unittest.main()
