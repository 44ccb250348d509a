# Runs PROGRAM with MODEL, SHADERS where it takes them, and the name of the PICTURE that it writes; COMPAREs it with GOLDEN.
file(REMOVE ${PICTURE})
execute_process(COMMAND ${CMAKE_COMMAND} -E env LIBGL_ALWAYS_SOFTWARE=1 ${PROGRAM} ${MODEL} ${SHADERS} ${PICTURE} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${COMPARE} compare ${GOLDEN} ${PICTURE} --mean 0.8 --worst-block 9 COMMAND_ERROR_IS_FATAL ANY)
