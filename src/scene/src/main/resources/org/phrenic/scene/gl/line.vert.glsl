// Ends of lines, and points; lifted towards the eye, so that a line on a surface is seen.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;

uniform mat4 toEye;
uniform mat4 projection;
uniform vec4 clip;
uniform float lift;         // mm
uniform float pointSize;    // pixels
uniform float parallel;
uniform float faded;        // 1: lines on faces that look away fade

out float endStrength;

void main() {
    vec4 eye = toEye * vec4(position, 1.0);
    vec3 nearer = parallel > 0.5 ? vec3(0.0, 0.0, 1.0) : normalize(-eye.xyz);
    vec3 n = mat3(toEye) * normal.xyz;
    endStrength = faded > 0.5 ? mix(0.25, 1.0, smoothstep(-0.2, 0.2, dot(n, nearer))) : 1.0;
    gl_ClipDistance[0] = dot(clip.xyz, eye.xyz) + clip.w;
    eye.xyz += lift * nearer;
    gl_Position = projection * eye;
    gl_PointSize = pointSize;
}
