from typing import Any, Callable, Iterable, Iterator, Mapping, NamedTuple, Optional, Sequence, Union

from .._katydid import Definition, StrPath

class Progress(NamedTuple):
    points: int
    had: int
    solved: int
    failed: int
    seconds: float

class Summary(NamedTuple):
    points: int
    had: int
    solved: int
    failed: int
    seconds: float
    files: list[str]

class StudyInput(NamedTuple):
    name: str
    low: Optional[float]
    high: Optional[float]
    step: Optional[float]
    choices: Optional[list[Any]]

class Table(Mapping[str, Any]):
    status: list[str]
    reason: list[str]
    @property
    def rows(self) -> int: ...
    @property
    def ok(self) -> list[bool]: ...
    def row(self, at: int) -> dict[str, Any]: ...
    def __getitem__(self, name: str) -> Any: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def to_pandas(self) -> Any: ...

Workers = Union[None, int, tuple[int, int]]

class Study:
    folder: str
    @property
    def inputs(self) -> list[StudyInput]: ...
    @property
    def outputs(self) -> list[str]: ...
    @property
    def points(self) -> int: ...
    def run(self, engine: str = "local", *, workers: Workers = None, address: Any = None,
            progress: Optional[Callable[[Progress], Any]] = None, options: Optional[Mapping[str, Any]] = None,
            grace: float = 30.0) -> Summary: ...
    def evaluate(self, points: Any, engine: str = "local", *, workers: Workers = None, address: Any = None,
                 options: Optional[Mapping[str, Any]] = None, grace: float = 30.0) -> Table: ...
    def table(self) -> Table: ...
    def write(self) -> None: ...
    def close(self) -> None: ...
    def __enter__(self) -> "Study": ...
    def __exit__(self, kind: Any, value: Any, trace: Any) -> None: ...

Names = Union[str, Iterable[str]]
Bounds = Optional[Mapping[str, float]]

class Problem:
    study: Study
    objectives: list[tuple[str, float]]
    constraints: list[tuple[str, float, float]]
    def __init__(self, study: Study, minimise: Names = (), maximise: Names = (), at_most: Bounds = None,
                 at_least: Bounds = None, **how: Any) -> None: ...
    @property
    def inputs(self) -> list[StudyInput]: ...
    def evaluate(self, points: Any) -> tuple[list[list[float]], list[list[float]]]: ...
    def scalar(self, points: Any) -> list[float]: ...

class cma_objective:
    x0: list[float]
    sigma0: float
    options: dict[str, Any]
    def __init__(self, study: Study, minimise: Names = (), maximise: Names = (), at_most: Bounds = None,
                 at_least: Bounds = None, **how: Any) -> None: ...
    def point(self, place: Sequence[float]) -> dict[str, float]: ...
    def __call__(self, places: Any) -> Any: ...

def study(definition: Union[StrPath, Definition], plan: Union[StrPath, Mapping[str, Any]], folder: Optional[StrPath] = None, *,
          set: Optional[Mapping[str, Any]] = None, model: Optional[StrPath] = None, units: Optional[str] = None,
          lenient: bool = False, allow_scripts: bool = False, python: Optional[StrPath] = None,
          time_limit: Optional[float] = None, byte_limit: Optional[int] = None, retry: bool = False,
          words: Sequence[str] = ()) -> Study: ...
def pymoo_problem(study: Study, minimise: Names = (), maximise: Names = (), at_most: Bounds = None, at_least: Bounds = None, *,
                  mixed: Optional[bool] = None, **how: Any) -> Any: ...
def optuna_trials(optuna_study: Any, study: Study, minimise: Names = (), maximise: Names = (), at_most: Bounds = None,
                  at_least: Bounds = None, *, trials: int = 100, batch: int = 8, **how: Any) -> Any: ...
