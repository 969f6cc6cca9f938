# SPDX-License-Identifier: GPL-3.0-or-later
"""An installation works by itself: the program, the Python module, the models and the completion."""
import gzip
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest
import zipfile

BUILD, SOURCE = pathlib.Path(os.environ["BRASH_BUILD_DIR"]), pathlib.Path(os.environ["BRASH_SOURCE_DIR"])


def install(prefix, **environment):
    subprocess.run([os.environ["CMAKE"], "--install", BUILD, "--prefix", prefix], check=True, capture_output=True,
                   env={**os.environ, **environment})


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.prefix = pathlib.Path(cls.folder.name).resolve()
        install(cls.prefix)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def run_here(self, *command):
        environment = {"PATH": "/usr/bin:/bin", "PYTHONPATH": str(self.prefix / "lib/python3/dist-packages")}
        done = subprocess.run([str(word) for word in command], cwd=self.prefix, env=environment, capture_output=True,
                              text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_a_case_runs_with_the_installed_model(self):
        case = self.prefix / "share/brash/examples/validation/cone.toml"
        self.run_here("bin/brash", "run", case, "--set", "time.duration=0.2", "-o", "out")
        manifest = json.loads((self.prefix / "out/manifest.json").read_text())
        model = manifest["inputs"][1]["path"]
        self.assertTrue(model.startswith(str(self.prefix / "share/brash/models")), model)

    def test_a_unit_is_made_with_the_installed_library_and_models(self):
        self.run_here("bin/brash", "export", "fmu", "share/brash/examples/validation/cone.toml", "-o", "cone.fmu")
        with zipfile.ZipFile(self.prefix / "cone.fmu") as unit:
            self.assertEqual(unit.read("binaries/linux64/brash.so"), (self.prefix / "lib/brash/fmu.so").read_bytes())
            self.assertEqual(unit.read("resources/models/cone_network.json"),
                             (self.prefix / "share/brash/models/cone_network.json").read_bytes())

    def test_the_module_is_imported_and_runs_from_there(self):
        said = self.run_here("/usr/bin/python3", "-c", f"""
import brash
case = brash.Case.from_file("share/brash/examples/validation/cone.toml", {{"time.duration": 0.2}})
case.run("python")
brash.FailureModel("superposition")
print(brash.__file__)
print([line for line in open("/proc/self/maps") if {str(BUILD)!r} in line])""")
        self.assertEqual(said.splitlines(), [str(self.prefix / "lib/python3/dist-packages/brash/__init__.py"), "[]"])

    def test_nothing_that_is_read_lies_in_the_build_tree_or_the_sources(self):
        try:
            said = subprocess.run(["strace", "-f", "-e", "trace=openat", self.prefix / "bin/brash", "check",
                                   self.prefix / "share/brash/examples/validation/cone.toml"], capture_output=True, text=True)
        except FileNotFoundError:
            self.skipTest("strace is not installed")
        opened = [line for line in said.stderr.splitlines() if f'"{SOURCE}/' in line]
        self.assertEqual(opened, [])

    def test_a_program_of_others_is_built_with_the_installed_package(self):
        source, build = SOURCE / "tests/install/consumer", self.prefix / "consumer"
        said = ""
        for command in ([os.environ["CMAKE"], "-G", "Ninja", "-S", source, "-B", build,
                         f"-DCMAKE_PREFIX_PATH={self.prefix}"],
                        [os.environ["CMAKE"], "--build", build], [build / "consumer"]):
            done = subprocess.run(command, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            said = done.stdout
        self.assertEqual(said, "4 pieces, breaks: 1\n")
        self.assertNotIn(str(BUILD), "".join(p.read_text() for p in (self.prefix / "lib/cmake/brash").iterdir()))

    def test_the_cpp_program_of_the_tutorial_is_built_as_it_stands(self):
        page = (SOURCE / "docs/tutorials/polygon-kernel.md").read_text(encoding="utf-8")
        folder = self.prefix / "tutorial"
        folder.mkdir()
        for name, text in re.findall(r"^```(?:cmake|cpp) (\S+)\n(.*?)^```$", page, re.MULTILINE | re.DOTALL):
            (folder / name).write_text(text)
        for command in ([os.environ["CMAKE"], "-G", "Ninja", "-B", "build", f"-DCMAKE_PREFIX_PATH={self.prefix}"],
                        [os.environ["CMAKE"], "--build", "build"], ["build/floes"]):
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"^[\d.]+ m2\n[\d.]+ m2\nnothing is lost\n$")

    def test_documents_schema_and_completion_are_there(self):
        for name in ("share/brash/case.schema.json", "share/doc/brash/README.md", "share/doc/brash/CITATION.cff",
                     "share/doc/brash/docs/glossary.md", "share/brash/models/cone_network.md",
                     "share/brash/models/cone_network_errors.csv",
                     "share/bash-completion/completions/brash", "share/man/man1/brash.1.gz", "lib/python3/dist-packages/brash/_brash.pyi"):
            self.assertTrue((self.prefix / name).is_file(), name)

    def test_the_files_that_tutorials_read_are_there(self):
        """Under the name of the sources, as docs/tutorials/index.md links them, with what their scripts import."""
        pages = "".join(page.read_text() for page in (self.prefix / "share/doc/brash/docs/tutorials").glob("*.*"))
        names = set(re.findall(r"experiments/([\w/]+\.(?:toml|csv|py))", pages))
        self.assertGreater(len(names), 10)
        examples = self.prefix / "share/brash/examples"
        self.assertEqual([name for name in sorted(names) if not (examples / name).is_file()], [])
        for plan, case in (("turbine/design.toml", "turbine.toml"), ("floater/thicknesses.toml", "kulluk.toml")):
            self.assertIn(f'case = "{case}"', (examples / plan).read_text())
            self.assertTrue((examples / plan).with_name(case).is_file())
        for folder, script in (("floater", "offset"), ("coupling", "tower")):
            self.run_here("/usr/bin/python3", "-B", "-c",
                          f"import sys; sys.path.insert(0, {str(examples / folder)!r}); import {script}")

    def test_debian_s_changelog_begins_with_a_version_that_debian_reads(self):
        text = gzip.decompress((self.prefix / "share/doc/brash/changelog.Debian.gz").read_bytes()).decode()
        self.assertRegex(text.splitlines()[0], r"^brash \(\d+\.\d+\.\d+-1\) unstable; urgency=medium$")

    def test_the_module_goes_where_debian_s_python_looks(self):
        for prefix, wanted in (("/usr", "lib/python3/dist-packages"), ("/usr/local", "lib/python3.*/dist-packages")):
            with tempfile.TemporaryDirectory() as stage:
                install(prefix, DESTDIR=stage)
                [found] = pathlib.Path(stage).rglob("_brash.*.so")
                self.assertRegex(str(found.parent), f"^{re.escape(stage + prefix)}/{wanted}/brash$")

    def test_the_completion_knows_every_command_and_option(self):
        """Each command's help against what the shell offers, all the way down."""
        script = "source share/bash-completion/completions/brash; COMP_WORDS=(brash {} ''); " \
                 "COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); [ -z '{}' ] || COMP_WORDS[COMP_CWORD]=-; _brash; " \
                 "printf '%s\\n' \"${{COMPREPLY[@]}}\""

        def offered(path, dash):
            return set(self.run_here("bash", "-c", script.format(" ".join(path), dash)).split())

        def check(path):
            text = self.run_here("bin/brash", *path, "--help")
            listed = {o for o in re.findall(r"^  (-\S+)", text, re.MULTILINE) for o in re.sub("{.*?}", "", o).split(",")}
            self.assertTrue(listed)
            self.assertEqual(offered(path, "-"), listed, path)
            commands = re.findall(r"^  ([a-z]+) +\S", text.partition("Subcommands:")[2], re.MULTILINE)
            if commands:
                self.assertLessEqual(set(commands), offered(path, ""))
            for command in commands:
                check([*path, command])

        check([])


if __name__ == "__main__":
    unittest.main()
