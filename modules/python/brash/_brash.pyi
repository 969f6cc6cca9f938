# SPDX-License-Identifier: GPL-3.0-or-later
"""Types of the module; shapes and units are in the docstrings. A test holds this file against the module."""

from collections.abc import Callable, Sequence
from decimal import Decimal
from fractions import Fraction
from os import PathLike
from typing import Any, NamedTuple, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]
Table = NDArray[np.void]
Path = str | PathLike[str]
# A Polygon, vertices with shape (n, 2), WKT or GeoJSON as text, or an object with __geo_interface__.
PolygonLike = Any
LineLike = Any

__version__: str

class InputError(ValueError): ...
class NotApplicable(InputError): ...
class RunError(RuntimeError): ...
class ContractViolation(AssertionError): ...

class Case:
    @staticmethod
    def from_file(path: Path, changes: dict[str, Any] = {}) -> Case: ...
    @staticmethod
    def from_text(text: str, name: str = "case", changes: dict[str, Any] = {}) -> Case: ...
    def __getitem__(self, key: str) -> Any: ...
    def __setitem__(self, key: str, value: Any) -> None: ...
    def update(self, changes: dict[str, Any]) -> None: ...
    def copy(self) -> Case: ...
    def derived(self) -> dict[str, Any]: ...
    def mesh(self) -> tuple[Floats, NDArray[np.int32]]: ...
    def to_dict(self) -> dict[str, dict[str, Any]]: ...
    def to_toml(self) -> str: ...
    def run(self, output: Path | None = None, resume: bool = False, replace: bool = False, threads: int = 1) -> Run: ...
    @property
    def name(self) -> str: ...
    @property
    def origin(self) -> str: ...

def schema() -> str: ...
def template(ice: str = "basin") -> str: ...
def new_case(kind: str = "cone", ice: str = "basin") -> str: ...
def site_ice() -> list[str]: ...

class FloeRecord:
    @property
    def id(self) -> int: ...
    @property
    def area(self) -> float: ...
    @property
    def thickness(self) -> float: ...
    @property
    def birth(self) -> float: ...
    @property
    def death(self) -> float: ...
    @property
    def end(self) -> str: ...
    @property
    def peak_stress(self) -> float: ...
    @property
    def rings(self) -> list[Floats]: ...

class Floe:
    @property
    def record(self) -> FloeRecord: ...
    @property
    def id(self) -> int: ...
    @property
    def position(self) -> Floats: ...
    @property
    def rotation(self) -> Floats: ...
    @property
    def rings(self) -> list[Floats]: ...

class Frame:
    @property
    def time(self) -> float: ...
    @property
    def structure(self) -> Floats: ...
    @property
    def structure_rotation(self) -> Floats: ...
    @property
    def floes(self) -> list[Floe]: ...

class Results:
    @property
    def loads(self) -> Table: ...
    @property
    def events(self) -> Table: ...
    @property
    def splits(self) -> Table: ...
    @property
    def floes(self) -> list[FloeRecord]: ...
    @property
    def initial_sheet(self) -> list[Floats]: ...
    @property
    def final_sheet(self) -> list[Floats]: ...
    @property
    def n_frames(self) -> int: ...
    def frame(self, number: int) -> Frame: ...

def read_results(path: Path) -> Results: ...
def export_run(run: Path, format: str, output: Path | None = None) -> str: ...

class Run:
    @property
    def results(self) -> Results: ...
    @property
    def loads(self) -> Table: ...
    @property
    def events(self) -> Table: ...
    @property
    def summary(self) -> dict[str, Any]: ...
    @property
    def wall_seconds(self) -> float: ...

class Steps:
    @property
    def loads(self) -> Table: ...
    @property
    def events(self) -> Table: ...
    @property
    def splits(self) -> Table: ...
    @property
    def births(self) -> list[FloeRecord]: ...
    @property
    def deaths(self) -> list[tuple[int, str]]: ...

