# SPDX-License-Identifier: GPL-3.0-or-later
"""Load histories in Python: the reader, events, extremes, comparison, design; pandas and xarray in and out."""
import json
import pathlib
import pickle
import tempfile
import threading
import time
import unittest
import warnings

import numpy as np

import brash

try:
    import pandas as pd
    import xarray as xr
except ImportError:
    pd = xr = None

GENERATOR = np.random.default_rng(11)


def sawtooth(cycles, excess=40.0):
    """(times, load): a straight rise to an exponential peak above 100 in each second."""
    peaks = 100.0 + GENERATOR.exponential(excess, cycles)
    load = (20.0 + (peaks[:, None] - 20.0) * np.arange(1, 21) / 20).ravel()
    return 0.05 * np.arange(load.size), load


class Histories(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def test_a_column_is_read_in_si_and_between_two_times(self):
        file = self.folder / "load.csv"
        file.write_text("time [ms],Fx [kN]\n0,1\n500,2\n1000,3\n1500,4\n")
        times, values = brash.read_history(file, start=0.5, end=1.0)
        self.assertEqual((times.tolist(), values.tolist()), ([0.5, 1.0], [2000.0, 3000.0]))

    def test_one_object_has_the_statistics_of_a_history(self):
        times, load = sawtooth(400)
        file = self.folder / "load.csv"
        lines = [f"2024-02-01T12:{int(t) // 60:02d}:{t % 60:06.3f},{x:.9g}\n" for t, x in zip(times, load / 1e3)]
        file.write_text("time,Fx [kN]\n" + "".join(lines))
        history = brash.History.read(file)
        self.assertEqual((history.name, history.unit, history.start), ("Fx", "N", "2024-02-01T12:00:" + lines[0][17:23]))
        np.testing.assert_allclose(history.values, load, rtol=1e-8)
        pair = tuple(history)  # the functions take the one as the other
        self.assertEqual(history.stats()["mean"], brash.stats(pair)["mean"])
        self.assertEqual((history.stats()["unit"], history.stats()["start"]), ("N", history.start))
        self.assertEqual(history.extremes(600.0), brash.extremes(pair, 600.0))
        events = brash.load_events(pair)
        self.assertEqual(history.peaks().values.tolist(), events["peak"].tolist())
        self.assertEqual(history.peaks().times.tolist(), events["peak_time"].tolist())
        self.assertEqual([a.tolist() for a in history.rainflow()], [a.tolist() for a in brash.rainflow(history.values)])
        self.assertEqual(history.compare(pair)["mean"], brash.compare(pair, pair)["mean"])
        spectrum = history.spectrum()
        step = np.diff(history.times).mean()
        peak = spectrum["frequency"][1:][spectrum["density"][1:].argmax()]
        self.assertEqual(peak, history.stats()["spectrum_peak"]["frequency"])
        self.assertLess(spectrum["frequency"][-1], 0.5 / step + 1e-6)
        self.assertTrue(np.all(spectrum["lower_95"] < spectrum["upper_95"]))
        part = history.between(1.0, 2.0)
        self.assertTrue(part.times.min() >= 1.0 and part.times.max() <= 2.0 and part.unit == "N")
        self.assertEqual(pickle.loads(pickle.dumps(history)).start, history.start)
        for bad in (([1, 2], [1]), ([[1, 2]], [[1, 2]])):
            with self.assertRaises(brash.InputError):
                brash.History(*bad)

    @unittest.skipIf(pd is None, "pandas and xarray are not installed")
    def test_a_history_goes_to_pandas_with_its_dates(self):
        file = self.folder / "load.csv"
        file.write_text("time,Fx [kN]\n2024-02-01T12:00:00.3,1\n2024-02-01T12:00:00.4,2\n2024-02-01T12:00:01,4\n")
        series = brash.History.read(file).to_pandas()
        self.assertEqual((series.name, series.attrs["units"], series.tolist()), ("Fx", "N", [1e3, 2e3, 4e3]))
        self.assertEqual(series.index[1], pd.Timestamp("2024-02-01T12:00:00.4"))
        self.assertEqual(brash.History([0, 1], [2, 3]).to_pandas().index.tolist(), [0.0, 1.0])
        self.assertEqual(brash.read_history(file, as_="pandas").attrs["start"], "2024-02-01T12:00:00.3")
        self.assertEqual(brash.read_history(file, as_="xarray").attrs["start"], "2024-02-01T12:00:00.3")

    def test_markers_of_missing_values_are_warned_of_and_left_out(self):
        file = self.folder / "load.csv"
        file.write_text("time,F [kN]\n" + "".join(f"{i},{-9999 if i == 7 else 50 + i % 5}\n" for i in range(20)))
        with self.assertWarnsRegex(UserWarning, r"1 sample is -9999(.|\n)*missing=\[-9999\]"):
            brash.read_history(file)
        times, values = brash.read_history(file, missing=[-9999])
        self.assertEqual((len(times), values.min()), (19, 50e3))
        self.assertIn("-9999", " ".join(brash.stats((np.arange(20.0), np.where(np.arange(20) == 7, -9999, 50.0 + np.arange(20) % 5)))["warnings"]))

    def test_the_output_of_openfast_is_read(self):
        file = self.folder / "tower.out"
        file.write_text("\nPredictions were generated on 01-Jan-2026\n\nDescription from the input file, line 2\n\n"
                        "Time\tTwrBsFxt\tTwrBsMyt\n(s)\t(kN)\t(kN-m)\n0.0\t1.5E+02\t3\n0.1\t-2.5E+02\t4\n")
        times, values = brash.read_history(file, "TwrBsFxt")
        self.assertEqual(times.tolist(), [0.0, 0.1])
        np.testing.assert_allclose(values, [150e3, -250e3])

    @unittest.skipIf(pd is None, "pandas and xarray are not installed")
    def test_pandas_and_xarray_go_in_and_come_out(self):
        times, load = sawtooth(100)
        series, array = pd.Series(load, index=times), xr.DataArray(load, coords={"time": times}, dims=("time",))
        dated = pd.Series(load, index=pd.Timestamp("2026-01-01") + pd.to_timedelta(times, unit="s"))
        expected = brash.load_events((times, load))
        for history in (series, array, dated):
            np.testing.assert_allclose(brash.load_events(history)["peak"], expected["peak"])
        file = self.folder / "load.csv"
        file.write_text("time,Fx [kN]\n0,1\n1,2\n2,4\n")
        series = brash.read_history(file, as_="pandas")
        self.assertEqual((series.name, series.index.name, series.iloc[-1], series.attrs["units"]), ("Fx", "time", 4000.0, "N"))
        array = brash.read_history(file, as_="xarray")
        self.assertEqual((array.attrs["units"], array.time.attrs["units"]), ("N", "s"))

    @unittest.skipIf(pd is None, "pandas and xarray are not installed")
    def test_times_have_their_unit_and_rows_are_no_times(self):
        times, load = sawtooth(100)
        expected = brash.load_events((times, load))["peak_time"]
        for unit, factor in (("ms", 1e3), ("min", 1 / 60), ("s", 1.0)):
            along = xr.DataArray(times * factor, dims=("time",), attrs={"units": unit})
            found = brash.load_events(xr.DataArray(load, coords={"time": along}, dims=("time",)))
            np.testing.assert_allclose(found["peak_time"], expected, rtol=1e-12)
        with self.assertRaisesRegex(brash.InputError, "no unit of time|furlong"):
            along = xr.DataArray(times, dims=("time",), attrs={"units": "furlong"})
            brash.stats(xr.DataArray(load, coords={"time": along}, dims=("time",)))
        table = pd.DataFrame({"time": times, "Fx": load})
        for rows in (table.Fx, table[table.time > 5.0].Fx):
            with self.assertRaisesRegex(brash.InputError, "counts rows(.|\n)*set_index"):
                brash.stats(rows)
        np.testing.assert_allclose(brash.load_events(table.set_index("time").Fx)["peak_time"], expected)
        seconds = pd.Series(load, index=pd.Index(np.arange(load.size), name="time"))
        np.testing.assert_allclose(brash.load_events(seconds)["peak_time"], expected / 0.05, rtol=1e-9)

    @unittest.skipIf(pd is None, "pandas and xarray are not installed")
    def test_dates_with_a_zone_or_a_gap(self):
        times, load = sawtooth(100)
        dates = pd.Timestamp("2026-10-25T00:30", tz="Europe/Berlin") + pd.to_timedelta(60 * times, unit="s")
        # Clocks go back within these hours.
        zoned = brash.load_events(pd.Series(load, index=dates))
        np.testing.assert_allclose(zoned["peak_time"], brash.load_events((60 * times, load))["peak_time"])
        missing = pd.Series(load, index=dates.tz_convert(None).where(times != times[7]))
        with self.assertRaisesRegex(brash.InputError, "NaT"):
            brash.load_events(missing)
        self.assertEqual(len(brash.load_events(missing[missing.index.notna()])["peak"]), len(zoned["peak"]))
        with self.assertRaises(brash.InputError):
            brash.load_events(pd.Series([], index=pd.DatetimeIndex([]), dtype=float))

    def test_masked_values_and_times_are_refused(self):
        times, load = sawtooth(100)
        masked = np.ma.masked_greater(load, 200.0)
        for history in ((times, masked), (np.ma.masked_less(times, 1.0), load)):
            with self.assertRaisesRegex(brash.InputError, "without masked values"):
                brash.load_events(history)
        kept = brash.load_events((times, masked.filled(np.nan)))
        self.assertGreater(len(kept["peak"]), 0)

    def looks_during(self, call):
        """How often this thread comes to work during a call in another thread, and its result."""
        results = []
        worker = threading.Thread(target=lambda: results.append(call()))
        worker.start()
        looks = 0
        while worker.is_alive():
            looks += 1
            time.sleep(0.001)
        worker.join()
        return looks, results[0]

    def test_long_statistics_let_other_threads_work(self):
        history = sawtooth(20_000)
        looks, n = self.looks_during(lambda: brash.stats(history)["n"])
        self.assertEqual(n, history[1].size)
        self.assertGreater(looks, 20)

    def test_the_reading_of_a_long_history_lets_other_threads_work(self):
        times, load = sawtooth(20_000)
        file = self.folder / "long.csv"
        np.savetxt(file, np.column_stack([times, load]), delimiter=",", header="time,Fx", comments="")
        looks, (_, values) = self.looks_during(lambda: brash.read_history(file))
        self.assertEqual(values.size, load.size)
        self.assertGreater(looks, 20)

    def test_events_extremes_and_fatigue_are_those_of_the_command(self):
        times, load = sawtooth(1000)
        events = brash.load_events((times, load))
        self.assertGreater(len(events["peak"]), 900)
        np.testing.assert_allclose(events["rise"] + events["fall"], events["end"] - events["start"])
        found = brash.extremes((times, load), 3000.0)
        self.assertEqual(found["recommended"]["law"], "GEV")
        truth = 100.0 + 40.0 * np.log(3000.0)
        self.assertTrue(found["recommended"]["level_95"][0] < truth < found["recommended"]["level_95"][1])
        self.assertIsNone(brash.extremes((times[:1200], load[:1200]), 3600.0)["recommended"]["law"])
        self.assertEqual(brash.stats((times, load), exponents=[4.0])["fatigue"][0]["exponent"], 4.0)
        halves = [(times[:10000], load[:10000]), (times[10000:], load[10000:])]
        self.assertIsNotNone(brash.extremes(halves, 3000.0)["recommended"]["law"])

    def test_a_load_below_zero_is_told_to_change_its_sign(self):
        times, load = sawtooth(200)
        told = "the mean is negative"
        with self.assertWarnsRegex(UserWarning, told):
            brash.load_events((times, -load))
        self.assertTrue(any(told in text for text in brash.stats((times, -load))["warnings"]))
        self.assertTrue(any(told in text for text in brash.extremes((times, -load), 600.0)["warnings"]))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            brash.load_events((times, load))
            brash.load_events((times, load - load.mean() - 1.0))  # small below zero, with peaks above it
        self.assertFalse(any(told in text for text in brash.stats((times, load))["warnings"]))

    def test_rainflow_counts_the_example_of_the_standard(self):
        ranges, _, counts = brash.rainflow([-2, 1, -3, 5, -1, 3, -4, 4, -2])
        found = {r: counts[ranges == r].sum() for r in ranges}
        self.assertEqual(found, {3: 0.5, 4: 1.5, 6: 0.5, 8: 1.0, 9: 0.5})

    def test_replicates_are_compared(self):
        run, measured = [sawtooth(100) for _ in range(4)], [sawtooth(100, 80.0) for _ in range(3)]
        found = brash.compare(run, measured)
        self.assertEqual(found["run"]["histories"], 4)
        self.assertIn("mean", found["differs"])

    @unittest.skipIf(pd is None, "pandas and xarray are not installed")
    def test_units_are_told_and_different_ones_refused(self):
        times, load = sawtooth(100)
        array = lambda values, **attrs: xr.DataArray(values, coords={"time": times}, dims=("time",), attrs=attrs)
        newtons, kilonewtons = array(load, units="N"), array(load / 1000, units="kN")
        self.assertEqual(brash.stats(kilonewtons)["unit"], "kN")
        self.assertIsNone(brash.stats(array(load))["unit"])
        found = brash.compare(newtons, [newtons, (times, load)])
        self.assertEqual((found["run"]["unit"], found["measured"]["unit"]), ("N", "N"))
        self.assertAlmostEqual(found["mean"]["ratio"], 1.0)
        for refused in (lambda: brash.compare(newtons, kilonewtons), lambda: brash.compare([newtons, kilonewtons], newtons),
                        lambda: brash.extremes([newtons, kilonewtons], 600.0)):
            with self.assertRaisesRegex(brash.InputError, "'kN'.*'N'|'N'.*'kN'"):
                refused()

    def test_a_campaign_becomes_design_loads(self):
        for replicate in range(3):
            run = self.folder / "cases" / f"thin-r{replicate:04d}"
            run.mkdir(parents=True)
            (run / "summary.json").write_text('{"statistics_from": 0}')
            rows = "\n".join(f"{t:.2f},{x}" for t, x in zip(*sawtooth(200)))
            (run / "history.csv").write_text(f"time,Fx\n{rows}\n")
        settings = [{"setting": "thin", "values": {"ice.thickness": 0.3}}]
        (self.folder / "summary.json").write_text(json.dumps({"settings": settings}))
        rows = "".join(f"thin-r{replicate:04d},thin,{replicate},done\n" for replicate in range(3))
        (self.folder / "campaign.csv").write_text("case,setting,replicate,status\n" + rows)
        state = brash.design(self.folder, hours=[0.5, 1.0])["settings"][0]
        self.assertEqual([level["hours"] for level in state["levels"]], [0.5, 1.0])
        self.assertLess(state["levels"][0]["level"], state["levels"][1]["level"])
        with self.assertRaises(brash.InputError):
            brash.design(self.folder / "cases")

    def test_return_levels_are_those_of_a_campaign(self):
        thin, thick = [[sawtooth(200, excess) for _ in range(4)] for excess in (40.0, 80.0)]
        found = brash.return_levels({"thin": (100, thin), "thick": (2, thick)}, years=[1, 50])
        self.assertEqual([level["years"] for level in found["annual"]], [1, 50])
        for level in found["annual"]:
            self.assertLess(level["level_95"][0], level["level"])
            self.assertLess(level["level"], level["level_95"][1])
            self.assertAlmostEqual(sum(level["shares"].values()), 1.0)
        # Half the hours have the level in twice the years.
        half = brash.return_levels({"thin": (50, thin), "thick": (1, thick)}, years=[100])["annual"][0]
        self.assertAlmostEqual(half["level"] / found["annual"][1]["level"], 1.0, places=9)
        self.assertEqual(len(brash.return_levels({"thick": (2, thick[0])})["annual"]), 4)

    def test_states_of_return_levels_are_checked(self):
        load = sawtooth(100)
        for states, words in (({}, "one state at least"), ({"thin": load[0]}, "hours a year, a history"),
                              ({"thin": (9000, load)}, "from 0 to 8784")):
            with self.assertRaisesRegex(brash.InputError, words):
                brash.return_levels(states)

    def test_what_is_no_history_is_refused(self):
        for bad in (3, "text", ([0, 1], [1]), ([1, 0, 2], [1, 2, 3])):
            with self.assertRaises(brash.InputError):
                brash.stats(bad)


if __name__ == "__main__":
    unittest.main()
