# SPDX-License-Identifier: GPL-3.0-or-later
"""A run that is no physics ends, says where, leaves what repeats it, and nothing that looks like a result.

Here the fault is put into the state that a run goes on from; tests/modules/simulation/watchdog.cpp puts each fault that a
watchdog looks for before it.
"""
import json
import os
import re
import signal
import subprocess
import unittest

from program import BRASH, FaultTest, call, campaign_command, run_command, start, wait_for

FAULTS = {"place": "floe 2 is at (", "speed": "is not finite", "ledger": "the ledger does not fit the floes: they lack"}
# A sheet that floats freely meets a wall and rebounds whole: few sweeps leave it too fast, and a shorter step does not help.
BLOW = """
algorithm.preset = "paper"
[ice]
thickness = 7
youngs_modulus = "0.35 GPa"
flexural_strength = "163 kPa"
compressive_strength = "261 kPa"
[structure]
kind = "plane"
breaking = "downward"
angle = "90 deg"
waterline_width = 37
height = 20
height_under_water = 10
length = 10
start_distance = 5.5
speed = 1
motion.frame = "ice-drifts-through-still-water"
[field]
length = 80
width = 158
border = "free"
initial_crack = false
[failure]
model = "wedge"
[contact]
restitution = 1
iterations = 10
area = "surface"
[time]
step = 0.02
duration = 1
"""


def spoil(checkpoint, fault):
    subprocess.run([os.environ["BRASH_SPOIL_CHECKPOINT"], checkpoint, fault], check=True)


class Watchdog(FaultTest):
    def test_a_run_with_a_fault_leaves_its_state_before_the_step_and_no_result(self):
        for fault, words in FAULTS.items():
            folder = self.path / fault
            process = start(run_command(folder, "--set", "time.duration=100"))
            self.assertTrue(wait_for((folder / "checkpoint.nc").exists, process))
            process.send_signal(signal.SIGINT)
            process.communicate()
            spoil(folder / "checkpoint.nc", fault)
            spoilt = (folder / "checkpoint.nc").read_bytes()
            (folder / "summary.json").write_text("{}")  # of an earlier run
            for _ in range(2):
                done = call(run_command(folder, "--set", "time.duration=100", "--resume"))
                self.fails_clearly(done, {1}, words, "brash: step ", " failed, from t = ", str(folder / "checkpoint.nc"))
                self.assertEqual(sorted(p.name for p in folder.iterdir()), ["checkpoint.nc", "summary.json"])
                self.assertEqual((folder / "summary.json").read_text(), "{}")
                self.assertEqual((folder / "checkpoint.nc").read_bytes(), spoilt)

    def test_a_fault_that_takes_some_steps_leaves_the_state_just_before_it(self):
        folder = self.path / "later"
        process = start(run_command(folder, "--set", "time.duration=100"))
        self.assertTrue(wait_for((folder / "checkpoint.nc").exists, process))
        process.send_signal(signal.SIGINT)
        process.communicate()
        spoil(folder / "checkpoint.nc", "later")
        resume = run_command(folder, "--set", "time.duration=100", "--resume")
        spoilt = (folder / "checkpoint.nc").read_bytes()
        errors, states = [], []
        for _ in range(2):
            done = call(resume)
            self.fails_clearly(done, {1}, "floe 2 is at (", "brash: step ", str(folder / "checkpoint.nc"))
            errors.append(done.stderr)
            states.append((folder / "checkpoint.nc").read_bytes())
        self.assertNotEqual(states[0], spoilt)
        self.assertEqual(states[0], states[1])
        self.assertEqual(errors[0], errors[1])

    def test_the_remedy_of_contacts_that_give_energy_helps(self):
        case = self.path / "blow.toml"
        case.write_text(BLOW)
        command = [BRASH, "run", str(case), "--set", "output.statistics_from=0", "-o", str(self.path / "blow")]
        done, remedy = call(command), []
        self.fails_clearly(done, {1}, "contacts gave the floes ", "remedy:  ")
        for _ in range(3):
            if done.returncode == 1:
                remedy = re.findall(r"--set (time\.step=\S+|contact\.iterations=\S+)", done.stderr)
                done = call([*command, "--replace", *(word for key in remedy for word in ("--set", key))])
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("contact.iterations=40", remedy)

    def test_a_case_of_a_campaign_with_a_fault_is_recorded_with_its_state(self):
        folder = self.path / "campaign"
        process = start(campaign_command(folder))
        self.assertTrue(wait_for(lambda: list(folder.glob("cases/*.part/lock")), process))
        process.send_signal(signal.SIGINT)
        process.communicate()
        checkpoints = sorted(folder.glob("cases/*.part/checkpoint.nc"))
        self.assertTrue(checkpoints)
        spoil(checkpoints[0], "place")
        spoilt = checkpoints[0].read_bytes()
        case = folder / "cases" / checkpoints[0].parent.name.removesuffix(".part")
        done = call(campaign_command(folder, "--resume"))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("1 cases failed", done.stderr)
        record = json.loads(case.with_name(case.name + ".failed").read_text())
        state = case.with_name(case.name + ".failed.nc")
        self.assertIn("floe 2 is at (", record["error"])
        self.assertIn(str(state), record["error"])
        self.assertEqual(state.read_bytes(), spoilt)
        self.assertFalse(case.exists() or case.with_name(case.name + ".part").exists())


if __name__ == "__main__":
    unittest.main()
