"""Define recordings, plans, and scripts as data, with the standard library only.

Every package of a higher layer may import the modules `recording`, `plan`, `script`, and `machine`.
"""
