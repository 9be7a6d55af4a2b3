"""The `workbook` command. Each module here that has a `register` function adds its subcommands."""
