"""Watch a program in simulated time or on the wall clock, and record everything that it does in the graph.

Import `observer.Observer`, whose `watch` returns a `watch.Watch`. `quiescence` detects when the program is at rest, and
`steal_time` measures the CPU time that the host took from this machine.
"""
