# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash export openfast`: both files are read as OpenFAST reads them, by the order of the lines that it expects."""
import csv
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import numpy as np

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])

# The lines of a structural control's input of OpenFAST 5, in order; None: a heading.
LINES = (
    None, None, None, "Echo", None, "StC_DOF_MODE", "StC_X_DOF", "StC_Y_DOF", "StC_Z_DOF",
    None, "StC_P_X", "StC_P_Y", "StC_P_Z", None, "StC_X_DSP", "StC_Y_DSP", "StC_Z_DSP", "StC_Z_PreLd",
    None, "StC_X_PSP", "StC_X_NSP", "StC_Y_PSP", "StC_Y_NSP", "StC_Z_PSP", "StC_Z_NSP",
    None, "StC_X_M", "StC_Y_M", "StC_Z_M", "StC_Omni_M", "StC_X_K", "StC_Y_K", "StC_Z_K", "StC_X_C", "StC_Y_C", "StC_Z_C",
    "StC_X_KS", "StC_Y_KS", "StC_Z_KS", "StC_X_CS", "StC_Y_CS", "StC_Z_CS",
    None, "Use_F_TBL", "NKInpSt", None, None, None, None, None,
    None, "StC_CMODE", "StC_CChan", "StC_SA_MODE", "StC_X_C_HIGH", "StC_X_C_LOW", "StC_Y_C_HIGH", "StC_Y_C_LOW",
    "StC_Z_C_HIGH", "StC_Z_C_LOW", "StC_X_C_BRAKE", "StC_Y_C_BRAKE", "StC_Z_C_BRAKE",
    None, "L_X", "B_X", "area_X", "area_ratio_X", "headLossCoeff_X", "rho_X",
    "L_Y", "B_Y", "area_Y", "area_ratio_Y", "headLossCoeff_Y", "rho_Y",
    None, "PrescribedForcesCoordSys", "PrescribedForcesFile", None)


def read_control(path, names=LINES):
    lines = path.read_text(encoding="ascii").splitlines()
    assert len(lines) == len(names), len(lines)
    values = {}
    for text, name in zip(lines, names):
        if name is None:
            continue
        value, found = text.split()[:2]
        assert found == name, text
        values[name] = value
    return values


# The lines of ServoDyn's section on structural control, in the order of its reader, and those of the main file from the
# run's time on: 4, and 5 with four more. Each has its value first.
SERVODYN = ("NumBStC", "BStCfiles", "NumNStC", "NStCfiles", "NumTStC", "TStCfiles", "NumSStC", "SStCfiles")
MAIN = {4: ("TMax", "DT", "InterpOrder", "NumCrctn", "DT_UJac"),
        5: ("TMax", "DT", "ModCoupling", "InterpOrder", "NumCrctn", "RhoInf", "ConvTol", "MaxConvIter", "DT_UJac")}


def changes_on_page():
    """For each diff of the tutorial its pairs (name, before, after)."""
    page = (SOURCE / "docs/tutorials/wind.md").read_text(encoding="utf-8")
    result = []
    for block in re.findall(r"^```diff\n(.*?)^```$", page, re.MULTILINE | re.DOTALL):
        lines = [(line[0], *line[1:].split()) for line in block.splitlines()]
        olds, news = lines[0::2], lines[1::2]
        assert [line[0] for line in lines] == ["-", "+"] * len(olds), block
        assert [old[2] for old in olds] == [new[2] for new in news], block
        result.append([(old[2], old[1], new[1]) for old, new in zip(olds, news)])
    return page, result


def read_forces(path):
    return np.loadtxt(path, comments=["#", "!", "%"])


