"""Watching one program on simulated time or on the wall clock, and recording all that it does on the graph.

Import `observer.Observer`, whose `watch` gives a `watch.Watch`; `quiescence` tells when the program rests, and
`steal_time` what the host took from this machine.
"""
