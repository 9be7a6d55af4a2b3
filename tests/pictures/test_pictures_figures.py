import io
from pathlib import Path

import matplotlib
import numpy as np
import pytest
from matplotlib.figure import Figure
from PIL import Image

import workbook.grading
from tests.pictures.reading import pixels
from workbook import pictures
from workbook.lab.jupyter_files import FRONT_END
from workbook.pictures import palette, png

TEMPLATES = Path(workbook.grading.__file__).with_name("templates")


def dark(picture: bytes) -> int:
    """Return how many opaque pixels are too dark to be visible on a dark page."""
    image = pixels(picture)
    return int(np.count_nonzero((image[..., :3].max(axis=2) < 60) & (image[..., 3] > 128)))


def contrast(color: str, page: str) -> float:
    def luminance(name: str) -> float:
        parts = [value / 12.92 if value <= 0.03928 else ((value + 0.055) / 1.055) ** 2.4
                 for value in palette.rgba(name)[:3]]  # fmt: skip
        return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]

    light, low = sorted((luminance(color), luminance(page)), reverse=True)
    return (light + 0.05) / (low + 0.05)


@pytest.mark.parametrize("page", ["#ffffff", "#111111"])
@pytest.mark.parametrize("color", palette.CYCLE)
def test_every_color_reads_on_both_pages(color: str, page: str) -> None:
    assert contrast(color, page) > 4.1


def test_text_in_a_picture_reads_on_both_pages() -> None:
    assert contrast(palette.TEXT, "#ffffff") >= 4.5
    part = min(1.0, palette.rgba(palette.TEXT)[0] * palette.BRIGHTER_IN_THE_DARK)
    brighter = "#" + 3 * f"{round(255 * part):02x}"
    assert min(contrast(brighter, page) for page in ("#111111", "#121212", "#212121")) >= 4.5
    rule = f"filter: brightness({palette.BRIGHTER_IN_THE_DARK})"
    assert rule in (FRONT_END / "panel" / "contrast.css").read_text()
    assert rule.replace(": ", ":") in (TEMPLATES / "page.html.j2").read_text()


def test_a_figure_of_ours_is_transparent_and_has_nothing_dark() -> None:
    fig, ax = pictures.figure(4, 2)
    ax.plot([0, 1, 2], [1, 3, 2], label="battery")
    ax.set_title("Battery")
    ax.legend()
    picture = pictures.render(fig)
    assert pixels(picture)[2, 2, 3] == 0
    assert dark(picture) == 0
    assert png.size_on_screen(picture)[0] == pytest.approx(4 * 96, abs=30)


def test_a_plain_matplotlib_figure_is_made_readable() -> None:
    fig = Figure(figsize=(4, 2))
    ax = fig.subplots()
    ax.plot([0, 1], [1, 0], label="line")
    ax.set_xlabel("time (s)")
    ax.legend()
    assert dark(pictures.render(fig)) == 0


def test_the_style_ends_with_its_block() -> None:
    before = matplotlib.rcParams["text.color"]
    with pictures.style():
        assert matplotlib.rcParams["text.color"] == palette.TEXT
    assert matplotlib.rcParams["text.color"] == before


def test_a_pyplot_figure_is_closed_so_that_it_is_not_shown_twice() -> None:
    matplotlib.use("agg")
    import matplotlib.pyplot as plt

    with pictures.style():
        fig, ax = plt.subplots()
        ax.plot([0, 1])
    still = pictures.still(fig, "a rising line")
    assert plt.get_fignums() == []
    assert repr(still) == "Picture: a rising line"


def test_several_axes() -> None:
    _, axes = pictures.figure(rows=2, columns=1)
    assert axes.shape == (2,)


def test_bytes_stay_as_they_are() -> None:
    picture = pictures.humanoid.placeholder()
    assert pictures.still(picture, "robot asleep").png is picture


def test_a_plot_gets_smaller_and_a_color_map_keeps_its_colors() -> None:
    fig, ax = pictures.figure()
    for phase in range(4):
        ax.plot(np.sin(np.linspace(0, 9, 100) + phase))
    plot = pictures.render(fig)
    assert Image.open(io.BytesIO(plot)).mode == "P"
    assert png.size_on_screen(plot)[0] == pytest.approx(6.4 * 96, abs=40)
    dots = np.random.default_rng(7).integers(0, 255, (64, 64, 4), dtype=np.uint8)
    dots[..., 3] = 255
    kept = Image.open(io.BytesIO(png.encode_faithfully(dots)))
    assert np.array_equal(np.asarray(kept), dots)
