"""Present one judgment to a person: as a card in a notebook, terminal text, or Markdown, with shared wording.

Other packages import `card`, `text`, `markdown`, and `wording`. This package neither judges nor runs programs.
"""
