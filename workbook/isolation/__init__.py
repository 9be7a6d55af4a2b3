"""The tiers of isolation for programs that are not trusted, each behind `workbook.programs.tier.Tier`.

`tiers` makes one by its name and says what it covers and leaves open; graders import that, and `user_ids` to lease ids.
"""
