# throng_glad: the functions of OpenGL, for exactly the version and the extensions that are used.
find_program(THRONG_GLAD glad REQUIRED)
set(glad_dir ${CMAKE_CURRENT_BINARY_DIR}/glad)
if(NOT EXISTS ${glad_dir}/src/gl.c)
  execute_process(
    COMMAND ${THRONG_GLAD} --quiet --reproducible --api gl:core=4.5
            --extensions GL_ARB_shader_draw_parameters,GL_KHR_debug --out-path ${glad_dir} c
    COMMAND_ERROR_IS_FATAL ANY)
endif()
add_library(throng_glad OBJECT ${glad_dir}/src/gl.c)
set_target_properties(throng_glad PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_include_directories(throng_glad SYSTEM PUBLIC ${glad_dir}/include)
