"""The lessons and the cards in a real browser. A package: JupyterLab, Chromium and Playwright end with it."""
