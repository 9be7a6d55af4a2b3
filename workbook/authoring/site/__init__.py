"""Build the course's website, which works without a kernel. `make site` writes it to `build/site`.

`sources.py` writes the sources, and Sphinx and MyST-NB render them. Other packages import only `build_site`.
"""

from workbook.authoring.site.building import build_site

__all__ = ["build_site"]
