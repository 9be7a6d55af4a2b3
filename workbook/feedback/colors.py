"""The colors of feedback: the palette for shapes, and for text a darker and a lighter variant of each color.

No color has 4.5:1 on white and on the ground of a dark theme at once. So text is colored by CSS variables, `TEXT`.
A card sets them where JupyterLab or VS Code names the theme, a page sets them for the theme of the browser. Where they
are not set, `var()` falls back on the theme's own text color. A sign or a word always says the same as the color.
"""

COLORS = {"passed": "#208a3c", "failed": "#dc3b3b", "partial": "#b06a00", "skipped": "#787878"}
"""Shapes, by the state of a criterion."""
ON_LIGHT = {"passed": "#17652c", "failed": "#ae2020", "partial": "#804d00", "skipped": "#565656"}
"""Text on a light ground, tinted or not."""
ON_DARK = {"passed": "#5fc97c", "failed": "#ff9a95", "partial": "#e5a545", "skipped": "#b4b4b4"}
"""Text on a dark ground, tinted or not."""
TEXT = {state: f"var(--workbook-{state})" for state in COLORS}
"""What the style of a text names: `color:var(--workbook-failed)`."""
TINT_SHARE = 0.14


def tint(state: str, share: float = TINT_SHARE) -> str:
    """The color of a state, so thin that it tints a light or a dark ground and text stays readable on it.

    `share`: a larger one is for grounds of text that is not colored itself.
    """
    color = COLORS[state]
    red, green, blue = (int(color[at : at + 2], 16) for at in (1, 3, 5))
    return f"rgba({red},{green},{blue},{share})"


TINTS = {state: tint(state) for state in COLORS}


def variables(colors: dict[str, str]) -> str:
    """Declarations that set the variables of `TEXT` to these colors."""
    return ";".join(f"--workbook-{state}:{color}" for state, color in colors.items())
