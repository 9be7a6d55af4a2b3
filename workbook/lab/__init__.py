"""Creating the environment, launching JupyterLab, and the student's own copy of the lessons."""
