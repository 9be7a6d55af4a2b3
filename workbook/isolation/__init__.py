"""Define the isolation tiers, which are ways to run untrusted programs. All of them implement `programs.tier.Tier`.

`tiers` creates a tier by name and describes its protection and its gaps. The grading layer imports only `tiers` and, to
lease user IDs, `user_ids`.
"""
