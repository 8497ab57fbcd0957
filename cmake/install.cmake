# Installation, in four components: `programs` (epsnet, certify, certify-exact, manual pages, completion, documents), `libraries`
# (what programs load at run time) and `development` (headers, libraries to link with, the packages of CMake and pkg-config); and `python`, in python/CMakeLists.txt.
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/epsnet)

if(EPSNET_PROGRAMS)
  install(TARGETS epsnet certify certify-exact RUNTIME COMPONENT programs)
  include(cmake/help.cmake)
endif()

# The libraries, and the headers that the CMakeLists.txt of the rooms name.
set_target_properties(epsnet_options PROPERTIES EXPORT_NAME options)
set_target_properties(epsnet_certify PROPERTIES EXPORT_NAME certify OUTPUT_NAME epsnet_certify)
set_target_properties(epsnet_netgen PROPERTIES EXPORT_NAME epsnet OUTPUT_NAME epsnet)
install(TARGETS epsnet_options EXPORT epsnet-targets)
foreach(library epsnet_certify epsnet_netgen)
  # Before 1.0 a minor version may break programs that were linked with the previous one.
  set_target_properties(${library} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_compile_options(${library} INTERFACE $<INSTALL_INTERFACE:-ffp-contract=off>)  # As in cmake/users.cmake.
  install(TARGETS ${library} EXPORT epsnet-targets
    LIBRARY COMPONENT libraries NAMELINK_COMPONENT development
    ARCHIVE COMPONENT development
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endforeach()
install(DIRECTORY ${epsnet_include}/epsnet DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN *.h)

# find_package(epsnet)
install(EXPORT epsnet-targets NAMESPACE epsnet:: DESTINATION ${package} COMPONENT development)
configure_file(cmake/epsnet-config.cmake.in epsnet-config.cmake @ONLY)
write_basic_package_version_file(compatible-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/epsnet-config.cmake cmake/dependencies.cmake ${CMAKE_CURRENT_BINARY_DIR}/compatible-version.cmake
  cmake/epsnet-config-version.cmake DESTINATION ${package} COMPONENT development)

# pkg-config epsnet, pkg-config epsnet-certify. Headers of Boost and GMP make programs call GMP and MPFR themselves.
# Of static libraries every program needs all; those that shared ones need are private (pkg-config --static).
if(EPSNET_DEBIAN)
  set(pc_prefix ${CMAKE_INSTALL_PREFIX})
else()  # Wherever it is moved.
  file(RELATIVE_PATH to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  set(pc_prefix "\${pcfiledir}/${to_prefix}")
endif()
function(epsnet_pkg_config name description requires libs libs_private)
  if(NOT BUILD_SHARED_LIBS)  # Then every program needs all.
    string(APPEND libs " ${libs_private}")
    set(libs_private "")
  endif()
  configure_file(cmake/pkg-config.pc.in ${name}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endfunction()
if(EPSNET_INCLUDE_flint_arb_h)
  set(flint -lflint)
else()
  set(flint "-lflint-arb -lflint")
endif()
epsnet_pkg_config(epsnet "${PROJECT_DESCRIPTION}" "epsnet-certify = ${PROJECT_VERSION}" "-lepsnet -lmpfr -lgmp" "-ltbb -lmetis -lClp -lCoinUtils")
epsnet_pkg_config(epsnet-certify "Checker of epsilon-nets of closed hyperbolic surfaces" "" "-lepsnet_certify -lgmpxx -lgmp"
  "${flint} -lmpfr -pthread -lm")

# Licence and documents.
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT programs)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT programs PATTERN site EXCLUDE)
if(EPSNET_DEBIAN)
  include(cmake/debian.cmake)
else()
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT programs)
  install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
endif()
