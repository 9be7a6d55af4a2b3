"""Load the course's two pytest plugins:

one for `pytest --nbval notebooks`, one for criteria files with `--answer FILE`.
"""

pytest_plugins = ["workbook.authoring.nbval_glue", "workbook.exercise.pytest_plugin"]
