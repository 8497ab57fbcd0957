# run(COMMAND...) fails if the command fails.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()
# The first comment of an example has, after a line "Prints…:", the text that the program prints.
function(run_example source)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE printed)
  file(READ ${source} text)
  string(REGEX MATCH "\n// Prints[^\n]*:\n((//   [^\n]*\n)+)" found "${text}")
  string(REGEX REPLACE "(^|\n)//   " "\\1" said "${CMAKE_MATCH_1}")
  if(said STREQUAL "" OR NOT printed STREQUAL said)
    message(FATAL_ERROR "${source} says that it prints\n${said}and prints\n${printed}")
  endif()
endfunction()
