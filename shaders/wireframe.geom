// Adds barycentric coordinates to each triangle. The fragment shader computes the distance to the edges from them.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in Surface {
  vec3 position;
  vec3 normal;
  vec2 coordinate;
  float curvature;
  vec2 yarns;
} corner[];
#ifdef FIELD
in float fieldPlace[];
#endif

out Surface {
  vec3 position;
  vec3 normal;
  vec2 coordinate;
  float curvature;
  vec2 yarns;
} surface;
out vec3 barycentric;
#ifdef FIELD
out float place;
#endif

void main() {
  for (int i = 0; i < 3; ++i) {
    surface.position = corner[i].position;
    surface.normal = corner[i].normal;
    surface.coordinate = corner[i].coordinate;
    surface.curvature = corner[i].curvature;
    surface.yarns = corner[i].yarns;
#ifdef FIELD
    place = fieldPlace[i];
#endif
    barycentric = vec3(i == 0, i == 1, i == 2);
    gl_Position = gl_in[i].gl_Position;
    EmitVertex();
  }
  EndPrimitive();
}
