package org.phrenic.mesh.edit;

import java.util.Arrays;
import org.phrenic.engine.math.RadixSort;
import org.phrenic.mesh.TriangleMesh;

/** A half-edge mesh with edge split, collapse and flip in place. */
final class HalfEdgeMesh extends HalfEdges {
    private final OneRing ring = new OneRing();

    HalfEdgeMesh(TriangleMesh mesh) {
        super(mesh);
    }

    /** Splits the edge of {@code h} at the given point; returns the new vertex. */
    int split(int h, double x, double y, double z) {
        int m = newVertex(x, y, z);
        int o = twin[h];
        int hn = next(h);
        int a = start[h];
        int b = start[hn];
        int c = start[previous(h)];
        int t = newTriangle(m, b, c);
        link(t + 1, twin[hn]);
        link(t + 2, hn);
        crease[t] = crease[h];
        crease[t + 1] = crease[hn];
        crease[hn] = false;
        start[hn] = m;
        out[m] = t;
        twin[t] = NONE;
        if (out[b] == hn) {
            out[b] = t + 1;
        }
        if (o != NONE) {
            int on = next(o);
            int d = start[previous(o)];
            int u = newTriangle(m, a, d);
            link(u + 1, twin[on]);
            link(u + 2, on);
            crease[u] = crease[h];
            crease[u + 1] = crease[on];
            crease[on] = false;
            start[on] = m;
            if (out[a] == on) {
                out[a] = u + 1;
            }
            link(h, u);
            link(o, t);
            clearFlipChecked(u);
            clearFlipChecked(o);
        }
        clearFlipChecked(t);
        clearFlipChecked(h);
        return m;
    }

    /** Flips the inner edge of {@code h}. The edge must not be a crease, and the new edge must not exist yet. */
    void flip(int h) {
        int o = twin[h];
        int hn = next(h);
        int hp = previous(h);
        int on = next(o);
        int op = previous(o);
        int a = start[h];
        int b = start[o];
        int c = start[hp];
        int d = start[op];
        int beyondBc = twin[hn];
        int beyondCa = twin[hp];
        int beyondAd = twin[on];
        int beyondDb = twin[op];
        if (out[a] == h || out[a] == on) {
            out[a] = hp;
        }
        if (out[b] == o || out[b] == hn) {
            out[b] = op;
        }
        if (out[c] == hp) {
            out[c] = hn;
        }
        if (out[d] == op) {
            out[d] = on;
        }
        start[h] = d;
        start[hn] = c;
        start[hp] = a;
        start[o] = c;
        start[on] = d;
        start[op] = b;
        link(hn, beyondCa);
        link(hp, beyondAd);
        link(on, beyondDb);
        link(op, beyondBc);
        boolean creaseBc = crease[hn];
        crease[hn] = crease[hp];
        crease[hp] = crease[on];
        crease[on] = crease[op];
        crease[op] = creaseBc;
        clearFlipChecked(h);
        clearFlipChecked(o);
    }

    /**
     * Whether collapsing the edge of {@code h} keeps the surface manifold and its topology unchanged (link condition,
     * Dey et al. 1999).
     */
    boolean canCollapse(int h) {
        if (!preservesBoundary(h)) {
            return false;
        }
        collectRing(start[h], ring);
        return satisfiesLinkCondition(h, ring);
    }

    /**
     * The part of {@link #canCollapse} that needs no one-ring. The edge must not connect two boundaries, and the
     * vertices opposite it must have enough neighbours.
     */
    boolean preservesBoundary(int h) {
        int o = twin[h];
        if (o != NONE && isBoundaryVertex(start[h]) && isBoundaryVertex(end(h))) {
            return false;
        }
        return canRemoveTriangle(h) && (o == NONE || canRemoveTriangle(o));
    }

