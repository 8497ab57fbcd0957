# Targets that look at the sources: format, format-check (clang-format) and tidy (clang-tidy over compile_commands.json).
set(folders certify kernel triangulation netgen python experiments tests fuzz examples)
list(TRANSFORM folders PREPEND ${CMAKE_SOURCE_DIR}/)
list(TRANSFORM folders APPEND /*.h OUTPUT_VARIABLE headers)
list(TRANSFORM folders APPEND /*.cpp OUTPUT_VARIABLE sources)
file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${headers} ${sources})
list(APPEND sources ${CMAKE_SOURCE_DIR}/epsnet.h)

add_custom_target(format COMMAND clang-format -i ${sources} VERBATIM)
add_custom_target(format-check COMMAND clang-format --dry-run -Werror ${sources} VERBATIM)

# Tests, fuzz targets and experiments are left out: GoogleTest's macros set off many checks, and half of the time would go there. So is, in `tidy`, the
# static analyzer, which takes as long as everything else; `analyze` is that alone.
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
set(run_tidy run-clang-tidy -quiet -p ${CMAKE_BINARY_DIR} -j ${cores})
set(tidied "^${CMAKE_SOURCE_DIR}/(certify|kernel|triangulation|netgen)/")
add_custom_target(tidy COMMAND ${run_tidy} "-checks=-clang-analyzer-*" ${tidied} VERBATIM)
add_custom_target(analyze COMMAND ${run_tidy} "-checks=-*,clang-analyzer-*,-clang-analyzer-core.StackAddressEscape" ${tidied} VERBATIM)
