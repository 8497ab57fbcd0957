message(FATAL_ERROR "README.md has no ```cpp block: the example that this test compiles and runs is gone.")