    /** Link condition: only the vertices opposite the edge are neighbours of both its ends. */
    boolean satisfiesLinkCondition(int h, OneRing ringOfStart) {
        int common = 0;
        int b = end(h);
        int g = out[b];
        do {
            int back = previous(g);
            common += ringOfStart.contains(end(g)) ? 1 : 0;
            int following = twin[back];
            if (following == NONE) {
                common += ringOfStart.contains(start[back]) ? 1 : 0;
            }
            g = following;
        } while (g != NONE && g != out[b]);
        return common == (twin[h] == NONE ? 1 : 2);
    }

    private boolean canRemoveTriangle(int h) {
        if (twin[next(h)] == NONE && twin[previous(h)] == NONE) {
            return false;
        }
        int c = start[previous(h)];
        return valenceExceeds(isBoundaryVertex(c) ? 2 : 3, c);
    }

    /** Collapses the edge of {@code h}. Its start vertex is removed, and its end vertex moves to the given point. */
    void collapse(int h, double x, double y, double z) {
        int a = start[h];
        int b = end(h);
        int o = twin[h];
        int g = out[a];
        do {
            start[g] = b;
            g = twin[previous(g)];
        } while (g != NONE && g != out[a]);
        int fromB = NONE;
        // A single call site keeps the inlined code small.
        for (int side = h; side != NONE; side = side == h ? o : NONE) {
            fromB = closeSide(side);
        }
        // Both triangles are removed first, so that fanStart does not pass through them.
        out[b] = fanStart(fromB);
        removeVertex(a);
        setPosition(b, x, y, z);
        int k = out[b];
        do {
            clearFlipChecked(k);
            k = twin[previous(k)];
        } while (k != NONE && k != out[b]);
    }

    /**
     * Removes the triangle of {@code h}, whose edge has collapsed, and joins the neighbours across its other two edges.
     * Returns a half-edge from the remaining vertex.
     */
    private int closeSide(int h) {
        int hn = next(h);
        int hp = previous(h);
        int c = start[hp];
        int x = twin[hn];
        int y = twin[hp];
        boolean joined = crease[hn] || crease[hp];
        if (x != NONE) {
            twin[x] = y;
            crease[x] = joined;
        }
        if (y != NONE) {
            twin[y] = x;
            crease[y] = joined;
        }
        int t = h - h % 3;
        removeTriangle(t);
        // The outer half-edges run from c to b or from b to c, so each end gets one outgoing half-edge.
        int fromC = NONE;
        int fromB = NONE;
        for (int side = 0; side < 2; side++) {
            int k = side == 0 ? x : y;
            if (k != NONE) {
                fromC = start[k] == c ? k : next(k);
                fromB = start[k] == c ? next(k) : k;
            }
        }
        out[c] = fanStart(fromC);
        return fromB;
    }

    /**
     * Edges with a squared length strictly between two bounds, sorted by length in single precision. The low 32 bits of
     * each entry are the half-edge.
     */
    long[] sortedEdges(double aboveSquare, double belowSquare, boolean longestFirst) {
        long[] keys = new long[3 * triangleEnd];
        int length = 0;
        for (int h = 0; h < keys.length; h++) {
            if (isPrimary(h)) {
                double square = squareLength(h);
                if (square > aboveSquare && square < belowSquare) {
                    // The bits of a non-negative float sort like its value. The half-edge index breaks ties.
                    int bits = Float.floatToRawIntBits((float) square);
                    keys[length++] = (long) (longestFirst ? -bits : bits) << 32 | h;
                }
            }
        }
        RadixSort.sort(keys, length);
        return Arrays.copyOf(keys, length);
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

    TriangleMesh toMesh() {
        int[] name = new int[vertexEnd];
        double[] p = new double[3 * vertexCount()];
        int n = 0;
        for (int v = 0; v < vertexEnd; v++) {
            if (out[v] != NONE) {
                System.arraycopy(position, 3 * v, p, 3 * n, 3);
                name[v] = n++;
            }
        }
        int[] t = Arrays.stream(start, 0, 3 * triangleEnd)
                .filter(v -> v != NONE)
                .map(v -> name[v])
                .toArray();
        return new TriangleMesh(p, t);
    }
}
