# SPDX-License-Identifier: GPL-3.0-or-later
"""No shell reads what comes from input, no path in a file leads out of its folder, pictures show text as text, and what is
created has the modes that the user's umask leaves."""
import json
import os
import pathlib
import shutil
import stat
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

from broken_files import CASE, DATABASE_PLAN

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
#: What a shell, or a careless one behind it, would run or fall over. Each would leave a file whose name has "owned".
NAMES = ["$(touch owned1)", "`touch owned2`", "a; touch owned3;", "a' 'b \"c", "a\ntouch owned4\n", "-o owned5", "a && touch owned6",
         "*", "${IFS}x", "a|tee owned7", "%A%j", "\\", "~", "<script>alert(1)<", "ä 氷"]
QUICK_CASE = CASE.replace("duration = 0.6", "duration = 0.05").replace("statistics_from = 0.2", "statistics_from = 0")

#: Stands for sbatch: keeps its words, ends each with a NUL, and says a number.
FAKE_SBATCH = '#!/bin/sh\nn=$(ls "$FAKE" | wc -l)\nprintf "%s\\0" "$@" > "$FAKE/$n"\necho $((100 + n))\n'


def brash(*words, cwd, umask=-1, code=0, **environment):
    done = subprocess.run([BRASH, *map(str, words)], cwd=cwd, umask=umask, capture_output=True, text=True,
                          env={**os.environ, **environment})
    assert done.returncode == code, f"{words}: {done.returncode}\n{done.stderr}"
    return done


class Scratch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.path = pathlib.Path(scratch.name).resolve()

    def assert_nothing_ran(self):
        self.assertEqual([str(p) for p in self.path.rglob("owned*")], [])


class NoShell(Scratch):
    def test_hostile_names_of_cases_and_folders_are_only_names_to_run_and_campaign(self):
        for i, name in enumerate(NAMES):
            with self.subTest(name):
                case = self.path / f"{i}" / f"{name}.toml"
                case.parent.mkdir()
                case.write_text(QUICK_CASE)
                plan = self.path / f"{i}" / "plan.toml"
                plan.write_text(f"[campaign]\ncase = {json.dumps(case.name)}\nreplicates = 2\n")
                out = self.path / f"{i}" / f"{name} out"
                brash("campaign", plan, "-o", out, "--jobs", "2", cwd=self.path)
                self.assertEqual(len(list((out / "cases").glob("base-r000?/summary.json"))), 2)
                self.assertEqual(json.loads((out / "summary.json").read_text())["settings"][0]["case"], name)
                self.assert_nothing_ran()
        run = self.path / NAMES[0]
        brash("run", self.path / "0" / f"{NAMES[0]}.toml", "-o", run, cwd=self.path)
        brash("rerun", run / "manifest.json", cwd=self.path)
        self.assert_nothing_ran()

    def test_slurm_gets_each_word_as_it_is_and_a_script_without_any_of_them(self):
        fake = self.path / "bin"
        fake.mkdir()
        for command, text in (("sbatch", FAKE_SBATCH), ("squeue", "#!/bin/sh\n")):
            (fake / command).write_text(text)
            (fake / command).chmod(0o755)
        (self.path / "case.toml").write_text(QUICK_CASE)
        plan = self.path / "plan $(touch owned) ';.toml"
        plan.write_text("[campaign]\ncase = \"case.toml\"\n")
        for i, name in enumerate(NAMES):
            with self.subTest(name):
                seen = self.path / f"seen{i}"
                seen.mkdir()
                out = self.path / f"{i} {name}"
                environment = {"PATH": f"{fake}:{os.environ['PATH']}", "FAKE": str(seen)}
                brash("campaign", plan, "-o", out, "--on", "slurm", cwd=self.path, **environment)
                array, collector = ((seen / n).read_bytes().decode().split("\0")[:-1] for n in ("0", "1"))
                script = out / "slurm/exec.sh"
                self.assertEqual(script.read_text(), '#!/bin/sh\nexec "$@"\n')
                words = array[array.index(str(script)) + 1:]
                self.assertEqual(words[1:], ["campaign-chunk", str(out / "slurm/round-1.json")])
                self.assertIn(str(out), collector)
                self.assertIn(str(plan), collector)
                # As Slurm would start it: by a shell that knows nothing but the script and the words.
                subprocess.run(["/bin/sh", str(script), *words], check=True, cwd=self.path,
                               env={**os.environ, "SLURM_ARRAY_TASK_ID": "0"})
                self.assertTrue((out / "cases/base-r0000/summary.json").exists())
                self.assert_nothing_ran()


