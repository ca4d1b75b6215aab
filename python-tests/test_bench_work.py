"""That the benchmark of whole work tells wrong answers and steep growth: what it is trusted for."""

import math
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "benches" / "work"))

import answers
import definitions
import table
from measure import Taken

ROW = definitions.Row("A row", "", "", 1000, within=1e-3)


@pytest.mark.parametrize(
    "ours",
    [
        {},
        {"b": [1, 2, 3]},
        {"a": [1, 2]},
        {"a": [1, 2.01, 3]},
        {"a": [1, None, 3]},
        {"a": [1, math.nan, 3]},
        {"a": [1, "2", 3]},
    ],
)
def test_wrong_answers(ours):
    assert answers.difference(ROW, ours, {"a": [1, 2, 3]}) is not None


def test_right_answers():
    assert answers.difference(ROW, {"a": [1.001, 2.002, 3]}, {"a": [1, 2, 3]}) is None
    assert answers.difference(ROW, {"a": ["x"]}, {"a": ["x"]}) is None
    assert answers.difference(ROW, {"a": ["x"]}, {"a": ["y"]}) is not None


def measured(row, power):
    taken = [Taken(0.5 + (size / 1000) ** power, 10.0) for size in row.sizes()]
    return table.Measured(row, taken, Taken(0.5, 10.0), [0.5, 1.0])


def test_exponents_are_those_beyond_start_up():
    for power in (1, 1.5, 2):
        assert measured(ROW, power).exponent() == pytest.approx(power)
    assert "above" in table.line(table.cells(measured(ROW, 1.5)))
    assert "above" not in table.line(table.cells(measured(ROW, 1.05)))


def test_a_logarithm_is_allowed_where_things_are_sorted():
    sorting = definitions.Row("A row", "", "", 1000, sorting=True)
    growth = SimpleNamespace(row=sorting)
    logarithm = math.log(4000 * math.log(4000) / (1000 * math.log(1000))) / math.log(4)
    assert table.Measured.limit(growth) == pytest.approx(0.1 + logarithm)


def test_rows_have_names_of_their_own():
    names = [row.name for row in definitions.ROWS]
    assert len(names) == len(set(names)) >= 30
