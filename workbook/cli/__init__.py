"""The `workbook` command: each module here that has a `register` function adds its subcommands.

It is a face, so nothing imports it. The modules import what they need when they run, to keep `workbook --help` fast.
"""
