uniform vec4 lineColour;    // encoded, opacity
uniform float lineWidth;
in float strength;
in float across;
out vec4 colour;

void main() {
    float cover = clamp(0.5 * lineWidth + 0.5 - abs(across), 0.0, 1.0);
    colour = vec4(lineColour.rgb, lineColour.a * cover * strength);
}
