# SPDX-License-Identifier: GPL-3.0-or-later
"""A simulation is stepped, looked at, run, written and read back."""
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import threading
import unittest

import numpy as np
import pandas as pd
import xarray as xr

import brash

CONE = pathlib.Path(os.environ["BRASH_SOURCE_DIR"]) / "experiments/validation/cone.toml"
# Its engine continues from a checkpoint to the bit.
EARLIER = CONE.parent / "second_reading.toml"
SHORT = {"time.duration": "2 s"}


class Steps(unittest.TestCase):
    def test_the_ledger_closes_and_floes_float_where_they_broke_off(self):
        simulation = brash.Simulation(brash.Case.from_file(CONE))
        births = {floe.record.id for floe in simulation.frame().floes}
        steps = simulation.step(150)
        births |= {floe.id for floe in steps.births}
        self.assertGreater(len(steps.events), 0)
        self.assertEqual(steps.loads.shape, (150,))
        self.assertAlmostEqual(steps.loads["time"][-1], simulation.time, places=12)
        frame = simulation.frame()
        self.assertAlmostEqual(frame.structure[0], -7 + 1.202 * simulation.time, places=9)
        self.assertLessEqual({floe.id for floe in frame.floes}, births)
        for floe in frame.floes:
            outline = floe.rings[0]
            self.assertEqual(outline.shape[1], 3)
            self.assertTrue(np.all(np.abs(outline) < 60), outline)
            self.assertAlmostEqual(np.linalg.norm(floe.rotation), 1, places=12)
        ledger = simulation.ledger
        self.assertEqual(ledger.pop("initial"), sum(ledger.values()))
        self.assertEqual(ledger["sheet"], sum(part.exact_area for part in simulation.sheet))

    def test_a_driven_structure_goes_where_it_is_told(self):
        simulation = brash.Simulation(brash.Case.from_file(CONE, {"structure.motion.kind": "driven"}))
        still = ([0, 0, 0], [0, 0, 0])
        place = lambda: np.append(simulation.frame().structure, simulation.frame().structure_rotation)
        simulation.step(pose=([-6.99, 0.01, 0], [np.cos(0.01), 0, 0, np.sin(0.01)]))
        np.testing.assert_allclose(place(), [-6.99, 0.01, 0, np.cos(0.01), 0, 0, np.sin(0.01)], atol=1e-14)
        simulation.step(10, twist=still)
        np.testing.assert_allclose(place()[:3], [-6.99, 0.01, 0], atol=1e-14)
        simulation.step(pose=([-6.98, 0, 0], [1, 0, 0, 0]), twist=still)
        np.testing.assert_allclose(place(), [-6.98, 0, 0, 1, 0, 0, 0], atol=1e-14)
        for wrong in ({"n": 2, "pose": ([0, 0, 0], [1, 0, 0, 0])}, {"pose": [0, 0, 0]}, {"twist": ([0, 0], [0, 0, 0])},
                      {"pose": ([0, 0, 0], [0, 0, 0, 0])}, {"pose": ([-6.0, 0, 0], [1, 0, 0, 0])}, {"twist": ([np.nan, 0, 0], [0, 0, 0])}):
            with self.assertRaises(brash.InputError):
                simulation.step(**wrong)
        with self.assertRaises(brash.InputError):
            brash.Simulation(brash.Case.from_file(CONE)).step(twist=still)

    def test_steps_are_those_of_a_run(self):
        case = brash.Case.from_file(CONE, SHORT)
        simulation = brash.Simulation(case)
        loads = np.concatenate([simulation.step(n).loads for n in (1, 0, 99, 100)])
        run = case.run()
        np.testing.assert_array_equal(loads, run.loads)
        self.assertEqual(run.results.n_frames, 31)
        self.assertEqual(run.results.frame(-1).time, run.results.frame(30).time)
        with self.assertRaises(IndexError):
            run.results.frame(31)
        self.assertEqual(len(run.events), run.summary["n_breaks"])

    def test_splits_of_steps_are_those_of_a_run(self):
        # Tests of the law have this weak sheet; it splits after 2.4 s.
        case = brash.Case.from_file(EARLIER, {
            "output.statistics_from": 0, "field.border": "free", "field.length": 40, "field.width": 60, "ice.fracture_toughness": 20e3,
            "failure.model": "wedge", "failure.pattern": "disc", "failure.judged": "centre-line",
            "failure.order": "circumferential-first", "failure.edge": "static", "failure.second_order": False,
            "failure.joint_loads": False, "time.duration": "2.5 s"})
        simulation = brash.Simulation(case)
        splits = np.concatenate([simulation.step(n).splits for n in (100, 150)])
        self.assertEqual(splits.shape, (1,))
        self.assertGreater(splits["stress_intensity"][0], 20e3)
        np.testing.assert_array_equal(splits, case.run().results.splits)

    def test_steps_before_ctrl_c_come_with_the_next_call(self):
        def interrupt(*_):
            raise KeyboardInterrupt

        before = signal.signal(signal.SIGALRM, interrupt)
        self.addCleanup(signal.signal, signal.SIGALRM, before)
        simulation = brash.Simulation(brash.Case.from_file(CONE))
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        with self.assertRaises(KeyboardInterrupt):
            simulation.step(1900)
        done = round(simulation.time / 0.01)
        self.assertGreater(done, 0)
        steps = simulation.step(3)
        np.testing.assert_allclose(steps.loads["time"], 0.01 * np.arange(1, done + 4), atol=1e-9)
        self.assertEqual(simulation.step(2).loads.shape, (2,))

    def test_a_simulation_is_one_thread_s_at_a_time(self):
        simulation = brash.Simulation(brash.Case.from_file(CONE))
        refused = []

        def step():
            try:
                for _ in range(20):
                    simulation.step(5)
            except RuntimeError as error:
                refused.append(str(error))

        threads = [threading.Thread(target=step) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(all("another thread" in text for text in refused), refused)
        simulation.step()

    def test_no_step_goes_beyond_the_last_row_of_a_path(self):
        path = [[0, -7, 0, 0], [0.105, -6.9, 0, 0]]
        text = re.sub(r"(?m)^(speed|start_distance) .*$", "", CONE.read_text())
        case = brash.Case.from_text(text, changes={"structure.motion.path": path, "time.duration": 0.105})
        simulation = brash.Simulation(case)
        with self.assertRaisesRegex(brash.InputError, r"0\.12 s, beyond the last row .* 0\.105 s"):
            simulation.step(12)
        self.assertEqual(simulation.time, 0)
        taken = len(case.run().loads)
        self.assertEqual(simulation.step(taken).loads.shape, (taken,))
        for n in (1, 2**63 - 1):
            with self.assertRaises(brash.InputError):
                simulation.step(n)
        self.assertEqual(simulation.step(0).loads.shape, (0,))

    def test_bad_counts_and_cases_are_refused(self):
        simulation = brash.Simulation(brash.Case.from_file(CONE))
        with self.assertRaises(brash.InputError):
            simulation.step(-1)
        with self.assertRaises(TypeError):
            simulation.step(1.5)
        with self.assertRaises(TypeError):
            brash.Simulation("cone.toml")


class Runs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        cls.run_ = brash.Case.from_file(CONE, SHORT).run(cls.path / "run")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_it_leaves_what_the_command_leaves_byte_for_byte(self):
        command = [os.environ["BRASH"], "run", CONE, "--set", "time.duration=2 s", "-o", self.path / "command"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        ours = sorted(p.name for p in (self.path / "run").iterdir())
        self.assertEqual(ours, sorted(p.name for p in (self.path / "command").iterdir()))
        for name in ("run.nc", "history.csv", "events.csv", "summary.json"):
            with self.subTest(name):
                self.assertEqual((self.path / "run" / name).read_bytes(), (self.path / "command" / name).read_bytes())

    def test_results_read_back_are_those_of_the_run(self):
        results = brash.read_results(self.path / "run/run.nc")
        np.testing.assert_array_equal(results.loads, self.run_.loads)
        np.testing.assert_array_equal(results.events, self.run_.events)
        self.assertEqual([f.id for f in results.floes], [f.id for f in self.run_.results.floes])

    def test_exports_are_those_of_the_command(self):
        ours, theirs = self.path / "exported", self.path / "by_the_command"
        ours.mkdir()
        shutil.copy(self.path / "run/run.nc", ours)
        for name, file in (("gltf", "run.glb"), ("vtk", "vtk/run.pvd")):
            with self.subTest(name):
                self.assertEqual(pathlib.Path(brash.export_run(ours, name)), ours / file)
                output = theirs / (file if name == "gltf" else name)
                subprocess.run([os.environ["BRASH"], "export", name, ours, "-o", output], check=True,
                               stdout=subprocess.DEVNULL)
        files = sorted(p.relative_to(theirs) for p in theirs.rglob("*") if p.is_file())
        self.assertGreater(len(files), 10)
        for file in files:
            self.assertEqual((ours / file).read_bytes(), (theirs / file).read_bytes(), file)
        with self.assertRaisesRegex(brash.InputError, "'obj' is no format(.|\n)*vtk, gltf"):
            brash.export_run(ours, "obj")
        with self.assertRaisesRegex(brash.InputError, "is not a name of a replay"):
            brash.export_run(ours, "gltf", ours / "run.txt")
        with self.assertRaisesRegex(brash.InputError, "output: is an empty name"):
            brash.export_run(ours, "gltf", "")

    def test_results_open_with_xarray_and_pandas_without_us(self):
        history = xr.open_dataset(self.path / "run/run.nc")
        np.testing.assert_array_equal(history["Fx"], self.run_.loads["Fx"])
        table = pd.read_csv(self.path / "run/history.csv", float_precision="round_trip")
        np.testing.assert_array_equal(table["Fx"], self.run_.loads["Fx"])
        loads = pd.DataFrame(self.run_.loads)
        self.assertEqual(list(table.columns), [name for name in loads.columns if name in table])
        self.assertFalse(loads.drop(columns=table.columns).any(axis=None))  # of a structure that turns or floats
        events = pd.read_csv(self.path / "run/events.csv", float_precision="round_trip")
        np.testing.assert_array_equal(events.dropna(subset=["l_break"])["l_break"], self.run_.events["l_break"])

    def test_a_case_without_a_file_leaves_one(self):
        case = brash.Case.from_text(brash.Case.from_file(CONE, {"time.duration": 0.1}).to_toml(), "mine")
        case.run(self.path / "mine")
        self.assertEqual(brash.Case.from_file(self.path / "mine/inputs/case.toml").to_toml(), case.to_toml())

    def test_ctrl_c_keeps_a_checkpoint_and_resume_completes(self):
        def interrupt(*_):
            raise KeyboardInterrupt

        case = brash.Case.from_file(EARLIER, {"time.duration": "6 s"})
        before = signal.signal(signal.SIGALRM, interrupt)
        self.addCleanup(signal.signal, signal.SIGALRM, before)
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        with self.assertRaises(KeyboardInterrupt):
            case.run(self.path / "stop")
        self.assertEqual([p.name for p in (self.path / "stop").iterdir()], ["checkpoint.nc"])
        with self.assertRaisesRegex(brash.InputError, "with other values"):
            brash.Case.from_file(EARLIER, {"time.duration": "7 s"}).run(self.path / "stop", resume=True)
        shutil.copytree(self.path / "stop", self.path / "begun anew")
        brash.Case.from_file(CONE, SHORT).run(self.path / "begun anew", replace=True)
        self.assertFalse((self.path / "begun anew/checkpoint.nc").exists())
        resumed = case.run(self.path / "stop", resume=True)
        np.testing.assert_array_equal(resumed.loads, case.run().loads)

    def test_a_finished_run_is_not_begun_anew_without_replace(self):
        case = brash.Case.from_file(CONE, {"time.duration": 0.1})
        case.run(self.path / "done")
        before = (self.path / "done/manifest.json").read_bytes()
        other = brash.Case.from_file(CONE, {"time.duration": 0.1, "ice.thickness": 0.4})
        for resume in (False, True):
            with self.assertRaisesRegex(brash.InputError, "holds a finished run"):
                other.run(self.path / "done", resume=resume)
        self.assertEqual((self.path / "done/manifest.json").read_bytes(), before)
        other.run(self.path / "done", replace=True)
        self.assertNotEqual((self.path / "done/manifest.json").read_bytes(), before)

    def test_a_campaign_leaves_a_row_for_each_case(self):
        plan = self.path / "plan.toml"
        plan.write_text(f'[campaign]\ncase = "{CONE}"\nreplicates = 2\n[set]\ntime.duration = 0.1\n')
        counts = brash.campaign(plan, self.path / "campaign", jobs=1)
        self.assertEqual(counts, {"n_cases": 2, "n_done": 2, "n_failed": 0, "n_missing": 0})
        self.assertEqual(len(pd.read_csv(self.path / "campaign/campaign.csv")), 2)
        with self.assertRaises(brash.InputError):
            brash.campaign(plan, self.path / "campaign", jobs=-1)
        with self.assertRaisesRegex(brash.InputError, "none.toml"):
            brash.campaign(self.path / "none.toml", self.path / "campaign")

    def test_bad_folders_and_files_are_refused(self):
        case = brash.Case.from_file(CONE, {"time.duration": 0.1})
        with self.assertRaises(brash.InputError):
            case.run(resume=True)
        with self.assertRaisesRegex(brash.InputError, "output: is an empty name"):
            case.run("")
        blocked = self.path / "blocked"
        blocked.write_text("a file")
        with self.assertRaisesRegex(brash.InputError, "blocked"):
            case.run(blocked)
        with self.assertRaises(TypeError):
            case.run(3)
        with self.assertRaisesRegex(brash.InputError, "blocked"):
            brash.read_results(blocked)


if __name__ == "__main__":
    unittest.main()
