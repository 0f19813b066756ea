# drape_unity(<target>): compiles several sources at a time where DRAPE_UNITY_BUILD says so. Headers are then read, and
# Eigen's templates compiled, once for the batch instead of once a source. Sources that Highway includes again for each
# instruction set (hwy/foreach_target.h) must be compiled alone. Names of a source's own (its unnamed namespace) must differ
# from those of its neighbours in the same library or test program.
function(drape_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${DRAPE_UNITY_BUILD} UNITY_BUILD_BATCH_SIZE 12)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "_kernel\\.cpp$")
  set_source_files_properties(${sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# drape_library(<path> [SOURCES <files>] [LINKS <targets>] [PRIVATE_LINKS <targets>] [ALONE])
#
# Adds the static library drape_<path> for src/<path>; a slash in the path becomes "_" in the name. Without sources it is
# a library of headers. Its headers are reached as "<path>/header.hpp", and only by targets that link it: each library
# publishes a folder that contains only a link to its own sources. So an include that points upwards in the layering
# does not compile. ALONE keeps it out of unity builds.
function(drape_library path)
  cmake_parse_arguments(ARG "ALONE" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  string(REPLACE "/" "_" name "${path}")
  set(include_root "${PROJECT_BINARY_DIR}/include/${name}")
  cmake_path(GET path PARENT_PATH parent)
  file(MAKE_DIRECTORY "${include_root}/${parent}")
  file(CREATE_LINK "${PROJECT_SOURCE_DIR}/src/${path}" "${include_root}/${path}" SYMBOLIC)

  if(NOT ARG_SOURCES)
    add_library(drape_${name} INTERFACE)
    target_include_directories(drape_${name} INTERFACE "${include_root}")
    target_link_libraries(drape_${name} INTERFACE ${ARG_LINKS})
    return()
  endif()
  add_library(drape_${name} STATIC ${ARG_SOURCES})
  target_include_directories(drape_${name} PUBLIC "${include_root}")
  target_link_libraries(drape_${name} PUBLIC drape_compiler ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
  if(NOT ARG_ALONE)
    drape_unity(drape_${name})
  endif()
endfunction()

# drape_program(<name> SOURCES <files> LINKS <targets>): an executable in <build>/bin. Every program requests
# huge pages for large blocks of memory (src/app/operator_new.cpp).
function(drape_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  set(operator_new "${PROJECT_SOURCE_DIR}/src/app/operator_new.cpp")
  # Compiled together with a caller of operator new, its free() causes the warning mismatched-new-delete.
  set_source_files_properties("${operator_new}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  add_executable(${name} ${ARG_SOURCES} "${operator_new}")
  target_link_libraries(${name} PRIVATE drape_compiler ${ARG_LINKS})
  drape_unity(${name})
endfunction()
