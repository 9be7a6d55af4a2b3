"""Grade many answers: judge them on slots or a farm, resume runs, and write the gradebook, pages, and exports.

A slot is a process that judges answers on this machine, and a farm consists of slots on several machines. `cli` and
`magics` use this package. In it, `slots` judges answers, `batch` grades a class, and `results` defines the lines of
`results.jsonl`.
"""
