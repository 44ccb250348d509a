# Included by ctest: throng_add_suites(FOLDER PROGRAM LABELS TIMES_AS_SLOW) asks a program for its suites and adds one test a suite.
# A test a process costs more than most tests: a second of loading under the sanitizers.
function(throng_add_suites folder program labels times_as_slow)
  if(NOT EXISTS "${program}")
    add_test(${folder}.IsNotBuilt ${program})
    set_tests_properties(${folder}.IsNotBuilt PROPERTIES LABELS "${labels}")
    return()
  endif()
  execute_process(COMMAND ${program} --gtest_list_tests TIMEOUT 60 OUTPUT_VARIABLE listed RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${program} --gtest_list_tests: ${result}")
  endif()
  string(REGEX REPLACE "[;#][^\n]*|\\[|\\]" "" listed "${listed}")  # values of parameters
  string(REGEX MATCHALL "[^ \n]+\\. *(\n  [^\n]+)+" suites "${listed}")
  foreach(suite IN LISTS suites)
    string(REGEX MATCHALL "\n  " tests "${suite}")
    list(LENGTH tests count)
    math(EXPR seconds "50 + 20 * ${count}")  # some tests open four shows, each in seconds on a busy core
    if(folder STREQUAL assets)  # programs make their files anew, which takes minutes on a busy core
      math(EXPR seconds "600 + ${seconds}")
    endif()
    math(EXPR seconds "${times_as_slow} * ${seconds}")
    if(labels MATCHES window)  # a person's afternoon is one test
      math(EXPR seconds "2 * ${seconds}")
    endif()
    string(REGEX REPLACE "\\..*" "" suite "${suite}")
    add_test(${folder}.${suite} ${program} --gtest_filter=${suite}.*)
    set_tests_properties(${folder}.${suite} PROPERTIES LABELS "${labels}" TIMEOUT ${seconds})
  endforeach()
endfunction()
