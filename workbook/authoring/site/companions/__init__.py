"""Nodes that run next to a lesson's program while one of the site's robots is recorded.

Only the programs that `recordings.py` generates import them.
"""