class PathsInFiles(Scratch):
    """failure.file stays in the folder of the file that names it; see tests/corpus/bad for what is refused."""

    def setUp(self):
        super().setUp()
        for place in (self.path, self.path / "cases/models"):
            place.mkdir(parents=True, exist_ok=True)
            shutil.copy(SOURCE / "experiments/failure_database/cone_network.json", place / "model.json")

    def case(self, file):
        path = self.path / "cases/case.toml"
        path.write_text(QUICK_CASE.replace('model = "wedge"', f'model = "network"\nfile = "{file}"'))
        return path

    def test_a_model_beside_the_case_is_taken(self):
        for file in ("models/model.json", "./models/../models/model.json", self.path / "cases/models/model.json"):
            brash("run", self.case(file), "-o", "out", "--replace", cwd=self.path)

    def test_a_model_elsewhere_is_taken_when_the_command_line_says_so(self):
        for file in ("../model.json", self.path / "model.json", "models/../../model.json"):
            refused = brash("run", self.case(file), "-o", "out", cwd=self.path, code=2)
            self.assertIn("failure.file", refused.stderr)
            self.assertIn("leads out of the folder", refused.stderr)
            self.assertIn("--set failure.file=PATH", refused.stderr)
        self.assertFalse((self.path / "out").exists())
        case = self.case("models/model.json")
        brash("run", case, "-o", "out", "--set", "failure.file=model.json", cwd=self.path)
        self.assertEqual(json.loads((self.path / "out/manifest.json").read_text())["inputs"][1]["path"],
                         str(self.path / "model.json"))
        brash("rerun", "out/manifest.json", cwd=self.path)

    def test_a_campaign_hands_the_model_of_its_case_on(self):
        self.case("models/model.json")
        (self.path / "plan.toml").write_text('[campaign]\ncase = "cases/case.toml"\n')
        brash("campaign", "plan.toml", "-o", "out", "--jobs", "1", cwd=self.path)

    def test_nothing_that_a_manifest_says_is_written_outside_the_output_folder(self):
        brash("run", self.case("models/model.json"), "-o", "out", cwd=self.path)
        manifest = json.loads((self.path / "out/manifest.json").read_text())
        for name in ("../escaped", str(self.path / "escaped"), "..", ""):
            manifest["case"]["name"] = name
            (self.path / "out/manifest.json").write_text(json.dumps(manifest))
            brash("rerun", "out/manifest.json", "-o", "again/there", "--anyway", cwd=self.path, code=2)
        self.assertEqual(list(self.path.rglob("*escaped*")), [])
        self.assertFalse((self.path / "again").exists())


class Pictures(Scratch):
    def test_the_picture_of_a_comparison_shows_the_names_of_columns_as_text(self):
        name = "<script>alert(1)</script>&\"'<image onload='alert(2)'/>"
        rows = "".join(f"{0.1 * i:.1f};{i % 7}\n" for i in range(60))
        (self.path / "history.csv").write_text(f"time;{name}\n{rows}")
        brash("compare", "history.csv", "history.csv", "--column", name, "-o", "picture.svg", cwd=self.path)
        picture = xml.etree.ElementTree.parse(self.path / "picture.svg")
        tags = {element.tag.rpartition("}")[2] for element in picture.iter()}
        self.assertEqual(tags & {"script", "image", "foreignObject"}, set())
        self.assertTrue(any("<script>alert(1)</script>" in (element.text or "") for element in picture.iter()))

    def test_the_list_of_files_for_paraview_is_well_formed_whatever_the_case_is_called(self):
        case = self.path / "<a & \"b'>.toml"
        case.write_text(QUICK_CASE)
        brash("run", case, "-o", "out", cwd=self.path)
        brash("export", "vtk", "out/run.nc", "-o", "vtk <&>", cwd=self.path)
        xml.etree.ElementTree.parse(self.path / "vtk <&>/run.pvd")


class Modes(Scratch):
    def test_what_is_created_has_the_modes_that_the_umask_leaves(self):
        for umask in (0o077, 0o022, 0o002):
            folder = self.path / f"{umask:o}"
            folder.mkdir()
            (folder / "case.toml").write_text(QUICK_CASE)
            (folder / "plan.toml").write_text('[campaign]\ncase = "case.toml"\n[output]\nkeep = "run"\n')
            (folder / "database.toml").write_text(DATABASE_PLAN)
            (folder / "sheet.wkt").write_text("POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))\n")
            (folder / "events.csv").write_text("0,5,2,3\n")
            (folder / "history.csv").write_text("".join(f"{0.1 * i:.1f},{i % 7}\n" for i in range(200)))
            given = set(folder.iterdir())
            for command in ("run case.toml -o run --set output.checkpoint_interval=0.02", "campaign plan.toml -o campaign --jobs 1",
                            "failure database database.toml -o database.nc", "crack --sheet sheet.wkt --events events.csv -o a/pieces.geojson",
                            "stats history.csv --spectrum b/spectrum.csv", "compare history.csv history.csv --column 2 -o c/picture.svg",
                            "export vtk run/run.nc", "export gltf run/run.nc", "export fmu case.toml -o d/case.fmu",
                            "rerun run/manifest.json -o again"):
                brash(*command.split(), cwd=folder, umask=umask)
            made = [p for p in folder.rglob("*") if p not in given]
            self.assertGreater(len(made), 40)
            for path in made:
                wanted = (0o777 if path.is_dir() else 0o666) & ~umask
                self.assertEqual(f"{stat.S_IMODE(path.stat().st_mode):o}", f"{wanted:o}", path)


if __name__ == "__main__":
    unittest.main()
