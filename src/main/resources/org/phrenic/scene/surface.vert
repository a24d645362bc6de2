#version 330 core
// A surface: places are in mm, LPS; the model matrix carries what moves as a rigid body.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 shade;
layout(location = 3) in float field;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;

out vec3 worldPosition;
out vec3 eyePosition;
out vec3 eyeNormal;
out vec2 vertexShade;
out float vertexField;

void main() {
    vec4 world = model * vec4(position, 1.0);
    vec4 eye = view * world;
    worldPosition = world.xyz;
    eyePosition = eye.xyz;
    eyeNormal = mat3(view) * (mat3(model) * normal);
    vertexShade = shade;
    vertexField = field;
    gl_Position = projection * eye;
}
