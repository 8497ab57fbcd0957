# The libraries epsnet is linked with, found in the same way by its own build and by find_package(epsnet):
#   GMP::GMP, GMP::GMPXX, MPFR::MPFR, FLINT::FLINT (FLINT with Arb: two libraries before FLINT 3),
#   Threads::Threads, TBB::tbb, and the Boost headers as Boost::headers.
# Targets are global where CMAKE_FIND_PACKAGE_TARGETS_GLOBAL is ON, as those of find_package are.
# Sets epsnet_missing to the libraries that are not found. If epsnet_is_shared is set, searches only for the libraries that public headers include.

set(epsnet_missing "")

# Makes the imported target from the first header and all libraries named; target names among them are linked too.
macro(epsnet_import target header)
  if(NOT TARGET ${target})
    string(MAKE_C_IDENTIFIER EPSNET_INCLUDE_${header} include)
    find_path(${include} ${header})
    mark_as_advanced(${include})
    set(epsnet_import_found "${${include}}")
    set(epsnet_import_libraries "")
    foreach(library ${ARGN})
      if(library MATCHES "::")
        list(APPEND epsnet_import_libraries ${library})
      else()
        find_library(EPSNET_LIBRARY_${library} ${library})
        mark_as_advanced(EPSNET_LIBRARY_${library})
        list(APPEND epsnet_import_libraries "${EPSNET_LIBRARY_${library}}")
        if(NOT EPSNET_LIBRARY_${library})
          set(epsnet_import_found FALSE)
        endif()
      endif()
    endforeach()
    if(epsnet_import_found)
      set(epsnet_import_scope "")
      if(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL)
        set(epsnet_import_scope GLOBAL)
      endif()
      add_library(${target} INTERFACE IMPORTED ${epsnet_import_scope})
      set_target_properties(${target} PROPERTIES
        INTERFACE_INCLUDE_DIRECTORIES "${${include}}"
        INTERFACE_LINK_LIBRARIES "${epsnet_import_libraries}")
    else()
      list(APPEND epsnet_missing ${target})
    endif()
  endif()
endmacro()

epsnet_import(GMP::GMP gmp.h gmp)
epsnet_import(GMP::GMPXX gmpxx.h gmpxx GMP::GMP)
epsnet_import(MPFR::MPFR mpfr.h mpfr GMP::GMP)
if(NOT epsnet_is_shared)
  find_path(EPSNET_INCLUDE_flint_arb_h flint/arb.h)
  mark_as_advanced(EPSNET_INCLUDE_flint_arb_h)
  if(EPSNET_INCLUDE_flint_arb_h)
    epsnet_import(FLINT::FLINT flint/arb.h flint MPFR::MPFR)
  else()
    epsnet_import(FLINT::FLINT arb.h flint-arb flint MPFR::MPFR)
  endif()

  set(packages Threads TBB)
  if(EMSCRIPTEN)
    set(packages Threads)  # One thread: netgen/nets/parts.cpp.
  endif()
  foreach(package ${packages})
    find_package(${package} QUIET)
    if(NOT ${package}_FOUND)
      list(APPEND epsnet_missing ${package})
    endif()
  endforeach()
endif()
find_package(Boost QUIET CONFIG)  # CMake leaves the search to the config file that Boost installs (policy CMP0167).
if(NOT TARGET Boost::headers)
  list(APPEND epsnet_missing Boost)
endif()
