"""Type-check an answer with mypy in a separate process that the answer can't influence.

Together with the answer, mypy can check *probes*, which are short programs that use the answer.

Import `type_check`, `MypyOptions`, and `TypeCheckFailed` from `typecheck`. Before many checks, also call `warm_cache`
from that module.
"""
