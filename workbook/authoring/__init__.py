"""Build, run, and check the notebooks of lessons and exercises, and create new ones from templates.

This package is for authors and needs the `dev` extra. Its entry points are `python -m workbook.authoring` and
`workbook new`. Tests also import `Tree`, `check`, `build`, `compare`, and `read_wrong_answer` from its modules. Nothing
else in `workbook` imports it.
"""
