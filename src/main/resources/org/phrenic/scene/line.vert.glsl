// Ends of lines, and points; lifted towards the eye, so that a line on a surface is seen.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;

uniform mat4 pose;
uniform mat4 view;
uniform mat4 projection;
uniform vec4 clip;
uniform float lift;         // mm
uniform float pointSize;    // pixels
uniform float parallel;
uniform float faded;        // 1: lines on faces that look away fade

out float endStrength;

void main() {
    vec4 world = pose * vec4(position, 1.0);
    vec4 eye = view * world;
    vec3 toEye = parallel > 0.5 ? vec3(0.0, 0.0, 1.0) : normalize(-eye.xyz);
    vec3 n = mat3(view) * (mat3(pose) * normal.xyz);
    endStrength = faded > 0.5 ? mix(0.25, 1.0, smoothstep(-0.2, 0.2, dot(n, toEye))) : 1.0;
    eye.xyz += lift * toEye;
    gl_ClipDistance[0] = dot(clip.xyz, world.xyz) + clip.w;
    gl_Position = projection * eye;
    gl_PointSize = pointSize;
}
