"""Present one judgment to a person: as a notebook card, terminal text, or Markdown, with shared wording.

The layers above import `card`, `text`, `markdown`, and `wording`. Nothing here judges or runs anything.
"""
