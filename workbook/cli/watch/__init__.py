"""`workbook check --watch`: judging an answer again at each save. `workbook.cli.check` imports it when it is asked for.

It is no module of `workbook.cli` itself, because those are imported for every command.
"""
