# Builds and runs the program of the README by the lines for CMake that stand there: with the tree SOURCE, or with the
# library that is installed in PREFIX.
file(READ ${SOURCE}/README.md page)
string(REGEX MATCH "```cmake\n([^`]*)```" found "${page}")
set(lines "${CMAKE_MATCH_1}")
if(NOT lines MATCHES "add_subdirectory\\(throng [^\n]*# or, once installed: (find_package\\([^\n]*\\))\n")
  message(FATAL_ERROR "the README no longer has both ways: ${lines}")
endif()
if(PREFIX)
  string(REGEX REPLACE "add_subdirectory[^\n]*" "${CMAKE_MATCH_1}" lines "${lines}")
endif()
string(REPLACE "target_link_libraries(" "add_executable(my_game main.cpp)\ntarget_link_libraries(" lines "${lines}")

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
file(CREATE_LINK ${SOURCE} ${FOLDER}/throng SYMBOLIC)
file(COPY_FILE ${SOURCE}/tests/library/readme_program.cpp ${FOLDER}/main.cpp)
file(WRITE ${FOLDER}/CMakeLists.txt
  "cmake_minimum_required(VERSION 3.25)\nproject(my_game LANGUAGES C CXX)\n${lines}")

execute_process(COMMAND ${CMAKE_COMMAND} -S ${FOLDER} -B ${FOLDER}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_PREFIX_PATH=${PREFIX} -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_EXE_LINKER_FLAGS=${FLAGS}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER}/build OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${said}")
endif()
execute_process(COMMAND ${FOLDER}/build/my_game ${SOURCE}/assets/mannequin.glb OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
if(NOT said MATCHES "^pose hash [0-9a-f]+\n$")
  message(SEND_ERROR "the program said: ${said}")
endif()
