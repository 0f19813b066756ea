#include "io/mesh_import.hpp"

#include "glb_file.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace drape::io {
namespace {

const std::string fourCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";

ImportedMesh import(std::string_view name, std::string_view bytes) {
  return importMeshFromMemory(name, bytes, {});
}

/// A unit square as binary glTF, in a node that mirrors and stretches it to x = 0 .. -2.
std::string glbSquare() {
  std::string data;
  for (const float value : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 1.0F, 1.0F, 0.0F}) {
    data += littleEndian(value);
  }
  for (const std::uint32_t index : {0U, 1U, 2U, 1U, 3U, 2U}) {
    data += littleEndian(index);
  }
  const std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[-2,1,1]}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"byteLength":72}],)"
      R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},)"
      R"({"bufferView":1,"componentType":5125,"count":6,"type":"SCALAR"}]})";
  return glbFile(json, data);
}

TEST(MeshImport, refusesMoreTrianglesThanAllowed) {
  ImportOptions options;
  options.maxTriangles = 2;
  const std::string quads = fourCorners + "f 1 2 4 3\n";
  EXPECT_EQ(importMeshFromMemory("a.obj", quads, options).summary.triangles, 2);
  options.maxTriangles = 1;
  for (const auto& [name, bytes] : {std::pair("a.obj", quads), std::pair("a.glb", glbSquare())}) {
    try {
      (void)importMeshFromMemory(name, bytes, options);
      ADD_FAILURE() << name;
    } catch (const messages::InputError& error) {
      EXPECT_NE(std::string(error.what())
                    .find(std::string(name) + ": it has 2 triangles, and the limit for this body is 1. Reduce"),
                std::string::npos)
          << error.what();
    }
  }
}

TEST(MeshImport, keepsTheVerticesOfTheFileOfABodyOnRequest) {
  ImportOptions options;
  options.use = MeshUse::Body;
  const std::string obj = "v 9 9 9\n" + fourCorners + "v 1 0 0\nf 2 3 4\nf 6 5 4\n";
  EXPECT_EQ(importMeshFromMemory("a.obj", obj, options).file, nullptr);
  options.keepsFile = true;
  const ImportedMesh mesh = importMeshFromMemory("a.obj", obj, options);
  ASSERT_NE(mesh.file, nullptr);
  ASSERT_EQ(mesh.file->particle.size(), 6U);
  EXPECT_EQ(mesh.file->particle[0], -1) << "no face uses it";
  EXPECT_EQ(mesh.file->particle[2], mesh.file->particle[5]) << "they are at one place";
}

TEST(MeshImport, readsAnObjFile) {
  const ImportedMesh mesh = import("a.obj", fourCorners + "f 1 2 3\nf 2 4 3\n");
  EXPECT_EQ(mesh.summary.vertices, 4);
  EXPECT_EQ(mesh.summary.triangles, 2);
  EXPECT_EQ(mesh.summary.springs, 5);
  EXPECT_EQ(mesh.summary.source, "a.obj");
}

