"""Check an answer, and probes that use it, with mypy in a separate process that the answer can't influence.

Import `typecheck`: `type_check`, `MypyOptions`, `TypeCheckFailed`, and `warm_cache` before many checks.
"""
