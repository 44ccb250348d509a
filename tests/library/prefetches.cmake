# Fails unless the kernels that write palettes prefetch the lines they write. GCC may leave such calls out (compiler.h),
# after which everything still works, a sixth slower.
#   cmake -DOBJDUMP=... "-DOBJECTS=a.o;b.o" -P prefetches.cmake
list(FILTER OBJECTS INCLUDE REGEX "/palette_kernels\\.cpp")
execute_process(COMMAND ${OBJDUMP} -d --no-show-raw-insn ${OBJECTS} OUTPUT_FILE ${CMAKE_CURRENT_BINARY_DIR}/prefetches.txt
  COMMAND_ERROR_IS_FATAL ANY)
file(STRINGS ${CMAKE_CURRENT_BINARY_DIR}/prefetches.txt lines REGEX ">:$|prefetch")
file(REMOVE ${CMAKE_CURRENT_BINARY_DIR}/prefetches.txt)
set(function "")
foreach(line IN LISTS lines)
  if(line MATCHES ">:$")
    set(function "${line}")
  elseif(function MATCHES "rigid_palette|model_palette")
    return()
  endif()
endforeach()
message(FATAL_ERROR "no kernel that writes palettes prefetches")
