"""Slots: warm processes, each of which judges one answer after another.

`protocol`: the messages between a slot and its owner. `worker`: the process that judges. `forking`: forking slots
instead of starting them. `client`: the owner's side of a slot. `pool`: keeping slots warm, and replacing broken ones.
`scheduler`: assigning answers to slots. `health`: detecting slots that are stuck.
"""
