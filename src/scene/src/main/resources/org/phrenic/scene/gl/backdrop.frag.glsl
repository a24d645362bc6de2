uniform vec3 middle;        // encoded
uniform vec3 edge;
uniform vec2 offset;        // of this tile in the whole, pixels
uniform vec2 whole;         // pixels
out vec4 colour;

void main() {
    vec2 p = (gl_FragCoord.xy + offset) / whole - vec2(0.5, 0.54);
    float away = smoothstep(0.0, 1.0, dot(p, p) * 1.9);
    // A little unevenness hides the steps of eight bits.
    float grain = fract(dot(floor(gl_FragCoord.xy), vec2(0.7548777, 0.5698403))) - 0.5;
    colour = vec4(mix(middle, edge, away) + grain / 255.0, 1.0);
}
