# Manual pages and completion, made from the --help texts of the programs: share/man/man1, and where bash and zsh look for completion.
set(help ${CMAKE_CURRENT_BINARY_DIR}/help)
file(GLOB scripts CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/help/*)
set(compress "")
if(EPSNET_DEBIAN)
  set(compress COMMAND gzip -9nr ${help}/man1)
  set(zsh ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
else()
  set(zsh ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
endif()
add_custom_command(OUTPUT ${help}/done
  COMMAND ${CMAKE_CURRENT_LIST_DIR}/help/make.sh ${help} ${PROJECT_VERSION} $<TARGET_FILE:epsnet> $<TARGET_FILE:certify> $<TARGET_FILE:certify-exact>
  ${compress} COMMAND ${CMAKE_COMMAND} -E touch ${help}/done
  DEPENDS ${scripts} epsnet certify certify-exact VERBATIM)
add_custom_target(help_pages ALL DEPENDS ${help}/done)

install(DIRECTORY ${help}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT programs)
install(DIRECTORY ${help}/bash/ DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT programs)
install(DIRECTORY ${help}/zsh/ DESTINATION ${zsh} COMPONENT programs)
