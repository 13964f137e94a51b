# What is installed, and the package for Debian 12 (`deploy/package`): the command, the page and documentation, presets and
# families to begin with, the unit of systemd, the manual page and the shell's completion. The package's scripts make the
# user and stop the service; they start nothing.
include(GNUInstallDirs)

# What the command prints about itself.
set(words ${CMAKE_BINARY_DIR}/package)
file(MAKE_DIRECTORY ${words})
add_custom_command(OUTPUT ${words}/dripfeed.1.gz ${words}/dripfeed
  COMMAND dripfeed man > ${words}/dripfeed.1
  COMMAND gzip -9nf ${words}/dripfeed.1
  COMMAND dripfeed completion bash > ${words}/dripfeed
  DEPENDS dripfeed VERBATIM)
add_custom_target(package_words DEPENDS ${words}/dripfeed.1.gz ${words}/dripfeed)

install(TARGETS dripfeed RUNTIME DESTINATION bin)
install(FILES ${words}/dripfeed.1.gz DESTINATION share/man/man1)
install(FILES ${words}/dripfeed DESTINATION share/bash-completion/completions)
install(DIRECTORY web/dist/ DESTINATION share/dripfeed/web PATTERN .built EXCLUDE)
install(DIRECTORY deploy/machines deploy/families DESTINATION share/dripfeed)
install(DIRECTORY docs/ DESTINATION share/doc/dripfeed)
install(FILES LICENSE DESTINATION share/doc/dripfeed RENAME copyright)
install(FILES deploy/dripfeed.service DESTINATION lib/systemd/system)
install(FILES deploy/debian/dripfeed.json DESTINATION /etc/dripfeed)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME dripfeed)
set(CPACK_PACKAGE_CONTACT "dripfeed <dripfeed@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "program distribution and DNC server for CNC machine tools")
set(CPACK_PACKAGE_DESCRIPTION
  "Keeps part families and programs, renders and checks them for each machine's control, and feeds them by blocks over serial lines, sockets and Modbus.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_SET_DESTDIR OFF)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION misc)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS adduser)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS ca-certificates)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(scripts ${CMAKE_SOURCE_DIR}/deploy/debian)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${scripts}/conffiles ${scripts}/postinst ${scripts}/prerm ${scripts}/postrm)
include(CPack)
