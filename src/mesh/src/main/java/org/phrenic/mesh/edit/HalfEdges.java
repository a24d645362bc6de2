package org.phrenic.mesh.edit;

import java.util.Arrays;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/**
 * A triangle surface as half-edges in flat arrays (Botsch et al. 2010, Polygon Mesh Processing, section 2.3). Half-edge
 * {@code 3t + i} runs from corner i to corner i + 1 of triangle t. {@code twin} is the opposite half-edge of the same
 * edge, or {@link #NONE} on a boundary. {@code out} is one half-edge that starts at a vertex; at a boundary vertex it
 * is the boundary half-edge. Slots of removed triangles and vertices are reused.
 *
 * <p>The surface is cut open where it is not manifold or not consistently oriented: along non-manifold edges, and at
 * vertices with several fans (Gueziec et al. 2001, Cutting and Stitching, doi 10.1109/2945.928166).
 */
abstract class HalfEdges {
    static final int NONE = -1;
    static final int SMOOTH = 0;
    static final int ON_FEATURE_LINE = 1;
    static final int CORNER = 2;
    /** A feature line has a corner where it turns by more than 53 degrees. */
    private static final double SHARP_TURN = 0.6;

    /** Start vertex of each half-edge; {@link #NONE} in a removed triangle. */
    int[] start;

    int[] twin;
    int[] out;
    double[] position;
    /** Feature edges, which keep position and direction; marked on both half-edges. */
    boolean[] crease;

    /** Half-edges that {@link EdgeFlipper} has checked and whose neighbourhood is unchanged since. */
    boolean[] flipChecked;

    /** Whether every edge of the input mesh had two triangles. */
    final boolean inputClosed;

    private boolean hasCreases;
    /** Neighbours along the feature line of the vertex last passed to {@link #featureKind}. */
    int previousOnLine;

    int nextOnLine;
    /** Upper bounds (exclusive) of the triangle and vertex indices in use. */
    int triangleEnd;

    int vertexEnd;
    private int vertexCount;
    private final IntList freeTriangles = new IntList();
    private final IntList freeVertices = new IntList();

    HalfEdges(TriangleMesh mesh) {
        int[] t = withoutRepeatedCorners(mesh.triangles());
        EdgeTable edges = new EdgeTable(mesh.vertexCount(), t, 3);
        inputClosed = edges.isClosed();
        start = t;
        triangleEnd = t.length / 3;
        position = mesh.positions().clone();
        vertexEnd = mesh.vertexCount();
        out = new int[vertexEnd];
        twin = new int[t.length];
        crease = new boolean[t.length];
        flipChecked = new boolean[t.length];
        Arrays.fill(out, NONE);
        Arrays.fill(twin, NONE);
        pair(edges);
        separateFans();
        vertexCount = vertexEnd;
        for (int v = 0; v < vertexEnd; v++) {
            if (out[v] == NONE) {
                removeVertex(v);
            }
        }
    }

    private static int[] withoutRepeatedCorners(int[] triangles) {
        int[] kept = new int[triangles.length];
        int length = 0;
        for (int i = 0; i < triangles.length; i += 3) {
            int a = triangles[i];
            int b = triangles[i + 1];
            int c = triangles[i + 2];
            if (a != b && b != c && c != a) {
                System.arraycopy(triangles, i, kept, length, 3);
                length += 3;
            }
        }
        return Arrays.copyOf(kept, length);
    }

    private void pair(EdgeTable edges) {
        for (int e = 0; e < edges.edgeCount(); e++) {
            int h = edges.sides()[edges.start(e)];
            int other = edges.faceCount(e) == 2 ? edges.sides()[edges.start(e) + 1] : h;
            if (other != h && start[other] == end(h)) {
                link(h, other);
            }
        }
    }

    /** Duplicates a vertex for each further fan at it. */
    private void separateFans() {
        boolean[] done = new boolean[start.length];
        for (int h = 0; h < start.length; h++) {
            if (done[h]) {
                continue;
            }
            int v = start[h];
            int first = fanStart(h);
            int name = out[v] == NONE ? v : newVertex(position[3 * v], position[3 * v + 1], position[3 * v + 2]);
            out[name] = first;
            int g = first;
            do {
                done[g] = true;
                start[g] = name;
                g = twin[previous(g)];
            } while (g != NONE && g != first);
        }
    }

    static int next(int h) {
        return h % 3 == 2 ? h - 2 : h + 1;
    }

    static int previous(int h) {
        return h % 3 == 0 ? h + 2 : h - 1;
    }

    int end(int h) {
        return start[next(h)];
    }

    int vertexCount() {
        return vertexCount;
    }

    boolean isAlive(int h) {
        return start[h] != NONE;
    }

    boolean isBoundaryVertex(int v) {
        return twin[out[v]] == NONE;
    }

    /** Whether {@code h} is the half-edge that represents its edge in loops over edges. */
    boolean isPrimary(int h) {
        return start[h] != NONE && h > twin[h];
    }

    double squareLength(int h) {
        return Vectors.squaredDistance(position, start[h], end(h));
    }

