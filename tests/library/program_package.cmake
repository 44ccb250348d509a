# The packages that cpack makes of BUILD in FOLDER: what the .deb says and holds; the program of the archive draws, from
# the data beside it, wherever it is unpacked.
file(REMOVE_RECURSE ${FOLDER})
execute_process(COMMAND ${CPACK} --config ${BUILD}/CPackConfig.cmake -B ${FOLDER}
  OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE status)
file(GLOB archive ${FOLDER}/throng-${VERSION}-*.tar.zst)
file(GLOB deb ${FOLDER}/throng_${VERSION}_*.deb)
if(NOT status EQUAL 0 OR NOT archive OR NOT deb)
  message(FATAL_ERROR "cpack ended with ${status} and made ${archive} ${deb}: ${said}")
endif()

function(expect_field field pattern)
  execute_process(COMMAND dpkg-deb --field ${deb} ${field} OUTPUT_VARIABLE value COMMAND_ERROR_IS_FATAL ANY)
  if(NOT value MATCHES "${pattern}")
    message(SEND_ERROR "${field} of ${deb} is: ${value}")
  endif()
endfunction()
expect_field(Package "^throng\n")
expect_field(Version "^${VERSION}\n")
expect_field(Maintainer "[A-Za-z]")
expect_field(Description "^Crowds of skinned characters")
expect_field(Depends "libc6 \\(>=")           # found by dpkg-shlibdeps
expect_field(Depends "libegl1.*libgl1-mesa-dri")  # opened while the program runs
expect_field(Suggests "libosmesa6")

execute_process(COMMAND dpkg-deb --contents ${deb} OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
foreach(file IN ITEMS bin/throng share/applications/throng.desktop share/icons/hicolor/scalable/apps/throng.svg share/mime/packages/throng.xml
    share/doc/throng/copyright share/throng/shaders/crowd.vert share/throng/shaders/labels/crowd.vert share/throng/assets/mannequin.glb
    share/throng/assets/cast.json share/throng/assets/fonts/Roboto-Regular.ttf share/throng/assets/samples/robot.glb)
  if(NOT listed MATCHES " \\./usr/${file}\n")
    message(SEND_ERROR "${file} is missing in ${deb}")
  endif()
endforeach()
if(listed MATCHES " (\\./usr/(include|lib|[^\n]*\\.(cpp|h|md|cmake))[^\n]*)\n")
  message(SEND_ERROR "${CMAKE_MATCH_1} is in ${deb} and the program does not read it")
endif()

file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${FOLDER}/unpacked)
file(GLOB unpacked ${FOLDER}/unpacked/*)
set(moved ${FOLDER}/moved)
file(RENAME ${unpacked} ${moved})
function(draw result output)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=THRONG_DATA ${moved}/bin/throng --headless --frames 1 --agents 10 --size 160x90
      --screenshot ${FOLDER}/picture.png RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  set(${result} ${status} PARENT_SCOPE)
  set(${output} "${said}" PARENT_SCOPE)
endfunction()
draw(status said)
if(NOT status EQUAL 0 OR NOT EXISTS ${FOLDER}/picture.png)
  message(SEND_ERROR "the program of ${archive} failed (${status}): ${said}")
endif()

# The source tree has the same files: only a broken one shows which are read.
file(WRITE ${moved}/share/throng/shaders/crowd_plain.vert "not a shader")
draw(status said)
if(status EQUAL 0 OR NOT said MATCHES "shader does not compile: crowd_plain.vert")
  message(SEND_ERROR "the program of ${archive} did not read the shaders beside it (${status}): ${said}")
endif()
