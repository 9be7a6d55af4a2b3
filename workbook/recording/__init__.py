"""What was seen of a program, what to watch for, and what is said meanwhile, as data: the standard library only.

Every layer above may import its modules: `recording`, `plan`, `script` and `machine`.
"""
