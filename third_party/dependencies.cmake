# How each dependency is found. All are Debian packages (docs/guide/building.md says which and why); no sources are copied here.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
pkg_check_modules(hwy REQUIRED IMPORTED_TARGET libhwy)
pkg_check_modules(gmpxx REQUIRED IMPORTED_TARGET gmpxx)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(assimp REQUIRED)
find_package(glfw3 3.3 REQUIRED)
find_package(OpenGL REQUIRED COMPONENTS OpenGL)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus)
pkg_check_modules(osmesa REQUIRED IMPORTED_TARGET osmesa)

# GLEW's own CMake and pkg-config files bring libGL with them. The headless program must not load libGL ahead of
# OSMesa, so the bare library is found here and each program adds the GL it draws with.
find_path(GLEW_INCLUDE_DIR GL/glew.h REQUIRED)
find_library(GLEW_LIBRARY GLEW REQUIRED)
add_library(drape_glew INTERFACE)
target_include_directories(drape_glew SYSTEM INTERFACE "${GLEW_INCLUDE_DIR}")
target_link_libraries(drape_glew INTERFACE "${GLEW_LIBRARY}")

find_path(STB_INCLUDE_DIR stb/stb_image_write.h REQUIRED)
add_library(drape_stb INTERFACE)
target_include_directories(drape_stb SYSTEM INTERFACE "${STB_INCLUDE_DIR}")

# The interface's typeface is embedded, so that text looks the same on every machine.
find_file(DRAPE_FONT Roboto-Regular.ttf REQUIRED PATHS /usr/share/fonts/truetype/roboto/unhinted/RobotoTTF NO_DEFAULT_PATH)
