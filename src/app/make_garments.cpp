// drape-make-garments OUTPUT_DIR: writes the built-in garments and stands of assets/meshes.
#include "io/garments/garments.hpp"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

void writeAll(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const drape::io::GarmentFile& file : drape::io::garmentFiles()) {
    std::ofstream stream(folder / file.name, std::ios::binary);
    stream << file.text << std::flush;
    if (!stream) {
      throw std::runtime_error((folder / file.name).string() +
                               ": cannot be written. Check permissions and free space.");
    }
  }
}

}  // namespace

int main(int argumentCount, char** arguments) {
  if (argumentCount != 2) {
    std::cerr << "usage: drape-make-garments OUTPUT_DIR\n";
    return 2;
  }
  try {
    writeAll(arguments[1]);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "drape-make-garments: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
