"""For every pytest run in this checkout, `pytest --nbval notebooks` included."""

pytest_plugins = ["workbook.authoring.nbval_glue"]