class OpenFast(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        subprocess.run([BRASH, "run", SOURCE / "experiments/validation/cone.toml", "--set", "time.duration=1.5", "-o",
                        cls.folder / "run"], check=True, capture_output=True)
        with open(cls.folder / "run/history.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        cls.history = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def export(self, *options, code=0):
        done = subprocess.run([BRASH, "export", "openfast", self.folder / "run/run.nc", *options], check=False,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stdout + done.stderr

    def test_the_forces_are_those_of_the_history(self):
        self.export()
        table = read_forces(self.folder / "run/openfast/ice_forces.dat")
        names = ("time", "Fx", "Fy", "Fz", "Mx", "My", "Mz")
        self.assertEqual(table.shape, (151, 7))
        for column, name in zip(table[:-1].T, names):
            np.testing.assert_allclose(column, self.history[name], rtol=1e-8, atol=1e-6)
        self.assertGreater(table[:, 1].max(), 1e4)  # pushes the structure back, as the ice drifts

    def test_moments_are_about_the_point_and_time_starts_where_it_is_told(self):
        self.export("-o", self.folder / "moved", "--point", "0,1.5,-4", "--from", "0.5")
        table = read_forces(self.folder / "moved/ice_forces.dat")[:-1]
        late = self.history["time"] >= 0.5
        np.testing.assert_allclose(table[:, 0], self.history["time"][late] - 0.5, atol=1e-6)
        force = np.stack([self.history[name][late] for name in ("Fx", "Fy", "Fz")], axis=1)
        moment = np.stack([self.history[name][late] for name in ("Mx", "My", "Mz")], axis=1)
        np.testing.assert_allclose(table[:, 4:], moment - np.cross([0, 1.5, -4], force), rtol=1e-7, atol=1e-2)
        control = read_control(self.folder / "moved/ice_StC.dat")
        self.assertEqual([float(control[f"StC_P_{axis}"]) for axis in "XYZ"], [0, 1.5, -4])

    def test_the_control_applies_that_file_in_global_coordinates(self):
        self.export("-o", self.folder / "plain")
        control = read_control(self.folder / "plain/ice_StC.dat")
        self.assertEqual(control["StC_DOF_MODE"], "6")
        self.assertEqual(control["PrescribedForcesCoordSys"], "1")
        self.assertEqual(control["PrescribedForcesFile"], '"ice_forces.dat"')
        self.assertEqual(control["NKInpSt"], "2")

    def test_the_load_ends_with_the_run_and_the_output_states_the_time(self):
        said = self.export("-o", self.folder / "end", "--from", "0.5")
        table = read_forces(self.folder / "end/ice_forces.dat")
        np.testing.assert_allclose(table[-1], [1.01] + 6 * [0.0], atol=1e-9)
        self.assertIn("TMax of OpenFAST: at most 1 s", said)

    def test_a_ramp_grows_from_zero_to_the_load(self):
        self.export("-o", self.folder / "ramp", "--point", "0,1.5,-4", "--from", "0.5", "--ramp", "0.4")
        self.export("-o", self.folder / "jump", "--point", "0,1.5,-4", "--from", "0.5")
        ramp, jump = (read_forces(self.folder / name / "ice_forces.dat") for name in ("ramp", "jump"))
        share = np.minimum(jump[:, 0] / 0.4, 1.0)
        np.testing.assert_allclose(ramp[:, 1:], share[:, None] * jump[:, 1:], rtol=1e-7, atol=1e-6)
        self.assertIn("less than the 1 s of load", self.export("--from", "0.5", "--ramp", "1", code=2))

    def test_an_older_version_numbers_the_mode_and_names_a_mass_differently(self):
        self.export("-o", self.folder / "old", "--openfast", "4")
        names = ["StC_XY_M" if name == "StC_Omni_M" else name for name in LINES]
        self.assertEqual(read_control(self.folder / "old/ice_StC.dat", names)["StC_DOF_MODE"], "4")

    def test_the_point_counts_from_the_reference_of_the_component(self):
        for version in (4, 5):
            names = LINES if version == 5 else ["StC_XY_M" if name == "StC_Omni_M" else name for name in LINES]
            self.export("-o", self.folder / "raised", "--openfast", str(version), "--point", "0.5,0,-2", "--reference", "10")
            control = read_control(self.folder / "raised/ice_StC.dat", names)
            self.assertEqual([float(control[f"StC_P_{axis}"]) for axis in "XYZ"], [0.5, 0.0, -12.0])
        text = (self.folder / "raised/ice_StC.dat").read_text(encoding="ascii")
        self.assertIn("the still water of the ice run is at -10", text)
        # The reference moves the point in OpenFAST's axes, and not the load's moments.
        self.export("-o", self.folder / "level", "--point", "0.5,0,-2")
        self.assertEqual((self.folder / "level/ice_forces.dat").read_bytes(),
                         (self.folder / "raised/ice_forces.dat").read_bytes())
        self.assertIn("is at 0\n", (self.folder / "level/ice_StC.dat").read_text(encoding="ascii"))

    def test_the_tutorial_changes_lines_that_openfast_has_to_values_that_fit(self):
        page, (main, servodyn) = changes_on_page()
        for names in MAIN.values():
            places = [names.index(name) for name, _, _ in main]
            self.assertEqual(places, sorted(places))
        places = [SERVODYN.index(name) for name, _, _ in servodyn]
        self.assertEqual(places, sorted(places))
        values = {name: after for name, _, after in main + servodyn}
        self.assertEqual((values["InterpOrder"], values["NumCrctn"], values["NumSStC"]), ("1", "2", "1"))
        # The documented command: its files have the names of the diff, its load lasts as long as TMax.
        words = re.search(r"^brash export openfast (\S+) (.*--reference.*)$", page, re.MULTILINE)[2].split()
        self.assertEqual(words[words.index("--reference") + 1], "10")
        case = (SOURCE / "experiments/turbine/turbine.toml").read_text(encoding="utf-8")
        duration = float(re.search(r"^duration = (\S+)$", case, re.MULTILINE)[1])
        self.assertEqual(float(values["TMax"]), duration - float(words[words.index("--from") + 1]))
        words[words.index("--from") + 1], words[words.index("--ramp") + 1] = "0.5", "0.2"  # of this test's short run
        words[words.index("-o") + 1] = str(self.folder / "monopile")
        self.export(*words)
        control = read_control(self.folder / "monopile" / values["SStCfiles"].strip('"'))
        self.assertEqual(float(control["StC_P_Z"]), -10.0)
        self.assertTrue((self.folder / "monopile" / control["PrescribedForcesFile"].strip('"')).is_file())

    def test_a_start_after_the_end_is_refused(self):
        self.assertIn("less than the end of the run", self.export("--from", "7", code=2))

    def test_a_run_that_kept_its_history_alone_has_the_same_files(self):
        run = self.folder / "histories"
        run.mkdir()
        (run / "history.csv").write_bytes((self.folder / "run/history.csv").read_bytes())
        subprocess.run([BRASH, "export", "openfast", run, "--point", "0,1.5,-4"], check=True, capture_output=True)
        self.export("-o", self.folder / "whole", "--point", "0,1.5,-4")
        for name in ("ice_forces.dat", "ice_StC.dat"):
            self.assertEqual((run / "openfast" / name).read_bytes(), (self.folder / "whole" / name).read_bytes())


class OpenFastOfACampaign(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        plan = cls.folder / "plan.toml"
        plan.write_text(f"""
[campaign]
case = "{SOURCE}/experiments/validation/cone.toml"
replicates = 3
[set]
time.duration = 1.5
output.statistics_from = 0.5
[[grid]]
structure.angle = ["50 deg", "61.4 deg"]
[output]
keep = "history"
columns = ["n_breaks"]
""", encoding="utf-8")
        subprocess.run([BRASH, "campaign", plan, "-o", cls.folder / "runs"], check=True, capture_output=True)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def export(self, *options, code=0):
        done = subprocess.run([BRASH, "export", "openfast", self.folder / "runs", *options], check=False,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stdout + done.stderr

    def history(self, case):
        names = ("time", "Fx", "Fy", "Fz", "Mx", "My", "Mz")
        with open(self.folder / "runs/cases" / case / "history.csv", encoding="utf-8") as file:
            return np.array([[float(row[name]) for name in names] for row in csv.DictReader(file)])

    def test_each_run_has_its_load_file(self):
        said = self.export()
        cases = sorted(path.name for path in (self.folder / "runs/cases").iterdir())
        self.assertEqual(sorted(path.name for path in (self.folder / "runs/openfast").iterdir()), cases)
        self.assertEqual(len(cases), 6)
        self.assertIn("6 runs", said)
        self.assertIn("TMax of OpenFAST: at most 1.5 s", said)
        for case in cases:
            table = read_forces(self.folder / "runs/openfast" / case / "ice_forces.dat")
            np.testing.assert_allclose(table[:-1], self.history(case), rtol=1e-8, atol=1e-6)
            read_control(self.folder / "runs/openfast" / case / "ice_StC.dat")

    def test_replicates_are_joined_on_request_alone_and_the_file_says_where(self):
        said = self.export("-o", self.folder / "joined", "--join", "2.5")
        self.assertIn("angle-50deg: 2.5 s of 3 replicates, the load jumps from one to the next at 1, 2 s", said)
        path = self.folder / "joined/angle-50deg/ice_forces.dat"
        self.assertIn("# 3 replicates of one state of the ice: the load jumps from one to the next at 1, 2 s",
                      path.read_text(encoding="ascii"))
        steady = [self.history(f"angle-50deg-r000{i}") for i in range(3)]
        loads = np.concatenate([rows[rows[:, 0] > 0.5] for rows in steady])[:, 1:]
        table = read_forces(path)
        np.testing.assert_allclose(table[:-1, 0], 0.01 * np.arange(251), atol=1e-6)
        np.testing.assert_allclose(table[:-1, 1:], loads[:251], rtol=1e-8, atol=1e-6)

    def test_too_few_replicates_are_refused(self):
        self.assertIn("3 replicates have 2.99 s together", self.export("--join", "600", code=2))
        run = self.folder / "runs/cases/angle-50deg-r0000"
        done = subprocess.run([BRASH, "export", "openfast", run, "--join", "600"], check=False, capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("is not a campaign", done.stderr)


if __name__ == "__main__":
    unittest.main()
