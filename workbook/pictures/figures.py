"""Style the lessons' matplotlib figures: a transparent background, and readable on light and dark pages."""

import io
import sys
from contextlib import AbstractContextManager
from typing import Any

import matplotlib
import numpy as np
from cycler import cycler
from matplotlib.axis import Axis
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.legend import Legend
from matplotlib.spines import Spine
from matplotlib.text import Text

from workbook.pictures.palette import CYCLE, GREY, TEXT
from workbook.pictures.png import Pixels, encode_faithfully
from workbook.pictures.stills import Still

DOTS_PER_INCH = 192
"""The resolution of figures: 96 page pixels per inch, drawn with two dots per pixel."""

LOOK: Any = {
    "figure.facecolor": "none",
    "axes.facecolor": "none",
    "savefig.facecolor": "none",
    "axes.edgecolor": GREY,
    "axes.labelcolor": TEXT,
    "axes.titlecolor": TEXT,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": GREY,
    "grid.alpha": 0.25,
    "text.color": TEXT,
    "xtick.color": TEXT,
    "ytick.color": TEXT,
    "legend.frameon": False,
    "font.family": "DejaVu Sans",
    "font.size": 10,
    "axes.prop_cycle": cycler(color=list(CYCLE)),
}


def style() -> AbstractContextManager[None]:
    """Apply the lessons' style to all figures in a `with` block.

    For example: `with pictures.style(): fig, ax = plt.subplots()`.
    """
    return matplotlib.rc_context(LOOK)


def figure(width: float = 6.4, height: float = 3.0, rows: int = 1, columns: int = 1) -> tuple[Figure, Any]:
    """Return a new figure in the lessons' style, and its axes (an array if there are several).

    `width` and `height` are in inches. The figure doesn't use pyplot, so it's neither shown twice nor kept in memory.
    """
    with style():
        fig = Figure(figsize=(width, height), layout="constrained")
        return fig, fig.subplots(rows, columns)


def render(fig: Figure) -> bytes:
    """Return a figure as PNG bytes, cropped to its content. Black turns gray, so that it's visible on a dark page."""
    _make_readable(fig)
    drawn = _Drawn()
    with style():
        fig.savefig(
            drawn, format="rgba", dpi=DOTS_PER_INCH, transparent=True, bbox_inches="tight", pad_inches=0.06
        )
    return encode_faithfully(drawn.pixels, dots_per_pixel=DOTS_PER_INCH / 96)


class _Drawn(io.BytesIO):
    """A file-like object for matplotlib's "rgba" format, which is written in one piece.

    `pixels` has the shape (height, width, 4).
    """

    pixels: Pixels

    def write(self, drawn: Any) -> int:
        self.pixels = np.array(drawn, dtype=np.uint8)
        return self.pixels.nbytes


def still(picture: Figure | bytes, description: str) -> Still:
    """Return a matplotlib figure or PNG bytes as a still. `description` is its alternative text."""
    if isinstance(picture, bytes):
        return Still(picture, description)
    png = render(picture)
    pyplot = sys.modules.get("matplotlib.pyplot")
    if pyplot is not None:
        pyplot.close(picture)  # otherwise, the notebook shows the figure again at the end of the cell
    return Still(png, description)


def show(picture: Figure | bytes, description: str) -> None:
    """Show a matplotlib figure or PNG bytes in the cell. `description` is the alternative text."""
    from IPython.display import display

    display(still(picture, description))


def _make_readable(fig: Figure) -> None:
    for artist in fig.findobj():
        if isinstance(artist, Text):
            if _is_black(artist.get_color()):
                artist.set_color(TEXT)
        elif isinstance(artist, Spine):
            if _is_black(artist.get_edgecolor()):
                artist.set_edgecolor(GREY)
        elif isinstance(artist, Legend):
            artist.get_frame().set_alpha(0.0)
        elif isinstance(artist, Axis) and any(_is_black(line.get_color()) for line in artist.get_ticklines()):
            artist.set_tick_params(which="both", color=GREY, labelcolor=TEXT)


def _is_black(color: Any) -> bool:
    try:
        return max(to_rgb(color)) < 0.05
    except ValueError:
        return False
