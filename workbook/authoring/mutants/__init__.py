"""Mutation testing of an exercise's judge. A mutant is a right answer with one small fault.

Operators generate mutants from a program's syntax tree, and the real judge judges them. The reports in `tests/mutants/`
list the survivors, which got full marks. This package needs LibCST from the authors' extra (`make env EXTRAS=dev`).
"""
