# SPDX-License-Identifier: GPL-3.0-or-later
"""Python: threads and processes on the same files, cases that are changed while they run, lists that hold themselves,
objects that are half made, interpreters that end, and Ctrl-C.

BRASH_HOSTILE_SECONDS=60 has the threads and processes work for a minute instead of a few seconds.
"""
import multiprocessing
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import brash

CONE = pathlib.Path(os.environ["BRASH_SOURCE_DIR"]) / "experiments/validation/cone.toml"
SECONDS = float(os.environ.get("BRASH_HOSTILE_SECONDS", "3"))
TINY = {"time.duration": 0.05, "failure.model": "wedge"}


def work(shared, own, until, problems):
    """Reads what others read, and writes what others write, again and again."""
    n = 0
    while time.monotonic() < until and not problems:
        try:
            case = brash.Case.from_file(CONE, TINY)
            run = case.run(own, replace=True)
            try:
                assert len(brash.read_results(shared / "run.nc").loads) == len(run.loads)
            except brash.InputError as error:  # a run that begins removes what an earlier one left
                assert "No such file" in str(error), error
            assert len(brash.read_results(pathlib.Path(own) / "run.nc").loads) == len(run.loads)
            try:
                case.run(shared, replace=True)
            except brash.InputError as error:
                assert "is in use" in str(error), error
            n += 1
        except Exception as error:  # noqa: BLE001
            problems.append(f"{type(error).__name__}: {error}")
    return n


def work_in_threads(shared, own, until):
    problems = []
    counts = [0, 0]

    def one(i):
        counts[i] = work(shared, own / str(i), until, problems)

    threads = [threading.Thread(target=one, args=(i,)) for i in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return sum(counts), problems


def in_process(shared, own, until, answers):
    answers.put(work_in_threads(pathlib.Path(shared), pathlib.Path(own), until))


class Scratch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.path = pathlib.Path(scratch.name)

    def script(self, text, **options):
        return subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, timeout=120, **options)


class Together(Scratch):
    def test_two_threads_in_each_of_eight_processes_work_on_the_same_files(self):
        brash.Case.from_file(CONE, TINY).run(self.path / "shared")
        context = multiprocessing.get_context("spawn")
        answers = context.Queue()
        until = time.monotonic() + SECONDS + 4
        processes = [context.Process(target=in_process, args=(self.path / "shared", self.path / str(i), until, answers))
                     for i in range(8)]
        for process in processes:
            process.start()
        found = [answers.get(timeout=SECONDS + 120) for _ in processes]
        for process in processes:
            process.join()
        self.assertEqual([p.exitcode for p in processes], [0] * 8)
        self.assertEqual([problem for _, problems in found for problem in problems], [])
        print(f"{sum(n for n, _ in found)} rounds in 8 processes of 2 threads", file=sys.stderr)
        self.assertGreater(sum(n for n, _ in found), 0)


class Cases(Scratch):
    def test_a_case_that_runs_cannot_be_changed_and_others_can(self):
        case = brash.Case.from_file(CONE, {"time.duration": 3, "failure.model": "wedge"})
        thread = threading.Thread(target=case.run)
        thread.start()
        refused = 0
        while thread.is_alive():
            try:
                case["ice.thickness"] = 0.33
            except RuntimeError as error:
                self.assertIn("is running", str(error))
                refused += 1
            case.copy()["ice.thickness"] = 0.5
            time.sleep(0.01)
        thread.join()
        self.assertGreater(refused, 0)
        case["ice.thickness"] = 0.4

    def test_lists_that_hold_themselves_are_refused(self):
        endless = [1]
        endless.append(endless)
        case = brash.Case.from_file(CONE)
        with self.assertRaisesRegex(brash.InputError, "holds itself"):
            case["failure.wedges"] = endless
        for call in (lambda: brash.IceSheet(endless), lambda: brash.Polygon(endless), lambda: brash.fit_trapezoid(endless, (0, 0), (1, 0), 1)):
            with self.assertRaises((ValueError, TypeError)):
                call()

        class Endless:
            def tolist(self):
                return self

        with self.assertRaisesRegex(brash.InputError, "holds itself"):
            case["failure.wedges"] = Endless()

    def test_half_made_objects_raise(self):
        case = brash.Case.from_file(CONE)
        types = [value for value in vars(brash).values() if isinstance(value, type) and type(value).__name__ == "pybind11_type"]
        self.assertGreater(len(types), 12)
        for kind in types:
            half = kind.__new__(kind)
            for name in vars(kind):
                if name.startswith("__") and name not in ("__repr__", "__eq__", "__copy__", "__call__"):
                    continue
                with self.subTest(f"{kind.__name__}.{name}"), self.assertRaises((TypeError, AttributeError)):
                    value = getattr(half, name)
                    value(case) if name == "__eq__" else value()
        half = brash.Case.__new__(brash.Case)
        for use in (brash.Simulation, brash.Criterion, brash.characteristic_length, lambda c: c == case):
            with self.assertRaises(TypeError):
                if use(half) is False:
                    raise TypeError("not equal, and not looked at")


