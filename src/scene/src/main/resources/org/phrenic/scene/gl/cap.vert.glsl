// A square in the plane that cuts, about the body; corners in eye coordinates.
uniform mat4 projection;
uniform vec3 corners[4];

void main() {
    gl_Position = projection * vec4(corners[gl_VertexID], 1.0);
}
