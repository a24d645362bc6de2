package org.phrenic.mesh.edit;

import org.phrenic.mesh.query.TriangleTree;

/**
 * Tangential relaxation for remeshing. Each vertex moves in its tangent plane to the area-weighted centroid of its
 * triangles and is then projected onto the triangles of the original surface that face the same way. On a boundary or a
 * crease it slides along the original line; corners of creases do not move. A move that would flip or flatten a
 * triangle is rejected.
 */
final class VertexRelaxer {
    /**
     * Original triangles that face away from the vertex by more than 100 degrees are on the far side of a thin sheet.
     */
    private static final double SAME_SIDE = -0.17;

    private static final double MIN_COSINE = 0.2;

    private final HalfEdgeMesh mesh;
    private final TriangleTree surface;
    private final TriangleTree lines;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();
    private final OneRing ring = new OneRing();
    private final MovedTriangle moved = new MovedTriangle();

    /**
     * @param surface the original surface
     * @param lines the original's boundary edges and creases as triangles (a, b, b)
     */
    VertexRelaxer(HalfEdgeMesh mesh, TriangleTree surface, TriangleTree lines) {
        this.mesh = mesh;
        this.surface = surface;
        this.lines = lines;
    }

    /** One Gauss-Seidel pass over all vertices. */
    void relax(double reach) {
        for (int v = 0; v < mesh.vertexEnd; v++) {
            if (mesh.out[v] != HalfEdgeMesh.NONE) {
                int kind = mesh.featureKind(v);
                if (kind == HalfEdgeMesh.SMOOTH) {
                    relaxInTangentPlane(v, reach);
                } else if (kind == HalfEdgeMesh.ON_FEATURE_LINE) {
                    relaxAlongLine(v, reach);
                }
            }
        }
        mesh.clearAllFlipChecked();
    }

    /** Moves v to the midpoint of its two neighbours on a feature line, projected onto the original line. */
    private void relaxAlongLine(int v, double reach) {
        double[] p = mesh.position;
        int a = 3 * mesh.previousOnLine;
        int b = 3 * mesh.nextOnLine;
        double x = (p[a] + p[b]) / 2;
        double y = (p[a + 1] + p[b + 1]) / 2;
        double z = (p[a + 2] + p[b + 2]) / 2;
        if (lines.closest(x, y, z, reach, hit)) {
            mesh.collectRing(v, ring);
            if (keepsSides(hit.x, hit.y, hit.z)) {
                mesh.setPosition(v, hit.x, hit.y, hit.z);
            }
        }
    }

    private void relaxInTangentPlane(int v, double reach) {
        mesh.collectRing(v, ring);
        double[] p = mesh.position;
        double vx = p[3 * v];
        double vy = p[3 * v + 1];
        double vz = p[3 * v + 2];
        double nx = 0;
        double ny = 0;
        double nz = 0;
        double gx = 0;
        double gy = 0;
        double gz = 0;
        double area = 0;
        int c = 3 * ring.vertices[ring.size - 1];
        double ux = p[c] - vx;
        double uy = p[c + 1] - vy;
        double uz = p[c + 2] - vz;
        for (int i = 0; i < ring.size; i++) {
            int d = 3 * ring.vertices[i];
            double wx = p[d] - vx;
            double wy = p[d + 1] - vy;
            double wz = p[d + 2] - vz;
            double mx = uy * wz - uz * wy;
            double my = uz * wx - ux * wz;
            double mz = ux * wy - uy * wx;
            double weight = Math.sqrt(mx * mx + my * my + mz * mz);
            nx += mx;
            ny += my;
            nz += mz;
            area += weight;
            gx += weight * (ux + wx);
            gy += weight * (uy + wy);
            gz += weight * (uz + wz);
            ux = wx;
            uy = wy;
            uz = wz;
        }
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        if (!(length > 0)) {
            return;
        }
        nx /= length;
        ny /= length;
        nz /= length;
        // The centroid of each triangle relative to v is a third of the sum of its other two corners.
        gx /= 3 * area;
        gy /= 3 * area;
        gz /= 3 * area;
        double along = gx * nx + gy * ny + gz * nz;
        moveOntoSurface(v, vx + gx - along * nx, vy + gy - along * ny, vz + gz - along * nz, nx, ny, nz, reach);
    }

    /** Moves v to the point nearest to (x, y, z) on the side of the surface that faces along the normal. */
    private void moveOntoSurface(int v, double x, double y, double z, double nx, double ny, double nz, double reach) {
        double vx = mesh.position[3 * v];
        double vy = mesh.position[3 * v + 1];
        double vz = mesh.position[3 * v + 2];
        // A vertex on the surface is no farther from it than it has moved, so most searches end in this small ball.
        double step = Math.sqrt((x - vx) * (x - vx) + (y - vy) * (y - vy) + (z - vz) * (z - vz));
        boolean found = surface.closest(x, y, z, Math.min(reach, step), nx, ny, nz, SAME_SIDE, hit)
                || surface.closest(x, y, z, reach, nx, ny, nz, SAME_SIDE, hit);
        if (found && keepsSides(hit.x, hit.y, hit.z)) {
            mesh.setPosition(v, hit.x, hit.y, hit.z);
        }
    }

    /** Whether each triangle of the ring keeps its orientation when the vertex moves to (x, y, z). */
    private boolean keepsSides(double x, double y, double z) {
        double[] p = mesh.position;
        for (int i = 0; i < ring.triangles; i++) {
            moved.set(p, ring.vertex, ring.vertices[i], ring.next(i), x, y, z);
            if (moved.dot < MIN_COSINE * Math.sqrt(moved.before * moved.after)) {
                return false;
            }
        }
        return true;
    }
}
