# SPDX-License-Identifier: Apache-2.0
# `cpack` in a build folder makes a Debian package of the program, its cases, its completions and its manual pages. The
# program is built for the processors that -march names: configure with -DRIPRAP_MARCH=x86-64-v3 for a package that travels.
include(GNUInstallDirs)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # tests need not be built for a package
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME riprap)
set(CPACK_PACKAGE_VENDOR Riprap)
set(CPACK_PACKAGE_CONTACT "the authors of Riprap <riprap@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGE_DESCRIPTION "Moves discrete solid blocks and water together: rock slides into reservoirs, armour under waves, floes in a
dam break. Built for processors of kind ${RIPRAP_MARCH}.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # by dpkg-shlibdeps, of the package dpkg-dev
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "chromium, ffmpeg, paraview")
# Made by the program itself, which is built by then.
install(CODE "
  set(program \"${PROJECT_BINARY_DIR}/apps/riprap\")
  set(root \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/share\")
  file(MAKE_DIRECTORY \${root}/bash-completion/completions \${root}/zsh/vendor-completions
       \${root}/fish/vendor_completions.d \${root}/man/man1)
  function(write_words file)
    execute_process(COMMAND \${program} \${ARGN} OUTPUT_FILE \${root}/\${file} COMMAND_ERROR_IS_FATAL ANY)
  endfunction()
  write_words(bash-completion/completions/riprap completion bash)
  write_words(zsh/vendor-completions/_riprap completion zsh)
  write_words(fish/vendor_completions.d/riprap.fish completion fish)
  write_words(man/man1/riprap.1 man)
  foreach(command run check resume new sweep matrix validate view render surface plot waves list schema bench)
    write_words(man/man1/riprap-\${command}.1 man \${command})
  endforeach()
")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/riprap RENAME copyright)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/riprap)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/paraview DESTINATION ${CMAKE_INSTALL_DATADIR}/riprap)
include(CPack)
