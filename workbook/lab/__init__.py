"""Around the notebooks: creating the environment, launching JupyterLab, setting up kernels, the student's own copy.

It is a face: only `cli` and `authoring` import from it. `bootstrap` runs before anything is installed.
"""
