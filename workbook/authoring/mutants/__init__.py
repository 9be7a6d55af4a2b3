"""Mutants: right programs with one small fault each, to find out what the judge of an exercise lets through.

Operators make them from the syntax tree of a program, the real judge judges them, and a report in `tests/mutants/`
keeps those with full marks. Needs LibCST, which is a tool of authors (`make env EXTRAS=dev`).
"""
