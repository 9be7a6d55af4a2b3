"""Slots: processes that judge one answer after another. A slot is warm if it's ready for the next answer.

`protocol`: the messages between a slot and its owner. `worker`: the process that judges. `forking`: forking slots
instead of starting them. `client`: the owner's side of a slot. `pool`: keeping slots warm, and replacing broken ones.
`scheduler`: assigning answers to slots. `service`: sharing slots among a class. `health`: detecting slots that are
stuck.
"""
