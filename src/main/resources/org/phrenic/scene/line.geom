#version 330 core
// A line of a width in pixels, which core profiles do not draw themselves; a dot where both ends coincide.
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;
in float beyond[];
uniform vec2 size;
uniform float width;
uniform float nearer;
out float past;

void main() {
    vec4 a = gl_in[0].gl_Position;
    vec4 b = gl_in[1].gl_Position;
    if (a.w <= 0.0 || b.w <= 0.0) {
        return;
    }
    vec2 along = (b.xy / b.w - a.xy / a.w) * size;
    float extent = length(along);
    vec2 ahead = extent > 1e-3 ? along / extent : vec2(1.0, 0.0);
    vec2 side = vec2(-ahead.y, ahead.x) * width / size;
    vec2 end = extent > 1e-3 ? vec2(0.0) : vec2(ahead.x * 1.8 * width, 0.0) / size;
    vec2 wide = extent > 1e-3 ? side : 1.8 * side;
    for (int corner = 0; corner < 4; corner++) {
        bool first = corner < 2;
        vec4 p = first ? a : b;
        float s = (corner & 1) == 0 ? 1.0 : -1.0;
        past = first ? beyond[0] : beyond[1];
        gl_Position = vec4(p.xy + (s * wide + (first ? -end : end)) * p.w, p.z - nearer * p.w, p.w);
        EmitVertex();
    }
    EndPrimitive();
}
