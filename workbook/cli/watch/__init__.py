"""`workbook check --watch`: judge an answer again after each save. `workbook.cli.check` imports this package on demand.

The modules aren't directly in `workbook.cli`, because every command imports all modules there.
"""
