"""Slots: processes that judge answers, one after another. A slot is warm if it's ready for the next answer.

`protocol`: the messages between a slot and its owner, the process that started it. `worker`: the slot's process.
`forking`: creating slots by forking, which is faster than starting a Python interpreter for each. `client`: the owner's
side of a slot. `pool`: keeping slots warm and replacing broken ones. `scheduler`: assigning answers to slots.
`service`: sharing slots among the students of a class. `health`: detecting slots that are stuck.
"""
