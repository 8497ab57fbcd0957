# Whether this version is one that find_package asks for; if it is not, CMake prints PACKAGE_VERSION, which then says why.
include(${CMAKE_CURRENT_LIST_DIR}/compatible-version.cmake)
if(NOT PACKAGE_VERSION_COMPATIBLE AND NOT PACKAGE_VERSION_UNSUITABLE)
  if(PACKAGE_VERSION VERSION_LESS PACKAGE_FIND_VERSION)
    string(APPEND PACKAGE_VERSION ", which is too old")
  else()
    string(APPEND PACKAGE_VERSION ", which is too new: before 1.0 a new minor version may change names of the interface")
  endif()
endif()
