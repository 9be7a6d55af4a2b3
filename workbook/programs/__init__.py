"""Start programs as separate processes, limit them, keep their logs, and end all processes that they started.

`process.NodeProcess` runs a `spec.ProgramSpec`. `tier` defines the interface of an isolation tier, and `unconfined`
implements it without isolation. `fork_client.own_server` lets a process that starts many programs fork them.
"""