class Ends(Scratch):
    def test_an_interpreter_that_ends_in_the_middle_of_a_call_does_not_abort(self):
        for call in ("case.run()", f"case.run({str(self.path / 'out')!r})", "brash.Simulation(case).step(10**6)"):
            done = self.script(f"""
import threading, time, brash
case = brash.Case.from_file({str(CONE)!r}, {{"time.duration": 1000, "failure.model": "wedge"}})
threading.Thread(target=lambda: {call}, daemon=True).start()
time.sleep(0.5)
""")
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_threads_without_memory_raise(self):
        # All limits and calls: tests/experiments/python_limits.py
        for call, limits in (("brash.Simulation(case).step(50)", (0, 2, 4, 6, 8, 12, 16)),
                             (f"brash.Case.from_file({str(CONE)!r})", (0, 1, 2)),
                             ("brash.Polygon([(0, 0), (1, 0), (0, 1)]).area", (0,)),
                             ("case['time.step']", (0,))):
            for megabytes in limits:
                done = self.script(f"""
import resource, threading, brash
case = brash.Case.from_file({str(CONE)!r}, {{"time.duration": 1.5, "failure.model": "wedge", "output.statistics_from": 0}})
ends = []
limited = threading.Event()
def call():
    limited.wait()
    try:
        {call}
        ends.append("done")
    except MemoryError:
        ends.append("MemoryError")
    except Exception as error:
        ends.append("MemoryError" if "memory" in str(error) else repr(error))
threads = [threading.Thread(target=call) for _ in range(3)]
for thread in threads:  # before the limit: a start without memory may hang (CPython issue 140746)
    thread.start()
now = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (now + ({megabytes} << 20),) * 2)
limited.set()
for thread in threads:
    thread.join()
print(*sorted(set(ends)))
""", env={**os.environ, "MALLOC_ARENA_MAX": "1"})  # a heap for each thread would be memory that is left
                self.assertEqual(done.returncode, 0, f"{call}, {megabytes} MB: {done.stderr}")
                self.assertLessEqual(set(done.stdout.split()), {"done", "MemoryError"}, f"{call}, {megabytes} MB: {done.stdout}")

    def test_ctrl_c_ends_long_calls(self):
        plan = self.path / "plan.toml"
        plan.write_text(f'[campaign]\ncase = "{CONE}"\nreplicates = 2\n[set]\ntime.duration = 1000\n')
        for call in ("case.run()", "brash.Simulation(case).step(10**6)",
                     f"brash.campaign({str(plan)!r}, {str(self.path / 'campaign')!r}, jobs=1)",
                     "brash.FailureModel('fem')(b_lc=np.full(10**5, 0.3), c_lc=0.3, theta=1.0, mu1=0.5, mu2=0.0)",
                     "brash.IceSheet([[0, 0], [9, 0], [9, 9], [0, 9]]).contains(np.full((5 * 10**7, 2), 4.0))",
                     "brash.kendall(np.random.rand(10**7), np.random.rand(10**7))",
                     "brash.bootstrap_interval(np.arange(1e5), np.mean, n_resamples=10**6)"):
            with self.subTest(call):
                process = subprocess.Popen([sys.executable, "-c", f"""
import numpy as np, brash
case = brash.Case.from_file({str(CONE)!r}, {{"time.duration": 1000, "failure.model": "wedge"}})
print("ready", flush=True)
{call}
"""], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                process.stdout.readline()
                time.sleep(1.0)
                self.assertIsNone(process.poll(), "it was over before it was stopped")
                process.send_signal(signal.SIGINT)
                _, err = process.communicate(timeout=60)
                # A campaign takes the signal itself, and says how to go on.
                self.assertRegex(err, "resume=True continues" if "campaign" in call else "KeyboardInterrupt")


if __name__ == "__main__":
    unittest.main()
