#include "input_error.hpp"
#include "io/mesh_import.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stop_token>
#include <thread>

namespace drape::io {
namespace {

namespace fs = std::filesystem;

const std::string fourVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";

std::string problemOf(std::string_view name, std::string_view bytes) {
  return inputErrorOf([&] { (void)importMeshFromMemory(name, bytes, {}); });
}

/// Pseudo-random bytes, the same in every run.
std::string noise(std::size_t count) {
  std::string bytes;
  std::uint64_t state = 12345;
  for (std::size_t i = 0; i < count; ++i) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    bytes += static_cast<char>(state >> 56U);
  }
  return bytes;
}

/// A separate folder, removed at the end.
class ImportFailure : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "drape-io-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }

  void TearDown() override {
    unsetenv("DRAPE_MESH_IMPORT");
    fs::remove_all(folder_);
  }

  fs::path write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  /// Replaces the import program by a shell script.
  void pretendReader(const std::string& script) {
    const fs::path program = write("reader", "#!/bin/sh\n" + script + "\n");
    fs::permissions(program, fs::perms::owner_all);
    setenv("DRAPE_MESH_IMPORT", program.c_str(), 1);
  }

  /// The message for a valid file.
  static std::string problemOfSoundFile(double timeLimit = 0.0) {
    ImportOptions options;
    options.timeLimit = timeLimit;
    return inputErrorOf([&] { (void)importMeshFromMemory("sound.obj", fourVertices + "f 1 2 3\n", options); });
  }

  fs::path folder_;
};

std::string problemOfFile(const fs::path& file) {
  return inputErrorOf([&] { (void)importMesh(file, {}); });
}

TEST_F(ImportFailure, namesAFileThatIsMissing) {
  const std::string message = problemOfFile(folder_ / "missing.obj");
  EXPECT_TRUE(contains(message, "missing.obj: no such file")) << message;
}

TEST_F(ImportFailure, namesADirectory) {
  fs::create_directory(folder_ / "folder.obj");
  EXPECT_TRUE(contains(problemOfFile(folder_ / "folder.obj"), "folder.obj: is a directory"));
}

TEST_F(ImportFailure, namesAPipe) {
  ASSERT_EQ(mkfifo((folder_ / "pipe.obj").c_str(), 0600), 0);
  EXPECT_TRUE(contains(problemOfFile(folder_ / "pipe.obj"), "pipe.obj: is not a regular file"));
}

TEST_F(ImportFailure, namesAFileThatMayNotBeRead) {
  if (geteuid() == 0) {
    GTEST_SKIP() << "root may read everything";
  }
  const fs::path file = write("locked.obj", fourVertices);
  fs::permissions(file, fs::perms::none);
  EXPECT_TRUE(contains(problemOfFile(file), "locked.obj: cannot be read"));
}

TEST_F(ImportFailure, namesAFileThatIsTooLargeWithoutReadingIt) {
  const fs::path file = write("large.obj", "");
  fs::resize_file(file, std::uintmax_t{600} << 20);
  EXPECT_TRUE(contains(problemOfFile(file), "600 MiB large, and the limit is 512 MiB"));
}

TEST_F(ImportFailure, listsTheFormatsForAnUnknownEnding) {
  for (const std::string name : {"shirt.xyz", "shirt", "shirt."}) {
    const std::string message = problemOfFile(write(name, fourVertices));
    EXPECT_TRUE(contains(message, ".obj, .ply, .stl, .off, .glb, .gltf")) << message;
  }
}

TEST_F(ImportFailure, saysWhatToExportInsteadOfAFormatThatIsNotRead) {
  EXPECT_TRUE(
      contains(problemOfFile(write("a.fbx", "x")), "a.fbx: '.fbx' files are not supported. Open it in Blender"));
  EXPECT_TRUE(contains(problemOfFile(write("a.DAE", "x")), "'.dae' files are not supported"));
  EXPECT_TRUE(contains(problemOfFile(write("a.zprj", "x")), "Marvelous Designer and export the garment as OBJ"));
}

TEST_F(ImportFailure, namesAnEmptyFile) {
  EXPECT_TRUE(contains(problemOfFile(write("empty.obj", "")), "empty.obj: the file is empty"));
}

