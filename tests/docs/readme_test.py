# SPDX-License-Identifier: GPL-3.0-or-later
"""The README's first screen: is it for me, how good is it, how long does it take, how do I start; nothing before it is explained."""
import os
import pathlib
import re
import unittest

SOURCE = pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
README = (SOURCE / "README.md").read_text(encoding="utf-8")
FILM_ENDS = README.index("</picture>")


def section(heading):
    """The text under a heading of the README, up to the next."""
    return README.partition(f"\n## {heading}\n")[2].partition("\n## ")[0]


def cells(text, column):
    """The cells of a table's column, without its heading and rule."""
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines() if line.startswith("|")]
    return [row[column] for row in rows[2:]]


class FirstScreen(unittest.TestCase):
    def test_it_is_short_and_in_the_order_of_a_reader_s_questions(self):
        self.assertLessEqual(len(README.splitlines()), 90)
        self.assertEqual(re.findall(r"^## (.*)$", README, re.MULTILINE),
                         ["How good is it", "How long does it take", "How do I start", "Citation and licence"])
        one_sentence = re.sub(r"\s+", " ", README[:README.index("<picture>")].partition("\n\n")[2]).strip()
        self.assertRegex(one_sentence, r"^`brash` simulates [^.]*\.$")
        self.assertLess(FILM_ENDS, README.index("| you have | you get |"))
        self.assertLess(README.index("| you have | you get |"), README.index("**Not modelled:**"))
        self.assertLess(README.index("**Not modelled:**"), README.index("## How good is it"))

    def test_the_film_says_which_cone_ice_and_speed(self):
        caption = README[FILM_ENDS:].partition("*")[2].partition("*")[0]
        for number in (r"cone [\d.]+ m wide", r"ice [\d.]+ m thick", r"[\d.]+ m/s"):
            self.assertRegex(caption, number)
        self.assertNotRegex(README, r"(?i)the validation (run|case)")

    def test_presets_are_explained_before_a_number_of_theirs(self):
        table = README.index("| case | known |")
        for preset, words in (("paper", r"preset `paper` takes \[a paper\]"), ("brash", r"default, `brash`, has more physics")):
            explained = re.search(words, README)
            self.assertIsNotNone(explained, preset)
            self.assertLess(explained.start(), table)
            # The name of the program apart, no preset is named before.
            before = README[:explained.start()].replace("`brash` simulates", "")
            self.assertNotRegex(before, rf"`{preset}`(?!,? has more)")

    def test_the_worst_miss_is_named_and_each_accuracy_has_a_known_value(self):
        table = section("How good is it")
        self.assertEqual(len(re.findall(r"\*\*worst miss:\*\*", table)), 1)
        for known in cells(table, 1):
            self.assertNotEqual(known, "")

    def test_nothing_is_both_modelled_and_not(self):
        table = README.partition("| you have | you get |")[2].partition("**Not modelled:**")
        promised = " ".join(line for line in table[0].splitlines() if line.startswith("|"))
        for thing in re.split(r",\s*(?:and )?", table[2].partition("(")[0]):
            self.assertNotIn(thing.strip(), promised)
        # The same on the first page of the documents, where large floes once stood in both columns.
        scope = (SOURCE / "docs/index.md").read_text(encoding="utf-8").partition("| modelled | not modelled |")[2]
        scope = "| modelled | not modelled |" + scope.partition("\n\n")[0]
        modelled, absent = ({part.strip() for cell in cells(scope, column) for part in re.split(r"[,;:]", cell)} for column in (0, 1))
        self.assertGreater(min(len(modelled), len(absent)), 10)
        self.assertEqual(modelled & absent, set())
        self.assertIn("the structure bends and splits large floes", modelled)
        self.assertIn("large floes that bend or split each other", absent)

    def test_the_start_is_at_most_five_commands_and_each_task_one_row(self):
        start = section("How do I start")
        commands = re.findall(r"^    (\S.*)$", start, re.MULTILINE)
        self.assertEqual(commands[0].split("#")[0].strip(), "./dev demo")
        self.assertLessEqual(len(commands), 5)
        self.assertIn("brash run", commands[-1])
        tasks = cells(start, 0)
        self.assertEqual(len(tasks), len(set(tasks)))
        for page in cells(start, 1):
            self.assertRegex(page, r"\]\([\w./#-]+\)")


if __name__ == "__main__":
    unittest.main()
