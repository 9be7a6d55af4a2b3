"""Create the environment, launch JupyterLab, set up kernels, and update the student's copy of the notebooks.

Only `cli` and `authoring` import from this package. Its module `bootstrap` runs before anything is installed.
"""
