#version 330 core
in float past;
uniform vec4 colour;
uniform bool clipped;
layout(location = 0) out vec4 result;

void main() {
    if (clipped && past > 0.0) {
        discard;
    }
    result = colour;
}
