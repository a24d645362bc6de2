// Key, fill and rim light go with the camera, the ambient light comes from above (warm below, cool above). Colours are
// linear; the last step is a film curve that also encodes them (Hejl and Burgess-Dawson 2010).
in vec3 eyePosition;
in vec3 eyeNormal;
in vec3 shownTrait;
out vec4 colour;

uniform vec3 base;          // linear
uniform vec3 tendonBase;    // linear
uniform vec2 shine;         // strength and exponent of the highlight
uniform float parallel;     // 1: parallel projection
uniform float thinness;     // log2 of the light that passes straight through
uniform vec4 accent;        // linear colour and strength of what stands out
#ifdef FIELD
in float shownQuantity;
uniform vec2 range;         // least value, 1 / (most - least)
uniform sampler1D colours;  // encoded, as the scale beside the picture shows them
#endif
#ifdef PEEL
uniform sampler2D opaqueDepth;
uniform sampler2D peeledDepth;
uniform float firstLayer;
#endif

#ifdef PEEL
// Depths are kept in 24 bits: what is no farther away than two of their steps is the same surface.
const float SAME_DEPTH = 1.3e-7;
#endif
const vec3 KEY = vec3(-0.44, 0.60, 0.67);
const vec3 FILL = vec3(0.78, 0.05, 0.62);

vec3 film(vec3 light) {
    vec3 x = max(light - 0.004, 0.0);
    return (x * (6.2 * x + 0.5)) / (x * (6.2 * x + 1.7) + 0.06);
}

void main() {
#ifdef PEEL
    float behind = texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r;
    float before = texelFetch(peeledDepth, ivec2(gl_FragCoord.xy), 0).r;
    if (gl_FragCoord.z >= behind || (firstLayer < 0.5 && gl_FragCoord.z <= before + SAME_DEPTH)) {
        discard;
    }
#endif
    vec3 n = normalize(eyeNormal);
    vec3 toEye = parallel > 0.5 ? vec3(0.0, 0.0, 1.0) : normalize(-eyePosition);
    n = gl_FrontFacing ? n : -n;
    float facing = clamp(dot(n, toEye), 0.0, 1.0);
    float openness = shownTrait.x;

#ifdef TENDON
    vec3 albedo = mix(base, tendonBase, smoothstep(0.25, 0.75, shownTrait.y));
#else
    vec3 albedo = base;
#endif
#ifdef CUT
    if (!gl_FrontFacing) {
        colour = vec4(film(albedo * 1.15 + 0.02 + accent.rgb * accent.a * 0.4), 1.0);
        return;
    }
#endif

    float key = max(dot(n, KEY) * 0.88 + 0.12, 0.0);
    float fill = max(dot(n, FILL), 0.0);
#ifdef FIELD
    vec3 shown = texture(colours, (shownQuantity - range.x) * range.y).rgb;
    float light = 0.52 + 0.40 * key + 0.12 * fill;
    vec3 encoded = shown * min(light, 1.06) * mix(0.72, 1.0, openness);
    encoded = mix(encoded, sqrt(accent.rgb), accent.a * 0.5);
#else
    float up = n.y * 0.5 + 0.5;
    vec3 ambient = mix(vec3(0.22, 0.17, 0.15), vec3(0.36, 0.36, 0.37), up) * openness;
#ifdef BACK_FACES
    float gloss = 0.0;
#else
    vec3 halfway = normalize(KEY + toEye);
    float gloss = shine.x * pow(max(dot(n, halfway), 0.0), shine.y) * openness;
#endif
    float edge = 1.0 - facing;
    float rim = edge * edge * edge * (0.35 + 0.65 * up) * openness;
    vec3 light = albedo
            * (key * mix(0.55, 1.0, openness) * vec3(1.34, 1.27, 1.15) + fill * vec3(0.22, 0.24, 0.27) + ambient)
            + vec3(gloss) + rim * 0.22 * (albedo + 0.25);
    light = mix(light, accent.rgb * (0.5 + 0.5 * key), accent.a) + accent.rgb * accent.a * edge * edge;
    vec3 encoded = film(light * 1.05);
#endif

#ifdef TRANSLUCENT
    // What passes a thin shell falls with the length of the way through it, 1 / cos: a clear middle and a full outline.
    float through = exp2(thinness / max(facing, 0.08));
    colour = vec4(encoded, (1.0 - through) * shownTrait.z);
#else
    colour = vec4(encoded, 1.0);
#endif
#ifdef PEEL
    colour.rgb *= colour.a;
#endif
}
