// One triangle that covers the picture.
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
    // Undefined where a clip plane is enabled, unless it is written.
    gl_ClipDistance[0] = 1.0;
}
