#version 330 core
// A peeled layer over the picture.
in vec2 place;
uniform sampler2D layer;
layout(location = 0) out vec4 result;

void main() {
    result = texelFetch(layer, ivec2(gl_FragCoord.xy), 0);
}
