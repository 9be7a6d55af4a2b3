"""Define the colors of feedback: a palette for shapes, and a darker and a lighter variant of each color for text.

No color has a contrast of 4.5:1 both on white and on a dark theme's background. So the color of text comes from CSS
variables (see `TEXT`). A card sets these variables if JupyterLab or VS Code reports its theme; a web page sets them for
the browser's theme. If they aren't set, text inherits the theme's own color. A sign or word always repeats the color's
meaning.
"""

COLORS = {"passed": "#208a3c", "failed": "#dc3b3b", "partial": "#b06a00", "skipped": "#787878"}
"""The colors of shapes, by criterion state."""
ON_LIGHT = {
    "passed": "#17652c",
    "failed": "#ae2020",
    "partial": "#804d00",
    "skipped": "#565656",
    "timeline": "none",
}
"""The colors of text on a light background, tinted or not, and the CSS filter of the timeline."""
ON_DARK = {
    "passed": "#5fc97c",
    "failed": "#ff9a95",
    "partial": "#e5a545",
    "skipped": "#b4b4b4",
    "timeline": "invert(1) hue-rotate(180deg)",
}
"""The same on a dark background. The filter makes the timeline's dark labels light, and keeps its other hues."""
TEXT = {state: f"var(--workbook-{state})" for state in COLORS}
"""The values of the CSS property for text color, as in `color:var(--workbook-failed)`."""
TINT_SHARE = 0.14


def tint(state: str, share: float = TINT_SHARE) -> str:
    """Return the color for a state, transparent enough that text on the tinted background stays readable.

    `share`: the opacity, from 0 to 1. Use a higher opacity behind text that isn't itself colored.
    """
    color = COLORS[state]
    red, green, blue = (int(color[at : at + 2], 16) for at in (1, 3, 5))
    return f"rgba({red},{green},{blue},{share})"


TINTS = {state: tint(state) for state in COLORS}


def variables(colors: dict[str, str]) -> str:
    """Return CSS declarations that set the variables in `TEXT`, and the timeline's filter."""
    return ";".join(f"--workbook-{state}:{color}" for state, color in colors.items())
