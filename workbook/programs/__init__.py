"""Start programs as separate processes, limit them, keep their logs, and kill all processes that they started.

`process.NodeProcess` runs a `spec.ProgramSpec`. An isolation tier is one way to protect the machine from a program:
`tier` defines the interface, and `unconfined` implements it without isolation. With `fork_client.own_server`, a process
that starts many programs can fork them instead of starting a Python interpreter for each.
"""