TEST(MeshImport, readsAPlyFile) {
  const ImportedMesh mesh =
      import("a.ply",
             "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
             "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
             "0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
  EXPECT_EQ(mesh.summary.vertices, 4);
  EXPECT_EQ(mesh.summary.springs, 5);
}

TEST(MeshImport, readsAnStlFileAndJoinsItsTriangles) {
  const std::string facet = "facet normal 0 0 1\nouter loop\n";
  const std::string end = "endloop\nendfacet\n";
  const ImportedMesh mesh =
      import("a.stl", "solid x\n" + facet + "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n" + end + facet +
                          "vertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n" + end + "endsolid x\n");
  EXPECT_EQ(mesh.summary.vertices, 4);
  EXPECT_EQ(mesh.summary.springs, 5);
}

TEST(MeshImport, readsBinaryGltfWithTheTransformsOfItsNodes) {
  const ImportedMesh mesh = import("a.glb", glbSquare());
  EXPECT_EQ(mesh.summary.vertices, 4);
  EXPECT_DOUBLE_EQ(mesh.summary.size[0], 2.0);
  const Triangle& face = mesh.cloth.triangles.front();
  const auto at = [&mesh, &face](std::size_t corner) { return mesh.cloth.positions[face[corner]]; };
  const Vec3 ab = at(1) - at(0);
  const Vec3 ac = at(2) - at(0);
  EXPECT_GT(ab.x() * ac.y() - ab.y() * ac.x(), 0.0) << "a mirrored mesh still shows its front";
}

TEST(MeshImport, takesTheEndingInCapitals) {
  EXPECT_EQ(import("A.OBJ", fourCorners + "f 1 2 3\n").summary.triangles, 1);
}

TEST(MeshImport, triangulatesQuadsAndPolygons) {
  EXPECT_EQ(import("a.obj", fourCorners + "f 1 2 4 3\n").summary.triangles, 2);
  EXPECT_EQ(import("a.obj", fourCorners + "v -0.5 0.5 0\nf 1 2 4 3 5\n").summary.triangles, 3);
}

TEST(MeshImport, joinsObjectsAndMaterialGroups) {
  const ImportedMesh mesh = import(
      "a.obj", "mtllib nowhere.mtl\n" + fourCorners + "o one\nusemtl red\nf 1 2 3\no two\nusemtl blue\nf 2 4 3\n");
  EXPECT_EQ(mesh.summary.vertices, 4);
  EXPECT_EQ(mesh.summary.components, 1);
}

TEST(MeshImport, splitsByTextureCoordinatesButNotByNormals) {
  const ImportedMesh mesh = import("a.obj", fourCorners +
                                                "vt 0 0\nvt 1 0\nvt 0 1\nvt 5 5\nvn 0 0 1\nvn 0 1 0\n"
                                                "f 1/1/1 2/2/1 3/3/1\nf 2/2/2 4/4/2 3/3/2\n");
  EXPECT_EQ(mesh.render.uvs.size(), 4U);
  EXPECT_EQ(mesh.render.uvs[1], Vec2(1, 0));
  const ImportedMesh seam =
      import("a.obj", fourCorners + "vt 0 0\nvt 1 0\nvt 0 1\nvt 5 5\nf 1/1 2/2 3/3\nf 2/4 4/4 3/3\n");
  EXPECT_EQ(seam.render.uvs.size(), 5U);
  EXPECT_EQ(seam.summary.vertices, 4);
}

TEST(MeshImport, warnsWhereTheDistanceFromTheOriginRoundsTheEdges) {
  const auto squareAt = [](const std::string& x0, const std::string& x1) {
    return import("a.obj", "v " + x0 + " 0 0\nv " + x1 + " 0 0\nv " + x0 + " 1 0\nv " + x1 + " 1 0\nf 1 2 4 3\n");
  };
  EXPECT_TRUE(squareAt("1000.3", "1001.3").summary.warnings.empty());
  const ImportedMesh far = squareAt("100000.3", "100001.3");
  ASSERT_EQ(far.summary.warnings.size(), 1U);
  EXPECT_NE(far.summary.warnings[0].find("as large as 1e+05"), std::string::npos) << far.summary.warnings[0];
  EXPECT_NE(far.summary.warnings[0].find("off by up to 1.2 %"), std::string::npos) << far.summary.warnings[0];
}

TEST(MeshImport, leavesOutPointsAndLines) {
  const ImportedMesh mesh = import("a.obj", fourCorners + "f 1 2\nf 1 2 3\nl 1 4\n");
  EXPECT_EQ(mesh.summary.triangles, 1);
  EXPECT_EQ(mesh.summary.facesSkipped, 2);
}

TEST(MeshImport, countsFromTheEndWhereAnObjFileDoes) {
  EXPECT_EQ(import("a.obj", fourCorners + "f -4 -3 -2\n").summary.triangles, 1);
}

TEST(MeshImport, scalesToMetres) {
  ImportOptions options;
  options.metresPerUnit = 0.01;
  EXPECT_NEAR(importMeshFromMemory("a.obj", fourCorners + "f 1 2 3\n", options).summary.size[0], 0.01, 1e-12);
}

TEST(MeshImport, readsAnOffFile) {
  const ImportedMesh mesh =
      import("a.off", "OFF\n# square\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2 255 0 0\n");
  EXPECT_EQ(mesh.summary.vertices, 4);
  EXPECT_EQ(mesh.summary.springs, 5);
}

/// The square of glbSquare as text, with its buffer under the name `uri`.
std::string gltfSquare(const std::string& uri) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"byteLength":72,"uri":")" +
         uri +
         R"("}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},)"
         R"({"bufferView":1,"componentType":5125,"count":6,"type":"SCALAR"}]})";
}

