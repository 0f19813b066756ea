# drape_build_info(<target>)
#
# Gives a program "build_info.hpp": compiler, flags and the commit that it is built from. Each build determines the commit; the
# file changes, and the program is compiled again, only when the commit changes.
function(drape_build_info target)
  set(folder "${PROJECT_BINARY_DIR}/build_info/${target}")
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  set(flags "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} -ffp-contract=off")
  if(DRAPE_SANITIZER)
    string(APPEND flags " -fsanitize=${DRAPE_SANITIZER}")
  endif()
  string(STRIP "${flags}" flags)
  add_custom_target(${target}-build-info
    BYPRODUCTS "${folder}/build_info.hpp"
    COMMAND "${CMAKE_COMMAND}" -D "SOURCE=${PROJECT_SOURCE_DIR}" -D "OUTPUT=${folder}/build_info.hpp"
      -D "COMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" -D "FLAGS=${flags}"
      -D "BUILD_TYPE=${CMAKE_BUILD_TYPE}" -P "${PROJECT_SOURCE_DIR}/cmake/WriteBuildInfo.cmake"
    VERBATIM)
  add_dependencies(${target} ${target}-build-info)
  target_include_directories(${target} PRIVATE "${folder}")
endfunction()
