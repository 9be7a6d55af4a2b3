"""Define the `workbook` command. Each module here that has a `register` function adds its subcommands.

This package is an entry point, so modules outside of it don't import it. To keep `workbook --help` fast, the modules
here import slow modules only when a subcommand runs.
"""
