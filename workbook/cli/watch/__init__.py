"""`workbook check --watch`: judge an answer again after each save.

Every `workbook` command imports all modules that are directly in `workbook.cli`. The slow modules in this package are
imported only by `workbook.cli.check`, and only when they're needed.
"""
