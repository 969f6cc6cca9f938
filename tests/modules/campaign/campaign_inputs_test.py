# SPDX-License-Identifier: GPL-3.0-or-later
"""Models and meshes of a campaign: cases run from copies, and a file that has changed is refused."""
import hashlib
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
import broken_files  # noqa: E402

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
MODELS = SOURCE / "experiments/failure_database"
# A model that reads a file, and a run that may be shorter.
CASE = broken_files.CASE.replace('model = "wedge"', 'model = "network"').replace("statistics_from = 0.2", "statistics_from = 0.1")
PLAN = """
[campaign]
case = "cone.toml"
[[grid]]
labels = ["one", "other"]
failure.file = ["a/model.json", "b/model.json"]
[output]
keep = "history"
"""


def brash(*arguments, **options):
    return subprocess.run([BRASH, *map(str, arguments)], capture_output=True, text=True, **options)


def sha256(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def with_files_of_at_most(n_bytes):
    """Lets the system refuse larger files, as a full disk does."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (n_bytes, n_bytes))


class Inputs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.plan, self.out = self.path / "plan.toml", self.path / "out"
        self.plan.write_text(PLAN)
        (self.path / "cone.toml").write_text(CASE)
        self.models = [self.path / "a/model.json", self.path / "b/model.json"]
        for model in self.models:
            model.parent.mkdir()
            shutil.copy(MODELS / "cone_network.json", model)
        self.models[1].write_text(self.models[1].read_text() + "\n")

    def campaign(self, *options, code=0, **more):
        done = brash("campaign", self.plan, "-o", self.out, "--jobs", 2, *options, **more)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def manifest(self, case):
        return json.loads((self.out / "cases" / case / "manifest.json").read_text())

    def test_two_files_of_one_name_are_two_copies_that_the_settings_name(self):
        self.campaign()
        for model, label in zip(self.models, ("one", "other")):
            digest = sha256(model)
            name = f"inputs/model/model-{digest[:8]}.json"
            self.assertEqual(sha256(self.out / name), digest)
            self.assertIn(f'file = "../{name}"', (self.out / f"settings/cone_{label}.toml").read_text())
            read = self.manifest(f"{label}-r0000")["inputs"][1]
            self.assertEqual((read["sha256"], read["copy"]), (digest, name))
        self.assertEqual(len(list((self.out / "inputs/model").iterdir())), 2)

    def test_a_file_that_has_changed_is_another_setting(self):
        self.campaign()
        before = self.models[0].read_text()
        self.models[0].write_text(before + "\n\n")
        refused = self.campaign("--resume", "--replicates", 2, code=2)
        for word in ("settings/cone_one.toml", "allowed:", "remedy:"):
            self.assertIn(word, refused.stderr)
        self.assertEqual(len(list((self.out / "inputs/model").iterdir())), 2)
        self.models[0].write_text(before)
        self.campaign("--resume", "--replicates", 2)

    def test_a_setting_alone_gives_the_bytes_of_its_case_wherever_the_folder_lies(self):
        self.campaign()
        elsewhere = self.path / "elsewhere"
        shutil.move(self.out, elsewhere)
        for model in self.models:
            model.unlink()
        done = brash("run", elsewhere / "settings/cone_other.toml", "-o", self.path / "alone")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("summary.json", "history.csv"):
            self.assertEqual((self.path / "alone" / name).read_bytes(),
                             (elsewhere / "cases/other-r0000" / name).read_bytes())

    def test_the_manifest_has_the_options_and_every_input_with_its_hash(self):
        self.campaign("--replicates", 2, "--set", "time.duration=0.2")
        manifest = json.loads((self.out / "manifest.json").read_text())
        self.assertEqual(manifest["options"], {"set": ["time.duration=0.2"], "quick": False, "replicates": 2})
        copies = {str(path.relative_to(self.out)): sha256(path) for path in (self.out / "inputs").rglob("*.*")}
        self.assertEqual(len(copies), 4)
        self.assertEqual({file["copy"]: file["sha256"] for file in manifest["inputs"]}, copies)
        names = [f"inputs/model/model-{sha256(model)[:8]}.json" for model in self.models]
        self.assertEqual([(maker["inputs"], maker["n_cases"]) for maker in manifest["cases_made_by"]],
                         [([{"name": name, "sha256": copies[name]}], 2) for name in names])

    def test_a_text_of_the_grid_is_no_variable_of_the_netcdf_table(self):
        import netCDF4
        self.campaign()
        with netCDF4.Dataset(self.out / "campaign.nc") as table:
            self.assertNotIn("failure.file", table.variables)
            self.assertIn("horizontal.mean", table.variables)

    def test_an_interrupted_case_begins_again_when_the_program_has_another_model_now(self):
        self.plan.write_text('[campaign]\ncase = "cone.toml"\n[set]\noutput.checkpoint_interval = 0.1\n'
                             '[output]\nkeep = "history"\n')
        shipped = self.path / "shipped"
        shipped.mkdir()
        model = shipped / "cone_network.json"
        shutil.copy(MODELS / model.name, model)
        there = {**os.environ, "BRASH_MODEL_PATH": str(shipped)}
        self.campaign(env=there)
        # The checkpoint of a run of this case is that of the interrupted case.
        alone = brash("run", self.out / "settings/cone.toml", "-o", self.path / "alone", env=there)
        self.assertEqual(alone.returncode, 0, alone.stderr)
        case = self.out / "cases/base-r0000"
        before = (case / "history.csv").read_bytes()
        case.rename(case.with_suffix(".part"))
        for file in case.with_suffix(".part").iterdir():
            file.unlink()
        shutil.copy(self.path / "alone/checkpoint.nc", case.with_suffix(".part"))
        model.write_text(model.read_text() + "\n")
        self.campaign("--resume", env=there)
        self.assertFalse(case.with_suffix(".failed").exists())
        self.assertEqual((case / "history.csv").read_bytes(), before)
        self.assertEqual(self.manifest("base-r0000")["inputs"][1]["sha256"], sha256(model))

    def test_a_copy_that_has_changed_is_named_before_a_case_is_repeated(self):
        self.campaign()
        for model in self.models:
            model.unlink()
        again = brash("rerun", self.out / "manifest.json")
        self.assertEqual(again.returncode, 0, again.stderr)
        copy = self.out / self.manifest("one-r0000")["inputs"][1]["copy"]
        copy.write_text(copy.read_text() + "\n\n")
        refused = brash("rerun", self.out / "cases/one-r0000/manifest.json")
        self.assertEqual((refused.returncode, refused.stdout), (2, ""))
        self.assertIn(f"input {copy}", refused.stderr)
        self.assertEqual(refused.stderr.count("\n    was "), 1)

    def test_a_case_in_a_folder_of_settings_names_nothing_but_the_copies(self):
        settings = self.path / "settings"
        settings.mkdir()
        (settings / "case.toml").write_text(CASE.replace('"network"', '"network"\nfile = "../a/model.json"'))
        refused = brash("run", settings / "case.toml", "-o", self.out)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("leads out of the folder", refused.stderr)

    def test_a_plan_and_a_case_of_one_name_are_two_copies(self):
        (self.path / "c").mkdir()
        (self.path / "c/plan.toml").write_text(CASE)
        self.plan.write_text('[campaign]\ncase = "c/plan.toml"\n')
        self.campaign()
        digests = {sha256(path) for path in (self.out / "inputs").iterdir()}
        self.assertEqual(digests, {sha256(self.plan), sha256(self.path / "c/plan.toml")})

    def test_a_campaign_begins_again_after_its_copies_found_no_space(self):
        shutil.copy(MODELS / "cone_deep-network.json", self.models[0])
        self.plan.write_text('[campaign]\ncase = "cone.toml"\n[set]\nfailure.model = "deep-network"\n'
                             'failure.file = "a/model.json"\n')
        full = self.campaign(code=1, preexec_fn=lambda: with_files_of_at_most(16384))
        self.assertIn("cannot be written", full.stderr)
        self.campaign()


if __name__ == "__main__":
    unittest.main()
