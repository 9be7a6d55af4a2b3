"""The criteria vocabulary: a set of functions, each of which judges one aspect of a recording.

A function gives the same feedback in every exercise. Criteria files import the functions only from `workbook.criteria`.
"""
