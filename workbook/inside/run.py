"""Starts one of the files beside it without the rest of the workbook: `python -P run.py NAME ARGUMENT...`

The files of this folder import each other as `workbook.inside.NAME`, like everybody else. Here these names are made
from the files alone. They are forgotten before the file's `main` gets its arguments: a program that this process runs,
or becomes, finds the modules that it would find without them.
"""

import importlib
import importlib.util
import os
import sys
from importlib.machinery import ModuleSpec

FOLDER = os.path.dirname(os.path.abspath(__file__))
PACKAGES = ("workbook", "workbook.inside")


class SiblingFinder:
    """For `sys.meta_path`: the two packages without any code of their own, and the files of this folder."""

    def find_spec(self, name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        """Part of the import protocol: a file of this folder or one of its two packages; None for all other names."""
        if name in PACKAGES:
            return ModuleSpec(name, None, is_package=True)
        package, _, file = name.rpartition(".")
        if package != PACKAGES[-1]:
            return None
        return importlib.util.spec_from_file_location(name, os.path.join(FOLDER, f"{file}.py"))


def main(name: str, arguments: list[str]) -> None:
    """Call `main` of the file `name` with these arguments, after its sibling modules are taken out of `sys.modules`."""
    finder = SiblingFinder()
    sys.meta_path.insert(0, finder)
    sibling = importlib.import_module(f"{PACKAGES[-1]}.{name}")
    sys.meta_path.remove(finder)
    for loaded in [one for one in sys.modules if one.split(".")[0] == PACKAGES[0]]:
        del sys.modules[loaded]
    sibling.main(arguments)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
