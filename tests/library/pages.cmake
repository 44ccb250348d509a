# Makes the pages of the public headers of SOURCE in FOLDER. A warning of doxygen is an error.
file(MAKE_DIRECTORY ${FOLDER})
file(WRITE ${FOLDER}/Doxyfile "@INCLUDE = ${SOURCE}/engine/anim/include/throng/Doxyfile\nOUTPUT_DIRECTORY = ${FOLDER}\n")
execute_process(COMMAND ${DOXYGEN} ${FOLDER}/Doxyfile WORKING_DIRECTORY ${SOURCE} ERROR_VARIABLE said RESULT_VARIABLE status)
if(NOT status EQUAL 0 OR NOT EXISTS ${FOLDER}/html/classthrong_1_1Crowd.html)
  message(FATAL_ERROR "doxygen ended with ${status}: ${said}")
endif()
