"""From text to notebooks: builds, runs and checks lessons and exercises, and writes new ones from templates.

For authors; needs the `dev` extra. Faces are `python -m workbook.authoring` and `workbook new`; tests also use `Tree`,
`check`, `build`, `compare` and `read_wrong_answer` of the modules here. Nothing else in `workbook` imports it.
"""
