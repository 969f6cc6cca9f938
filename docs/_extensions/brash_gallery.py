# SPDX-License-Identifier: GPL-3.0-or-later
"""The directive `gallery`: a card for each experiment, of the title, the first sentence and the first picture of its README."""
import pathlib
import re

from docutils import nodes
from docutils.parsers.rst import Directive, directives
from docutils.statemachine import StringList

TOP = pathlib.Path(__file__).resolve().parents[2]
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


class Gallery(Directive):
    """The option `first` names the folders that come first; cards without a picture come last, the rest in order of name."""
    option_spec = {"first": directives.unchanged}

    def run(self):
        environment = self.state.document.settings.env
        first = self.options.get("first", "").split()
        cards = [(readme.parent.name, readme, *card_of(readme)) for readme in (TOP / "experiments").glob("*/README.md")]
        cards.sort(key=lambda card: (card[4] is None, first.index(card[0]) if card[0] in first else len(first), card[0]))
        up = "../" * environment.docname.count("/")
        gallery = nodes.container(classes=["cards"])
        for _, readme, title, sentence, picture in cards:
            environment.note_dependency(str(readme))
            page = f"{up}{readme.relative_to(TOP)}"
            lines = [f"[![]({up}{picture.relative_to(TOP)})]({page})", ""] if picture else []
            lines += [f"[**{title}**]({page})", "", re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", sentence)]
            card = nodes.container(classes=["card"])
            self.state.nested_parse(StringList(lines, environment.docname), self.content_offset, card)
            gallery += card
        return [gallery]


def setup(app):
    app.add_directive("gallery", Gallery)
    return {"parallel_read_safe": True}
