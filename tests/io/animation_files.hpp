#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace drape::io {

/// A glTF document of a bar of two bones along y, in metres: vertices at heights 0, 1 and 2, in a strip of the width 1.
/// The bone "lower" ends at the height 1, where the bone "upper" begins. In the clip "bend" of 2 s the upper bone turns
/// by 90 degrees about z; in the clip "still" it does not.
struct BarFile {
  std::string joints = "[1, 2]";                 ///< of the skin
  std::array<float, 3> times{0.0F, 1.0F, 2.0F};  ///< of the keys of "bend" [s]
  std::string name = "bend";                     ///< of the clip that bends
  std::string interpolation = "LINEAR";          ///< of the keys of "bend"; tangents of CUBICSPLINE are 0

  std::string upperPose;         ///< more keys of the node "upper", after a comma: its turn without a clip
  std::string meshName = "bar";  ///< of the node of the mesh
  std::string meshPose;          ///< the same of the node of the mesh, which readers of skinned meshes ignore

  float weight = 1.0F;  ///< a factor on the weights of all vertices

  bool isSolid = false;  ///< a closed block of the depth 1 instead of a strip

  int layers = 1;  ///< how often the mesh has each of its triangles

  [[nodiscard]] std::string text() const;
};

inline std::string base64Text(const std::string& bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? letters[group >> (18U - 6U * k) & 63U] : '=';
    }
  }
  return text;
}

inline std::string BarFile::text() const {
  std::string data;
  std::string views;
  std::string accessors;
  int count = 0;
  const auto add = [&](const void* values, std::size_t bytes, int elements, int component, const std::string& type,
                       const std::string& more = "") {
    const std::string sep = count > 0 ? "," : "";
    views += sep + R"({"buffer":0,"byteOffset":)" + std::to_string(data.size()) + R"(,"byteLength":)" +
             std::to_string(bytes) + "}";
    accessors += sep + R"({"bufferView":)" + std::to_string(count++) + R"(,"componentType":)" +
                 std::to_string(component) + R"(,"count":)" + std::to_string(elements) + R"(,"type":")" + type + "\"" +
                 more + "}";
    data.append(static_cast<const char*>(values), bytes);
    data.append((4 - data.size() % 4) % 4, '\0');
  };
  std::vector<float> positions;
  std::vector<std::uint8_t> bones;
  std::vector<float> weights;
  const std::vector<std::array<float, 2>> corners =
      isSolid ? std::vector<std::array<float, 2>>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}
              : std::vector<std::array<float, 2>>{{0, 0}, {1, 0}};
  for (int row = 0; row < 3; ++row) {
    for (const auto& [x, z] : corners) {
      positions.insert(positions.end(), {x, static_cast<float>(row), z});
      bones.insert(bones.end(), {static_cast<std::uint8_t>(row == 2 ? 1 : 0), 1, 0, 0});
      weights.insert(weights.end(), {row == 1 ? 0.5F * weight : weight, row == 1 ? 0.5F * weight : 0.0F, 0, 0});
    }
  }
  const auto vertices = static_cast<int>(positions.size() / 3);
  std::vector<std::uint16_t> indices;
  for (int layer = 0; layer < layers && !isSolid; ++layer) {
    indices.insert(indices.end(), {0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5});
  }
  for (int side = 0; side < 8 && isSolid; ++side) {
    const auto a = static_cast<std::uint16_t>(side);
    const auto b = static_cast<std::uint16_t>(side / 4 * 4 + (side + 1) % 4);
    indices.insert(indices.end(), {a, static_cast<std::uint16_t>(a + 4), b, b, static_cast<std::uint16_t>(a + 4),
                                   static_cast<std::uint16_t>(b + 4)});
  }
  if (isSolid) {
    indices.insert(indices.end(), {0, 1, 2, 0, 2, 3, 8, 10, 9, 8, 11, 10});
  }
  const std::vector<float> inverseBinds{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,  //
                                        1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1};
  constexpr float half = 0.70710678F;
  std::vector<float> turns{0, 0, 0, 1, 0, 0, 0.38268343F, 0.92387953F, 0, 0, half, half};
  if (interpolation == "CUBICSPLINE") {
    for (int key = 2; key >= 0; --key) {
      turns.insert(turns.begin() + 4L * (key + 1), 4, 0.0F);
      turns.insert(turns.begin() + 4L * key, 4, 0.0F);
    }
  }
  const std::vector<float> still{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  constexpr int number = 5126;
  add(positions.data(), positions.size() * 4, vertices, number, "VEC3",
      R"(,"min":[0,0,0],"max":[1,2,)" + std::string(isSolid ? "1]" : "0]"));
  add(indices.data(), indices.size() * 2, static_cast<int>(indices.size()), 5123, "SCALAR");
  add(bones.data(), bones.size(), vertices, 5121, "VEC4");
  add(weights.data(), weights.size() * 4, vertices, number, "VEC4");
  add(inverseBinds.data(), inverseBinds.size() * 4, 2, number, "MAT4");
  add(times.data(), times.size() * 4, 3, number, "SCALAR", R"(,"min":[0],"max":[2])");
  add(turns.data(), turns.size() * 4, static_cast<int>(turns.size() / 4), number, "VEC4");
  add(still.data(), still.size() * 4, 3, number, "VEC4");
  const auto clip = [](const std::string& title, int output, const std::string& kind) {
    return R"({"name":")" + title + R"(","samplers":[{"input":5,"output":)" + std::to_string(output) +
           R"(,"interpolation":")" + kind + R"("}],"channels":[{"sampler":0,"target":{"node":2,"path":"rotation"}}]})";
  };
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[)"
         R"({"name":")" +
         meshName + R"(","mesh":0,"skin":0)" + meshPose +
         R"(},{"name":"lower","children":[2]},{"name":"upper","translation":[0,1,0])" + upperPose +
         R"(}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3},"indices":1}]}],)"
         R"("skins":[{"joints":)" +
         joints + R"(,"inverseBindMatrices":4}],"animations":[)" + clip(name, 6, interpolation) + "," +
         clip("still", 7, "LINEAR") + R"(],"accessors":[)" + accessors + R"(],"bufferViews":[)" + views +
         R"(],"buffers":[{"byteLength":)" + std::to_string(data.size()) +
         R"(,"uri":"data:application/octet-stream;base64,)" + base64Text(data) + "\"}]}";
}

