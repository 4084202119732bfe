"""Values of a case that are given as objects of Python."""

from __future__ import annotations

import enum
import json
from collections import OrderedDict
from collections.abc import Iterator, Mapping
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from peristat._case import json_of


class Unit(str, enum.Enum):
    MM = "mm-N-MPa"


class Pair(Mapping[str, int]):
    def __getitem__(self, key: str) -> int:
        return {"a": 1, "b": 2}[key]

    def __iter__(self) -> Iterator[str]:
        return iter("ab")

    def __len__(self) -> int:
        return 2


@pytest.mark.parametrize(
    "value",
    [
        {},
        [],
        None,
        {"a": [1, -2, 3.5, True, False, None], "b": {"c": "d"}},
        {"text": 'quotes " and \\, lines \n, control \x01, é, 漢, 😀, \u2028'},
        [0.1, -0.0, 1e22, 1e-300, 5e-324, 1.7976931348623157e308, 200000000000.0],
        [0, 2**53 + 1, -(2**63), 2**64, 10**40],
        ((1, 2), [3, (4,)]),
        OrderedDict(b=1, a=2),
        {"units": Unit.MM},
    ],
)
def test_text_is_that_of_the_encoder_of_python(value: Any) -> None:
    assert json.loads(json_of(value)) == json.loads(json.dumps(value))


def test_text_looks_as_a_person_writes_it() -> None:
    assert json_of({"a": [1, 2.5], "b": True, "c": None}) == '{"a": [1, 2.5], "b": true, "c": null}'


@pytest.mark.parametrize(
    ("value", "plain"),
    [
        (np.float32(0.5), 0.5),
        (np.float64(0.1), 0.1),
        (np.int16(-3), -3),
        (np.bool_(True), True),
        (np.array([[1, 2], [3, 4]]), [[1, 2], [3, 4]]),
        (Decimal("0.25"), 0.25),
        (Fraction(1, 4), 0.25),
        (Path("a") / "b.csv", "a/b.csv"),
        (Pair(), {"a": 1, "b": 2}),
    ],
)
def test_values_of_other_libraries_are_numbers_and_lists(value: Any, plain: Any) -> None:
    assert json.loads(json_of({"key": [value]})) == {"key": [plain]}


@pytest.mark.parametrize("value", [float("nan"), float("inf"), np.float64("-inf"), np.array([1, np.nan]), Decimal("NaN")])
def test_numbers_are_finite(value: Any) -> None:
    with pytest.raises(ValueError, match="finite numbers, found"):
        json_of([value])


def test_what_json_has_no_value_for_is_refused() -> None:
    with pytest.raises(TypeError, match="found <object"):
        json_of({"a": object()})
    with pytest.raises(TypeError, match="keys of a case are texts, found 1"):
        json_of({1: 2})
    with pytest.raises(UnicodeEncodeError):
        json_of("\ud800")
    itself: list[Any] = []
    itself.append(itself)
    with pytest.raises(ValueError, match="contain itself"):
        json_of(itself)


def test_a_dictionary_may_change_while_it_is_read() -> None:
    case: dict[str, Any] = {}

    class Growing(Mapping[str, int]):
        def __getitem__(self, key: str) -> int:
            raise KeyError

        def __iter__(self) -> Iterator[str]:
            case["more"] = 2
            return iter(())

        def __len__(self) -> int:
            return 0

    case["a"] = Growing()
    assert json.loads(json_of(case)) == {"a": {}}
