# What a project gets that has epsnet as a subproject, and what is installed: the public headers as <epsnet/...>, and
#   epsnet::epsnet   everything, for #include <epsnet/epsnet.h>; epsnet::netgen is an older name of it,
#   epsnet::certify  the checker alone, with the reader and the writer of files.
# They hand on none of the compile options of our own targets, and none of our folders.
get_property(headers GLOBAL PROPERTY epsnet_public_headers)
set(epsnet_include ${PROJECT_BINARY_DIR}/include)
set(sources ${headers})
list(TRANSFORM sources PREPEND ${PROJECT_SOURCE_DIR}/)
add_custom_command(OUTPUT ${epsnet_include}/done
  COMMAND ${CMAKE_COMMAND} "-DHEADERS=${headers}" -DFROM=${PROJECT_SOURCE_DIR} -DTO=${epsnet_include}/epsnet -P ${CMAKE_CURRENT_LIST_DIR}/user_headers.cmake
  COMMAND ${CMAKE_COMMAND} -E touch ${epsnet_include}/done
  DEPENDS ${sources} ${CMAKE_CURRENT_LIST_DIR}/user_headers.cmake VERBATIM)
add_custom_target(epsnet_user_headers ALL DEPENDS ${epsnet_include}/done)

# epsnet_for_users(NAME TARGET LIBRARY...): epsnet::NAME is our target for users, whose headers need the libraries.
function(epsnet_for_users name target)
  add_library(${target}_for_users INTERFACE)
  add_library(epsnet::${name} ALIAS ${target}_for_users)
  add_dependencies(${target}_for_users epsnet_user_headers)
  target_include_directories(${target}_for_users SYSTEM INTERFACE ${epsnet_include})
  target_compile_features(${target}_for_users INTERFACE cxx_std_20)
  # The error bounds of the inline predicates must also hold in the programs that use them.
  target_compile_options(${target}_for_users INTERFACE -ffp-contract=off)
  target_link_libraries(${target}_for_users INTERFACE $<LINK_ONLY:${target}> ${ARGN})
endfunction()
epsnet_for_users(certify epsnet_certify GMP::GMPXX)
epsnet_for_users(epsnet epsnet_netgen epsnet::certify Boost::headers MPFR::MPFR GMP::GMP)
add_library(epsnet::netgen ALIAS epsnet_netgen_for_users)
