# The starter with hints for main() alone.
# loses: clean, wrong_message_found, wrong_value_found, numbers_arrive, refuses_wrong_types, refuses_wrong_words
# cause: mypy.untyped-def
# says: no-untyped-def
# on: starter
# replaces: def main():
def main() -> None:
