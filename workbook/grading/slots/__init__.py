"""Slots: warm processes, each of which judges one answer after another.

`protocol`: what a slot and its owner say to each other. `worker`: the process that judges. `forking`: how slots are
forked instead of started. `client`: a slot as its owner sees it, and the pool of those that stay warm. `scheduler`: who
is judged when, on which slot, and what happens when one breaks.
"""
