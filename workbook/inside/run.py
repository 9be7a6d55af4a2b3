"""Start a file of this folder without loading the rest of the package `workbook`.

The command is `python -P run.py NAME ARGUMENT...`.

Like all other modules, the files in this folder import each other as `workbook.inside.NAME`. This script makes those
imports work without the package. It removes the modules from `sys.modules` before it calls the file's `main`. So a
program that runs in this process later doesn't find them there.
"""

import importlib
import importlib.util
import os
import sys
from importlib.machinery import ModuleSpec

FOLDER = os.path.dirname(os.path.abspath(__file__))
PACKAGES = ("workbook", "workbook.inside")


class SiblingFinder:
    """A finder for `sys.meta_path`. It finds this folder's files, and empty packages in place of the two real ones."""

    def find_spec(self, name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        """Return the spec of a file in this folder or of an empty package, or None for any other name.

        Part of the import protocol.
        """
        if name in PACKAGES:
            return ModuleSpec(name, None, is_package=True)
        package, _, file = name.rpartition(".")
        if package != PACKAGES[-1]:
            return None
        return importlib.util.spec_from_file_location(name, os.path.join(FOLDER, f"{file}.py"))


def main(name: str, arguments: list[str]) -> None:
    """Import the file `name`, remove our modules from `sys.modules`, and call the file's `main`."""
    finder = SiblingFinder()
    sys.meta_path.insert(0, finder)
    sibling = importlib.import_module(f"{PACKAGES[-1]}.{name}")
    sys.meta_path.remove(finder)
    for loaded in [one for one in sys.modules if one.split(".")[0] == PACKAGES[0]]:
        del sys.modules[loaded]
    sibling.main(arguments)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
