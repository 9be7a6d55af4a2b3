"""Draw the twelve joint angles as a table next to the robot."""

import math
from collections.abc import Sequence

from workbook.pictures.canvas import Canvas, Font, Paint
from workbook.pictures.joints import COMFORTABLE, JOINT_NAMES
from workbook.pictures.palette import AMBER, BLUE, GREY, RED

TABLE_WIDTH = 284


def joint_table(canvas: Canvas, pose: Sequence[float] | None, at: float) -> None:
    """Draw twelve angles (rad), starting at `at` (px): index, name, a gauge from -π to π, and the number.

    A thick line in the gauge marks the comfortable range. If `pose` is None, dashes replace the numbers.
    """
    left, gauge, number = at + 4.0, at + 138.0, at + TABLE_WIDTH - 8.0
    half = 34.0
    canvas.text((left, 26), "joint", Font(size=11.5, bold=True))
    canvas.text((gauge + half, 26), "−π … π", Font(size=11.5, bold=True), align="center")
    canvas.text((number, 26), "rad", Font(size=11.5, bold=True), align="right")
    for index, name in enumerate(JOINT_NAMES):
        y = 52.0 + index * 29
        low, high = COMFORTABLE[name]
        canvas.text((left + 14, y), str(index), Font(size=11.5), align="right")
        canvas.text((left + 22, y), name.replace("_", " "), Font(size=12.5))
        canvas.line([(gauge, y - 4), (gauge + 2 * half, y - 4)], Paint(width=1.6, alpha=0.7))
        start, end = (gauge + half * (1 + bound / math.pi) for bound in (low, high))
        canvas.line([(start, y - 4), (end, y - 4)], Paint(width=5, alpha=0.4))
        canvas.line([(gauge + half, y - 9), (gauge + half, y + 1)], Paint(width=1.2, alpha=0.7))
        if pose is None:
            canvas.text((number, y), "–", Font(size=12.5), align="right")
            continue
        angle = pose[index]
        sign, color = (
            ("✗", RED) if abs(angle) > math.pi else ("!", AMBER) if not low <= angle <= high else ("", BLUE)
        )
        needle = gauge + half * (1 + max(-1.0, min(1.0, angle / math.pi)))
        canvas.disc((needle, y - 4), 5, Paint(fill=color))
        value = f"{angle:+.2f}" if abs(angle) < 100 else f"{angle:+.0e}"
        canvas.text(
            (number, y),
            value.replace("-", "−"),
            Font(size=12.5, color=color if sign else GREY),
            align="right",
        )
        canvas.text((gauge + 2 * half + 6, y), sign, Font(size=12.5, bold=True, color=color))
