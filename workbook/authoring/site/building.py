"""Build the site: write the sources, run Sphinx, and remove the files that no page needs."""

import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

from workbook.authoring.site.sources import write_sources
from workbook.authoring.tree import AuthoringError, Tree

NOT_NEEDED = (".buildinfo", "objects.inv", "_sources")


def build_site(tree: Tree, folder: Path) -> int:
    """Write the site to `folder`, replacing any existing site there. Return the number of pages.

    This function doesn't need a network, and doesn't run any of the course's programs. Raises AuthoringError if Sphinx
    isn't installed, or if it reports errors or warnings.
    """
    if find_spec("myst_nb") is None:
        raise AuthoringError("the site needs Sphinx and MyST-NB: run `make env EXTRAS=site`")
    work = folder.with_name(f"{folder.name}-work")
    shutil.rmtree(work, ignore_errors=True)
    write_sources(tree, work / "sources")
    command = [sys.executable, "-m", "sphinx", "-b", "html", "-q", "-W", "--keep-going", "-j", "2"]
    places = ["-d", work / "doctrees", work / "sources", work / "pages"]
    if subprocess.run([*command, *map(str, places)], cwd=tree.root).returncode:
        raise AuthoringError("Sphinx complained; the lines above say where")
    for name in NOT_NEEDED:
        path = work / "pages" / name
        shutil.rmtree(path) if path.is_dir() else path.unlink(missing_ok=True)
    shutil.rmtree(folder, ignore_errors=True)
    (work / "pages").rename(folder)
    shutil.rmtree(work)
    return sum(1 for _ in folder.rglob("*.html"))
