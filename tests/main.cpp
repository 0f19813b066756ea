// The main function of the test programs. Each process has its own folder for temporary files, so that the tests of
// several build folders can run at the same time.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

/// A new folder in the folder for temporary files. It takes the place of that folder, for GoogleTest too and for the
/// programs that tests start. The destructor deletes it.
class TemporaryFolder {
 public:
  TemporaryFolder() : folder_((std::filesystem::temp_directory_path() / "drape-tests-XXXXXX").string()) {
    if (mkdtemp(folder_.data()) == nullptr) {
      std::perror(folder_.c_str());
      std::exit(EXIT_FAILURE);
    }
    setenv("TMPDIR", folder_.c_str(), 1);
    setenv("TEST_TMPDIR", folder_.c_str(), 1);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  TemporaryFolder(TemporaryFolder&&) = delete;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;

 private:
  std::string folder_;
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const TemporaryFolder folder;
  return RUN_ALL_TESTS();
}
