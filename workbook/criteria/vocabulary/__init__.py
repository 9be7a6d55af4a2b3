"""The vocabulary of criteria: each function judges one thing about a recording.

A function gives the same feedback in every exercise. Criteria files import the functions only from `workbook.criteria`.
"""
