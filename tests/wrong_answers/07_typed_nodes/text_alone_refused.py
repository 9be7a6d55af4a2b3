# Refuses text, and hands everything else to float(), which reads bytes as well.
# loses: refuses_wrong_types
# cause: refuses-wrong-types.text-read
# replaces: if not isinstance(level, (int, float)):
if isinstance(level, str):
