package org.phrenic.mesh.edit;

import org.phrenic.engine.math.Triangles;

/** Collapses short edges that satisfy the link condition, without flipping triangles or making them thin. */
final class EdgeCollapser {
    /** Least cosine between a triangle's normals before and after a collapse: a rotation of up to 75 degrees. */
    static final double UP_TO_75_DEG = 0.26;
    /** Rotation of up to 110 degrees. */
    static final double UP_TO_110_DEG = -0.34;
    /** Any rotation and any shape, for very fine folds. The topology is still preserved. */
    static final double ANY_TURN = Double.NEGATIVE_INFINITY;

    /**
     * Least shape quality (twice the area over the squared longest edge) that a collapse may produce; 0.87 for an
     * equilateral triangle.
     */
    private static final double MIN_SHAPE = 0.15;
    /** If the {@link #spread} of the ends differs by more than this, the edge collapses into the sharper end. */
    private static final double SHARPER = 0.1;

    /** One bit for each of {@link #places}. */
    private static final int ALL_PLACES = 7;

    /** Edges shorter than this fraction of the longest allowed edge collapse even across creases. */
    private static final double TINY = 0.3;

    private final HalfEdgeMesh mesh;
    /** One-rings of the two ends of an edge. */
    private final OneRing[] rings = {new OneRing(), new OneRing()};
    /** Candidate positions of the remaining vertex: start, midpoint and end of the edge. */
    private final double[] places = new double[9];
    /** Normals of the triangles around one end, and their lengths. */
    private double[] normals = new double[3 * 64];

    private double[] lengths = new double[64];
    private final double[] normal = new double[3];
    private double leastCosine;
    private final MovedTriangle moved = new MovedTriangle();

    EdgeCollapser(HalfEdgeMesh mesh) {
        this.mesh = mesh;
    }

    /**
     * Collapses edges shorter than {@code below}, shortest first, while more than {@code leastVertices} vertices
     * remain. A collapse is rejected if a new edge would exceed {@code longest} or the cosine of a triangle's rotation
     * would fall below {@code leastCosine}. Returns the number of collapses.
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
        mesh.collectRing(a, rings[0]);
        mesh.collectRing(b, rings[1]);
        // Most edges are rejected here: a new edge would be too long at every candidate position.
        int tooLong = placesTooLong(a, b, longest * longest);
        if (tooLong == ALL_PLACES || !mesh.satisfiesLinkCondition(h, rings[0])) {
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
        if (!fits(rings[0], b, x, y, z) || !fits(rings[1], a, x, y, z)) {
            return false;
        }
        mesh.collapse(h, x, y, z);
        return true;
    }

    /** Bit mask of the {@link #places} at which a new edge would be too long. */
    private int placesTooLong(int a, int b, double longestSquare) {
        double[] p = mesh.position;
        for (int axis = 0; axis < 3; axis++) {
            double d = p[3 * b + axis] - p[3 * a + axis];
            places[axis] = p[3 * a + axis];
            places[3 + axis] = p[3 * a + axis] + 0.5 * d;
            places[6 + axis] = p[3 * a + axis] + d;
        }
        int tooLong = placesTooLong(rings[0], b, longestSquare);
        return tooLong == ALL_PLACES ? tooLong : tooLong | placesTooLong(rings[1], a, longestSquare);
    }

    private int placesTooLong(OneRing ring, int gone, double longestSquare) {
        double[] p = mesh.position;
        int tooLong = 0;
        for (int i = 0; i < ring.triangles; i++) {
            if (ring.triangleHas(i, gone)) {
                continue;
            }
            int r = 3 * ring.vertices[i];
            for (int place = 0; place < 3; place++) {
                double x = p[r] - places[3 * place];
                double y = p[r + 1] - places[3 * place + 1];
                double z = p[r + 2] - places[3 * place + 2];
                tooLong |= x * x + y * y + z * z > longestSquare ? 1 << place : 0;
            }
        }
        return tooLong;
    }

    /** Position of the remaining vertex on its edge, 0 at a to 1 at b; NaN if the edge must not collapse. */
    private double placeOnEdge(int h, int a, int b, double longest) {
        boolean boundaryA = mesh.isBoundaryVertex(a);
        boolean boundaryB = mesh.isBoundaryVertex(b);
        if (boundaryA != boundaryB) {
            return boundaryB ? 1 : 0;
        }
        int kindA = mesh.featureKind(a);
        int kindB = mesh.featureKind(b);
        if (kindA == HalfEdgeMesh.SMOOTH && kindB == HalfEdgeMesh.SMOOTH) {
            double spreadA = spread(rings[0]);
            double spreadB = spread(rings[1]);
            return spreadA < spreadB - SHARPER ? 0 : spreadB < spreadA - SHARPER ? 1 : 0.5;
        }
        if (kindA != kindB && (kindA == HalfEdgeMesh.SMOOTH || kindB == HalfEdgeMesh.SMOOTH)) {
            return kindB == HalfEdgeMesh.SMOOTH ? 0 : 1;
        }
        double share = kindA == kindB ? 0.5 : kindA == HalfEdgeMesh.CORNER ? 0 : 1;
        // A ragged boundary consists of corners only and must still coarsen. Between crease corners only tiny edges
        // collapse.
        boolean alongLine = boundaryA || (mesh.crease[h] && (kindA != HalfEdgeMesh.CORNER || kindA != kindB));
        return alongLine || mesh.squareLength(h) < TINY * TINY * longest * longest ? share : Double.NaN;
    }

    /** Least cosine between a triangle normal of the ring and the summed normal; 1 on a plane. */
    private double spread(OneRing ring) {
        int count = ring.triangles;
        if (lengths.length < count) {
            lengths = new double[2 * count];
            normals = new double[6 * count];
        }
        double[] n = normals;
        double sx = 0;
        double sy = 0;
        double sz = 0;
        for (int i = 0; i < count; i++) {
            lengths[i] =
                    Triangles.cross(mesh.position, 3 * ring.vertex, 3 * ring.vertices[i], 3 * ring.next(i), normal);
            System.arraycopy(normal, 0, n, 3 * i, 3);
            sx += normal[0];
            sy += normal[1];
            sz += normal[2];
        }
        double total = Math.sqrt(sx * sx + sy * sy + sz * sz);
        double least = 1;
        for (int i = 0; i < count; i++) {
            double scale = lengths[i] * total;
            if (scale > 0) {
                least = Math.min(least, (n[3 * i] * sx + n[3 * i + 1] * sy + n[3 * i + 2] * sz) / scale);
            }
        }
        return least;
    }

    /**
     * Whether the triangles of the ring that do not contain {@code gone} keep orientation and shape when its vertex
     * moves.
     */
    private boolean fits(OneRing ring, int gone, double x, double y, double z) {
        for (int i = 0; i < ring.triangles; i++) {
            if (ring.triangleHas(i, gone)) {
                continue;
            }
            moved.set(mesh.position, ring.vertex, ring.vertices[i], ring.next(i), x, y, z);
            double before = moved.shapeBefore();
            double after = moved.shapeAfter();
            // A degenerate triangle has no orientation to preserve.
            double cosine = before < 1e-6 ? 1 : moved.dot / (Math.sqrt(moved.before) * Math.sqrt(moved.after));
            if (cosine < leastCosine || (leastCosine > ANY_TURN && after < MIN_SHAPE && after < before)) {
                return false;
            }
        }
        return true;
    }
}
