# SPDX-License-Identifier: GPL-3.0-or-later
"""The Debian packages in a bare Debian 12: package_test.py FOLDER_OF_PACKAGES

Makes a Debian of debootstrap's smallest kind in a temporary folder, with the dependencies that the package names and no
other. There it installs the package, runs the example and the Python module, removes the package, and compares the list of
files with the list from before. At the end it builds a C++ program with libbrash-dev. Needs root and
debootstrap; exit code 77 where one is missing. `./dev package --check` calls it.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import debian

FOLDER = pathlib.Path(sys.argv[1]).resolve()
# What apt and dpkg write for themselves, and what is no file of the system.
NOT_COMPARED = ("proc", "sys", "dev", "tmp", "run", "var/cache", "var/log", "var/lib/apt", "var/lib/dpkg")


def fields(package):
    text = subprocess.run(["dpkg-deb", "-f", package], check=True, capture_output=True, text=True).stdout
    return dict(line.split(": ", 1) for line in text.splitlines() if re.match(r"[A-Z]", line))


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        [cls.package] = FOLDER.glob("brash_*.deb")
        folder = tempfile.mkdtemp(prefix="brash-debian-")
        cls.addClassCleanup(debian.remove, folder)
        cls.root = debian.Debian(folder, "12")
        (cls.root.path / "packages").mkdir()
        shutil.copy(cls.package, cls.root.path / "packages")
        cls.root("apt-get update -q")
        cls.root(f"apt-get satisfy -y -q --no-install-recommends '{fields(cls.package)['Depends']}'")
        cls.before = cls.files()
        cls.root(f"apt-get install -y -q --no-install-recommends /packages/{cls.package.name}")

    @classmethod
    def files(cls):
        return {name for name in cls.root.files() if not name.startswith(NOT_COMPARED)}

    def test_1_what_is_installed_is_what_the_package_lists(self):
        here = {name for name in self.files() - self.before if "__pycache__" not in name}
        listed = {line.lstrip("/") for line in self.root("dpkg -L brash").splitlines()}
        self.assertEqual(here - listed, set())
        self.assertLessEqual({"usr/bin/brash", "usr/share/brash/case.schema.json", "usr/share/man/man1/brash.1.gz",
                              "usr/share/bash-completion/completions/brash", "usr/share/doc/brash/copyright",
                              "usr/share/brash/models/cone_superposition.json"}, here)

    def test_2_the_example_runs_and_writes_its_report(self):
        said = self.root("cd /tmp && brash run /usr/share/brash/examples/validation/cone.toml --set time.duration=2 "
                         "--set output.statistics_from=0.5 -o run && brash rerun run/manifest.json && ls run")
        for name in ("report.html", "run.nc", "summary.json", "manifest.json"):
            self.assertIn(name, said.splitlines())
        self.assertGreater((self.root.path / "tmp/run/report.html").stat().st_size, 500_000)

    def test_3_the_module_is_imported_and_solves(self):
        said = self.root("cd /tmp && python3 -c 'import brash; print(brash.__version__); "
                         "print(brash.FailureModel(\"superposition\")(b_lc=[0.5], c_lc=0.3, theta=1.05, mu1=0.5, mu2=0.0).lbreak_over_lc)'")
        self.assertEqual(said.splitlines()[0], fields(self.package)["Version"].split("-")[0])

    def test_4_nothing_is_left_when_it_is_removed(self):
        self.root("apt-get purge -y -q brash")
        self.assertEqual(sorted(self.files() ^ self.before), [])

    def test_5_a_program_of_others_is_built_with_libbrash_dev(self):
        [development] = FOLDER.glob("libbrash-dev_*.deb")
        shutil.copy(development, self.root.path / "packages")
        shutil.copytree(pathlib.Path(__file__).parent / "consumer", self.root.path / "tmp/consumer")
        self.root("apt-get install -y -q --no-install-recommends g++ cmake make "
                  f"/packages/{development.name} /packages/{self.package.name}")
        self.root("cmake -S /tmp/consumer -B /tmp/built && cmake --build /tmp/built")
        self.assertEqual(self.root("BRASH_MODEL_PATH=/usr/share/brash/models /tmp/built/consumer"), "4 pieces, breaks: 1\n")


if __name__ == "__main__":
    if missing := debian.missing():
        print(f"not checked: needs {missing}", file=sys.stderr)
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=2)
