"""Grade many answers: judge them on slots or farms, resume runs, and write the gradebook, pages, and exports.

`cli` and `magics` use this package. In it, `slots` judges answers, `batch` grades a class, and `results` defines the
lines of `results.jsonl`.
"""
