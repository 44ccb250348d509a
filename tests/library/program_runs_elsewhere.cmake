# The program installed in PREFIX runs after its folder was moved, from the data beside it.
function(run_program result output)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=THRONG_DATA
    ${PREFIX}-moved/bin/throng --headless=none --frames 1 --agents 10
    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  set(${result} ${status} PARENT_SCOPE)
  set(${output} "${said}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${PREFIX}-moved)
file(COPY ${PREFIX}/bin ${PREFIX}/share DESTINATION ${PREFIX}-moved)
run_program(status said)
if(NOT status EQUAL 0)
  message(SEND_ERROR "the installed program failed (${status}): ${said}")
endif()

# The source tree has the same files: only a broken one shows which are read.
set(model ${PREFIX}-moved/share/throng/assets/mannequin.glb)
file(WRITE ${model} "not a model")
run_program(status said)
if(NOT status EQUAL 1 OR NOT said MATCHES "share/throng/assets/mannequin.glb")
  message(SEND_ERROR "the installed program did not read ${model} (${status}): ${said}")
endif()

file(GLOB_RECURSE files RELATIVE ${PREFIX} ${PREFIX}/share/throng/*)
list(FILTER files EXCLUDE REGEX "\\.(vert|geom|frag|glsl|glb|json|ttf|pack)$|/fonts/LICENSE.txt$|/samples/")
if(files)
  message(SEND_ERROR "the program reads none of these, and they were installed: ${files}")
endif()

foreach(kind IN ITEMS shaders/*.vert shaders/*.geom shaders/*.frag shaders/*.glsl shaders/labels/*.frag assets/*.glb assets/*.json
     assets/fonts/*.ttf assets/fonts/*.txt assets/samples/*.glb assets/samples/*.txt assets/samples/*.wkt)
  file(GLOB files RELATIVE ${SOURCE} ${SOURCE}/${kind})
  foreach(file IN LISTS files)
    if(NOT EXISTS ${PREFIX}-moved/share/throng/${file})
      message(SEND_ERROR "${file} was not installed")
    endif()
  endforeach()
endforeach()
