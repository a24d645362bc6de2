#version 330 core
// A soft gradient, a little brighter behind the middle; with a fine dither, so that no bands show.
in vec2 place;
uniform vec3 low;
uniform vec3 high;
uniform vec4 part;
layout(location = 0) out vec4 result;

void main() {
    vec2 at = part.xy + place * part.zw;
    vec3 c = mix(low, high, smoothstep(0.0, 1.0, at.y));
    c += 0.03 * (1.0 - smoothstep(0.0, 0.75, distance(at, vec2(0.5, 0.55))));
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    result = vec4(c + (noise - 0.5) / 255.0, 1.0);
}
