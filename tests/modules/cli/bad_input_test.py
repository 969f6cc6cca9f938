# SPDX-License-Identifier: GPL-3.0-or-later
"""Every broken input of tests/corpus/bad is refused: exit code 2, a message that says where, what, what is allowed and
what to do, nothing written and nothing left behind, in little time and memory.

tests/corpus/bad/expected.toml says for each file which command reads it and what the message must say. The files are
the named blocks of tests/corpus/bad/*.txt, and those beside them that are no text.
"""
import os
import pathlib
import resource
import shlex
import shutil
import subprocess
import tempfile
import tomllib
import unittest

import broken_files

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
CORPUS = SOURCE / "tests/corpus/bad"
#: A refusal takes milliseconds; a hang takes for ever [s].
PATIENCE = 60
#: Far above what reading the largest input that is allowed takes, far below what a broken one may ask for [bytes].
MOST_MEMORY = 3 << 30
#: Words that every refusal has, each at the start of a line.
PARTS = ("\n  allowed: ", "\n  remedy:  ")


def limit_memory():
    if os.environ.get("BRASH_SANITIZE"):
        return  # a sanitizer reserves more address space than there is memory
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


def files_below(folder):
    """Everything in a folder, files with size and time of the last change; a campaign's lock says who was there last."""
    def state(p):
        return (p.stat().st_size, p.stat().st_mtime_ns) if p.is_file() else None  # a lock comes and goes in a folder
    return {str(p.relative_to(folder)): state(p) for p in folder.rglob("*") if p.name != "campaign.lock"}


def expectations(path):
    """What a broken case expects of itself, in lines `# expect: text`."""
    mark = b"# expect: "
    return [line[len(mark):].decode() for line in path.read_bytes().split(b"\n") if line.startswith(mark)]


def unpack(source, folder):
    """Makes a folder of files of each file of named blocks, and copies the files that are no text."""
    shutil.copytree(source, folder)
    for blocks in folder.glob("*.txt"):
        (folder / blocks.stem).mkdir(exist_ok=True)
        for block in (b"\n" + blocks.read_bytes()).removesuffix(b"\n").split(b"\n=== ")[1:]:
            name, content = block.split(b"\n", 1)
            (folder / blocks.stem / name.decode()).write_bytes(content)
        blocks.unlink()
    (folder.parent / "units.txt").touch()  # a file outside, to which some cases lead


class BadInput(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.path = pathlib.Path(scratch.name)
        cls.good, cls.made, cls.here = cls.path / "good", cls.path / "made", cls.path / "here"
        for folder in (cls.good, cls.made, cls.here):
            folder.mkdir()
        broken_files.make_good(BRASH, SOURCE, cls.good)
        broken_files.make_broken(cls.good, cls.made)
        cls.corpus = cls.path / "corpus/bad"
        unpack(CORPUS, cls.corpus)
        cls.expected = tomllib.loads((CORPUS / "expected.toml").read_text(encoding="utf-8"))

    def refuse(self, command, file, wanted):
        """Runs a command in an empty folder, which must stay empty."""
        words = [word.format(file=file, good=self.good, out=self.here / "out") for word in shlex.split(command)]
        done = subprocess.run([BRASH, *words], capture_output=True, timeout=PATIENCE, cwd=self.here, stdin=subprocess.DEVNULL,
                              preexec_fn=limit_memory, env={**os.environ, "TMPDIR": str(self.here)})
        said = done.stderr.decode()  # a message is UTF-8, whatever a file holds
        message = "".join(line for line in said.splitlines(keepends=True) if not line.startswith("warning: "))
        self.assertEqual(done.returncode, 2, message)
        self.assertEqual(done.stdout, b"")
        self.assertTrue(message.startswith("brash: "), message)
        for part in (*PARTS, *wanted):
            self.assertIn(part, message)
        self.assertTrue(all(c == "\n" or c >= " " for c in message), repr(message))
        self.assertLess(len(message), 20000)
        self.assertEqual(files_below(self.here), {}, "something is left behind")

    def test_every_broken_input_is_refused(self):
        n = 0
        seen = set()
        for name, group in self.expected.items():
            folder = self.made if group.get("made") else self.corpus
            files = group.get("says")
            if files is None:  # the files themselves say it
                files = {p.name: expectations(p) for p in sorted((folder / name).iterdir())}
            before = files_below(folder / group.get("folder", name))
            for file, says in files.items():
                path = folder / group.get("folder", name) / file
                seen.add(path)
                self.assertTrue(path.exists(), path)
                name_shown = [] if file in group.get("names_other", []) else [file]
                for command in group["commands"]:
                    with self.subTest(file=str(path.relative_to(folder)), command=command):
                        self.assertTrue(says, "nothing is expected of the message")
                        self.refuse(command, path, name_shown + says)
                    n += 1
            with self.subTest(folder=name):
                self.assertEqual(files_below(folder / group.get("folder", name)), before, "the input has changed, or has company")
        self.assertGreater(n, 400)
        stored = {p for p in self.corpus.rglob("*") if p.is_file() and p.name not in ("expected.toml", "README.md")}
        self.assertEqual(sorted(stored - seen), [], "no command is said to read these")


if __name__ == "__main__":
    unittest.main()
