"""Define the palette of all drawings. Its colors have a contrast of at least 4.2:1 to white and to #111111.

JupyterLab's dark page has the color #111111.
"""

GREEN = "#208a3c"
RED = "#dc3b3b"
AMBER = "#b06a00"
BLUE = "#2f78d0"
GREY = "#787878"
TEXT = "#737373"
"""The color of text in a figure, with a contrast of 4.7:1 on white. No color reaches 4.5:1 on both a white and a dark
page, so dark pages brighten their figures.
"""
BRIGHTER_IN_THE_DARK = 1.3
"""The factor by which dark pages brighten figures, with the CSS filter `brightness()`. In JupyterLab,
`lab/front_end/panel/contrast.css` does so.
"""

CYCLE = (BLUE, AMBER, GREEN, RED, GREY)
"""The order in which a plot's lines take their colors."""


def rgba(color: str, alpha: float = 1.0) -> tuple[float, float, float, float]:
    """Return `"#rrggbb"` as four floats from 0 to 1."""
    return (
        int(color[1:3], 16) / 255,
        int(color[3:5], 16) / 255,
        int(color[5:7], 16) / 255,
        alpha,
    )
