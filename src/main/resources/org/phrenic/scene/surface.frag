#version 330 core
// Light on tissue: a key, a fill and a rim light that go with the viewer, a sky above and a ground below the patient, what the
// neighbourhood shades (baked for each vertex), and a veil that grows with depth.
in vec3 worldPosition;
in vec3 eyePosition;
in vec3 eyeNormal;
in vec2 vertexShade;
in float vertexField;

uniform mat4 view;
uniform bool parallelSight;
uniform vec3 colour;
uniform vec3 tendonColour;
uniform float opacity;
uniform float gloss;
uniform float shininess;
uniform float glow;
uniform vec2 depthRange;
uniform vec3 veil;
uniform float veilStrength;
uniform vec4 clipPlane;
uniform bool clipped;
uniform bool fieldOn;
uniform vec2 fieldRange;
uniform sampler2D fieldColours;
// Peeling: 0 off, 1 the nearest layer, 2 the next one behind what the last pass saw.
uniform int peel;
uniform sampler2D opaqueDepth;
uniform sampler2D lastDepth;

layout(location = 0) out vec4 result;

const vec3 KEY = vec3(-0.42, 0.56, 0.71);
const vec3 FILL = vec3(0.82, 0.05, 0.57);
const vec3 RIM = vec3(0.10, 0.55, -0.83);
const vec3 KEY_LIGHT = vec3(1.00, 0.97, 0.92) * 0.94;
const vec3 FILL_LIGHT = vec3(0.80, 0.88, 1.00) * 0.30;
const vec3 RIM_LIGHT = vec3(0.95, 0.97, 1.00) * 0.30;
const vec3 SKY = vec3(0.34, 0.35, 0.37);
const vec3 GROUND = vec3(0.19, 0.17, 0.16);
// Light passes a little round the edge of soft tissue.
const float WRAP = 0.22;

vec3 linear(vec3 c) {
    return pow(c, vec3(2.2));
}

vec3 shown(vec3 c) {
    // Reinhard's curve with a white point, so that highlights keep their colour.
    return pow(c * (1.0 + c / 2.6) / (1.0 + c), vec3(1.0 / 2.2));
}

float lit(vec3 n, vec3 light) {
    return max(0.0, (dot(n, light) + WRAP) / (1.0 + WRAP));
}

void main() {
    if (clipped && dot(clipPlane.xyz, worldPosition) > clipPlane.w) {
        discard;
    }
    if (peel > 0) {
        ivec2 at = ivec2(gl_FragCoord.xy);
        if (gl_FragCoord.z >= texelFetch(opaqueDepth, at, 0).r) {
            discard;
        }
        if (peel > 1 && gl_FragCoord.z <= texelFetch(lastDepth, at, 0).r + 1e-7) {
            discard;
        }
    }
    vec3 sight = parallelSight ? vec3(0.0, 0.0, 1.0) : normalize(-eyePosition);
    vec3 n = normalize(eyeNormal);
    if (!gl_FrontFacing) {
        n = -n;
    }
    vec3 albedo = linear(mix(colour, tendonColour, vertexShade.y));
    if (fieldOn) {
        float share = clamp((vertexField - fieldRange.x) / (fieldRange.y - fieldRange.x), 0.0, 1.0);
        albedo = linear(texture(fieldColours, vec2((share * 255.0 + 0.5) / 256.0, 0.5)).rgb);
    }
    float open = vertexShade.x;
    if (clipped && !gl_FrontFacing && opacity >= 1.0) {
        // The inside of what is cut open: matt and darker, as the face of a cut.
        albedo *= 0.55;
        open *= 0.8;
    }
    float up = (transpose(mat3(view)) * n).z;
    vec3 light = mix(GROUND, SKY, 0.5 + 0.5 * up) * open
            + KEY_LIGHT * lit(n, KEY) * mix(0.55, 1.0, open)
            + FILL_LIGHT * lit(n, FILL)
            + RIM_LIGHT * max(0.0, dot(n, RIM));
    float facing = clamp(dot(n, sight), 0.0, 1.0);
    vec3 halfway = normalize(KEY + sight);
    vec3 highlight = gloss * KEY_LIGHT * pow(max(0.0, dot(n, halfway)), shininess) * open;
    vec3 c = albedo * light * 1.55 + highlight;
    c += glow * vec3(0.9, 0.6, 0.1) * (0.25 + pow(1.0 - facing, 2.0));
    c = shown(c);
    float depth = clamp((-eyePosition.z - depthRange.x) / (depthRange.y - depthRange.x), 0.0, 1.0);
    c = mix(c, veil, veilStrength * depth * depth);
    float a = opacity;
    if (opacity < 1.0) {
        // A clear shell shows where it is seen edge-on.
        float edge = 1.0 - facing;
        a = opacity + (1.0 - opacity) * 0.62 * edge * edge * edge;
        if (!gl_FrontFacing) {
            a *= 0.6;
        }
    }
    result = vec4(c, a);
}
