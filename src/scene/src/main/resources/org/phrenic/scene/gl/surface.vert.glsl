// A surface: rigid ones move by their pose, the others come with their present positions. Everything after is in eye
// coordinates, mm.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
// openness (1 in the open, 0 in a cleft), tendon, and what is left of a clear surface (0 at an open border)
layout(location = 2) in vec4 trait;
#ifdef FIELD
layout(location = 3) in float quantity;
out float shownQuantity;
#endif

uniform mat4 toEye;
uniform mat4 projection;
#ifdef TRANSLUCENT
uniform float lift;                   // mm
#endif
#ifdef CLIP
uniform vec4 clip;                    // in eye coordinates; keeps clip.xyz . x + clip.w >= 0
#endif

out vec3 eyePosition;
out vec3 eyeNormal;
out vec3 shownTrait;

void main() {
    vec4 eye = toEye * vec4(position, 1.0);
    eyePosition = eye.xyz;
    eyeNormal = mat3(toEye) * normal.xyz;
    shownTrait = trait.xyz;
#ifdef FIELD
    shownQuantity = quantity;
#endif
#ifdef CLIP
    gl_ClipDistance[0] = dot(clip.xyz, eye.xyz) + clip.w;
#endif
    gl_Position = projection * eye;
#ifdef TRANSLUCENT
    // The far side of a clear surface that lies on another, as a lung on the diaphragm, would be hidden in patches: its
    // depth is taken a little nearer.
    float turnedAway = dot(eyeNormal, eye.xyz) > 0.0 ? 1.0 : 0.0;
    vec4 nearer = projection * vec4(eye.xyz + vec3(0.0, 0.0, lift * turnedAway), 1.0);
    gl_Position.z = nearer.z / nearer.w * gl_Position.w;
#endif
}
