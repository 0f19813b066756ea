# One target that every target of the project links: the language, the warnings, the floating-point rules and the sanitizers.
add_library(drape_compiler INTERFACE)
target_compile_features(drape_compiler INTERFACE cxx_std_20)
set(CMAKE_CXX_EXTENSIONS OFF)

# The same inputs give the same bits: the compiler must not fuse a multiplication and an addition unless the source does.
target_compile_options(drape_compiler INTERFACE -ffp-contract=off)

target_compile_options(drape_compiler INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion
                                                -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast)
# In a unity build a local name of a test may be that of a function in another test.
target_compile_options(drape_compiler INTERFACE $<$<NOT:$<BOOL:$<TARGET_PROPERTY:DRAPE_MAY_SHADOW>>>:-Wshadow>)
# GCC 12 sees overlapping copies in std::string's operator+ where there are none (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(drape_compiler INTERFACE -Wno-restrict)
endif()
if(DRAPE_WARNINGS_AS_ERRORS)
  target_compile_options(drape_compiler INTERFACE -Werror)
endif()

if(DRAPE_SANITIZER)
  target_compile_options(drape_compiler INTERFACE -fsanitize=${DRAPE_SANITIZER} -fno-sanitize-recover=all
                                                  -fno-omit-frame-pointer)
  target_link_options(drape_compiler INTERFACE -fsanitize=${DRAPE_SANITIZER})
  # These checks instrument every memory access and double the time to compile. AddressSanitizer finds most of the same
  # errors, but no misaligned accesses.
  if(DRAPE_SANITIZER MATCHES "undefined")
    target_compile_options(drape_compiler INTERFACE -fno-sanitize=null,object-size,alignment,pointer-overflow)
  endif()
  # The checks that a sanitizer inserts hide initialisations from GCC's analysis: it warns inside std::regex.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(drape_compiler INTERFACE -Wno-maybe-uninitialized)
  endif()
  # An address-space limit would starve the sanitizer's own shadow memory, so the mesh importer leaves it out.
  target_compile_definitions(drape_compiler INTERFACE DRAPE_SANITIZED=1)
endif()
