"""What mypy says of an answer and of probes that use it, in a process that has mypy loaded and cannot be influenced.

Import `typecheck`: `type_check`, `MypyOptions`, `TypeCheckFailed`, and `warm_cache` before many checks.
"""