class Simulation:
    def __init__(self, case: Case, threads: int = 1) -> None: ...
    def step(
        self,
        n: int = 1,
        *,
        pose: tuple[ArrayLike, ArrayLike] | None = None,
        twist: tuple[ArrayLike, ArrayLike] | None = None,
    ) -> Steps: ...
    def frame(self) -> Frame: ...
    @property
    def time(self) -> float: ...
    @property
    def sheet(self) -> list[Polygon]: ...
    @property
    def ledger(self) -> dict[str, Fraction]: ...
    @property
    def sheet_motions(self) -> list[dict[str, Any]]: ...

def campaign(
    plan: Path,
    output: Path,
    jobs: int = 0,
    resume: bool = False,
    quick: bool = False,
    program: Path | None = None,
) -> dict[str, int]: ...

class Polygon:
    def __init__(self, outline: ArrayLike, holes: Sequence[ArrayLike] = ()) -> None: ...
    @staticmethod
    def read(value: PolygonLike) -> Polygon: ...
    @property
    def outline(self) -> Floats: ...
    @property
    def holes(self) -> list[Floats]: ...
    @property
    def area(self) -> float: ...
    @property
    def exact_area(self) -> Fraction: ...
    @property
    def centroid(self) -> Floats: ...
    @property
    def __geo_interface__(self) -> dict[str, Any]: ...
    def convex_parts(self) -> list[Floats]: ...
    def to_wkt(self) -> str: ...

class Cut:
    @property
    def pieces(self) -> list[Polygon]: ...
    @property
    def snap(self) -> Fraction: ...
    @property
    def n_rounded(self) -> int: ...

class Trapezoid:
    @property
    def depth(self) -> float: ...
    @property
    def contact_length(self) -> float: ...
    @property
    def angle(self) -> float: ...
    @property
    def error(self) -> float: ...
    @property
    def reidentified(self) -> bool: ...

class ContactRegion:
    @property
    def overlap(self) -> Polygon: ...
    @property
    def contact_length(self) -> float: ...
    @property
    def midpoint(self) -> Floats: ...
    @property
    def normal(self) -> Floats: ...

class IceSheet:
    def __init__(self, polygons: PolygonLike | Sequence[PolygonLike]) -> None: ...
    @property
    def area(self) -> float: ...
    @property
    def exact_area(self) -> Fraction: ...
    @property
    def n_vertices(self) -> int: ...
    def polygons(self) -> list[Polygon]: ...
    def contains(self, points: ArrayLike) -> bool | Bools: ...
    def cut(self, region: PolygonLike, cracks: LineLike | Sequence[LineLike] | ArrayLike | None = None) -> Cut: ...
    def cut_circumferential(
        self,
        centre: ArrayLike,
        radius: float,
        wedges: int = 4,
        angles: ArrayLike | None = None,
        sides: int = 16,
    ) -> Cut: ...
    def release_detached(self) -> list[Polygon]: ...
    def contacts(self, section: PolygonLike) -> list[ContactRegion]: ...
    def within(self, window: PolygonLike) -> list[Polygon]: ...
    def free_edge(self, at: ArrayLike, radius: float) -> list[Floats]: ...
    def to_wkt(self) -> str: ...
    def check(self) -> None: ...

class Map:
    @property
    def polygons(self) -> list[Polygon]: ...
    @property
    def kinds(self) -> list[str]: ...
    @property
    def ids(self) -> list[int]: ...
    @property
    def origin(self) -> tuple[Decimal, Decimal]: ...
    @property
    def crs(self) -> dict[str, Any] | None: ...
    @property
    def looks_like_degrees(self) -> bool: ...
    @property
    def sheet(self) -> list[Polygon]: ...
    @property
    def floes(self) -> list[Polygon]: ...
    def with_polygons(self, sheet: Sequence[PolygonLike], floes: Sequence[PolygonLike]) -> Map: ...
    def to_geojson(self) -> str: ...

