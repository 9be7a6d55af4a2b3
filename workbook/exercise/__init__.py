"""What an exercise is, and the way from an answer to a judgement: run it, record it, judge the recording.

The layers above import `definition` (an exercise), `answers` (what is handed in), `judging` and `source`.
"""
