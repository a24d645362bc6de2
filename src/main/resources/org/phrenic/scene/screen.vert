#version 330 core
// One triangle that covers the picture.
out vec2 place;

void main() {
    vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID >> 1) * 4 - 1);
    place = 0.5 + 0.5 * corner;
    gl_Position = vec4(corner, 1.0, 1.0);
}
