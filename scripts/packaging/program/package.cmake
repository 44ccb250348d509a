# The program as a package: `cpack` makes a .tar.zst, which runs wherever it is unpacked, and on Debian and its kin a .deb.
# Included by the CMakeLists.txt of the project, after all that is installed.
set(program_package ${CMAKE_CURRENT_LIST_DIR})
install(FILES ${program_package}/throng.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT throng_program)
install(FILES ${program_package}/throng.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT throng_program)
install(FILES ${program_package}/throng.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT throng_program)

# Our licence, and the notices of what is compiled into the program, as Debian's packages have them.
file(READ ${PROJECT_SOURCE_DIR}/LICENSE licence)
foreach(package IN ITEMS libimgui-dev libcli11-dev libglm-dev nlohmann-json3-dev libxxhash-dev libstb-dev python3-glad)
  if(EXISTS /usr/share/doc/${package}/copyright)
    file(READ /usr/share/doc/${package}/copyright notice)
    string(APPEND licence "\n\n---- ${package}\n\n${notice}")
  endif()
endforeach()
file(WRITE ${PROJECT_BINARY_DIR}/copyright "${licence}")
install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/throng COMPONENT throng_program)

set(CPACK_GENERATOR TZST)
find_program(THRONG_DPKG_SHLIBDEPS dpkg-shlibdeps)
mark_as_advanced(THRONG_DPKG_SHLIBDEPS)
if(THRONG_DPKG_SHLIBDEPS)
  list(APPEND CPACK_GENERATOR DEB)
endif()
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};throng;throng_program;/")  # this component alone
set(CPACK_MONOLITHIC_INSTALL ON)
set(CPACK_PACKAGE_FILE_NAME throng-${PROJECT_VERSION}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_PACKAGE_VENDOR "The Throng authors")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)

# What is linked is found by dpkg-shlibdeps; what is opened by name while the program runs is listed here.
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The Throng authors")
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
string(CONCAT CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "Shows and measures crowds of thousands, whose poses are computed on the CPU.\n"
  "They are the built-in people or glTF models, and go their own ways or those of\n"
  "recorded trajectories. Throng draws in a window, into pictures and into videos.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libxcursor1, libxi6, libxinerama1, libxrandr2")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, libosmesa6")
set(CPACK_DEBIAN_COMPRESSION_TYPE zstd)
include(CPack)
