# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands that documents show exist: the command, its options and how many arguments it takes, as its own help says.

commands_test.py BRASH
"""
import os
import pathlib
import re
import shlex
import subprocess
import sys
import unittest

SOURCE = pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
BRASH = sys.argv[1]
PAGES = [SOURCE / "README.md", SOURCE / "CONTRIBUTING.md", *sorted((SOURCE / "docs").rglob("*.md")),
         *sorted((SOURCE / "experiments").rglob("*.md"))]
HELPS = {}


class Help:
    """What `brash PATH --help` says: subcommands, options with whether they take a value, and positional arguments."""

    def __init__(self, path):
        text = subprocess.run([BRASH, *path, "--help"], check=True, capture_output=True, text=True).stdout
        self.commands = set(re.findall(r"^  ([a-z]+) +\S", text.partition("Subcommands:")[2], re.MULTILINE))
        self.takes_value = {}
        for names, rest in re.findall(r"^  (-\S+)(.*)$", text, re.MULTILINE):
            for name in names.split(","):
                # An option with a value is followed by the value's kind in capitals.
                self.takes_value[re.sub(r"\{.*\}", "", name)] = re.match(r" [A-Z]{2,}|.*\.\.\.", rest) is not None
        positionals = text.partition("Positionals:")[2].partition("\nOptions:")[0]
        lines = re.findall(r"^  ([a-z_]\S*) (.*)$", positionals, re.MULTILINE)
        self.n_least = sum("REQUIRED" in rest for _, rest in lines)
        self.n_most = float("inf") if any("..." in rest for _, rest in lines) else len(lines)


def help_of(path):
    if path not in HELPS:
        HELPS[path] = Help(path)
    return HELPS[path]


def lines_of(page):
    """Lines of code blocks, fenced or indented, and the inline code, without shell comments."""
    text = page.read_text(encoding="utf-8")
    fenced = re.findall(r"^```[^\n]*\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    text = re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)
    code = "\n".join(fenced) + "\n" + "\n".join(line[4:] for line in text.splitlines() if line.startswith("    "))
    yield from code.replace("\\\n", " ").splitlines()
    yield from re.findall(r"`((?:brash|\./dev) [^`]*)`", text)


def commands_of(page):
    """The words of each command that begins with `brash` or `./dev`; a pipe, a bracket or a redirection ends it."""
    for line in lines_of(page):
        for part in re.split(r"&&|\|\||[|;]|\$\(|<\(", re.sub(r"\s#\s.*$", "", line)):
            part = re.sub(r"[<>].*$|\)\s*$|^\s*[A-Z_]+=\S+ ", "", part).strip()
            if re.match(r"(brash|\./dev) ", part):
                yield shlex.split(part)


def complaint_about(words):
    """Why `brash WORDS` does not parse, or None. Upper-case words and dots stand for something of the reader's."""
    path = ()
    while len(words) and words[0] in help_of(path).commands:
        path, words = (*path, words[0]), words[1:]
    known = help_of(path)
    if not path and words[0] != "--version":
        return None if words[0].isupper() else f"no command `{words[0]}`"
    n_arguments, i = 0, 0
    while i < len(words):
        name, given = re.match(r"(--?[a-z][\w-]*)?=?(.*)$", words[i], re.DOTALL).groups()
        if name is None:
            n_arguments += words[i] != "..."
        elif name not in known.takes_value:
            return f"`{' '.join(path)}` has no option {name}"
        elif known.takes_value[name] and not given:
            i += 1
        i += 1
    if n_arguments > known.n_most:
        return f"`{' '.join(path)}` takes at most {known.n_most} arguments, not {n_arguments}"
    return None


class Commands(unittest.TestCase):
    def test_every_brash_command_in_the_documents_parses(self):
        n_checked = 0
        for page in PAGES:
            for words in commands_of(page):
                if words[0] == "brash":
                    n_checked += 1
                    self.assertIsNone(complaint_about(words[1:]), f"{page.relative_to(SOURCE)}: {' '.join(words)}")
        self.assertGreater(n_checked, 50)

    def test_every_dev_command_in_the_documents_is_one_of_its_usage(self):
        usage = subprocess.run([SOURCE / "dev", "help"], check=True, capture_output=True, text=True).stdout
        known = set(re.findall(r"^  ([a-z]+)", usage, re.MULTILINE))
        n_checked = 0
        for page in PAGES:
            for words in commands_of(page):
                if words[0] == "./dev" and not words[1].isupper():
                    n_checked += 1
                    self.assertIn(words[1], known, f"{page.relative_to(SOURCE)}: {' '.join(words)}")
        self.assertGreater(n_checked, 15)

    def test_scripts_that_the_documents_start_are_there_and_can_be_started(self):
        for page in PAGES:
            for line in lines_of(page):
                for path in re.findall(r"(?:^|\s)((?:experiments|tests|modules)/\S+\.(?:py|mjs))(?=\s|$)", re.sub(r"\s#\s.*$", "", line)):
                    self.assertTrue(os.access(SOURCE / path, os.X_OK) or "python3" in line or "node" in line,
                                    f"{page.relative_to(SOURCE)}: {path}")
                    self.assertTrue((SOURCE / path).is_file(), f"{page.relative_to(SOURCE)}: {path}")

    def test_a_command_that_does_not_exist_is_noticed(self):
        for words in (["runs", "x"], ["run", "case.toml", "--nonsense"], ["run", "a.toml", "b.toml"], ["failure", "train", "--ouput", "x"]):
            self.assertIsNotNone(complaint_about(words), words)
        self.assertIsNone(complaint_about(["run", "case.toml", "--set", "a=b", "-o", "out"]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
