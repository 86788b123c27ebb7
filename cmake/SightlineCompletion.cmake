# Shell completion and the manual page: the command prints what they are made of, so that they are as new as the command.
# Each shell looks in a folder of its own.
function(sightline_install_completion shell file folder)
  set(script "${PROJECT_BINARY_DIR}/completion/${shell}/${file}")
  add_custom_command(TARGET sightline POST_BUILD
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${PROJECT_BINARY_DIR}/completion/${shell}"
    COMMAND sightline completion ${shell} > "${script}")
  install(FILES "${script}" DESTINATION "${CMAKE_INSTALL_DATADIR}/${folder}")
endfunction()

function(sightline_install_manual)
  set(manual "${PROJECT_BINARY_DIR}/manual/sightline.1")
  add_custom_command(TARGET sightline POST_BUILD
    COMMAND "${CMAKE_COMMAND}" -D "COMMAND=$<TARGET_FILE:sightline>" -D "VERSION=${PROJECT_VERSION}" -D "OUT=${manual}"
      -P "${PROJECT_SOURCE_DIR}/cmake/make_manual.cmake")
  install(FILES "${manual}" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
endfunction()

if(NOT CMAKE_CROSSCOMPILING)
  sightline_install_manual()
  sightline_install_completion(bash sightline bash-completion/completions)
  sightline_install_completion(zsh _sightline zsh/site-functions)
  sightline_install_completion(fish sightline.fish fish/vendor_completions.d)
endif()
