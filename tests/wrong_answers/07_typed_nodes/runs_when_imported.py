# main() runs on import.
# loses: numbers_arrive, refuses_wrong_types, refuses_wrong_words
# cause: driver.never-called
# replaces: if __name__ == "__main__":
# replaces:     main()
main()
