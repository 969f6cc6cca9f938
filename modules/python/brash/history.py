# SPDX-License-Identifier: GPL-3.0-or-later
"""One load history, of a run or measured, with what `brash stats` and `brash compare` tell of it."""
from __future__ import annotations

from typing import Any

import numpy as np

from . import _brash


class History(tuple):
    """A pair (times, values) with a name, a unit and a start; every function that takes a history takes it.

    times: rising, shape (n,) [s]; values: shape (n,), in SI if the unit is known; start: the date at which times are 0.
    """

    name: str
    attrs: dict[str, str]

    def __new__(cls, times: Any, values: Any, name: str = "load", unit: str = "", start: str = "") -> History:
        pair = np.asarray(times, dtype=float), np.asarray(values, dtype=float)
        if pair[0].ndim != 1 or pair[0].shape != pair[1].shape:
            shapes = f"times have shape {pair[0].shape} and values {pair[1].shape}"
            raise _brash.InputError(f"History: {shapes}; both must have shape (n,)")
        history = super().__new__(cls, pair)
        history.name = name
        history.attrs = {key: text for key, text in (("units", unit), ("start", start)) if text}
        return history

    def __getnewargs__(self):
        return (*self, self.name, self.unit, self.start)

    @classmethod
    def read(cls, path: Any, column: str = "", **choice: Any) -> History:
        """The history of a run's folder or of a measured file; `choice` as of read_history()."""
        return _brash.read_history(path, column, **choice)

    @property
    def times(self) -> Any:
        return self[0]

    @property
    def values(self) -> Any:
        return self[1]

    @property
    def unit(self) -> str:
        return self.attrs.get("units", "")

    @property
    def start(self) -> str:
        return self.attrs.get("start", "")

    def between(self, start: float, end: float) -> History:
        """The samples from `start` to `end` [s], both with them."""
        within = (self.times >= start) & (self.times <= end)
        return History(self.times[within], self.values[within], self.name, self.unit, self.start)

    def stats(self, **settings: Any) -> dict[str, Any]:
        """Moments, quantiles, peaks, extremes: all that stats() gives."""
        return _brash.stats(self, **settings)

    def extremes(self, return_period: float, **settings: Any) -> dict[str, Any]:
        """Levels that are exceeded once in `return_period` [s], as extremes() gives them."""
        return _brash.extremes(self, return_period, **settings)

    def spectrum(self, segment: float = 0.0) -> dict[str, Any]:
        """Frequency [Hz], density and its 95 % band."""
        return _brash.spectrum(self, segment)

    def events(self, dead_band: float | None = None) -> dict[str, Any]:
        """Load events about the mean with start, end, peak and impulse; pandas.DataFrame takes them."""
        return _brash.load_events(self, dead_band)

    def peaks(self, dead_band: float | None = None) -> History:
        """The peak of each event, at its time."""
        events = self.events(dead_band)
        return History(events["peak_time"], events["peak"], self.name, self.unit, self.start)

    def rainflow(self) -> tuple[Any, Any, Any]:
        """Ranges, means and counts of the cycles (ASTM E1049)."""
        return _brash.rainflow(self.values)

    def compare(self, measured: Any) -> dict[str, Any]:
        """This history, as of a run, against a measured one or a list of replicates."""
        return _brash.compare(self, measured)

    def to_pandas(self) -> Any:
        """A pandas.Series over time, from `start` on if that is an ISO date. Needs pandas."""
        import pandas as pd

        index = pd.Index(self.times, name="time")
        if self.start:
            index = pd.DatetimeIndex(pd.Timestamp(self.start) + pd.to_timedelta(self.times, unit="s"), name="time")
        series = pd.Series(self.values, index=index, name=self.name)
        series.attrs = dict(self.attrs)
        return series

    def __repr__(self) -> str:
        unit = f" [{self.unit}]" if self.unit else ""
        span = f", {self.times[0]:g} to {self.times[-1]:g} s" if len(self.times) else ""
        return f"<brash.History {self.name}{unit}: {len(self.times)} samples{span}>"


History.__module__ = "brash"
