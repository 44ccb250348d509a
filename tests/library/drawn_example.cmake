# Runs PROGRAM with ARGUMENTS and the name of a picture that it writes, and compares the picture with GOLDEN by COMPARE.
file(REMOVE ${PICTURE})
execute_process(COMMAND ${CMAKE_COMMAND} -E env LIBGL_ALWAYS_SOFTWARE=1 ${PROGRAM} ${ARGUMENTS} ${PICTURE} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${COMPARE} compare ${GOLDEN} ${PICTURE} --mean 0.8 --worst-block 9 COMMAND_ERROR_IS_FATAL ANY)
