"""Define an exercise, and turn an answer into a judgment: run it, record it, judge the recording.

The layers above import `definition` (an exercise), `answers` (hand-ins), `judging`, and `source`.
"""
