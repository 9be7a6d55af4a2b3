"""Slots: warm processes, each of which judges one answer after another.

`protocol`: what a slot and its owner say to each other. `worker`: the process that judges. `forking`: how slots are
forked instead of started. `client`: a slot as its owner sees it. `pool`: slots that stay warm, and what happens when
one breaks. `scheduler`: who is judged when, and on which slot. `health`: whether a slot still gets anywhere.
"""
