# The package config of epsnet: find_package(epsnet) gives epsnet::netgen, epsnet::triangulation, epsnet::kernel, epsnet::certify.
include(${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake)
if(epsnet_missing)
  set(epsnet_FOUND FALSE)
  list(JOIN epsnet_missing ", " epsnet_missing)
  set(epsnet_NOT_FOUND_MESSAGE "epsnet needs ${epsnet_missing}")
else()
  include(${CMAKE_CURRENT_LIST_DIR}/epsnet-targets.cmake)
endif()
