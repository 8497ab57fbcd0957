file(REMOVE_RECURSE ${scratch}/prefix ${scratch}/consumer)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()
run(${CMAKE_COMMAND} --install ${build} --prefix ${scratch}/prefix)
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${scratch}/consumer -G ${generator}
  -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH=${scratch}/prefix -D README=${CMAKE_CURRENT_LIST_DIR}/../../README.md)
run(${CMAKE_COMMAND} --build ${scratch}/consumer)
run(${CMAKE_COMMAND} --build ${scratch}/consumer --target examples)
run(${scratch}/consumer/consumer ${scratch}/consumer/net.json)
run(${scratch}/prefix/bin/certify ${scratch}/consumer/net.json)
run(${scratch}/prefix/bin/epsnet info ${scratch}/consumer/net.json)
