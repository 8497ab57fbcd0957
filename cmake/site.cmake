# The site, in build/site/html: the documents and the reference of the public headers. cmake --build --preset release --target site
# needs the Debian packages of the group `site` (.ci/setup site). Warnings are errors.
set(site ${CMAKE_CURRENT_BINARY_DIR}/site)
get_property(names GLOBAL PROPERTY epsnet_public_headers)
set(headers ${names})
list(TRANSFORM headers PREPEND ${PROJECT_SOURCE_DIR}/)
list(JOIN headers " " headers)
configure_file(docs/site/Doxyfile.in ${site}/Doxyfile @ONLY)

find_program(EPSNET_DOXYGEN doxygen)
find_program(EPSNET_SPHINX sphinx-build)
mark_as_advanced(EPSNET_DOXYGEN EPSNET_SPHINX)
# The notebooks are executed, and become pages with their output.
set(has_notebooks FALSE)
if(TARGET epsnet_python)
  execute_process(COMMAND ${Python_EXECUTABLE} -c "import nbconvert, ipykernel, matplotlib, scipy" RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(NOT failed)
    set(has_notebooks TRUE)
  endif()
endif()
# Pictures become files, as SVG.
set(as_files)
foreach(type image/svg+xml text/html text/markdown text/latex image/png image/jpeg text/plain)
  list(APPEND as_files --NbConvertBase.display_data_priority=${type})
endforeach()
file(GLOB formal CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/formal/*.v)
file(GLOB notebooks CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/notebooks/*.ipynb)
if(EPSNET_DOXYGEN AND EPSNET_SPHINX AND has_notebooks)
  set(source ${site}/source)
  add_custom_target(site
    # The same folders as in the repository, so that relative links work.
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${source} ${site}/xml ${site}/html
    COMMAND ${CMAKE_COMMAND} -E copy_directory docs ${source}/docs
    COMMAND ${CMAKE_COMMAND} -E copy README.md CHANGELOG.md CONTRIBUTING.md CITATION.cff LICENSE ${source}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${source}/formal
    COMMAND ${CMAKE_COMMAND} -E copy ${formal} ${source}/formal
    COMMAND ${CMAKE_COMMAND} -E rename ${source}/docs/site/index.md ${source}/index.md
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${source}/docs/site
    COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${PROJECT_BINARY_DIR}/python PYDEVD_DISABLE_FILE_VALIDATION=1 ${Python_EXECUTABLE} -m nbconvert --log-level WARN --to markdown ${as_files}
      --execute --output-dir ${source}/docs/notebooks ${notebooks}
    COMMAND ${EPSNET_DOXYGEN} ${site}/Doxyfile
    COMMAND python3 docs/site/reference.py ${site}/xml docs/site/reference ${source}/reference ${names}
    COMMAND ${EPSNET_SPHINX} -W --keep-going -q -b html -c docs/site -D breathe_projects.epsnet=${site}/xml -D release=${PROJECT_VERSION}
      ${source} ${site}/html
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
  add_dependencies(site epsnet_python)
else()
  add_custom_target(site
    COMMAND ${CMAKE_COMMAND} -E echo "The site needs Doxygen, Sphinx, MyST, Breathe, furo, and for the notebooks the Python module and Jupyter: .ci/setup site test notebooks, then configure again."
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()
