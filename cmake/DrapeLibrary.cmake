# drape_library(<name> SOURCES <files> [LINKS <targets>] [PRIVATE_LINKS <targets>])
#
# Adds the static library drape_<name> for src/<name>. Its headers are reached as "<name>/header.hpp", and only by
# targets that link it: each library publishes a folder that holds nothing but a link to its own sources. So an
# include that points upwards in the layering does not compile.
function(drape_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  set(include_root "${PROJECT_BINARY_DIR}/include/${name}")
  file(MAKE_DIRECTORY "${include_root}")
  file(CREATE_LINK "${PROJECT_SOURCE_DIR}/src/${name}" "${include_root}/${name}" SYMBOLIC)

  add_library(drape_${name} STATIC ${ARG_SOURCES})
  target_include_directories(drape_${name} PUBLIC "${include_root}")
  target_link_libraries(drape_${name} PUBLIC drape_compiler ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
endfunction()

# drape_program(<name> SOURCES <files> LINKS <targets>): an executable in <build>/bin.
function(drape_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE drape_compiler ${ARG_LINKS})
endfunction()
