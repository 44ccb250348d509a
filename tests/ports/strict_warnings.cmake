# Warnings under which a host may compile our public headers. They are more than we ask for ourselves.
set(strict_warnings -Wall -Wextra -Wpedantic -Werror -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast
  -Wnon-virtual-dtor -Woverloaded-virtual -Wdouble-promotion -Wcast-align -Wcast-qual -Wformat=2 -Wundef -Wunused
  -Wnull-dereference -Wextra-semi -Wmissing-declarations -Wredundant-decls)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  list(APPEND strict_warnings -Wduplicated-cond -Wduplicated-branches -Wlogical-op -Wsuggest-override -Wzero-as-null-pointer-constant)
else()
  list(APPEND strict_warnings -Wimplicit-fallthrough -Wshadow-all -Wsuggest-override -Wheader-hygiene -Wcomma
    -Wzero-as-null-pointer-constant -Wno-unused-private-field)
endif()
