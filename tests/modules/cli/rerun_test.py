# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash rerun`: equal results on recorded runs; a changed input, model, program or result is named."""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
MODELS = SOURCE / "experiments/failure_database"
PYTHON = pathlib.Path(os.environ["BRASH_PYTHON"]) / "brash"


def brash(*arguments, cwd=None, **environment):
    return subprocess.run([BRASH, *map(str, arguments)], capture_output=True, text=True, cwd=cwd,
                          env={**os.environ, **environment})


class Rerun(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.case = self.path / "mine.toml"
        shutil.copy(SOURCE / "experiments/validation/cone.toml", self.case)

    def record(self, name, *options):
        done = brash("run", self.case, "--set", "time.duration=1.5", "-o", self.path / name, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.path / name / "manifest.json"

    def test_three_recorded_runs_repeat_byte_for_byte(self):
        runs = [self.record("a", "--set", "failure.model=network"),
                self.record("b", "--seed", 2, "--set", "failure.model=superposition", "--set", "structure.speed=1.5"),
                self.record("c", "--set", "ice.thickness='40 cm'", "--set", "failure.model=wedge", "--set", "time.step=0.02")]
        for manifest in runs:
            n_files = len(json.loads(manifest.read_text())["outputs"])
            done = brash("rerun", manifest)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(done.stdout.count("identical"), n_files)

    def test_a_changed_input_is_named_and_its_run_can_be_repeated_all_the_same(self):
        manifest = self.record("a", "--set", "failure.model=wedge")
        copy = manifest.parent / "inputs" / self.case.name
        copy.write_text(copy.read_text().replace("0.33 m", "0.43 m"))
        refused = brash("rerun", manifest)
        self.assertEqual((refused.returncode, refused.stdout), (2, ""))
        self.assertIn(f"input {copy}", refused.stderr)
        self.assertNotIn("model", refused.stderr.split("remedy")[0])
        again = brash("rerun", manifest, "--anyway", "-o", self.path / "again")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual((self.path / "again/run.nc").read_bytes(), (self.path / "a/run.nc").read_bytes())

    def test_a_copied_folder_reruns_without_what_the_run_was_given(self):
        model = self.path / "mine.json"
        shutil.copy(MODELS / "cone_network.json", model)
        manifest = self.record("a", "--set", "failure.model=network", "--set", f"failure.file={model}")
        elsewhere = self.path / "elsewhere"
        shutil.move(manifest.parent, elsewhere)
        model.unlink()
        self.case.unlink()
        done = brash("rerun", elsewhere / "manifest.json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertNotIn("DIFFERENT", done.stdout)

    def test_a_run_reruns_from_inside_its_folder(self):
        manifest = self.record("a", "--set", "failure.model=wedge")
        done = brash("rerun", manifest.name, cwd=manifest.parent)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def campaign(self, name):
        """The manifest of a campaign of two cases, all that it was given removed."""
        model = self.path / "mine.json"
        shutil.copy(MODELS / "cone_network.json", model)
        plan = self.path / "plan.toml"
        plan.write_text('[campaign]\ncase = "mine.toml"\nreplicates = 2\n[set]\ntime.duration = 1\n'
                        'failure.model = "network"\nfailure.file = "mine.json"\n[output]\nkeep = "history"\n')
        done = brash("campaign", plan, "-o", self.path / "c")
        self.assertEqual(done.returncode, 0, done.stderr)
        shutil.move(self.path / "c", self.path / name)
        for gone in (model, self.case, plan):
            gone.unlink()
        return self.path / name / "manifest.json"

    def test_what_has_changed_in_a_campaign_is_named_before_a_case_is_repeated(self):
        manifest = self.campaign("c")
        folder = manifest.parent
        case = folder / "cases/base-r0001"

        def named(what, n):
            done = brash("rerun", manifest)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(f"\n  {what}\n", done.stderr)
            self.assertEqual(done.stderr.count("\n    was "), n)

        for name, what in (("campaign.csv", "output"), ("summary.json", "output"), ("inputs/plan.toml", "input")):
            file, text = folder / name, (folder / name).read_text()
            file.write_text(text + "\n")
            named(f"{what} {file}", 1)
            file.write_text(text)
        case.rename(case.with_suffix(".part"))  # as one that is interrupted
        named(f"case {case.name}", 1)
        again = brash("rerun", manifest, "--anyway")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn(f"case {case.name}", again.stdout)
        self.assertIn("1 of 1 cases identical", again.stdout)
        (folder / "campaign.csv").unlink()
        named(f"output {folder / 'campaign.csv'}", 1)

    def test_a_copied_campaign_reruns_case_by_case(self):
        manifest = self.campaign("elsewhere")
        done = brash("rerun", manifest)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 of 2 cases identical", done.stdout)

    def test_a_campaign_with_a_setting_called_base_is_repeated(self):
        plan = self.path / "plan.toml"
        plan.write_text('[campaign]\ncase = "mine.toml"\n[set]\ntime.duration = 0.1\nfailure.model = "wedge"\n'
                        '[[grid]]\nlabels = ["base", "mu"]\nice.friction_ice = [0.3, 0.1]\n')
        self.assertEqual(brash("campaign", plan, "-o", self.path / "c").returncode, 0)
        done = brash("rerun", self.path / "c/manifest.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 of 2 cases identical", done.stdout)

    def test_a_run_resumes_with_its_own_model_only(self):
        model = self.path / "mine.json"
        shutil.copy(MODELS / "cone_network.json", model)
        options = ("--set", "failure.model=network", "--set", f"failure.file={model}",
                   "--set", "output.checkpoint_interval=0.1")
        self.record("a", *options)
        folder = self.path / "a"
        self.assertTrue((folder / "checkpoint.nc").exists())
        self.record("a", *options, "--resume")
        model.write_text(model.read_text() + "\n")
        refused = brash("run", self.case, "--set", "time.duration=1.5", "-o", folder, "--resume", *options)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("another failure model", refused.stderr)

    def models_behind(self, name, *options):
        """The inputs of a short run besides its case: name and hash."""
        inputs = json.loads(self.record(name, *options).read_text())["inputs"]
        self.assertEqual(pathlib.Path(inputs[0]["path"]), self.case)
        self.assertFalse(any("copy" in file for file in inputs[1:]))
        return {pathlib.Path(file["path"]).name: file["sha256"] for file in inputs[1:]}

    def test_every_model_behind_a_run_is_recorded(self):
        def shipped(*names):
            return {name: hashlib.sha256((MODELS / name).read_bytes()).hexdigest() for name in names}

        self.assertEqual(self.models_behind("a", "--set", "algorithm.preset=brash"),
                         shipped("cone_superposition.json", "cone_edge.json"))
        self.assertEqual(self.models_behind("b", "--set", "failure.model=superposition", "--set", "failure.order=radial-first"),
                         shipped("cone_superposition.json", "cone_superposition_split.json"))
        self.assertEqual(self.models_behind("c", "--set", "failure.model=wedge"), {})

    def test_another_model_of_a_moving_edge_is_named_and_ends_a_resumed_run(self):
        shipped = self.path / "shipped"
        shutil.copytree(MODELS, shipped)
        there = {"BRASH_MODEL_PATH": str(shipped)}
        run = ("run", self.case, "--set", "time.duration=0.5", "--set", "algorithm.preset=brash",
               "--set", "output.checkpoint_interval=0.1", "-o", self.path / "a")
        self.assertEqual(brash(*run, **there).returncode, 0)
        self.assertEqual(brash(*run, "--resume", **there).returncode, 0)
        edge = shipped / "cone_edge.json"
        edge.write_text(edge.read_text() + "\n")
        refused = brash(*run, "--resume", **there)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("another failure model", refused.stderr)
        refused = brash("rerun", self.path / "a/manifest.json", **there)
        self.assertEqual(refused.returncode, 2)
        self.assertIn(f"\n  model {edge}\n", refused.stderr)
        self.assertEqual(refused.stderr.count("\n    was "), 1)

    @unittest.skipUnless(PYTHON.is_dir() and not os.environ.get("BRASH_SANITIZE"), "there is no module that Python can load")
    def test_a_run_of_python_is_repeated_without_the_hash_of_its_module(self):
        run = ("import sys, brash\n"
               "case = brash.Case.from_file(sys.argv[1], {'time.duration': 1.5, 'failure.model': 'wedge'})\n"
               "case.run(sys.argv[2])\n")
        folder = self.path / "a"
        done = subprocess.run([sys.executable, "-B", "-c", run, self.case, folder], capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": str(PYTHON.parent)})
        self.assertEqual(done.returncode, 0, done.stderr)
        repeated = brash("rerun", folder / "manifest.json")
        self.assertEqual(repeated.returncode, 0, repeated.stderr)
        self.assertIn(f"note: Python made {folder / 'manifest.json'}", repeated.stderr)
        self.assertNotIn("DIFFERENT", repeated.stdout)
        self.assertIn("run.nc         identical", repeated.stdout)

    def test_a_finished_run_is_replaced_on_demand_only(self):
        manifest = self.record("a", "--set", "failure.model=wedge")
        refused = brash("run", self.case, "-o", manifest.parent)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("--replace", refused.stderr)
        self.record("a", "--set", "failure.model=wedge", "--replace")

    def test_a_finished_run_without_a_checkpoint_is_not_begun_anew_by_resume(self):
        folder = self.record("a", "--set", "failure.model=wedge").parent
        before = {file.name: file.read_bytes() for file in folder.iterdir() if file.is_file()}
        self.assertNotIn("checkpoint.nc", before)
        refused = brash("run", self.case, "--set", "ice.thickness=0.4", "-o", folder, "--resume")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("holds a finished run", refused.stderr)
        self.assertEqual({file.name: file.read_bytes() for file in folder.iterdir() if file.is_file()}, before)
        self.record("new", "--set", "failure.model=wedge", "--resume")  # nothing is there yet

    def test_no_command_writes_over_a_result(self):
        folder = self.record("a", "--set", "failure.model=wedge").parent
        (self.path / "sheet.wkt").write_text("POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))")
        (self.path / "events.csv").write_text("0,5,2,3\n")
        before = {file.name: file.read_bytes() for file in folder.iterdir() if file.is_file()}
        plan = SOURCE / "experiments/failure_database/plan.toml"
        for command in (("check", self.case, "--picture", folder / "plan.svg"),
                        ("crack", "--sheet", "sheet.wkt", "--events", "events.csv", "-o", folder / "summary.json"),
                        ("export", "map", folder / "run.nc", "-o", folder / "summary.json"),
                        ("report", folder, folder, "-o", folder / "summary.json"),
                        ("failure", "database", plan, "-o", folder / "run.nc"),
                        ("failure", "train", plan, "-o", folder / "summary.json")):
            with self.subTest(" ".join(map(str, command))):
                done = brash(*command, cwd=self.path)
                self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                self.assertIn("would be written over a result that manifest.json beside it lists", done.stderr)
        self.assertEqual({file.name: file.read_bytes() for file in folder.iterdir() if file.is_file()}, before)

    def test_no_run_takes_the_place_of_a_case_of_a_campaign(self):
        manifest = self.campaign("c")
        folder = manifest.parent
        case = folder / "cases/base-r0001"
        setting = folder / "settings/mine.toml"
        before = (case / "history.csv").read_bytes()
        for place in (case, folder / "cases/other", str(case) + "/"):
            done = brash("run", setting, "--set", "ice.thickness=0.4", "--replace", "-o", place)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("belongs to the cases of the campaign in", done.stderr)
            self.assertNotIn("--replace", done.stderr)
        self.assertEqual((case / "history.csv").read_bytes(), before)

    def test_a_case_that_is_not_of_its_setting_is_named(self):
        manifest = self.campaign("c")
        case = manifest.parent / "cases/base-r0001"
        setting = manifest.parent / "settings/mine.toml"

        def named(text, *options):
            foreign = self.path / "foreign"
            done = brash("run", setting, "-o", foreign, *options)
            self.assertEqual(done.returncode, 0, done.stderr)
            case.rename(self.path / "own")
            foreign.rename(case)
            refused = brash("rerun", manifest)
            self.assertEqual((refused.returncode, refused.stdout), (2, ""))
            self.assertIn(text, refused.stderr)
            self.assertEqual(refused.stderr.count("\n    was "), 1)
            case.rename(foreign)
            shutil.rmtree(foreign)
            (self.path / "own").rename(case)

        named("case base-r0001\n    was thickness = 0.33  # m\n    is  thickness = 0.4  # m\n",
              "--set", "ice.thickness=0.4", "--set", "random.replicate=1")
        named("case base-r0001\n    was replicate 0001\n    is  replicate 0000\n")
        other = setting.with_name("other.toml")
        shutil.copy(setting, other)
        setting, mine = other, setting
        named("case base-r0001\n    was mine\n    is  other\n", "--set", "random.replicate=1")

    def test_two_seeds_are_refused(self):
        refused = brash("run", self.case, "-o", self.path / "a", "--seed", 3, "--set", "random.seed = 4")
        self.assertEqual(refused.returncode, 2)
        for word in ("--seed", "random.seed", "allowed:", "remedy:"):
            self.assertIn(word, refused.stderr)

    def test_a_replaced_run_leaves_no_checkpoint_behind(self):
        often = ("--set", "output.checkpoint_interval=0.1", "--set", "failure.model=wedge")
        folder = self.record("a", *often).parent
        self.assertTrue((folder / "checkpoint.nc").exists())
        self.record("a", "--set", "failure.model=wedge", "--replace")
        self.assertFalse((folder / "checkpoint.nc").exists())

    def test_a_repeated_run_replaces_no_other_run(self):
        manifest = self.record("a", "--set", "failure.model=wedge")
        other = self.record("b", "--set", "failure.model=wedge", "--seed", 2)
        before = other.read_bytes()
        refused = brash("rerun", manifest, "-o", other.parent)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("holds a finished run", refused.stderr)
        self.assertEqual(other.read_bytes(), before)

    def test_a_changed_model_is_named(self):
        manifest = self.record("a")
        shutil.copy(MODELS / "cone_superposition.json", self.path / "cone_network.json")
        refused = brash("rerun", manifest, BRASH_MODEL_PATH=str(self.path))
        self.assertEqual(refused.returncode, 2)
        self.assertIn(f"model {self.path / 'cone_network.json'}", refused.stderr)

    def test_a_changed_model_of_the_case_is_named_and_nothing_else(self):
        model = self.path / "mine.json"
        shutil.copy(MODELS / "cone_network.json", model)
        manifest = self.record("a", "--set", "failure.model=network", "--set", f"failure.file={model}")
        recorded = hashlib.sha256(model.read_bytes()).hexdigest()
        copy = manifest.parent / "inputs/model/mine.json"
        copy.write_text(copy.read_text() + "\n")
        refused = brash("rerun", manifest)
        self.assertEqual((refused.returncode, refused.stdout), (2, ""))
        now = hashlib.sha256(copy.read_bytes()).hexdigest()
        self.assertIn(f"\n  input {copy}\n    was {recorded}\n    is  {now}\n", refused.stderr)
        self.assertEqual(refused.stderr.count("\n    was "), 1)
        copy.unlink()
        self.assertEqual(brash("rerun", manifest).returncode, 2)

    def test_a_changed_program_is_named(self):
        manifest = self.record("a", "--set", "failure.model=wedge")
        other = self.path / "brash"
        shutil.copy(BRASH, other)
        with open(other, "ab") as program:
            program.write(b"\0")
        refused = subprocess.run([other, "rerun", manifest], capture_output=True, text=True)
        self.assertEqual((refused.returncode, refused.stdout), (2, ""))
        self.assertIn("\n  program brash ", refused.stderr)
        self.assertEqual(refused.stderr.count("\n    was "), 1)
        again = subprocess.run([other, "rerun", manifest, "--anyway"], capture_output=True, text=True)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn("program brash", again.stdout)

    def test_a_changed_result_is_named_and_a_missing_one_is_made_again(self):
        manifest = self.record("a", "--set", "failure.model=wedge")
        (manifest.parent / "run.nc").unlink()
        self.assertEqual(brash("rerun", manifest).returncode, 0)
        history = manifest.parent / "history.csv"
        history.write_text(history.read_text().replace("0.5,", "0.6,", 1))
        refused = brash("rerun", manifest)
        self.assertEqual(refused.returncode, 2)
        self.assertIn(f"\n  output {history}\n", refused.stderr)
        self.assertEqual(refused.stderr.count("\n    was "), 1)

    def test_a_result_that_differs_is_named(self):
        manifest = self.record("a", "--set", "failure.model=wedge")
        m = json.loads(manifest.read_text())
        m["outputs"][0]["sha256"] = "0" * 64
        manifest.write_text(json.dumps(m))
        done = brash("rerun", manifest, "--anyway")
        self.assertEqual(done.returncode, 1)
        self.assertIn(m["outputs"][0]["path"], done.stderr)

    def test_what_is_no_manifest_is_refused(self):
        for text in ("", "{", "[]", "{}", '{"format": "brash-manifest-1"}', '{"format": 7}', '{"format": "other"}',
                     '{"format": "brash-manifest-1", "case": {"name": 1, "toml": []}}'):
            (self.path / "m.json").write_text(text)
            done = brash("rerun", self.path / "m.json")
            self.assertEqual(done.returncode, 2, text)
            self.assertIn("m.json", done.stderr)
        self.assertEqual(brash("rerun", self.path / "none.json").returncode, 2)
        self.assertEqual(brash("rerun", self.path).returncode, 2)


if __name__ == "__main__":
    unittest.main()
