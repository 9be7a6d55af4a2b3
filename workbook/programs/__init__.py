"""Starting a program as its own process, keeping its log, limiting it, and ending all that it has started.

`process.NodeProcess` runs a `spec.ProgramSpec`; `tier` says what a tier of isolation must offer, `unconfined` is none.
`fork_client.own_server` lets a process that starts many programs fork them.
"""
