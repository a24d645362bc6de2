package org.phrenic.mesh.edit;

/** Collapses short edges under the link condition, without flipped or thin triangles. */
final class EdgeCollapser {
    /** Least cosine between the normals of a triangle before and after a collapse: a turn of up to 75 degrees. */
    static final double UP_TO_75_DEG = 0.26;
    /** A turn of up to 110 degrees. */
    static final double UP_TO_110_DEG = -0.34;
    /** Any turn and any shape, for very fine folds; the topology is kept. */
    static final double ANY_TURN = Double.NEGATIVE_INFINITY;

    /**
     * Twice the area over the squared longest side, which a collapse may not undercut; an equilateral triangle has
     * 0.87.
     */
    private static final double LEAST_SHAPE = 0.15;
    /** By how much one end's triangles must spread more than the other's for it to stay where it is. */
    private static final double SHARPER = 0.1;

    /** All bits of {@link #placesTooLong}. */
    private static final int ALL_PLACES = 7;

    /** Edges shorter than this part of the longest go even across creases. */
    private static final double TINY = 0.3;

    private final HalfEdgeMesh mesh;
    /** The neighbours of an edge's two ends, gathered once a try. */
    private int[] ringA = new int[64];

    private int[] ringB = new int[64];
    private int sizeA;
    private int sizeB;
    /** Normals of the triangles about one end. */
    private double[] normals = new double[3 * 64];

    private double leastCosine;
    private final MovedTriangle moved = new MovedTriangle();

    EdgeCollapser(HalfEdgeMesh mesh) {
        this.mesh = mesh;
    }

    /**
     * Collapses edges shorter than {@code below}, shortest first, as long as no new edge exceeds {@code longest} and
     * more than {@code leastVertices} are left, and no triangle turns further than {@code leastCosine}; returns how
     * many.
     */
    int collapse(double below, double longest, int leastVertices, double leastCosine) {
        this.leastCosine = leastCosine;
        long[] queue = mesh.sortedEdges(-1, below * below, false);
        int done = 0;
        for (int k = 0; k < queue.length && mesh.vertexCount() > leastVertices; k++) {
            int h = (int) queue[k];
            if (mesh.isAlive(h) && mesh.squareLength(h) < below * below && tryCollapse(h, longest)) {
                done++;
            }
        }
        return done;
    }

    private boolean tryCollapse(int h, double longest) {
        if (!mesh.preservesBoundary(h)) {
            return false;
        }
        int a = mesh.start[h];
        int b = mesh.end(h);
        gatherRings(a, b);
        // Most edges stay because others would become too long wherever the vertex left over went.
        int tooLong = placesTooLong(a, b, longest * longest);
        if (tooLong == ALL_PLACES || !mesh.satisfiesLinkCondition(h, ringA, sizeA)) {
            return false;
        }
        double share = placeOnEdge(h, a, b, longest);
        if (Double.isNaN(share) || (tooLong & 1 << (int) (2 * share)) != 0) {
            return false;
        }
        double[] p = mesh.position;
        double x = p[3 * a] + share * (p[3 * b] - p[3 * a]);
        double y = p[3 * a + 1] + share * (p[3 * b + 1] - p[3 * a + 1]);
        double z = p[3 * a + 2] + share * (p[3 * b + 2] - p[3 * a + 2]);
        // One call for both ends, and so below: compilers copy what is called to each place.
        for (int end = 0; end < 2; end++) {
            int[] ring = end == 0 ? ringA : ringB;
            int size = end == 0 ? sizeA : sizeB;
            if (!fits(end == 0 ? a : b, end == 0 ? b : a, ring, size, x, y, z)) {
                return false;
            }
        }
        mesh.collapse(h, x, y, z);
        return true;
    }

    private void gatherRings(int a, int b) {
        for (int end = 0; end < 2; end++) {
            mesh.collectRing(end == 0 ? a : b);
            int[] free = ringA;
            ringA = ringB;
            sizeA = sizeB;
            ringB = mesh.ring;
            sizeB = mesh.ringSize;
            mesh.ring = free;
        }
    }

    /**
     * At which places of the vertex left over a new edge would be too long: bit 0 at a, bit 1 in the middle, bit 2 at
     * b.
     */
    private int placesTooLong(int a, int b, double longestSquare) {
        double[] p = mesh.position;
        double ax = p[3 * a];
        double ay = p[3 * a + 1];
        double az = p[3 * a + 2];
        double dx = p[3 * b] - ax;
        double dy = p[3 * b + 1] - ay;
        double dz = p[3 * b + 2] - az;
        double mx = ax + 0.5 * dx;
        double my = ay + 0.5 * dy;
        double mz = az + 0.5 * dz;
        double bx = ax + dx;
        double by = ay + dy;
        double bz = az + dz;
        int places = 0;
        for (int end = 0; end < 2; end++) {
            int[] ring = end == 0 ? ringA : ringB;
            int size = end == 0 ? sizeA : sizeB;
            int gone = end == 0 ? b : a;
            int count = mesh.isBoundaryVertex(end == 0 ? a : b) ? size - 1 : size;
            for (int i = 0; i < count; i++) {
                int r = ring[i];
                if (r == gone || ring[i + 1 == size ? 0 : i + 1] == gone) {
                    continue;
                }
                double x = p[3 * r];
                double y = p[3 * r + 1];
                double z = p[3 * r + 2];
                if ((x - ax) * (x - ax) + (y - ay) * (y - ay) + (z - az) * (z - az) > longestSquare) {
                    places |= 1;
                }
                if ((x - mx) * (x - mx) + (y - my) * (y - my) + (z - mz) * (z - mz) > longestSquare) {
                    places |= 2;
                }
                if ((x - bx) * (x - bx) + (y - by) * (y - by) + (z - bz) * (z - bz) > longestSquare) {
                    places |= 4;
                }
            }
            if (places == ALL_PLACES) {
                break;
            }
        }
        return places;
    }

