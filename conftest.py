"""For every pytest run in this checkout: `pytest --nbval notebooks`, and criteria files with `--answer FILE`."""

pytest_plugins = ["workbook.authoring.nbval_glue", "workbook.exercise.pytest_plugin"]
