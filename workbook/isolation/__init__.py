"""Define the isolation tiers for untrusted programs, all of which implement `workbook.programs.tier.Tier`.

`tiers` creates a tier by name, and describes what it protects and what it leaves open. The grading layer imports
`tiers`, and also `user_ids` to lease user IDs.
"""
