# BUILD is configured and nothing of it is built: its installation says so and lays nothing down in PREFIX.
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} --component throng_library
  RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
string(REGEX REPLACE "[ \n]+" " " said "${said}")  # CMake breaks lines where the paths end
if(status EQUAL 0 OR NOT said MATCHES "nothing is installed.*--target throng_installed")
  message(SEND_ERROR "the installation of nothing ended with ${status}: ${said}")
endif()
file(GLOB_RECURSE laid_down ${PREFIX}/*)
if(laid_down)
  message(SEND_ERROR "it laid down ${laid_down}")
endif()
