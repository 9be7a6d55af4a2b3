"""Define an exercise, and judge an answer: run the answer, record what it does, and judge the recording.

An *answer* is the program that a student hands in. A *judgment* is its result: a status, and the points for each
criterion. The layers above import `definition` (an exercise), `answers` (reading answers), `judging`, and `source`.
"""
