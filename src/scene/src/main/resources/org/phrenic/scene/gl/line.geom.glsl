// A line becomes a strip as wide as asked for: OpenGL core draws no line wider than a pixel everywhere.
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

uniform vec2 pixels;        // of the picture
uniform float lineWidth;    // pixels

in float endStrength[];
out float strength;
out float across;           // pixels from the middle

void corner(int end, vec2 side, float away) {
    vec4 p = gl_in[end].gl_Position;
    gl_Position = vec4(p.xy + side * away * p.w, p.zw);
    gl_ClipDistance[0] = gl_in[end].gl_ClipDistance[0];
    strength = endStrength[end];
    across = away;
    EmitVertex();
}

void main() {
    vec4 a = gl_in[0].gl_Position;
    vec4 b = gl_in[1].gl_Position;
    if (a.w <= 0.0 || b.w <= 0.0) {
        return;
    }
    vec2 along = (b.xy / b.w - a.xy / a.w) * pixels;
    float length = length(along);
    vec2 aside = length > 1e-6 ? vec2(-along.y, along.x) / length : vec2(0.0, 1.0);
    vec2 side = aside * 2.0 / pixels;
    float away = 0.5 * lineWidth + 0.5;
    corner(0, side, away);
    corner(0, side, -away);
    corner(1, side, away);
    corner(1, side, -away);
    EndPrimitive();
}
