# Configures epsnet without the test libraries, which must give no warning if tests are off and a clear error if they are on; then with the
# libraries.
file(REMOVE_RECURSE ${scratch})

# Sets `code` and `messages`.
function(configure)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${source} -B ${scratch} -G ${generator} -D CMAKE_CXX_COMPILER=${compiler} --no-warn-unused-cli ${ARGN}
    COMMAND_ECHO STDOUT RESULT_VARIABLE code OUTPUT_VARIABLE ignored ERROR_VARIABLE messages)
  message("${messages}")
  set(code ${code} PARENT_SCOPE)
  set(messages "${messages}" PARENT_SCOPE)
endfunction()
set(without -D CMAKE_DISABLE_FIND_PACKAGE_GTest=ON -D CMAKE_DISABLE_FIND_PACKAGE_rapidcheck=ON)
set(with -D CMAKE_DISABLE_FIND_PACKAGE_GTest=OFF -D CMAKE_DISABLE_FIND_PACKAGE_rapidcheck=OFF)

configure(${without} -D EPSNET_TESTS=ON)
foreach(text "GoogleTest" "RapidCheck" ".ci/packages" "-DEPSNET_TESTS=OFF")
  string(FIND "${messages}" "${text}" place)
  if(code EQUAL 0 OR place EQUAL -1)
    message(FATAL_ERROR "Tests without their libraries: exit code ${code}, or not a word about ${text}")
  endif()
endforeach()
foreach(arguments "${without};-D;EPSNET_TESTS=OFF" "${with};-D;EPSNET_TESTS=ON" "${without};-D;EPSNET_TESTS=OFF" "${with};-D;EPSNET_TESTS=ON")
  configure(${arguments})
  if(NOT code EQUAL 0 OR NOT messages STREQUAL "")
    message(FATAL_ERROR "${arguments}: exit code ${code}, and the messages above; 0 and none were expected")
  endif()
endforeach()
