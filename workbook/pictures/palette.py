"""The one palette. Every color has at least 4.2:1 against white and against the dark of JupyterLab (#111111)."""

GREEN = "#208a3c"
RED = "#dc3b3b"
AMBER = "#b06a00"
BLUE = "#2f78d0"
GREY = "#787878"

CYCLE = (BLUE, AMBER, GREEN, RED, GREY)
"""Order in which lines of a plot take their colors."""


def rgba(color: str, alpha: float = 1.0) -> tuple[float, float, float, float]:
    """`"#rrggbb"` as four floats from 0 to 1."""
    return (
        int(color[1:3], 16) / 255,
        int(color[3:5], 16) / 255,
        int(color[5:7], 16) / 255,
        alpha,
    )