TEST_F(ImportFailure, namesTheLineOfACoordinateThatIsNotFinite) {
  for (const std::string word : {"nan", "inf", "-inf", "1e400"}) {
    const std::string message = problemOf("bad.obj", "v 0 0 0\nv " + word + " 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_TRUE(contains(message, "bad.obj: line 2: '" + word + "'")) << message;
  }
}

TEST_F(ImportFailure, namesTheLineOfAMissingVertex) {
  EXPECT_TRUE(contains(problemOf("bad.obj", fourVertices + "f 1 2 9\n"), "bad.obj: line 5: there is no vertex 9"));
  EXPECT_TRUE(contains(problemOf("bad.obj", fourVertices + "f 0 1 2\n"), "bad.obj: line 5: vertex 0 does not exist"));
}

TEST_F(ImportFailure, saysThatThereAreNoFaces) {
  EXPECT_TRUE(contains(problemOf("bad.obj", fourVertices), "bad.obj: there are no faces"));
  EXPECT_TRUE(contains(problemOf("bad.obj", fourVertices + "f 1 2\n"), "no faces in it but lines and points"));
  EXPECT_TRUE(contains(problemOf("bad.obj", fourVertices + "l 1 2\nl 2 3\n"), "no faces in it but lines and points"));
  EXPECT_TRUE(contains(problemOf("bad.obj", fourVertices + "f 1 1 2\nf 3 3 3\n"), "none of its"));
}

TEST_F(ImportFailure, refusesRandomBytesInEveryFormat) {
  for (const std::string& format : meshFormats()) {
    for (const std::size_t size : {1U, 7U, 100U, 5000U}) {
      const std::string message = problemOf("noise." + format, noise(size));
      EXPECT_TRUE(contains(message, "noise." + format + ": ")) << message;
    }
  }
}

TEST_F(ImportFailure, readsAFileOnlyAsWhatItsNameSays) {
  EXPECT_TRUE(contains(problemOf("really_obj.stl", fourVertices + "f 1 2 3\n"), "it is too short for an STL file"));
  EXPECT_TRUE(contains(problemOf("really_stl.obj", "solid x\nendsolid x\n"), "it is not an OBJ file"));
}

TEST_F(ImportFailure, survivesObjFilesCutOffAnywhere) {
  const std::string whole = fourVertices + "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\nf 2/2 4/1 3/3\n";
  for (std::size_t size = 1; size < whole.size(); size += 3) {
    try {
      (void)importMeshFromMemory("cut.obj", whole.substr(0, size), {});
    } catch (const messages::InputError& error) {
      EXPECT_TRUE(contains(error.what(), "cut.obj: ")) << error.what();
    }
  }
}

TEST_F(ImportFailure, namesTheVertexThatLiesFarFromTheRest) {
  std::string obj = "# sheet\n";
  for (int i = 0; i < 25; ++i) {
    obj += "v " + std::to_string(i % 5) + (i == 16 ? " 1e5" : " 0") + " " + std::to_string(i / 5) + "\n";
  }
  for (int i = 1; i < 20; ++i) {
    obj +=
        i % 5 == 0 ? "" : "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 5) + "\n";
  }
  EXPECT_TRUE(contains(problemOf("far.obj", obj), "far.obj: vertex 17 (line 18) lies 100 km from the rest"));
}

TEST_F(ImportFailure, cancelsWhileTheReaderWorks) {
  const fs::path started = folder_ / "started";
  pretendReader("touch '" + started.string() + "'; exec sleep 60");
  std::stop_source source;
  ImportOptions options;
  options.watch.stop = source.get_token();
  options.watch.progress = [&source](double share, std::string_view) {
    if (share >= 0.2) {
      source.request_stop();
    }
  };
  std::thread later([&source, &started] {
    while (!fs::exists(started)) {
      std::this_thread::yield();
    }
    source.request_stop();
  });
  EXPECT_THROW((void)importMeshFromMemory("sound.obj", fourVertices + "f 1 2 3\n", options), Cancelled);
  later.join();
}

/// Checks that a message is short, has no control characters, and contains the file name.
void expectGoodMessage(const std::string& name, const std::string& message) {
  EXPECT_LT(message.size(), 400U) << message;
  EXPECT_TRUE(contains(message, name + ": ")) << message;
  EXPECT_TRUE(std::none_of(message.begin(), message.end(), [](char letter) { return letter >= 0 && letter < ' '; }))
      << message;
}

TEST_F(ImportFailure, hasAGoodMessageForEveryDamagedFile) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.obj", fourVertices + "vt 0 0\nf 1/1 2/1 3/1\nf 2 4 3\n"},
      {"a.stl", "solid x\n" + facet + "endsolid x\n"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"a.gltf", R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"a.bin"}],"meshes":[{}]})"}};
  const std::string bytes = noise(200);
  for (const auto& [name, whole] : files) {
    for (std::size_t i = 0; i < 24; ++i) {
      std::string damaged = whole;
      damaged[i * 37 % whole.size()] = bytes[2 * i];
      try {
        (void)importMeshFromMemory(name, damaged, {});
      } catch (const messages::InputError& error) {
        expectGoodMessage(name, error.what());
      }
    }
  }
}

TEST_F(ImportFailure, turnsACrashOfTheReaderIntoAMessage) {
  pretendReader("cat > /dev/null; kill -SEGV $$");
  const std::string message = problemOfSoundFile();
  EXPECT_TRUE(contains(message, "sound.obj: the mesh reader crashed")) << message;
  pretendReader("kill -ABRT $$");
  EXPECT_TRUE(contains(problemOfSoundFile(), "sound.obj: the mesh reader crashed"));
}

TEST_F(ImportFailure, turnsAFailureOfTheReaderIntoAMessage) {
  pretendReader("exit 3");
  EXPECT_TRUE(contains(problemOfSoundFile(), "exit status 3"));
}

TEST_F(ImportFailure, givesUpOnAReaderThatStalls) {
  const auto start = std::chrono::steady_clock::now();
  pretendReader("exec sleep 60");
  const std::string message = problemOfSoundFile(0.3);
  EXPECT_TRUE(contains(message, "sound.obj: reading it took longer than 0.3 s")) << message;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST_F(ImportFailure, doesNotBelieveAReaderThatTalksNonsense) {
  pretendReader("cat > /dev/null; echo nonsense");
  EXPECT_TRUE(contains(problemOfSoundFile(), "sound.obj: the answer of drape-mesh-import"));
  pretendReader("cat > /dev/null");
  EXPECT_TRUE(contains(problemOfSoundFile(), "sound.obj: the answer of drape-mesh-import"));
}

TEST_F(ImportFailure, saysWhereTheReaderShouldBe) {
  setenv("DRAPE_MESH_IMPORT", "/nowhere/drape-mesh-import", 1);
  EXPECT_TRUE(contains(problemOfSoundFile(), "/nowhere/drape-mesh-import"));
}

}  // namespace
}  // namespace drape::io
