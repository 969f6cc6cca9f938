# SPDX-License-Identifier: GPL-3.0-or-later
"""The directive `gallery`: a card for each experiment, of the title, the first sentence and a picture of its README."""
import pathlib
import re
import struct

from docutils import nodes
from docutils.parsers.rst import Directive, directives
from docutils.statemachine import StringList

TOP = pathlib.Path(__file__).resolve().parents[2]
SHAPE_OF_CARD = 1.2  # breadth over height of a card's picture; docs/_static/site.css has the same
# A sentence ends at a full stop that no abbreviation and no list of files owns, before a capital or the paragraph's end.
END = re.compile(r"(?<!\bSec)(?<!\bFig)(?<!\bFigs)(?<!\bEq)(?<!\bEqs)[.:?](?=\s+[A-Z`]|$)")


def card_of(readme):
    """(title, first sentence, path of the first picture or None)."""
    text = readme.read_text(encoding="utf-8")
    title = re.search(r"^# (.*)$", text, re.MULTILINE)[1]
    paragraph = " ".join(text.split("\n\n")[1].split())
    end = END.search(paragraph)
    sentence = paragraph[:end.start()] + end[0].replace(":", ".") if end else f"{paragraph}."
    picture = re.search(r"!\[[^]]*\]\(([^)]*)\)", text)
    return title, sentence, picture and readme.parent / picture[1]


def width_of(picture, panels):
    """Width of a PNG picture of `panels`, columns and rows, in percent of a card's, at which the first panel fills the card."""
    columns, rows = panels
    width, height = struct.unpack(">II", picture.read_bytes()[16:24])
    return round(100 * columns * min(1, rows * width / (columns * height * SHAPE_OF_CARD)))


class Gallery(Directive):
    """Cards without a picture come last, the rest in order of name.

    first     folders that come first.
    panels    folder=COLUMNSxROWS of a picture with several panels: the card shows the first, in letters that can be read.
    pictures  folder=path, in place of the README's first picture.
    """
    option_spec = {"first": directives.unchanged, "panels": directives.unchanged, "pictures": directives.unchanged}

    def pairs(self, name):
        return dict(pair.split("=") for pair in self.options.get(name, "").split())

    def run(self):
        environment = self.state.document.settings.env
        first = self.options.get("first", "").split()
        panels, pictures = self.pairs("panels"), self.pairs("pictures")
        cards = [(readme.parent.name, readme, *card_of(readme)) for readme in (TOP / "experiments").glob("*/README.md")]
        cards = [(*card[:4], TOP / pictures[card[0]] if card[0] in pictures else card[4]) for card in cards]
        cards.sort(key=lambda card: (card[4] is None, first.index(card[0]) if card[0] in first else len(first), card[0]))
        up = "../" * environment.docname.count("/")
        gallery = nodes.container(classes=["cards"])
        for name, readme, title, sentence, picture in cards:
            environment.note_dependency(str(readme))
            page = f"{up}{readme.relative_to(TOP)}"
            lines = []
            if picture:
                place = picture.relative_to(TOP / "docs" if "docs" in picture.relative_to(TOP).parts else TOP)
                lines = [f"[![]({up}{place})]({page})", ""]
            lines += [f"[**{title}**]({page})", "", re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", sentence)]
            card = nodes.container(classes=["card"])
            self.state.nested_parse(StringList(lines, environment.docname), self.content_offset, card)
            for image in card.findall(nodes.image):
                image["width"] = f"{width_of(picture, map(int, panels[name].split('x'))) if name in panels else 100}%"
            gallery += card
        return [gallery]


def setup(app):
    app.add_directive("gallery", Gallery)
    return {"parallel_read_safe": True}
