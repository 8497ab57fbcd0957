# Debian packages: cmake --preset package && cmake --build --preset package && cpack --preset package (.ci/package does that).
#   epsnet          the programs, their manual pages and completion, the documents
#   libepsnet0.3    the shared libraries
#   libepsnet-dev   headers, the packages of CMake and pkg-config, the examples
#   python3-epsnet  the Python module, for the Python of this Debian
#   certify-proved  the checker that is proved in Coq, if EPSNET_PROVED is ON: what formal/build has built
set(abi ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_PACKAGE_CONTACT "The epsnet authors <epsnet@example.org>")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(version "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")

set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL programs libraries development)
if(TARGET epsnet_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
elseif(EPSNET_PYTHON)
  message(FATAL_ERROR "The package python3-epsnet needs what the messages above name; -DEPSNET_PYTHON=OFF does without it.")
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/certify ${PROJECT_BINARY_DIR}/netgen)
set(about "An epsilon-net is a finite set of points such that every point of the
surface is within epsilon of one of them and no two are closer than epsilon.
Every net is proved by an independent checker in ball arithmetic.")

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME epsnet)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS "libepsnet${abi} (= ${version})")
set(CPACK_COMPONENT_PROGRAMS_DESCRIPTION "${about}")

set(CPACK_DEBIAN_LIBRARIES_PACKAGE_NAME libepsnet${abi})
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SECTION libs)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
# Not CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS: it warns of the Python module, which has no SONAME.
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/debian/shlibs "")
foreach(library libepsnet libepsnet_certify)
  file(APPEND ${CMAKE_CURRENT_BINARY_DIR}/debian/shlibs "${library} ${abi} libepsnet${abi} (>= ${version})\n")
endforeach()
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_BINARY_DIR}/debian/triggers ${CMAKE_CURRENT_BINARY_DIR}/debian/shlibs)
set(CPACK_COMPONENT_LIBRARIES_DESCRIPTION "${about}\n.\nThese are the shared libraries.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libepsnet-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libepsnet${abi} (= ${version}), libboost-dev, libgmp-dev, libmpfr-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "${about}\n.\nThese are the headers, the packages of CMake and pkg-config, and examples.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-epsnet)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
math(EXPR next_python "${EPSNET_PYTHON_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "libepsnet${abi} (= ${version}), python3 (>= 3.${EPSNET_PYTHON_MINOR}), python3 (<< 3.${next_python}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-flint, python3-matplotlib, python3-mpmath, python3-scipy, python3-tqdm")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "${about}\n.\nThis is the Python module.")

option(EPSNET_PROVED "Also make the package certify-proved" OFF)
if(EPSNET_PROVED)
  list(APPEND CPACK_COMPONENTS_ALL proved)
  set(CPACK_DEBIAN_PROVED_PACKAGE_NAME certify-proved)
  set(CPACK_DEBIAN_PROVED_PACKAGE_SECTION math)
  set(CPACK_COMPONENT_PROVED_DESCRIPTION "${about}\n.\nThis is a small checker of net files that is proved correct in Coq.")
  set(proved ${PROJECT_SOURCE_DIR}/build/formal/certify-proved)
  set(proved_help ${CMAKE_CURRENT_BINARY_DIR}/help-proved)
  execute_process(COMMAND ${CMAKE_CURRENT_LIST_DIR}/help/make.sh ${proved_help} ${PROJECT_VERSION} ${proved} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND gzip -9nr ${proved_help}/man1 COMMAND_ERROR_IS_FATAL ANY)
  install(PROGRAMS ${proved} TYPE BIN COMPONENT proved)
  install(DIRECTORY ${proved_help}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT proved)
endif()

# The copyright and the changelog that Debian requires in each package.
set(name epsnet)
configure_file(cmake/debian-changelog.in debian/changelog.Debian @ONLY)
execute_process(COMMAND gzip -9nf debian/changelog.Debian WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} COMMAND_ERROR_IS_FATAL ANY)
string(TOUPPER "${CPACK_COMPONENTS_ALL}" components)
foreach(component ${components})
  set(folder ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${component}_PACKAGE_NAME})
  string(TOLOWER ${component} lower)
  install(FILES LICENSE DESTINATION ${folder} RENAME copyright COMPONENT ${lower})
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/debian/changelog.Debian.gz DESTINATION ${folder} COMPONENT ${lower})
endforeach()
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libepsnet-dev COMPONENT development PATTERN notebooks EXCLUDE)
install(DIRECTORY examples/notebooks DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-epsnet/examples COMPONENT python)
include(CPack)