def read_map(text: str, origin: Sequence[int | float | str | Decimal] | None = None) -> Map: ...
def pieces(pieces: Path | Sequence[PolygonLike], born: bool = False, picture: bool = False) -> dict[str, Any]: ...
class Union:
    @property
    def polygons(self) -> list[Polygon]: ...
    @property
    def given(self) -> Fraction: ...
    @property
    def united(self) -> Fraction: ...
    @property
    def overlap(self) -> Fraction: ...
    @property
    def snap(self) -> Fraction: ...
    @property
    def n_rounded(self) -> int: ...

def unite(polygons: PolygonLike | Sequence[PolygonLike]) -> Union: ...

class Repair:
    @property
    def polygons(self) -> list[Polygon]: ...
    @property
    def sources(self) -> list[int]: ...
    @property
    def changed(self) -> list[int]: ...
    @property
    def gone(self) -> list[int]: ...
    @property
    def faults(self) -> list[str]: ...
    @property
    def given(self) -> Fraction: ...
    @property
    def kept(self) -> Fraction: ...
    @property
    def overlap(self) -> Fraction: ...
    @property
    def folded(self) -> Fraction: ...
    @property
    def snap(self) -> Fraction: ...

def repair(polygons: PolygonLike | Sequence[PolygonLike]) -> Repair: ...
def fit_trapezoid(
    ice: IceSheet | Sequence[ArrayLike],
    at: ArrayLike,
    towards: ArrayLike,
    reach: float,
    contact_length: float = 0.0,
) -> Trapezoid: ...

class Response(NamedTuple):
    sigma_over_p: Floats
    lbreak_over_lc: Floats
    in_range: Bools

class FailureModel:
    def __init__(self, model: str = "network") -> None: ...
    def __call__(
        self,
        b_lc: ArrayLike,
        c_lc: ArrayLike,
        theta: ArrayLike,
        mu1: ArrayLike,
        mu2: ArrayLike,
        thickness_over_lc: ArrayLike | None = None,
    ) -> Response: ...

class Assessment(NamedTuple):
    fails: Bools
    sigma_max: Floats
    breaking_length: Floats
    in_range: Bools

class Criterion:
    def __init__(self, case: Case, model: str | None = None) -> None: ...
    def __call__(
        self,
        depth: ArrayLike,
        contact_length: ArrayLike,
        angle: ArrayLike,
        mu1: ArrayLike,
        mu2: ArrayLike,
        pressure: ArrayLike,
    ) -> Assessment: ...

class EdgeBreak(NamedTuple):
    load: Floats
    time: Floats
    deflection: Floats
    breaking_length: Floats
    radial_first: Bools
    in_range: Bools

class MovingEdge:
    def __init__(self, case: Case, model: str = "") -> None: ...
    def __call__(
        self,
        b_lc: ArrayLike,
        c_lc: ArrayLike,
        theta: ArrayLike,
        speed: ArrayLike,
        mu1: ArrayLike | None = None,
    ) -> EdgeBreak: ...

@overload
def characteristic_length(case: Case) -> float: ...
@overload
def characteristic_length(
    *,
    thickness: ArrayLike,
    youngs_modulus: ArrayLike,
    poisson_ratio: ArrayLike,
    water_density: ArrayLike,
    gravity: ArrayLike = ...,
) -> Number: ...

class LoadRatios(NamedTuple):
    horizontal: Floats
    mu1: Floats
    mu2: Floats

def load_ratios(slope: ArrayLike, friction: ArrayLike, heading: ArrayLike = 0.0) -> LoadRatios: ...

# A float, or an array of the common shape if an argument is one.
Number = Any

class CroasdaleLoad(NamedTuple):
    horizontal: Number
    vertical: Number
    breaking: Number
    pushing: Number
    ride_up: Number
    lifting: Number
    turning: Number
    in_plane_factor: Number
    force_ratio: Number
    crack_length: Number
    characteristic_length: Number

class RalstonLoad(NamedTuple):
    horizontal: Number
    vertical: Number
    breaking_horizontal: Number
    ride_horizontal: Number
    breaking_vertical: Number
    ride_vertical: Number
    radius_ratio: Number

class NevelLoad(NamedTuple):
    vertical: Number
    characteristic_length: Number
    in_range: Number

