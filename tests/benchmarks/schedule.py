# SPDX-License-Identifier: GPL-3.0-or-later
"""How `Workers` of modules/core would share the measured chunks of a step among more threads than a machine has.

The simulation goes from event to event and follows modules/core/src/workers.cpp: each thread has a run of the chunks of
a loop, takes one after another, then goes through the runs of the threads after it. It leaves out shared caches and
memory, clocks that slow down under load, threads that share a core, and the system's own scheduling.
"""
import dataclasses
import heapq
import itertools


@dataclasses.dataclass(frozen=True)
class Costs:
    """Costs of sharing a loop [s].

    An atomic word lies in the cache of the core that exchanged it last. Another core has to fetch it, and only one core
    has it at a time. Words are the run of each thread, and the count of chunks that are done.
    """
    near: float = 0.0  # an exchange of a word that this core has
    far: float = 0.0  # an exchange of a word that another core has
    call: float = 0.0  # from the call of a loop of two threads to the caller's first look; `far` more for each further thread
    see: float = 0.0  # until the first of the others has seen the call; `far` later for each further thread
    end: float = 0.0  # until the caller knows that others have done the last chunk
    awake: float = float("inf")  # a thread without work sleeps after so long
    rouse: float = 0.0  # the caller's time to wake the first sleeping thread
    rouse_more: float = 0.0  # and each other one
    wake: float = 0.0  # from the caller's first look until a thread that it wakes first has seen the call

    WORDS = ("near", "far", "call", "see", "end")
    WAKING = ("rouse", "rouse_more", "wake")

    @staticmethod
    def measured(row):
        """Of bench_schedule."""
        more = (row["rousing_s"]["16"] - row["rousing_s"]["2"]) / 14
        awake_loop = row["caller_s"] + row["end_s"]
        first_chunk = row["caller_s"] + row["far_s"]  # the other thread's first chunk, had it seen the call at once
        return Costs(row["near_s"], row["far_s"], row["caller_s"], max(0.0, row["other_s"] - first_chunk), row["end_s"],
                     row["awake_s"], max(0.0, row["rousing_s"]["2"] - awake_loop), max(0.0, more),
                     row["roused_s"] - first_chunk)

    @staticmethod
    def names():
        return [field.name for field in dataclasses.fields(Costs)]

    def times(self, factor, names):
        """`names` are `factor` times as high."""
        return dataclasses.replace(self, **{name: factor * getattr(self, name) for name in names})


@dataclasses.dataclass
class Step:
    """Measured times of one step on one thread [s]."""
    serial: list  # before each loop, and after the last
    loops: list  # of each the times of its chunks
    stages: list  # of each the name of the function that shares it out

    def seconds(self):
        return sum(self.serial) + sum(map(sum, self.loops))

    def critical_path(self):
        """The step on any number of threads takes as long at least."""
        return sum(self.serial) + sum(map(max, self.loops))


def step_of(row, clock):
    """A step of bench_schedule, less the time of its clock, which each part contains once."""
    def net(seconds):
        return max(0.0, seconds - clock)
    return Step([net(s) for s in row["serial_s"]], [[net(s) for s in loop["chunks_s"]] for loop in row["loops"]],
                [loop["caller"].split("<")[0] for loop in row["loops"]])


@dataclasses.dataclass
class Schedule:
    """A step on `threads` threads: its time [s], counts, and where the time of all threads goes [s]."""
    threads: int
    seconds: float = 0.0
    shared_loops: int = 0  # threads wait for each other at the end of each
    exchanges: int = 0  # of the words of runs: one takes a chunk
    foreign: int = 0  # the same of the run of another thread
    without_chunk: int = 0  # threads that took no chunk, over all loops
    work: float = 0.0  # in chunks
    serial: float = 0.0  # of the caller between loops
    idle: float = 0.0  # of the others meanwhile, and of those without a part in a loop
    start: float = 0.0  # until a thread has seen a loop
    exchange: float = 0.0  # looking for chunks, taking and counting them
    wait: float = 0.0  # for the last chunk of a loop
    bars: list = dataclasses.field(default_factory=list)  # (thread, begin, end, stage or None where serial)


