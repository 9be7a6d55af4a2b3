"""Lessons and cards in a real browser. In this package, tests share a JupyterLab and a Chromium, which end with it."""
