# In the folder ${headers}: "kernel/isometry.h" becomes <epsnet/kernel/isometry.h>, so that a user's folder of the same name cannot hide ours.
file(GLOB_RECURSE installed ${headers}/*.h)
foreach(header ${installed})
  file(READ ${header} text)
  string(REGEX REPLACE "#include \"([^\"]*)\"" "#include <epsnet/\\1>" rewritten "${text}")
  if(NOT rewritten STREQUAL text)
    file(WRITE ${header} "${rewritten}")
  endif()
endforeach()