class CrushingLoad(NamedTuple):
    horizontal: Number
    pressure: Number

class KeelLoad(NamedTuple):
    horizontal: Number
    buoyancy: Number
    cohesion: Number

class RidgeLoad(NamedTuple):
    horizontal: Number
    layer: Number
    layer_pressure: Number
    keel: Number

class LindqvistLoad(NamedTuple):
    total: Number
    crushing: Number
    bending: Number
    submersion: Number

class RiskaLoad(NamedTuple):
    total: Number
    at_rest: Number
    per_speed: Number

class JeongLoad(NamedTuple):
    total: Number
    buoyancy: Number
    clearing: Number
    breaking: Number

def croasdale(
    *,
    slope: ArrayLike,
    width: ArrayLike,
    thickness: ArrayLike,
    flexural_strength: ArrayLike,
    youngs_modulus: ArrayLike,
    poisson_ratio: ArrayLike,
    friction_structure: ArrayLike,
    friction_ice: ArrayLike,
    ice_density: ArrayLike,
    water_density: ArrayLike,
    weight_density: ArrayLike = ...,
    rubble_height: ArrayLike = ...,
    rubble_porosity: ArrayLike = ...,
    rubble_cohesion: ArrayLike = ...,
    rubble_angle: ArrayLike = ...,
    rubble_friction_angle: ArrayLike = ...,
    gravity: ArrayLike = ...,
) -> CroasdaleLoad: ...
def ralston(
    *,
    breaking: str,
    yield_criterion: str = "tresca",
    slope: ArrayLike,
    waterline_width: ArrayLike,
    end_width: ArrayLike,
    thickness: ArrayLike,
    flexural_strength: ArrayLike,
    friction_structure: ArrayLike,
    ice_density: ArrayLike,
    water_density: ArrayLike,
    ride_thickness: ArrayLike = ...,
    gravity: ArrayLike = ...,
) -> RalstonLoad: ...
def nevel(
    *,
    wedge_angle: ArrayLike,
    loaded_length: ArrayLike,
    thickness: ArrayLike,
    flexural_strength: ArrayLike,
    youngs_modulus: ArrayLike,
    water_density: ArrayLike,
    gravity: ArrayLike = ...,
) -> NevelLoad: ...
def global_crushing(*, width: ArrayLike, thickness: ArrayLike, strength_coefficient: ArrayLike) -> CrushingLoad: ...
def keel(
    *,
    width: ArrayLike,
    keel_depth: ArrayLike,
    keel_porosity: ArrayLike,
    keel_cohesion: ArrayLike,
    keel_friction_angle: ArrayLike,
    ice_density: ArrayLike,
    water_density: ArrayLike,
    gravity: ArrayLike = ...,
) -> KeelLoad: ...
def ridge(
    *,
    width: ArrayLike,
    layer_thickness: ArrayLike,
    strength_coefficient: ArrayLike,
    keel_depth: ArrayLike,
    keel_porosity: ArrayLike,
    keel_cohesion: ArrayLike,
    keel_friction_angle: ArrayLike,
    ice_density: ArrayLike,
    water_density: ArrayLike,
    gravity: ArrayLike = ...,
) -> RidgeLoad: ...
def lindqvist(
    *,
    length: ArrayLike,
    breadth: ArrayLike,
    draught: ArrayLike,
    stem_angle: ArrayLike,
    waterline_angle: ArrayLike,
    speed: ArrayLike,
    thickness: ArrayLike,
    flexural_strength: ArrayLike,
    youngs_modulus: ArrayLike,
    poisson_ratio: ArrayLike,
    friction: ArrayLike,
    ice_density: ArrayLike,
    water_density: ArrayLike,
    gravity: ArrayLike = ...,
) -> LindqvistLoad: ...
def riska(
    *,
    length: ArrayLike,
    breadth: ArrayLike,
    draught: ArrayLike,
    midbody: ArrayLike,
    bow_length: ArrayLike,
    stem_angle: ArrayLike,
    thickness: ArrayLike,
    speed: ArrayLike,
) -> RiskaLoad: ...
def jeong(
    *,
    breadth: ArrayLike,
    draught: ArrayLike,
    thickness: ArrayLike,
    speed: ArrayLike,
    flexural_strength: ArrayLike,
    ice_density: ArrayLike,
    water_density: ArrayLike,
    buoyancy_factor: ArrayLike = ...,
    gravity: ArrayLike = ...,
) -> JeongLoad: ...
def breaking_length(
    *,
    thickness: ArrayLike,
    youngs_modulus: ArrayLike,
    poisson_ratio: ArrayLike,
    water_density: ArrayLike,
    gravity: ArrayLike = ...,
) -> Number: ...
def croasdale_of(case: Case) -> CroasdaleLoad: ...
def ralston_of(case: Case, yield_criterion: str = "tresca") -> RalstonLoad: ...
def nevel_of(case: Case, wedges: int) -> NevelLoad: ...
def global_crushing_of(case: Case, *, strength_coefficient: float) -> CrushingLoad: ...
def ridge_of(
    case: Case,
    *,
    layer_thickness: ArrayLike,
    strength_coefficient: ArrayLike,
    keel_depth: ArrayLike,
    keel_porosity: ArrayLike,
    keel_cohesion: ArrayLike,
    keel_friction_angle: ArrayLike,
    gravity: ArrayLike = ...,
) -> RidgeLoad: ...
def lindqvist_of(case: Case) -> LindqvistLoad: ...
def riska_of(case: Case) -> RiskaLoad: ...
def jeong_of(case: Case) -> JeongLoad: ...
def breaking_length_of(case: Case) -> float: ...

