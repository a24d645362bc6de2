// Darkens what lies behind its neighbours in the picture, more the farther behind: eye-dome lighting (Boucheny 2009)
// on a ring of four points.
uniform sampler2D depth;
uniform vec3 unproject;     // projection[10], projection[14], 1 if parallel
uniform float reach;        // a step in depth of this size is as dark as it gets, mm
uniform float radius;       // pixels
out vec4 factor;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float here = texelFetch(depth, at, 0).r;
    // Millimetres a unit of depth, near here.
    float z = here * 2.0 - 1.0;
    float away = unproject.y / (z + unproject.x);
    float slope = unproject.z > 0.5 ? 2.0 / unproject.x : 2.0 * away * away / unproject.y;
    float shares = -slope / reach;
    ivec2 most = textureSize(depth, 0) - 1;
    int r = int(radius + 0.5);
    vec4 around = vec4(
            texelFetch(depth, ivec2(min(at.x + r, most.x), at.y), 0).r,
            texelFetch(depth, ivec2(max(at.x - r, 0), at.y), 0).r,
            texelFetch(depth, ivec2(at.x, min(at.y + r, most.y)), 0).r,
            texelFetch(depth, ivec2(at.x, max(at.y - r, 0)), 0).r);
    float behind = dot(clamp((here - around) * shares, 0.0, 1.0), vec4(1.0));
    factor = vec4(vec3(here < 1.0 ? 1.0 - 0.14 * behind : 1.0), 1.0);
}
