"""The one palette. Every color has at least 4.2:1 against white and against the dark of JupyterLab (#111111)."""

GREEN = "#208a3c"
RED = "#dc3b3b"
AMBER = "#b06a00"
BLUE = "#2f78d0"
GREY = "#787878"
TEXT = "#737373"
"""Text in a picture: 4.7:1 on white. No color has 4.5:1 on a dark page as well, so those show pictures brighter."""
BRIGHTER_IN_THE_DARK = 1.3
"""By how much: `filter: brightness()` of JupyterLab's dark theme (`lab/front_end/panel/contrast.css`) and of pages."""

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