class Interval:
    lower: float
    upper: float

class Summary:
    n: int
    mean: float
    mean_95: Interval
    standard_deviation: float
    minimum: float
    maximum: float
    skewness: float
    excess_kurtosis: float
    quantile_1: float
    quantile_50: float
    quantile_95: float
    quantile_99: float
    autocorrelation_time: float
    effective_sample_size: float
    long_enough: bool

class Moments:
    n: int
    mean: float
    variance: float
    skewness: float
    excess_kurtosis: float
    minimum: float
    maximum: float

class AutocorrelationTime:
    tau: float
    window: int
    converged: bool

class Estimate:
    value: float
    interval: Interval

class Gumbel:
    location: float
    scale: float
    n: int

class GeneralisedPareto:
    threshold: float
    scale: float
    shape: float

class TestResult:
    statistic: float
    p_value: float

class MeanComparison:
    difference: float
    interval: Interval
    test: TestResult

def summarise(samples: ArrayLike, dt: float) -> Summary: ...
def moments(samples: ArrayLike) -> Moments: ...
def histogram(samples: ArrayLike, n_bins: int, lower: float, upper: float) -> tuple[Floats, Floats, int]: ...
def quantiles(samples: ArrayLike, levels: ArrayLike) -> Floats: ...
def autocorrelation(samples: ArrayLike, max_lag: int) -> Floats: ...
def autocorrelation_time(samples: ArrayLike, dt: float) -> AutocorrelationTime: ...
def welch_spectrum(samples: ArrayLike, dt: float, segment: int) -> tuple[Floats, Floats, float]: ...
def peaks_above(
    samples: ArrayLike, threshold: float, separation: int = 1
) -> tuple[NDArray[np.int64], Floats]: ...
def peaks_between_crossings(samples: ArrayLike, level: float) -> tuple[NDArray[np.int64], Floats]: ...
def block_maxima(samples: ArrayLike, block: int) -> Floats: ...
def fit_gumbel(samples: ArrayLike) -> Gumbel: ...
def fit_generalised_pareto(samples: ArrayLike, threshold: float) -> GeneralisedPareto: ...
@overload
def return_level(fit: Gumbel, return_period: float, confidence: float = 0.95) -> Estimate: ...
@overload
def return_level(
    fit: GeneralisedPareto, duration: float, return_period: float, confidence: float = 0.95
) -> Estimate: ...
def mean_interval(samples: ArrayLike, confidence: float = 0.95) -> Interval: ...
def batch_means_interval(samples: ArrayLike, n_batches: int, confidence: float = 0.95) -> Interval: ...
def bootstrap_interval(
    samples: ArrayLike,
    statistic: Callable[[Floats], float],
    block_length: int = 1,
    n_resamples: int = 1000,
    confidence: float = 0.95,
    seed: int = 1,
) -> Interval: ...
def sobol(n: int, dimension: int, seed: int = 1) -> Floats: ...
def kendall(x: ArrayLike, y: ArrayLike) -> TestResult: ...
def jonckheere_terpstra(groups: list[ArrayLike]) -> TestResult: ...
def mann_whitney(a: ArrayLike, b: ArrayLike) -> TestResult: ...
def holm(p_values: ArrayLike) -> Floats: ...
@overload
def compare_means(a: Summary, b: Summary, confidence: float = 0.95) -> MeanComparison: ...
@overload
def compare_means(a: ArrayLike, b: ArrayLike, confidence: float = 0.95) -> MeanComparison: ...

