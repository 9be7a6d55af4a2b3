"""Define recordings, plans, and scripts as data, with the standard library only.

Every layer above may import its modules: `recording`, `plan`, `script`, and `machine`.
"""
