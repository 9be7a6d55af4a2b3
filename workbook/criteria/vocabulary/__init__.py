"""Provide the vocabulary of criteria: functions, each of which judges one aspect of a recording.

A function gives the same feedback in every exercise. Criteria files import these functions only from
`workbook.criteria`.
"""
