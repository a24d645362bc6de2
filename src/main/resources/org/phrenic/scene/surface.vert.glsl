// A surface: rigid ones move by their pose, the others come with their positions of now. Everything after is in eye coordinates, mm.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 trait;   // openness (1 in the open, 0 in a cleft), tendon
#ifdef FIELD
layout(location = 3) in float quantity;
out float shownQuantity;
#endif

uniform mat4 pose;
uniform mat4 view;
uniform mat4 projection;
uniform vec4 clip;                    // keeps clip.xyz . x + clip.w >= 0

out vec3 eyePosition;
out vec3 eyeNormal;
out vec2 shownTrait;

void main() {
    vec4 world = pose * vec4(position, 1.0);
    vec4 eye = view * world;
    eyePosition = eye.xyz;
    eyeNormal = mat3(view) * (mat3(pose) * normal.xyz);
    shownTrait = trait.xy;
#ifdef FIELD
    shownQuantity = quantity;
#endif
#ifdef CLIP
    gl_ClipDistance[0] = dot(clip.xyz, world.xyz) + clip.w;
#endif
    gl_Position = projection * eye;
}
