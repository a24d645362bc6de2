uniform vec4 lineColour;
uniform float pointSize;
in float endStrength;
out vec4 colour;

void main() {
    float away = length(gl_PointCoord - 0.5) * pointSize;
    float cover = clamp(0.5 * pointSize - away, 0.0, 1.0);
    float shade = mix(1.0, 0.6, smoothstep(0.25, 0.5, away / pointSize));
    colour = vec4(lineColour.rgb * shade, lineColour.a * cover * endStrength);
}
