# score: 0
# says: keyboard
"""Asks a question first."""
name = input("your name? ")
