"""The vocabulary of criteria: functions that each judge one thing about a recording.

Each gives the same feedback in every exercise. Criteria files import them from `workbook.criteria` alone.
"""
