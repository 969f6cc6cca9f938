# SPDX-License-Identifier: GPL-3.0-or-later
"""The simulation of threads at schedules whose times and counts follow by hand."""
import pathlib
import random
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from schedule import Costs, Step, simulate, step_of

FREE = Costs()


def loop(*chunks):
    """A step that is one loop."""
    return Step([0.0, 0.0], [list(chunks)], ["loop"])


def some_step(seed=1):
    """Serial parts and loops of several lengths, one of them of a single chunk."""
    draw = random.Random(seed)
    loops = [[draw.uniform(1.0, 9.0) for _ in range(n)] for n in (40, 1, 3, 17, 64)]
    return Step([draw.uniform(0.0, 5.0) for _ in range(6)], loops, ["loop"] * 5)


class Schedules(unittest.TestCase):
    def test_four_equal_chunks_on_two_threads_take_half_the_time(self):
        run = simulate(loop(1.0, 1.0, 1.0, 1.0), 2, FREE)
        self.assertEqual(run.seconds, 2.0)
        self.assertEqual((run.shared_loops, run.exchanges, run.foreign, run.without_chunk), (1, 4, 0, 0))

    def test_a_long_chunk_sets_the_time_of_its_loop(self):
        for chunks in ((9.0, 1.0, 1.0, 1.0), (1.0, 1.0, 1.0, 9.0)):
            for threads in (4, 8):
                self.assertEqual(simulate(loop(*chunks), threads, FREE).seconds, 9.0)

    def test_one_thread_takes_the_sum_of_all_parts_whatever_threads_cost(self):
        step = some_step()
        run = simulate(step, 1, Costs(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0))
        self.assertAlmostEqual(run.seconds, step.seconds())
        self.assertEqual((run.shared_loops, run.exchanges, run.wait, run.start, run.exchange), (0, 0, 0.0, 0.0, 0.0))

    def test_without_costs_no_schedule_is_shorter_than_the_critical_path_or_an_equal_share(self):
        step = some_step()
        self.assertAlmostEqual(simulate(step, 64, FREE).seconds, step.critical_path())
        for threads in (2, 3, 8, 16):
            run = simulate(step, threads, FREE)
            self.assertGreaterEqual(run.seconds, step.critical_path() - 1e-9)
            self.assertGreaterEqual(run.seconds, step.seconds() / threads)
            # Nobody waits while there are chunks: a loop ends at most its longest chunk after an equal share.
            self.assertLessEqual(run.seconds, step.critical_path() + sum(map(sum, step.loops)) / threads)

    def test_a_thread_goes_through_the_shares_of_the_threads_after_it(self):
        # Of 8 chunks thread 0 has 0 and 1, thread 1 has 2 and 3, thread 2 has 4 and 5, thread 3 has 6 and 7.
        run = simulate(loop(1.0, 1.0, 5.0, 6.0, 9.0, 9.0, 20.0, 4.0), 4, FREE)
        # Thread 0 takes chunk 3, so thread 1 takes chunk 5. Thread 0 then finds none before chunk 7. Thread 2 finds none.
        of_others = sorted(bar[:3] for bar in run.bars if bar[1] > 1.0 and bar[3])
        self.assertEqual(of_others, [(0, 2.0, 8.0), (0, 8.0, 12.0), (1, 5.0, 14.0)])
        self.assertEqual((run.foreign, run.without_chunk, run.seconds), (3, 0, 20.0))

    def test_chunks_of_an_idle_thread_are_taken_in_their_order(self):
        # Thread 1 begins its own share, so thread 0 finds the last chunk left.
        run = simulate(loop(1.0, 1.0, 5.0, 2.0), 2, FREE)
        self.assertEqual((run.foreign, run.seconds), (1, 5.0))
        self.assertIn((0, 2.0, 4.0, "loop"), run.bars)

    def test_threads_beyond_the_chunks_find_none(self):
        run = simulate(loop(3.0, 3.0), 8, FREE)
        self.assertEqual((run.exchanges, run.without_chunk, run.seconds), (2, 6, 3.0))

    def test_a_loop_of_one_chunk_is_not_shared_out(self):
        run = simulate(loop(3.0), 8, Costs(call=1.0, see=1.0, end=1.0))
        self.assertEqual((run.shared_loops, run.seconds, run.work, run.idle), (0, 3.0, 3.0, 21.0))

    def test_the_time_of_all_threads_is_told_apart(self):
        for threads in (2, 5, 16):
            run = simulate(some_step(), threads, Costs(0.01, 0.1, 0.2, 0.3, 0.4, 5.0, 0.5, 0.1, 1.0))
            parts = run.work + run.serial + run.idle + run.start + run.exchange + run.wait
            self.assertAlmostEqual(parts, threads * run.seconds)
            self.assertAlmostEqual(run.work, sum(map(sum, some_step().loops)))
            self.assertEqual(run.exchanges, 40 + 3 + 17 + 64)
            self.assertEqual(len(run.bars), 6 + 40 + 1 + 3 + 17 + 64)


