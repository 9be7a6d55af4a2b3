"""Format numbers that vary from run to run, and check lines of code that the reader writes."""

import math
from typing import Any

MARK = "≈"
UNUSUAL = "unusual on this machine"
_REMINDER = "Replace each ... with your code, then run this cell again."
_TOLERANCE = 1e-6


def about(value: float, unit: str = "", *, between: tuple[float, float], digits: int = 2) -> str:
    """Format a number that varies from run to run, with "≈": `about(23.1, "ms", between=(5, 60))` is `≈ 23 ms`.

    `digits` is the number of significant digits. If the number is outside of the range `between`, the text adds
    "unusual on this machine". When notebooks are compared, any two numbers with "≈" count as equal, but a number with
    this remark doesn't equal one without it.

    Raise ValueError if the range is empty.
    """
    low, high = between
    if not low < high:
        raise ValueError(f"the range must go from a smaller number to a larger one, not from {low} to {high}")
    text = f"{MARK} {_rounded(float(value), digits)}"
    if unit:
        text += unit if unit in ("°", "%") else f" {unit}"
    return text if low <= value <= high else f"{text} ({UNUSUAL})"


def yours(got: Any, wanted: Any, hint: str = "") -> None:
    """Check the value that your line of code gives, and print the result.

    If `got` still contains `...`, print a reminder to replace it. Otherwise, print whether `got` equals `wanted` and,
    if not, also the `hint`. Floats, including those in tuples and lists, may differ by rounding errors. If `wanted` is
    a list, `got` may also be an array.
    """
    if _is_blank(got):
        print(_REMINDER)
    elif _same(got, wanted):
        print(f"✓ Correct: {_shown(got)}.")
    else:
        print(f"Not yet. Your line gives {_shown(got)}; expected: {_shown(wanted)}.")
        if hint:
            print(f"Try: {hint}")


def _rounded(value: float, digits: int) -> str:
    if not math.isfinite(value) or value == 0.0:
        return f"{value:.0f}"
    decimals = digits - 1 - math.floor(math.log10(abs(value)))
    rounded = round(value, decimals)
    if rounded and abs(rounded) >= 10 ** (digits - decimals):  # 9.97 became 10.0
        decimals -= 1
    return f"{rounded:,.{max(decimals, 0)}f}"


def _is_blank(got: Any) -> bool:
    if isinstance(got, dict):
        got = [*got, *got.values()]
    return got is ... or (isinstance(got, tuple | list) and any(_is_blank(one) for one in got))


def _same(got: Any, wanted: Any) -> bool:
    if isinstance(wanted, list) and hasattr(got, "tolist"):  # an array counts as a list
        got = got.tolist()
    if isinstance(wanted, tuple | list):
        return (
            isinstance(got, tuple | list)
            and len(got) == len(wanted)
            and all(_same(one, other) for one, other in zip(got, wanted, strict=True))
        )
    if isinstance(wanted, float):
        try:
            return math.isclose(got, wanted, rel_tol=_TOLERANCE, abs_tol=_TOLERANCE)
        except TypeError:
            return False
    try:
        return bool(got == wanted)
    except ValueError:  # comparing arrays doesn't give a single bool
        return False


def _shown(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, tuple):
        return f"({', '.join(map(_shown, value))}{',' if len(value) == 1 else ''})"
    return repr(value) if isinstance(value, str) else str(value)