    void markCrease(int h) {
        hasCreases = true;
        crease[h] = true;
        crease[twin[h]] = true;
    }

    final void link(int h, int o) {
        twin[h] = o;
        if (o != NONE) {
            twin[o] = h;
        }
    }

    /**
     * Classifies a vertex by the feature lines (boundary edges and creases) at it. It is {@link #SMOOTH} if no line
     * meets it, {@link #ON_FEATURE_LINE} if one line passes through it, and {@link #CORNER} if a line ends, branches or
     * turns sharply. For {@link #ON_FEATURE_LINE}, {@link #previousOnLine} and {@link #nextOnLine} are the neighbours
     * along the line.
     */
    int featureKind(int v) {
        if (!hasCreases && twin[out[v]] != NONE) {
            return SMOOTH;
        }
        int count = 0;
        int h = out[v];
        do {
            if (crease[h] || twin[h] == NONE) {
                count++;
                previousOnLine = nextOnLine;
                nextOnLine = end(h);
            }
            int back = previous(h);
            h = twin[back];
            if (h == NONE) {
                count++;
                previousOnLine = nextOnLine;
                nextOnLine = start[back];
            }
        } while (h != NONE && h != out[v]);
        if (count == 0) {
            return SMOOTH;
        }
        return count != 2 || turnsAt(v) ? CORNER : ON_FEATURE_LINE;
    }

    private boolean turnsAt(int v) {
        double dot = 0;
        double before = 0;
        double after = 0;
        for (int k = 0; k < 3; k++) {
            double u = position[3 * v + k] - position[3 * previousOnLine + k];
            double w = position[3 * nextOnLine + k] - position[3 * v + k];
            dot += u * w;
            before += u * u;
            after += w * w;
        }
        return dot < SHARP_TURN * Math.sqrt(before * after);
    }

    /** Rotates clockwise about the start of {@code h} to the boundary, or one full turn back to {@code h}. */
    final int fanStart(int h) {
        int g = h;
        while (twin[g] != NONE) {
            g = next(twin[g]);
            if (g == h) {
                break;
            }
        }
        return g;
    }

    /** Collects the one-ring of a vertex. */
    void collectRing(int v, OneRing ring) {
        ring.vertex = v;
        ring.size = 0;
        int h = out[v];
        do {
            ring.add(end(h));
            int back = previous(h);
            h = twin[back];
            if (h == NONE) {
                ring.triangles = ring.size;
                ring.add(start[back]);
                return;
            }
        } while (h != out[v]);
        ring.triangles = ring.size;
    }

    /** Whether a vertex has more than {@code least} neighbours; stops counting there. */
    boolean valenceExceeds(int least, int v) {
        int count = 0;
        int h = out[v];
        do {
            count++;
            h = twin[previous(h)];
            if (count > least) {
                return true;
            }
            if (h == NONE) {
                return count + 1 > least;
            }
        } while (h != out[v]);
        return false;
    }

    /** Adds a triangle without neighbours; returns its first half-edge. */
    final int newTriangle(int a, int b, int c) {
        int t = freeTriangles.isEmpty() ? 3 * triangleEnd++ : freeTriangles.removeLast();
        if (t + 3 > start.length) {
            start = Arrays.copyOf(start, start.length + start.length / 2 + 48);
            twin = Arrays.copyOf(twin, start.length);
            crease = Arrays.copyOf(crease, start.length);
            flipChecked = Arrays.copyOf(flipChecked, start.length);
        }
        Arrays.fill(crease, t, t + 3, false);
        start[t] = a;
        start[t + 1] = b;
        start[t + 2] = c;
        return t;
    }

    /** Clears the checked flag of the three edges of a changed triangle, on both half-edges. */
    final void clearFlipChecked(int h) {
        int t = h - h % 3;
        for (int side = t; side < t + 3; side++) {
            flipChecked[side] = false;
            if (twin[side] != NONE) {
                flipChecked[twin[side]] = false;
            }
        }
    }

    /** Clears the checked flag of all edges. */
    final void clearAllFlipChecked() {
        Arrays.fill(flipChecked, 0, 3 * triangleEnd, false);
    }

    final int newVertex(double x, double y, double z) {
        int v = freeVertices.isEmpty() ? vertexEnd++ : freeVertices.removeLast();
        if (v >= out.length) {
            out = Arrays.copyOf(out, v + v / 2 + 16);
            Arrays.fill(out, v, out.length, NONE);
            position = Arrays.copyOf(position, 3 * out.length);
        }
        setPosition(v, x, y, z);
        vertexCount++;
        return v;
    }

    final void setPosition(int v, double x, double y, double z) {
        position[3 * v] = x;
        position[3 * v + 1] = y;
        position[3 * v + 2] = z;
    }

    /** Removes the triangle whose first half-edge is t. */
    final void removeTriangle(int t) {
        Arrays.fill(start, t, t + 3, NONE);
        Arrays.fill(flipChecked, t, t + 3, true);
        freeTriangles.add(t);
    }

    /** Removes a vertex that no triangle uses. */
    final void removeVertex(int v) {
        out[v] = NONE;
        freeVertices.add(v);
        vertexCount--;
    }
}
