"""Create the environment, launch JupyterLab, set up kernels, and update the student's copy of the notebooks.

This package is a face: only `cli` and `authoring` import from it. `bootstrap` runs before anything is installed.
"""
