# Parks, but logs the words with a capital.
# loses: arms_parked
# cause: arms-parked.other-words
# says: 'Arms parked.'
# replaces: print("arms parked", flush=True)
print("Arms parked.", flush=True)
