# Compiles every source of the program that no library above has, for a system without the libraries that the program links.
# throng::anim with oneTBB is left out, as every build leaves it out where oneTBB is missing.
set(throng ${throng_SOURCE_DIR})
include(${throng}/engine/render/gl/glad.cmake)
set(commit_folder ${CMAKE_CURRENT_BINARY_DIR}/commit)
execute_process(COMMAND ${CMAKE_COMMAND} -DSOURCE=${throng} -DOUTPUT=${commit_folder}/throng_commit.h -P ${throng}/app/commit.cmake)

# These compile themselves once a target (app/CMakeLists.txt).
set_source_files_properties(${throng}/app/people/crowd/steering/near_bodies.cpp ${throng}/app/people/crowd/steering/step_strip.cpp
  PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
foreach(folder engine/base/json engine/anim/import engine/render engine/crowd engine/tracks app)
  string(MAKE_C_IDENTIFIER objects_of_${folder} objects)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${throng}/${folder}/*.cpp)
  add_library(${objects} OBJECT ${sources})
  add_dependencies(${objects} throng_output)
  target_link_libraries(${objects} PRIVATE throng_settings throng_glad throng::throng throng::anim throng::pack hwy::hwy)
  target_include_directories(${objects} SYSTEM PRIVATE ${PORT_HEADERS} ${PORT_HEADERS}/imgui ${commit_folder})
  target_compile_definitions(${objects} PRIVATE THRONG_SOURCE_DIR="${throng}" THRONG_VERSION="${throng_VERSION}")
  target_compile_options(${objects} PRIVATE -O0 -Wall -Wextra)
  target_compile_options(${objects} PRIVATE $<$<BOOL:${MINGW}>:-Wa,-mbig-obj>)  # a unit has more sections than an old object holds
  set_target_properties(${objects} PROPERTIES CXX_EXTENSIONS OFF)
  throng_compile_together(${objects})
endforeach()

file(GLOB example_sources CONFIGURE_DEPENDS ${throng}/engine/anim/examples/*.cpp)
add_library(example_objects OBJECT ${example_sources})
target_link_libraries(example_objects PRIVATE throng::throng)