# A pandas.Series whose index is time [s], an xarray.DataArray along time, or (times, values); in a list, replicates.
HistoryLike = Any

class History(tuple[Floats, Floats]):
    name: str
    attrs: dict[str, str]
    def __new__(cls, times: ArrayLike, values: ArrayLike, name: str = "load", unit: str = "", start: str = "") -> History: ...
    @classmethod
    def read(cls, path: Path, column: str = "", **choice: Any) -> History: ...
    @property
    def times(self) -> Floats: ...
    @property
    def values(self) -> Floats: ...
    @property
    def unit(self) -> str: ...
    @property
    def start(self) -> str: ...
    def between(self, start: float, end: float) -> History: ...
    def stats(self, **settings: Any) -> dict[str, Any]: ...
    def extremes(self, return_period: float, **settings: Any) -> dict[str, Any]: ...
    def spectrum(self, segment: float = 0.0) -> dict[str, Floats]: ...
    def events(self, dead_band: float | None = None) -> dict[str, Floats]: ...
    def peaks(self, dead_band: float | None = None) -> History: ...
    def rainflow(self) -> tuple[Floats, Floats, Floats]: ...
    def compare(self, measured: HistoryLike) -> dict[str, Any]: ...
    def to_pandas(self) -> Any: ...

def read_history(path: Path, column: str = "", start: float | None = None, end: float | None = None, dt: float = 0.0,
                 as_: str = "numpy", missing: Sequence[float] = ()) -> Any: ...
def load_events(history: HistoryLike, dead_band: float | None = None) -> dict[str, Floats]: ...
def extremes(histories: HistoryLike, return_period: float, block: float = 0.0, threshold: float | None = None,
             dead_band: float | None = None, extrapolate: bool = False) -> dict[str, Any]: ...
def stats(history: HistoryLike, return_period: float = 3600.0, exponents: Sequence[float] = (), frequency: float = 1.0,
          extrapolate: bool = False) -> dict[str, Any]: ...
def spectrum(history: HistoryLike, segment: float = 0.0) -> dict[str, Floats]: ...
def rainflow(samples: ArrayLike) -> tuple[Floats, Floats, Floats]: ...
def compare(run: HistoryLike, measured: HistoryLike) -> dict[str, Any]: ...
def design(campaign: Path, column: str = "Fx", hours: Sequence[float] = (1.0,), scatter: Path | None = None,
           years: Sequence[float] = (1.0, 10.0, 50.0, 100.0), exponents: Sequence[float] = (), frequency: float = 1.0,
           where: str = "") -> dict[str, Any]: ...
def return_levels(states: Mapping[str, tuple[float, HistoryLike]],
                  years: Sequence[float] = (1.0, 10.0, 50.0, 100.0)) -> dict[str, Any]: ...
def resistance(campaign: Path, bollard_pull: float | None = None, open_water_speed: float | None = None,
               thrust: Path | None = None, at_speed: float = ...) -> dict[str, Any]: ...
