// Fast approximate antialiasing (Lottes 2009) with a search for both ends of an edge: a pixel beside an edge takes as
// much of the pixel across it as the edge, drawn as a straight line between its ends, covers.
uniform sampler2D source;
out vec4 colour;

const float LEAST_CONTRAST = 0.03;
const float RELATIVE_CONTRAST = 0.1;
const int REACH = 12;                 // pixels searched in each direction

vec2 pixel;

float luma(vec2 place) {
    return dot(textureLod(source, place, 0.0).rgb, vec3(0.299, 0.587, 0.114));
}

// Pixels from a place on the edge to its end, in one direction; luma there differs from that of the edge.
float ending(vec2 place, vec2 way, float edge, float contrast, out float difference) {
    for (int i = 1; i < REACH; i++) {
        difference = luma(place + float(i) * way) - edge;
        if (abs(difference) >= contrast) {
            return float(i);
        }
    }
    difference = luma(place + float(REACH) * way) - edge;
    return float(REACH);
}

void main() {
    pixel = 1.0 / vec2(textureSize(source, 0));
    vec2 here = gl_FragCoord.xy * pixel;
    vec2 right = vec2(pixel.x, 0.0);
    vec2 up = vec2(0.0, pixel.y);
    float m = luma(here);
    float n = luma(here + up);
    float s = luma(here - up);
    float e = luma(here + right);
    float w = luma(here - right);
    float least = min(m, min(min(n, s), min(e, w)));
    float most = max(m, max(max(n, s), max(e, w)));
    if (most - least < max(LEAST_CONTRAST, RELATIVE_CONTRAST * most)) {
        colour = textureLod(source, here, 0.0);
        return;
    }
    float ne = luma(here + up + right);
    float nw = luma(here + up - right);
    float se = luma(here - up + right);
    float sw = luma(here - up - right);
    float changeAlongY = abs(nw + sw - 2.0 * w) + 2.0 * abs(n + s - 2.0 * m) + abs(ne + se - 2.0 * e);
    float changeAlongX = abs(nw + ne - 2.0 * n) + 2.0 * abs(w + e - 2.0 * m) + abs(sw + se - 2.0 * s);
    bool horizontal = changeAlongY >= changeAlongX;
    vec2 across = horizontal ? up : right;
    vec2 along = horizontal ? right : up;
    float forward = horizontal ? n : e;
    float backward = horizontal ? s : w;
    if (abs(backward - m) > abs(forward - m)) {
        across = -across;
        forward = backward;
    }
    vec2 start = here + 0.5 * across;
    float edge = 0.5 * (m + forward);
    float contrast = 0.25 * abs(forward - m);
    float firstDifference;
    float secondDifference;
    float first = ending(start, along, edge, contrast, firstDifference);
    float second = ending(start, -along, edge, contrast, secondDifference);
    // Only pixels on the side toward which the nearer end of the edge steps are partly covered.
    float nearest = first < second ? firstDifference : secondDifference;
    bool covered = (nearest < 0.0) != (m < edge);
    float share = covered ? 0.5 - min(first, second) / (first + second) : 0.0;
    colour = textureLod(source, here + share * across, 0.0);
}
