package org.phrenic.mesh.edit;

import java.util.Arrays;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.TriangleMesh;

/**
 * A triangle surface as half-edges: what meets what, the lines on it, and room for more. Half-edge {@code 3t + i} runs
 * from corner i to corner i + 1 of triangle t; {@code twin} is the half-edge that runs back along the same edge, -1 on
 * a boundary; {@code out} is one half-edge that starts at a vertex, on a boundary vertex the one that lies on the
 * boundary. All flat integer arrays; places of removed triangles and vertices are used again.
 *
 * <p>A surface that is not manifold, or not consistently oriented, is cut open where it is not: along such edges, and
 * at vertices of several fans (Gueziec et al. 2001, Cutting and Stitching, doi 10.1109/2945.928166).
 */
abstract class HalfEdges {
    static final int NONE = -1;
    static final int SMOOTH = 0;
    static final int ON_FEATURE_LINE = 1;
    static final int CORNER = 2;
    /** A line that turns by more than 53 degrees has a corner there. */
    private static final double SHARP_TURN = 0.6;

    /** Start vertex of each half-edge; -1 in a removed triangle. */
    int[] start;

    int[] twin;
    int[] out;
    double[] position;
    /** Edges that keep their place and direction, marked on both half-edges. */
    boolean[] crease;

    /**
     * Half-edges that {@link EdgeFlipper} need not look at: it left them as they are, and nothing near has changed
     * since.
     */
    boolean[] flipChecked;

    /** Whether each edge of the mesh given had two triangles. */
    final boolean inputClosed;

    private boolean hasCreases;
    int previousOnLine;
    int nextOnLine;
    /** Triangles and vertices below these numbers are in use or were. */
    int triangleEnd;

    int vertexEnd;
    private int vertexCount;
    private int[] freeTriangles = new int[64];
    private int freeTriangleCount;
    private int[] freeVertices = new int[64];
    private int freeVertexCount;

    /**
     * The vertices about {@link #collectRing}'s vertex, in order; on a boundary from one boundary edge to the other.
     */
    int[] ring = new int[64];

    int ringSize;

    HalfEdges(TriangleMesh mesh) {
        int[] t = withoutRepeatedCorners(mesh.triangles());
        EdgeTable edges = new EdgeTable(new TriangleMesh(mesh.positions(), t));
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
        for (int v = 0; v < vertexEnd; v++) {
            if (out[v] == NONE) {
                releaseVertex(v);
            } else {
                vertexCount++;
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
                kept[length++] = a;
                kept[length++] = b;
                kept[length++] = c;
            }
        }
        return Arrays.copyOf(kept, length);
    }

    private void pair(EdgeTable edges) {
        for (int e = 0; e < edges.edgeCount(); e++) {
            int h = edges.sides()[edges.start(e)];
            int other = edges.faceCount(e) == 2 ? edges.sides()[edges.start(e) + 1] : h;
            if (other != h && start[other] == end(h)) {
                twin[h] = other;
                twin[other] = h;
            }
        }
    }

    /** The first fan found at a vertex keeps it; each further fan gets a copy. */
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
        // newVertex counted the copies; the constructor counts every vertex.
        vertexCount = 0;
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

    /** One half-edge of each edge is the one that stands for it. */
    boolean isPrimary(int h) {
        return start[h] != NONE && h > twin[h];
    }

    double squareLength(int h) {
        int a = 3 * start[h];
        int b = 3 * end(h);
        double dx = position[a] - position[b];
        double dy = position[a + 1] - position[b + 1];
        double dz = position[a + 2] - position[b + 2];
        return dx * dx + dy * dy + dz * dz;
    }

    void markCrease(int h) {
        hasCreases = true;
        crease[h] = true;
        crease[twin[h]] = true;
    }

    boolean isCrease(int h) {
        return crease[h];
    }

    /**
     * What lines of the surface (boundary edges and creases) do to a vertex: {@link #SMOOTH} if none meets it,
     * {@link #ON_FEATURE_LINE} if one runs through it, {@link #CORNER} if it ends, branches or turns sharply there. For
     * the second, {@link #previousOnLine} and {@link #nextOnLine} are the neighbours along the line.
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

    /** Turns clockwise about the start of {@code h} to the boundary, or once round to {@code h} itself. */
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