class CostsOfThreads(unittest.TestCase):
    def test_a_loop_costs_its_call_and_its_end(self):
        # The caller looks after 1 s; the other sees the call 2 s later, is done after 13 s, and the caller knows after 17 s.
        run = simulate(loop(10.0, 10.0), 2, Costs(call=1.0, see=2.0, end=4.0))
        self.assertEqual(run.seconds, 17.0)
        self.assertEqual((run.start, run.wait, run.work), (1.0 + 3.0, 6.0 + 4.0, 20.0))

    def test_each_further_thread_lets_the_caller_and_the_threads_before_it_wait_for_a_word(self):
        run = simulate(loop(10.0, 10.0, 10.0), 3, Costs(far=1.0, call=1.0, see=2.0))
        begins = sorted(bar[1] for bar in run.bars if bar[3] == "loop")
        self.assertEqual(begins, [2.0, 5.0, 6.0])  # 4 and 5, and a share to fetch

    def test_a_word_of_another_core_is_dearer_and_one_thread_has_it_at_a_time(self):
        # The caller has set all words. Thread 1 fetches its share and later the count, the caller looks at that share.
        run = simulate(loop(5.0, 5.0), 2, Costs(far=1.0))
        self.assertEqual((run.seconds, run.exchange, run.wait), (7.0, 2.0 + 1.0, 1.0))
        # Threads 1 and 2 are done at 6 s, and count one after the other. The caller's count is away, and so are two shares.
        run = simulate(loop(9.0, 4.0, 3.0), 3, Costs(far=1.0))
        begins = [bar[1] for bar in run.bars if bar[3]]
        self.assertEqual(begins, [1.0, 2.0, 3.0])
        self.assertEqual((run.seconds, run.exchange), (10.0 + 3.0, (1.0 + 1.0 + 2.0) + (1.0 + 2.0 + 2.0) + 3.0))

    def test_threads_that_waited_long_sleep_and_are_woken_one_after_the_other(self):
        step = Step([100.0, 0.0], [[10.0, 10.0, 10.0]], ["loop"])
        dear = Costs(awake=50.0, rouse=4.0, rouse_more=2.0, wake=9.0)
        begins = {worker: begin for worker, begin, _, stage in simulate(step, 3, dear).bars if stage == "loop"}
        self.assertEqual(begins, {0: 106.0, 1: 109.0, 2: 111.0})
        step.serial[0] = 50.0
        begins = {worker: begin for worker, begin, _, stage in simulate(step, 3, dear).bars if stage == "loop"}
        self.assertEqual(begins, {0: 50.0, 1: 50.0, 2: 50.0})

    def test_a_loop_wakes_no_more_threads_than_it_has_chunks_for(self):
        step = Step([100.0, 0.0, 100.0, 0.0], [[10.0, 10.0], [10.0, 10.0, 10.0], [10.0] * 4], ["a", "b", "c"])
        run = simulate(step, 5, Costs(awake=50.0, rouse=4.0, rouse_more=2.0, wake=9.0))
        begins = {(stage, worker): begin for worker, begin, _, stage in run.bars if stage}
        # Loop a wakes thread 1. It is awake in loop b, which wakes thread 2. Then all have slept, and loop c wakes three.
        self.assertEqual(begins, {("a", 0): 104.0, ("a", 1): 109.0, ("b", 0): 123.0, ("b", 1): 119.0, ("b", 2): 128.0,
                                  ("c", 0): 246.0, ("c", 1): 247.0, ("c", 2): 249.0, ("c", 3): 251.0})
        self.assertEqual((run.without_chunk, run.seconds), (0, 261.0))

    def test_only_the_named_costs_are_multiplied(self):
        costs = Costs(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0)
        self.assertEqual(costs.times(5, Costs.WORDS), Costs(5.0, 10.0, 15.0, 20.0, 25.0, 6.0, 7.0, 8.0, 9.0))
        self.assertEqual(costs.times(5, Costs.WAKING), Costs(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 35.0, 40.0, 45.0))


class Measured(unittest.TestCase):
    def test_a_step_is_its_parts_less_one_look_at_the_clock_each(self):
        step = step_of({"serial_s": [3.0, 0.5, 2.0],
                        "loops": [{"caller": "each_body<X::f()>", "chunks_s": [5.0, 4.0]}, {"caller": "find", "chunks_s": [1.0]}]},
                       1.0)
        self.assertEqual(step, Step([2.0, 0.0, 1.0], [[4.0, 3.0], [0.0]], ["each_body", "find"]))
        self.assertEqual((step.seconds(), step.critical_path()), (10.0, 7.0))

    def test_costs_come_from_the_times_of_two_threads_and_of_sixteen(self):
        row = {"near_s": 1.0, "far_s": 2.0, "caller_s": 3.0, "other_s": 7.0, "end_s": 5.0, "awake_s": 6.0, "roused_s": 33.0,
               "rousing_s": {"2": 18.0, "16": 46.0}}
        self.assertEqual(Costs.measured(row), Costs(1.0, 2.0, 3.0, 2.0, 5.0, 6.0, 10.0, 2.0, 28.0))


if __name__ == "__main__":
    unittest.main()