    /** Where on its edge the vertex left over goes, 0 at a to 1 at b; NaN if the edge must stay. */
    private double placeOnEdge(int h, int a, int b, double longest) {
        boolean boundaryA = mesh.isBoundaryVertex(a);
        boolean boundaryB = mesh.isBoundaryVertex(b);
        if (boundaryA != boundaryB) {
            return boundaryB ? 1 : 0;
        }
        int kindA = mesh.featureKind(a);
        int kindB = mesh.featureKind(b);
        if (kindA == HalfEdgeMesh.SMOOTH && kindB == HalfEdgeMesh.SMOOTH) {
            double spreadA = 0;
            double spreadB = 0;
            for (int end = 0; end < 2; end++) {
                spreadA = spreadB;
                spreadB = spread(end == 0 ? a : b, end == 0 ? ringA : ringB, end == 0 ? sizeA : sizeB);
            }
            return spreadA < spreadB - SHARPER ? 0 : spreadB < spreadA - SHARPER ? 1 : 0.5;
        }
        if (kindA != kindB && (kindA == HalfEdgeMesh.SMOOTH || kindB == HalfEdgeMesh.SMOOTH)) {
            return kindB == HalfEdgeMesh.SMOOTH ? 0 : 1;
        }
        double share = kindA == kindB ? 0.5 : kindA == HalfEdgeMesh.CORNER ? 0 : 1;
        // Ragged boundaries are all corners, and have to coarsen; creases only give way where the edge is a splinter.
        boolean alongLine = boundaryA || (mesh.crease[h] && (kindA != HalfEdgeMesh.CORNER || kindA != kindB));
        return alongLine || mesh.squareLength(h) < TINY * TINY * longest * longest ? share : Double.NaN;
    }

    /**
     * The least cosine between the normal of a triangle at {@code v} and their common normal: 1 on a plane, less on a
     * rim.
     */
    private double spread(int v, int[] ring, int size) {
        int count = mesh.isBoundaryVertex(v) ? size - 1 : size;
        if (normals.length < 3 * count) {
            normals = new double[6 * count];
        }
        double[] n = normals;
        double[] p = mesh.position;
        double vx = p[3 * v];
        double vy = p[3 * v + 1];
        double vz = p[3 * v + 2];
        double sx = 0;
        double sy = 0;
        double sz = 0;
        for (int i = 0; i < count; i++) {
            int b = 3 * ring[i];
            int c = 3 * ring[i + 1 == size ? 0 : i + 1];
            double ux = p[b] - vx;
            double uy = p[b + 1] - vy;
            double uz = p[b + 2] - vz;
            double wx = p[c] - vx;
            double wy = p[c + 1] - vy;
            double wz = p[c + 2] - vz;
            double nx = uy * wz - uz * wy;
            double ny = uz * wx - ux * wz;
            double nz = ux * wy - uy * wx;
            sx += nx;
            sy += ny;
            sz += nz;
            n[3 * i] = nx;
            n[3 * i + 1] = ny;
            n[3 * i + 2] = nz;
        }
        double total = Math.sqrt(sx * sx + sy * sy + sz * sz);
        double least = 1;
        for (int i = 0; i < 3 * count; i += 3) {
            double scale = Math.sqrt(n[i] * n[i] + n[i + 1] * n[i + 1] + n[i + 2] * n[i + 2]) * total;
            if (scale > 0) {
                least = Math.min(least, (n[i] * sx + n[i + 1] * sy + n[i + 2] * sz) / scale);
            }
        }
        return least;
    }

    /**
     * Whether the triangles at {@code v} that do not hold {@code gone} keep side and shape when v moves to (x, y, z).
     */
    private boolean fits(int v, int gone, int[] ring, int size, double x, double y, double z) {
        int count = mesh.isBoundaryVertex(v) ? size - 1 : size;
        for (int i = 0; i < count; i++) {
            int b = ring[i];
            int c = ring[i + 1 == size ? 0 : i + 1];
            if (b == gone || c == gone) {
                continue;
            }
            moved.set(mesh.position, v, b, c, x, y, z);
            double before = moved.shapeBefore();
            double after = moved.shapeAfter();
            // A triangle without area has no orientation to keep.
            double cosine = before < 1e-6 ? 1 : moved.dot / (Math.sqrt(moved.before) * Math.sqrt(moved.after));
            if (cosine < leastCosine || (leastCosine > ANY_TURN && after < LEAST_SHAPE && after < before)) {
                return false;
            }
        }
        return true;
    }
}
