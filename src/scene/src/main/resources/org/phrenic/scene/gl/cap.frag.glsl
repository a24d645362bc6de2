uniform vec3 cut;           // encoded
out vec4 colour;

void main() {
    colour = vec4(cut, 1.0);
}
