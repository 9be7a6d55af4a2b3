"""Watch a program in simulated time or on the wall clock, and record its messages, services, and nodes.

A *watch* is one run of a program under observation, and its result is a *recording*. Import `observer.Observer` and
`watch.Watch`. `rest` detects when the program is at rest, and `steal_time` measures the CPU time that a virtual
machine's host took from this machine.
"""
