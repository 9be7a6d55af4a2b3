# Made by `python -m workbook.authoring typings` from the installed message classes; do not edit.