    /** Fills {@link #ring}; triangles are (v, ring[i], ring[i + 1]), wrapping round only inside the surface. */
    void collectRing(int v) {
        ringSize = 0;
        int h = out[v];
        do {
            addToRing(end(h));
            int back = previous(h);
            h = twin[back];
            if (h == NONE) {
                addToRing(start[back]);
                return;
            }
        } while (h != out[v]);
    }

    private void addToRing(int v) {
        if (ringSize == ring.length) {
            ring = Arrays.copyOf(ring, 2 * ringSize);
        }
        ring[ringSize++] = v;
    }

    int valence(int v) {
        int count = 0;
        int h = out[v];
        do {
            count++;
            h = twin[previous(h)];
            if (h == NONE) {
                return count + 1;
            }
        } while (h != out[v]);
        return count;
    }

    /** Whether a vertex has more than so many neighbours, without going round all of them. */
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

    boolean areNeighbours(int a, int b) {
        int h = out[a];
        do {
            int back = previous(h);
            if (end(h) == b || start[back] == b) {
                return true;
            }
            h = twin[back];
        } while (h != NONE && h != out[a]);
        return false;
    }

    final int newTriangle(int a, int b, int c) {
        int t;
        if (freeTriangleCount > 0) {
            t = freeTriangles[--freeTriangleCount];
        } else {
            t = 3 * triangleEnd++;
            if (t + 3 > start.length) {
                start = Arrays.copyOf(start, start.length + start.length / 2 + 48);
                twin = Arrays.copyOf(twin, start.length);
                crease = Arrays.copyOf(crease, start.length);
                flipChecked = Arrays.copyOf(flipChecked, start.length);
            }
        }
        Arrays.fill(crease, t, t + 3, false);
        start[t] = a;
        start[t + 1] = b;
        start[t + 2] = c;
        return t;
    }

    /**
     * Notes that the triangle of {@code h} has changed: its three edges, seen from either side, are no longer settled.
     */
    final void clearFlipChecked(int h) {
        int t = h - h % 3;
        for (int side = t; side < t + 3; side++) {
            flipChecked[side] = false;
            if (twin[side] != NONE) {
                flipChecked[twin[side]] = false;
            }
        }
    }

    /** As {@link #clearFlipChecked} for all triangles: after vertices have moved everywhere. */
    final void clearAllFlipChecked() {
        Arrays.fill(flipChecked, 0, 3 * triangleEnd, false);
    }

    final int newVertex(double x, double y, double z) {
        int v;
        if (freeVertexCount > 0) {
            v = freeVertices[--freeVertexCount];
        } else {
            v = vertexEnd++;
            if (v >= out.length) {
                out = Arrays.copyOf(out, v + v / 2 + 16);
                Arrays.fill(out, v, out.length, NONE);
                position = Arrays.copyOf(position, 3 * out.length);
            }
        }
        position[3 * v] = x;
        position[3 * v + 1] = y;
        position[3 * v + 2] = z;
        vertexCount++;
        return v;
    }

    /** Takes the triangle out whose first half-edge is t. */
    final void removeTriangle(int t) {
        Arrays.fill(start, t, t + 3, NONE);
        Arrays.fill(flipChecked, t, t + 3, true);
        if (freeTriangleCount == freeTriangles.length) {
            freeTriangles = Arrays.copyOf(freeTriangles, 2 * freeTriangleCount);
        }
        freeTriangles[freeTriangleCount++] = t;
    }

    /** Takes a vertex out that nothing meets. */
    final void removeVertex(int v) {
        releaseVertex(v);
        vertexCount--;
    }

    private void releaseVertex(int v) {
        out[v] = NONE;
        if (freeVertexCount == freeVertices.length) {
            freeVertices = Arrays.copyOf(freeVertices, 2 * freeVertexCount);
        }
        freeVertices[freeVertexCount++] = v;
    }

    TriangleMesh toMesh() {
        int[] name = new int[vertexEnd];
        double[] p = new double[3 * vertexCount];
        int n = 0;
        for (int v = 0; v < vertexEnd; v++) {
            if (out[v] != NONE) {
                System.arraycopy(position, 3 * v, p, 3 * n, 3);
                name[v] = n++;
            }
        }
        int[] t = new int[3 * triangleEnd];
        int length = 0;
        for (int h = 0; h < 3 * triangleEnd; h++) {
            if (start[h] != NONE) {
                t[length++] = name[start[h]];
            }
        }
        return new TriangleMesh(p, Arrays.copyOf(t, length));
    }
}
