"""Check an answer, and probes that use it, with mypy in a separate process that the answer can't influence.

Import `type_check`, `MypyOptions`, and `TypeCheckFailed` from `typecheck`. Before many checks, also call its
`warm_cache`.
"""
