// Darkens what lies behind its neighbours in the picture, more the farther behind: eye-dome lighting (Boucheny 2009) on a ring of four points.
uniform sampler2D depth;
uniform vec4 unproject;     // projection[10], projection[14], 1 if parallel, 1 / reach in mm
uniform float radius;       // pixels
out vec4 factor;

float distanceAt(ivec2 at, ivec2 most) {
    float z = texelFetch(depth, clamp(at, ivec2(0), most), 0).r * 2.0 - 1.0;
    return unproject.z > 0.5 ? (unproject.y - z) / unproject.x : unproject.y / (z + unproject.x);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    if (texelFetch(depth, at, 0).r >= 1.0) {
        discard;
    }
    ivec2 most = textureSize(depth, 0) - 1;
    float here = distanceAt(at, most);
    int r = int(radius + 0.5);
    float behind = clamp((here - distanceAt(at + ivec2(r, 0), most)) * unproject.w, 0.0, 1.0)
            + clamp((here - distanceAt(at - ivec2(r, 0), most)) * unproject.w, 0.0, 1.0)
            + clamp((here - distanceAt(at + ivec2(0, r), most)) * unproject.w, 0.0, 1.0)
            + clamp((here - distanceAt(at - ivec2(0, r), most)) * unproject.w, 0.0, 1.0);
    factor = vec4(vec3(1.0 - 0.14 * behind), 1.0);
}