TEST(MeshImport, readsGltfWithItsBufferInside) {
  const ImportedMesh mesh =
      import("a.gltf", gltfSquare("data:application/octet-stream;base64,"
                                  "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAACAPwAAgD8AAAAA"
                                  "AAAAAAEAAAACAAAAAQAAAAMAAAACAAAA"));
  EXPECT_EQ(mesh.summary.vertices, 4);
  EXPECT_EQ(mesh.summary.springs, 5);
  EXPECT_EQ(mesh.format.metresPerUnit, 1.0);
}

TEST(MeshImport, readsGltfWithItsBufferBesideIt) {
  std::string pattern = (std::filesystem::temp_directory_path() / "drape-gltf-XXXXXX").string();
  ASSERT_NE(mkdtemp(pattern.data()), nullptr);
  const std::filesystem::path folder = pattern;
  const std::string glb = glbSquare();
  std::ofstream(folder / "the buffer.bin", std::ios::binary) << glb.substr(glb.size() - 72);
  std::ofstream(folder / "a.gltf") << gltfSquare("the%20buffer.bin");
  EXPECT_EQ(importMesh(folder / "a.gltf", {}).summary.springs, 5);
  std::filesystem::remove_all(folder);
}

TEST(MeshImport, readsTextWithAByteOrderMarkWideLettersOrIndentation) {
  const std::string plain = fourCorners + "f 1 2 3\nf 2 4 3\n";
  std::string wide = "\xff\xfe";
  std::string indented;
  for (const char letter : plain) {
    (wide += letter) += '\0';
    indented += letter == '\n' ? std::string("\r\n \t") : std::string(1, letter);
  }
  for (const std::string& text : {"\xef\xbb\xbf" + plain, wide, indented}) {
    EXPECT_EQ(import("a.obj", text).summary.triangles, 2);
  }
}

TEST(MeshImport, readsABinaryPlyWhoseNumbersBeginWithABlank) {
  for (int first = 0; first < 256; ++first) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    bytes += littleEndian((std::bit_cast<std::uint32_t>(0.25F) & ~0xffU) | static_cast<std::uint32_t>(first));
    for (const float value : {0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F}) {
      bytes += littleEndian(value);
    }
    bytes += '\3' + littleEndian(0U) + littleEndian(1U) + littleEndian(2U);
    const bool slow = first > 13 && first != ' ' && first % 16 != 0;
    if (!slow) {
      EXPECT_EQ(import("a.ply", bytes).summary.triangles, 1) << "first byte " << first;
    }
  }
}

TEST(MeshImport, reportsItsProgress) {
  std::vector<double> shares;
  ImportOptions options;
  options.watch.progress = [&shares](double share, std::string_view stage) {
    shares.push_back(share);
    EXPECT_FALSE(stage.empty());
  };
  (void)importMeshFromMemory("a.obj", fourCorners + "f 1 2 3\n", options);
  EXPECT_GE(shares.size(), 3U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GT(shares.back(), 0.9);
  EXPECT_LE(shares.back(), 1.0);
}

TEST(MeshImport, hasTheUnitAndTheUpAxisThatTheFormatPrescribes) {
  const FormatFacts gltf = import("a.glb", glbSquare()).format;
  EXPECT_EQ(gltf.metresPerUnit, 1.0);
  EXPECT_EQ(gltf.up, 'y');
  const FormatFacts obj = import("a.obj", fourCorners + "f 1 2 3\n").format;
  EXPECT_FALSE(obj.metresPerUnit.has_value());
  EXPECT_FALSE(obj.up.has_value());
}

TEST(MeshImport, offersFormatsWithoutDots) {
  for (const std::string& format : meshFormats()) {
    EXPECT_NE(format.front(), '.');
  }
}

}  // namespace
}  // namespace drape::io
