# score: 10
"""Prints what a terminal, a page or a spreadsheet might obey."""
print("\x1b[2J\x1b]0;owned\x07\x1b[31m=HYPERLINK(\"http://127.0.0.1\")", "<script>alert(1)</script>", "\u202egnp.exe")
@@GOOD@@