"""One judgement as a person reads it: the card in a notebook, text in a terminal, Markdown, the words they share.

The layers above import `card`, `text`, `markdown` and `wording`. Nothing here judges or runs anything.
"""
