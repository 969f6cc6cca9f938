# SPDX-License-Identifier: GPL-3.0-or-later
"""The documents stay readable: short sentences, few numbers in each, no clauses in the place of nouns.

Tables, headings, code and displayed formulas are left out. An inline formula or a code span counts as one word.
prose_test.py FILE... prints the counts of files instead, and their longest sentences.
"""
import dataclasses
import os
import pathlib
import re
import statistics
import sys
import unittest

SOURCE = pathlib.Path(os.environ.get("BRASH_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
DOCUMENTS = [*SOURCE.glob("*.md"), *(SOURCE / "docs").rglob("*.md"), *(SOURCE / "experiments").rglob("*.md")]
ROOMS = [SOURCE / name for name in ("geometry", "failure", "modules", "tests")]

NUMBER = re.compile(r"(?<![\w.])-?\d[\d.]*(?:e-?\d+)?\b")
WHAT = re.compile(r"\bwhat (?:is|it|they|that|the|a|an|this|was|were|no|floes|one)\b", re.IGNORECASE)
THAT_OF = re.compile(r"\b(?:that|those) of\b", re.IGNORECASE)

# Jolt, Box2D, Manifold and CGAL have a median of 11 to 18 words, 20 to 37 at 90 %, and 0.1 to 0.6 numbers a sentence.
MOST_MEDIAN = 16
MOST_90 = 30
MOST_NUMBERS = 0.6
MOST_CLAUSES = 3  # in 10 000 words, of each kind


@dataclasses.dataclass
class Prose:
    """Counts over sentences: lengths in words, numbers in each, clauses in 10 000 words."""
    words: int
    median: float
    at_90: int
    numbers: float
    what: float
    that_of: float

    def __str__(self):
        return (f"{self.words} words; {self.median:g} words a sentence, {self.at_90} at 90 %; {self.numbers:.2f} numbers a "
                f"sentence; in 10 000 words {self.what:.1f} 'what is ...', {self.that_of:.1f} 'that of'")


def comments(text):
    """The comment lines of C++ without their slashes."""
    lines = [re.sub(r"^\s*//[/!<]*<?\s?", "", line) for line in text.splitlines() if re.match(r"\s*//", line)]
    return "\n".join(line for line in lines if not line.startswith("SPDX"))


def paragraphs(text):
    """Paragraphs and list items as single lines; inline code and formulas are one word, links their text."""
    text = re.sub(r"```.*?```|\$\$.*?\$\$", " ", text, flags=re.DOTALL)
    for block in re.split(r"\n\s*\n", text):
        kept = [line for line in block.splitlines() if not re.match(r"\s*(\||#|    |<!--|!\[)", line)]
        for item in re.split(r"\n(?=\s*(?:[-*]|\d+\.)\s)", "\n".join(kept)):
            item = re.sub(r"\]\([^)]*\)", "]", item)
            words = re.sub(r"\$[^$]*\$|`[^`]*`", "X", item).split()
            if len(words) > 3:
                yield " ".join(words)


def sentences(text):
    for paragraph in paragraphs(text):
        for sentence in re.split(r"(?<=[.!?:])\s+(?=[A-Z*\[(\"'`])", paragraph):
            if len(sentence.split()) > 2:
                yield sentence


def prose(texts):
    found = [sentence for text in texts for sentence in sentences(text)]
    lengths = sorted(len(sentence.split()) for sentence in found)
    words = sum(lengths)

    def in_10_000_words(pattern):
        return 1e4 * sum(len(pattern.findall(sentence)) for sentence in found) / words

    return Prose(words, statistics.median(lengths), lengths[int(0.9 * (len(lengths) - 1))],
                 sum(len(NUMBER.findall(sentence)) for sentence in found) / len(found), in_10_000_words(WHAT),
                 in_10_000_words(THAT_OF))


def text_of(file):
    text = file.read_text(encoding="utf-8", errors="replace")
    return comments(text) if file.suffix in (".cpp", ".hpp") else text


class Counter(unittest.TestCase):
    SAMPLE = """# A heading is no sentence of this text

What is left of 2 floes is that of 3.5 others. The second `code span` has $x + 1$ words.

| 1 | table |

- An item with one [link](target.md) counts too.

```sh
this is code and no prose
```
"""

    def test_counts_words_numbers_and_clauses_of_prose_alone(self):
        found = prose([self.SAMPLE])
        self.assertEqual(found.words, 11 + 6 + 8)
        self.assertEqual((found.median, found.at_90), (8, 8))
        self.assertAlmostEqual(found.numbers, 2 / 3)
        self.assertAlmostEqual(found.what, 1e4 / found.words)
        self.assertAlmostEqual(found.that_of, 1e4 / found.words)

    def test_takes_the_comments_of_cpp_without_slashes_and_licence(self):
        code = "// SPDX-License-Identifier: X\nint a;  // not a line of its own\n  /// First line.\n//!< Second."
        self.assertEqual(comments(code), "First line.\nSecond.")


class Documents(unittest.TestCase):
    def test_documents_have_short_sentences_with_few_numbers(self):
        found = prose(map(text_of, DOCUMENTS))
        print(f"documents: {found}")
        self.assertGreater(found.words, 10_000)
        self.expect_readable(found)

    def test_comments_of_the_code_keep_the_limits(self):
        files = [file for room in ROOMS for pattern in ("*.hpp", "*.cpp") for file in room.rglob(pattern)
                 if "node_modules" not in file.parts]
        found = prose(map(text_of, files))
        print(f"comments: {found}")
        self.assertGreater(found.words, 10_000)
        self.expect_readable(found)

    def test_no_line_begins_with_a_per_cent_sign(self):
        # The site's parser (MyST) takes such a line for a comment, and its text would be lost.
        lost = [f"{file.relative_to(SOURCE)}: {line}" for file in DOCUMENTS
                for line in re.sub(r"```.*?```", "", text_of(file), flags=re.DOTALL).splitlines() if re.match(r"\s{0,3}%", line)]
        self.assertEqual(lost, [])

    def expect_readable(self, found):
        self.assertLessEqual(found.median, MOST_MEDIAN)
        self.assertLessEqual(found.at_90, MOST_90)
        self.assertLessEqual(found.numbers, MOST_NUMBERS)
        self.assertLess(found.what, MOST_CLAUSES)
        self.assertLess(found.that_of, MOST_CLAUSES)


def main(names):
    kinds = (".md", ".cpp", ".hpp")
    files = [file for name in map(pathlib.Path, names)
             for file in (sorted(f for f in name.rglob("*") if f.suffix in kinds) if name.is_dir() else [name])]
    longest = []
    for file in files:
        found = list(sentences(text_of(file)))
        if found:
            print(f"{file}: {prose([text_of(file)])}")
            longest += [(len(s.split()), file, s) for s in found]
    for _, file, sentence in sorted(longest, reverse=True)[:5]:
        print(f"\n{file}\n  {sentence}")


if __name__ == "__main__":
    if sys.argv[1:] and not sys.argv[1].startswith("-"):
        main(sys.argv[1:])
    else:
        unittest.main()
