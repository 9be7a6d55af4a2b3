"""Many answers: slots and farms that judge them, results that resume, the gradebook, pages and exports.

`cli` and `magics` import it: `slots` for judging, `batch` for a class, `results` for what `results.jsonl` holds.
"""