/// The same bar as COLLADA, with lengths in units of `metres` and `up` ("Y_UP" or "Z_UP"): y of the file points up or
/// forwards. In the only clip, of 1 s, the upper bone turns by 90 degrees about z of the file.
inline std::string colladaBar(const std::string& metres, const std::string& up) {
  const std::string identity = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";
  return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter=")" +
         metres + R"("/><up_axis>)" + up + R"(</up_axis></asset>
<library_geometries><geometry id="bar"><mesh>
<source id="places"><float_array id="places-a" count="18">0 0 0 1 0 0 0 1 0 1 1 0 0 2 0 1 2 0</float_array>
<technique_common><accessor source="#places-a" count="6" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="corners"><input semantic="POSITION" source="#places"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#corners" offset="0"/><p>0 1 2 2 1 3 2 3 4 4 3 5</p></triangles>
</mesh></geometry></library_geometries>
<library_controllers><controller id="skin"><skin source="#bar"><bind_shape_matrix>)" +
         identity + R"(</bind_shape_matrix>
<source id="names"><Name_array id="names-a" count="2">lower upper</Name_array><technique_common>
<accessor source="#names-a" count="2" stride="1"><param name="JOINT" type="name"/></accessor></technique_common></source>
<source id="binds"><float_array id="binds-a" count="32">)" +
         identity + R"( 1 0 0 0 0 1 0 -1 0 0 1 0 0 0 0 1</float_array><technique_common>
<accessor source="#binds-a" count="2" stride="16"><param name="TRANSFORM" type="float4x4"/></accessor>
</technique_common></source>
<source id="shares"><float_array id="shares-a" count="2">1 0.5</float_array><technique_common>
<accessor source="#shares-a" count="2" stride="1"><param name="WEIGHT" type="float"/></accessor></technique_common></source>
<joints><input semantic="JOINT" source="#names"/><input semantic="INV_BIND_MATRIX" source="#binds"/></joints>
<vertex_weights count="6"><input semantic="JOINT" source="#names" offset="0"/>
<input semantic="WEIGHT" source="#shares" offset="1"/><vcount>1 1 2 2 1 1</vcount>
<v>0 0 0 0 0 1 1 1 0 1 1 1 1 0 1 0</v></vertex_weights></skin></controller></library_controllers>
<library_animations><animation id="bend">
<source id="when"><float_array id="when-a" count="2">0 1</float_array><technique_common>
<accessor source="#when-a" count="2" stride="1"><param name="TIME" type="float"/></accessor></technique_common></source>
<source id="where"><float_array id="where-a" count="32">1 0 0 0 0 1 0 1 0 0 1 0 0 0 0 1
0 -1 0 0 1 0 0 1 0 0 1 0 0 0 0 1</float_array><technique_common>
<accessor source="#where-a" count="2" stride="16"><param name="TRANSFORM" type="float4x4"/></accessor>
</technique_common></source>
<source id="how"><Name_array id="how-a" count="2">LINEAR LINEAR</Name_array><technique_common>
<accessor source="#how-a" count="2" stride="1"><param name="INTERPOLATION" type="name"/></accessor></technique_common>
</source>
<sampler id="turn"><input semantic="INPUT" source="#when"/><input semantic="OUTPUT" source="#where"/>
<input semantic="INTERPOLATION" source="#how"/></sampler><channel source="#turn" target="upper/transform"/>
</animation></library_animations>
<library_visual_scenes><visual_scene id="scene">
<node id="lower" sid="lower" name="lower" type="JOINT"><matrix sid="transform">)" +
         identity + R"(</matrix>
<node id="upper" sid="upper" name="upper" type="JOINT"><matrix sid="transform">1 0 0 0 0 1 0 1 0 0 1 0 0 0 0 1</matrix>
</node></node>
<node id="shown"><instance_controller url="#skin"><skeleton>#lower</skeleton></instance_controller></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#scene"/></scene></COLLADA>)";
}

}  // namespace drape::io
