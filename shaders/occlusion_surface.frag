in vec3 seenNormal;
in float depth;

layout(location = 0) out vec4 depthHere;
layout(location = 1) out vec4 normalHere;  // of the side that the viewer sees, from 0 to 1

void main() {
  depthHere = vec4(depth);
  normalHere = vec4(0.5 + 0.5 * normalize(gl_FrontFacing ? seenNormal : -seenNormal), 1.0);
}
