import base64
import subprocess
import sys

import numpy as np
import pytest

from tests.pictures.reading import pixels
from workbook.pictures import png
from workbook.pictures.stills import Still


def square(color: tuple[int, int, int, int] = (32, 138, 60, 255)) -> bytes:
    dots = np.zeros((20, 40, 4), np.uint8)
    dots[5:15, 10:30] = color
    return png.encode(dots, dots_per_pixel=2)


def test_a_picture_comes_back_as_it_was() -> None:
    back = pixels(square())
    assert back.shape == (20, 40, 4)
    assert back[10, 20].tolist() == [32, 138, 60, 255]
    assert back[0, 0, 3] == 0


def test_its_size_on_screen_is_half_its_dots() -> None:
    assert png.size(square()) == (40, 20)
    assert png.size_on_screen(square()) == (20, 10)


def test_a_picture_without_resolution_is_shown_dot_by_dot() -> None:
    bare = png.encode(np.zeros((4, 6, 4), np.uint8))
    at = bare.index(b"pHYs") - 4
    assert png.size_on_screen(bare[:at] + bare[at + 21 :]) == (6, 4)


@pytest.mark.parametrize("damaged", [b"", b"<svg/>", b"\x89PNG\r\n\x1a\n1234abcd"])
def test_other_bytes_are_refused(damaged: bytes) -> None:
    with pytest.raises(ValueError, match="not a PNG image"):
        Still(damaged, "nothing")


def test_pixels_without_alpha_are_refused() -> None:
    with pytest.raises(ValueError, match="RGBA"):
        png.encode(np.zeros((4, 6, 3), np.uint8))


def test_a_still_carries_its_description_everywhere() -> None:
    still = Still(square(), 'humanoid "waving" <12 joints>')
    data, metadata = still._repr_mimebundle_()
    assert data["text/plain"] == repr(still) == 'Picture: humanoid "waving" <12 joints>'
    assert 'alt="humanoid &#34;waving&#34; &lt;12 joints&gt;"' in data["text/html"]
    assert 'width="20" height="10"' in data["text/html"]
    assert base64.b64decode(data["image/png"]) == still.png
    assert metadata["image/png"] == {"alt": still.description, "width": 20, "height": 10}


def test_a_still_without_description_is_refused() -> None:
    with pytest.raises(ValueError, match="needs a description"):
        Still(square(), "  ")


def test_a_still_can_be_saved(tmp_path: object) -> None:
    target = Still(square(), "green square").save(f"{tmp_path}/square.png")
    assert target.read_bytes() == square()


def test_the_small_parts_do_not_import_matplotlib() -> None:
    program = (
        "import sys; from workbook import pictures; pictures.marks.tiny([1.0], end=2.0); pictures.Still; "
        "pictures.animate; pictures.Follower; print('matplotlib' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"


def test_every_exported_name_is_there() -> None:
    from workbook import pictures

    for name in pictures.__all__:
        assert getattr(pictures, name) is not None
    with pytest.raises(AttributeError, match="has no attribute 'movie'"):
        pictures.movie  # noqa: B018
