#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform vec4 clipPlane;
out float beyond;

void main() {
    vec4 world = model * vec4(position, 1.0);
    beyond = dot(clipPlane.xyz, world.xyz) - clipPlane.w;
    gl_Position = projection * (view * world);
}
