# Shell completion: the command prints it, so that it is as new as the command; each shell looks in a folder of its own.
function(sightline_install_completion shell file folder)
  set(script "${PROJECT_BINARY_DIR}/completion/${shell}/${file}")
  add_custom_command(TARGET sightline POST_BUILD
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${PROJECT_BINARY_DIR}/completion/${shell}"
    COMMAND sightline completion ${shell} > "${script}")
  install(FILES "${script}" DESTINATION "${CMAKE_INSTALL_DATADIR}/${folder}")
endfunction()

if(NOT CMAKE_CROSSCOMPILING)
  sightline_install_completion(bash sightline bash-completion/completions)
  sightline_install_completion(zsh _sightline zsh/site-functions)
  sightline_install_completion(fish sightline.fish fish/vendor_completions.d)
endif()
