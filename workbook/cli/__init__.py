"""Define the `workbook` command: each module here with a `register` function adds its subcommands.

This package is an entry point, so no module outside imports it. To keep `workbook --help` fast, its modules import
other packages only when a subcommand runs.
"""
