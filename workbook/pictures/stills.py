"""Show an image along with a text description."""

import base64
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from workbook.pictures.png import data_uri, img_tag, size_on_screen

MimeBundle = tuple[dict[str, str], dict[str, Any]]


@dataclass(frozen=True)
class Still:
    """A PNG image with its description. JupyterLab displays it if it's the value of a cell's last expression.

    The description is the alternative text. Keep measured numbers out of it, because notebook checks compare it.
    """

    png: bytes
    description: str

    def __post_init__(self) -> None:
        size_on_screen(self.png)  # fails right away if these bytes aren't a PNG image
        if not self.description.strip():
            raise ValueError("a figure needs a description: those who cannot see it get this text instead")

    def __repr__(self) -> str:
        return f"Picture: {self.description}"

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> MimeBundle:
        # JupyterLab drops the alternative text of image/png, so it gets the image as an <img> as well. Exports and
        # viewers that don't show HTML use image/png.
        width, height = size_on_screen(self.png)
        bundle = {
            "text/plain": repr(self),
            "text/html": img_tag(self.png, self.description),
            "image/png": base64.b64encode(self.png).decode("ascii"),
        }
        return bundle, {"image/png": {"alt": self.description, "width": width, "height": height}}

    def data_uri(self) -> str:
        """Return the image as text for `src="…"`."""
        return data_uri(self.png)

    def save(self, path: str | Path) -> Path:
        """Write the image to a file and return its path."""
        target = Path(path)
        target.write_bytes(self.png)
        return target
