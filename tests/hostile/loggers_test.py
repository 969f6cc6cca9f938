# SPDX-License-Identifier: GPL-3.0-or-later
"""Files as loggers write them are read as what they say, or refused: nothing is a second or a newton by guess."""
import json
import unittest

from common import Hostile

MEAN = 2.0  # kN, of 1 2 3 2 1 2 3 ...


class Loggers(Hostile):
    def statistics(self, text, *more):
        (self.path / "logger.csv").write_text(text)
        return json.loads(self.succeeds("stats", "logger.csv", "--json", *more).stdout)

    def assert_read(self, text):
        """200 samples every 50 ms, of 2 kN in the mean."""
        out = self.statistics(text)
        self.assertAlmostEqual(out["sampling"]["step"], 0.05, places=6, msg=text[:60])
        self.assertAlmostEqual(out["mean"], 1e3 * MEAN, delta=1, msg=text[:60])

    @staticmethod
    def rows(time, separator=","):
        return "".join(f"{time(i)}{separator}{2 + (i % 4 - 1) * (i % 2 == 0)}\n" for i in range(200))

    def test_units_at_the_end_of_names_are_read(self):
        for head in ("time_ms,Fx_kN", "Time ms,Load kN", "t/ms,Fx/kN", "time [ms],Fx [kN]", "elapsed_ms,F_kN"):
            self.assert_read(head + "\n" + self.rows(lambda i: 50 * i))
        for head in ("time_s,Fx_kN", "t,Fx_kN", "Zeit;F [kN]", "seconds\tF_kN"):
            separator = next(c for c in ";\t," if c in head)
            self.assert_read(head + "\n" + self.rows(lambda i: f"{0.05 * i:.2f}", separator))
        self.assertEqual(self.statistics("t_s,Fx_kN\n" + self.rows(lambda i: i), "--column", "Fx_kN")["unit"], "N")

    def test_units_in_names_may_be_repeated_below_and_must_agree(self):
        for head in ("Time,Load kN\ns,kN", "Time,Load kN\ns,", "Time [s],Load_kN\ns,kN", "Time,Load kN\n[s],[kN]"):
            self.assert_read(head + "\n" + self.rows(lambda i: f"{0.05 * i:.2f}"))
        for head in ("Time,Load N\ns,kN", "Time [ms],Load [N]\ns,N"):
            (self.path / "logger.csv").write_text(head + "\n" + self.rows(lambda i: i))
            self.refused("stats", "logger.csv", saying="under a name that ends with")

    def test_dates_are_read_as_seconds_since_the_first(self):
        def date(i, form="2024-02-28T23:59:{:06.3f}"):
            seconds = 55 + 0.05 * i
            return form.format(seconds) if seconds < 60 else form.replace("02-28T23:59", "02-29T00:00").replace(
                "02-28 23:59", "02-29 00:00").format(seconds - 60)

        self.assert_read("time,Fx_kN\n" + self.rows(date))
        self.assert_read("timestamp;Fx_kN\n" + self.rows(lambda i: date(i, "2024-02-28 23:59:{:06.3f}+01:00"), ";"))
        self.assert_read("timestamp,Fx_kN\n" + self.rows(lambda i: date(i) + "Z"))
        for bad in ("2024-02-30T00:00:00", "2024-02-28T25:00:00", "28.02.2024 10:00:00", "10:00:00", "2024-02-28"):
            (self.path / "logger.csv").write_text("time,Fx\n" + f"{bad},1\n" * 3)
            self.refused("stats", "logger.csv", saying="is not a time that is read")

    def test_a_preamble_is_left_out_with_a_note_if_names_follow(self):
        for preamble in ("Logger 4711\n", "Station,Adventdalen\n", "Logger 4711, firmware 2.0\nStart,2024-02-28T10:00:00\n",
                         "Recorder A\nRate 20 Hz\n\n", "Rate [Hz],20\n"):
            with self.subTest(preamble):
                self.assert_read(preamble + "time,Fx_kN\n" + self.rows(lambda i: f"{0.05 * i:.2f}"))
                self.assert_read(preamble + "time,Fx\ns,kN\n" + self.rows(lambda i: f"{0.05 * i:.2f}"))
                said = self.succeeds("stats", "logger.csv").stderr.decode()
                self.assertIn(f"above the names, such as '{preamble.splitlines()[0]}'", said)
                (self.path / "logger.csv").write_text(preamble + self.rows(lambda i: 0.05 * i))
                self.assertIn("#", self.refused("stats", "logger.csv"))

    def test_a_text_in_utf_16_is_read_by_its_mark(self):
        text = "Zeit [s]\tFx [kN]\tGröße 𝛿\n" + "".join(
            f"{row}\t0\n" for row in self.rows(lambda i: f"{0.05 * i:.2f}", "\t").splitlines())
        for code in ("utf-16-le", "utf-16-be"):
            (self.path / "logger.txt").write_bytes(("\ufeff" + text.replace("\n", "\r\n")).encode(code))
            out = json.loads(self.succeeds("stats", "logger.txt", "--json").stdout)
            self.assertAlmostEqual(out["mean"], 1e3 * MEAN, delta=1)
            self.succeeds("stats", "logger.txt", "--column", "Größe 𝛿")
        sheet = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"
        (self.path / "sheet.wkt").write_bytes(sheet.encode("utf-16"))
        self.succeeds("pieces", "sheet.wkt")

    def test_eight_messy_tables_give_the_right_mean_without_editing(self):
        def rows(separator=",", comma=False, time=lambda i: f"{0.05 * i:.2f}", lost=range(0)):
            lines = self.rows(time, "|").splitlines(keepends=True)
            text = "".join(line for i, line in enumerate(lines) if i not in lost)
            return (text.replace(".", ",") if comma else text).replace("|", separator)

        def stamp(i):
            return f"2024-02-01 12:00:{0.05 * i:06.3f}"

        closing = "\nThis output file was closed on 19-Oct-2018 at 10:15:16.\n"
        tables = {
            "utf-16.txt": ("\ufefftime [s]\tFx [kN]\r\n" + rows("\t").replace("\n", "\r\n")).encode("utf-16-le"),
            "title.csv": "Ice basin, run 12\nOperator,N.N.\n\ntime [s],Fx [kN]\n" + rows(),
            "comma.csv": "\ufeffZeit [s];Fx [kN]\n" + rows(";", comma=True),
            "stamps.csv": "timestamp,Fx_kN\n" + rows(time=stamp),
            # Whole cycles are lost, and two cells of one cycle are empty.
            "gaps.csv": "time,Fx_kN\n" + rows(lost=range(40, 80)).replace("5.00,1\n", "5.00,\n").replace("5.10,3\n", "5.10,NA\n"),
            "units.dat": "time  Fx\n s  kN\n" + rows("   "),
            "closing.out": "\nSome program\n\n  Time  Fx\n (sec)  (kN)\n" + rows("  ") + closing,
            "tabs.txt": "Recorder A\nZeit\tKraft\ns\tkN\n" + rows("\t", comma=True)}
        for name, text in tables.items():
            (self.path / name).write_bytes(text if isinstance(text, bytes) else text.encode())
            out = json.loads(self.succeeds("stats", name, "--json").stdout)
            with self.subTest(name):
                self.assertAlmostEqual(out["mean"], 1e3 * MEAN, delta=1e-6)
                self.assertAlmostEqual(out["sampling"]["step"], 0.05, places=6)
                self.assertEqual(out["unit"], "N")

    def test_a_title_is_told_from_rows_that_are_broken(self):
        for text in ("time,Fx\nx,y\n" + self.rows(lambda i: i), "time,Fx\n0,abc\n" + self.rows(lambda i: i + 1)):
            (self.path / "logger.csv").write_text(text)
            self.refused("stats", "logger.csv", saying="logger.csv:2")

    def test_lost_samples_do_not_change_the_step(self):
        rows = self.rows(lambda i: f"{0.05 * i:.2f}").splitlines(keepends=True)
        del rows[50], rows[100:102]
        sampling = self.statistics("time,Fx_kN\n" + "".join(rows))["sampling"]
        self.assertAlmostEqual(sampling["step"], 0.05, places=9)
        self.assertEqual((sampling["lost_samples"], sampling["gaps"]), (3, []))
        self.assertIn("every 0.05 s, 3 samples lost", self.succeeds("stats", "logger.csv").stdout.decode())

    def test_a_marked_preamble_is_passed_over(self):
        self.assert_read("# Logger 4711\n# Rate 20 Hz\ntime,Fx_kN\n" + self.rows(lambda i: f"{0.05 * i:.2f}"))

    def test_a_first_column_that_nothing_calls_times_is_not_taken_for_seconds(self):
        for head in ("sample,Fx", "x,Fx", "Recorder,A", "time_kg,Fx", "date,Fx", "frame_ms2,F"):
            (self.path / "logger.csv").write_text(head + "\n" + self.rows(lambda i: i))
            with self.subTest(head):
                self.refused("stats", "logger.csv", saying="time")
        out = self.statistics("sample,Fx_kN\n" + self.rows(lambda i: i), "--dt", "0.05", "--column", "Fx_kN")
        self.assertAlmostEqual(out["sampling"]["step"], 0.05)


if __name__ == "__main__":
    unittest.main()
