# The lines for FetchContent of engine/anim/README.md fetch what the library is made of from a repository that has SOURCE as
# its one commit, no picture and no test, and the project configures with it.
file(READ ${SOURCE}/engine/anim/README.md page)
string(REGEX MATCH "```cmake\n(include\\(FetchContent\\)[^`]*)```" found "${page}")
if(NOT found)
  message(FATAL_ERROR "engine/anim/README.md no longer fetches the tree")
endif()

file(REMOVE_RECURSE ${FOLDER})
function(git)
  execute_process(COMMAND ${GIT} -C ${FOLDER} --git-dir=${FOLDER}/origin --work-tree=${SOURCE} -c user.name=test -c user.email=test ${ARGN}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()
file(MAKE_DIRECTORY ${FOLDER}/origin)
git(init --quiet)
git(config uploadpack.allowFilter true)
foreach(part IN ITEMS CMakeLists.txt LICENSE engine shaders app/README.md assets/pictures)
  git(add ${SOURCE}/${part})
endforeach()
git(commit --quiet --message "The tree")

string(REPLACE " URL " " file://${FOLDER}/origin " lines "${CMAKE_MATCH_1}")
file(WRITE ${FOLDER}/CMakeLists.txt
  "cmake_minimum_required(VERSION 3.25)\nproject(my_game LANGUAGES C CXX)\nadd_executable(my_game main.cpp)\n${lines}")
file(COPY_FILE ${SOURCE}/tests/library/readme_program.cpp ${FOLDER}/main.cpp)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${FOLDER} -B ${FOLDER}/build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${COMPILER}
  OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${said}")
endif()

file(GLOB parts RELATIVE ${FOLDER}/build/_deps/throng-src ${FOLDER}/build/_deps/throng-src/*)
list(REMOVE_ITEM parts .git CMakeLists.txt LICENSE)
if(NOT parts STREQUAL "engine;shaders")
  message(SEND_ERROR "these were fetched: ${parts}")
endif()