class Loop:
    """The threads at one loop."""

    def __init__(self, chunks, threads, costs):
        n = len(chunks)
        self.chunks, self.costs = chunks, costs
        self.next = [n * worker // threads for worker in range(threads)]
        self.end = [n * (worker + 1) // threads for worker in range(threads)]
        self.owner = [0] * (threads + 1)  # of each run's word, and of the count: the caller has set them
        self.free = [0.0] * (threads + 1)  # when the exchange in progress is over
        self.taken = [[] for _ in range(threads)]  # (begin, end) of chunks
        self.foreign, self.last_done = 0, 0.0

    def exchange(self, word, worker, now):
        """When a thread that wants a word now has exchanged it."""
        cost = self.costs.near if self.owner[word] == worker else self.costs.far
        self.owner[word], self.free[word] = worker, max(now, self.free[word]) + cost
        return self.free[word]

    def seek(self, worker, at, now):
        """One look at the run of the thread `at` places further. @return when its next event is, at which run, and what."""
        run = (worker + at) % len(self.next)
        if self.next[run] == self.end[run]:
            return now + (self.costs.near if self.owner[run] == worker else self.costs.far), at + 1, self.seek
        begin = self.exchange(run, worker, now)
        end = begin + self.chunks[self.next[run]]
        self.next[run] += 1
        self.foreign += run != worker
        self.taken[worker].append((begin, end))
        return end, at, self.count

    def count(self, worker, at, now):
        """A chunk is done."""
        self.last_done = self.exchange(len(self.next), worker, now)
        return self.last_done, at, self.seek

    def run(self, begins):
        """@param begins  when each thread looks for a chunk first, or None if it sleeps.
        @return when each has found that there are no more, or None."""
        idle, order = list(begins), itertools.count()
        events = [(begin, next(order), worker, 0, self.seek) for worker, begin in enumerate(begins) if begin is not None]
        heapq.heapify(events)
        while events:
            now, _, worker, at, act = heapq.heappop(events)
            if at == len(begins):
                idle[worker] = now
                continue
            then, at, act = act(worker, at, now)
            heapq.heappush(events, (then, next(order), worker, at, act))
        return idle


def begins_of(idle_since, now, n_chunks, costs):
    """When each thread looks for its first chunk of a loop that is called now; None if it sleeps through the loop."""
    threads = len(idle_since)
    called = now + costs.call + (threads - 2) * costs.far
    awake = [now - since <= costs.awake for since in idle_since[1:]]
    n_to_rouse = min(max(0, n_chunks - 1 - sum(awake)), len(awake) - sum(awake))
    begins, n_seen, n_roused = [called], 0, 0
    for is_awake, since in zip(awake, idle_since[1:]):
        if is_awake:
            begins.append(max(since, called + costs.see + n_seen * costs.far))
            n_seen += 1
        elif n_roused < n_to_rouse:
            begins.append(called + costs.wake + n_roused * costs.rouse_more)
            n_roused += 1
        else:
            begins.append(None)
    if n_roused > 0:
        begins[0] += costs.rouse + (n_roused - 1) * costs.rouse_more
    return begins


def share_loop(schedule, chunks, stage, idle_since, costs):
    """Adds a loop that is shared out at the end of the schedule so far."""
    threads, called = schedule.threads, schedule.seconds
    begins = begins_of(idle_since, called, len(chunks), costs)
    loop = Loop(chunks, threads, costs)
    idle_since[:] = [before if idle is None else idle for before, idle in zip(idle_since, loop.run(begins))]
    end = max(idle_since[0], loop.last_done + (costs.end if loop.owner[threads] != 0 else 0.0))
    schedule.seconds = end
    schedule.shared_loops += 1
    schedule.exchanges += len(chunks)
    schedule.foreign += loop.foreign
    for worker, taken in enumerate(loop.taken):
        if begins[worker] is None:
            schedule.idle += end - called
            continue
        work = sum(until - begin for begin, until in taken)
        began, ended = min(begins[worker], end), min(idle_since[worker], end)
        schedule.without_chunk += not taken
        schedule.work += work
        schedule.start += began - called
        schedule.exchange += ended - began - work
        schedule.wait += end - ended
        schedule.bars += [(worker, begin, until, stage) for begin, until in taken]


def simulate(step, threads, costs):
    """The schedule of a step on so many threads."""
    schedule = Schedule(threads)
    idle_since = [0.0] * threads

    def alone(seconds, stage):
        begin, schedule.seconds = schedule.seconds, schedule.seconds + seconds
        schedule.idle += (threads - 1) * seconds
        schedule.bars.append((0, begin, schedule.seconds, stage))

    for serial, chunks, stage in itertools.zip_longest(step.serial, step.loops, step.stages):
        alone(serial, None)
        schedule.serial += serial
        if chunks is None:
            break
        if threads > 1 and len(chunks) > 1:
            share_loop(schedule, chunks, stage, idle_since, costs)
        else:
            alone(sum(chunks), stage)
            schedule.work += sum(chunks)
    return schedule
