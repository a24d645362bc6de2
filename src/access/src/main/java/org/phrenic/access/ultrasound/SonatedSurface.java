package org.phrenic.access.ultrasound;

import java.util.regex.Pattern;
import org.phrenic.access.imaging.Tissue;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * A surface as a probe meets it: vertices in plane coordinates of a {@link SectorGrid} with their elevation in units of
 * the beam's width, and the triangles near the image plane. A level of that elevation cuts it in curves, which
 * {@link #crossings} intersects with the scan lines.
 */
class SonatedSurface {
    /** Part of the beam's width within which surfaces are cut. */
    static final double REACH = 0.7;
    /** Distance beyond the beam within which triangles count for the normals of vertices, mm. */
    private static final double NORMAL_MARGIN_MM = 15;

    private static final Pattern PORTAL = Pattern.compile("(vessel_)?portal_.*");

    final int index;
    final Surface surface;
    final Tissue tissue;
    /** +1 if the triangles face outward, -1 if inward, 0 if the surface has no inside. */
    final int orientation;

    /** Whether it is the portal vein or a branch of it, which the liver holds in a sheath of connective tissue. */
    final boolean portal;

    final int rank;
    private final double[] world;
    private final double[] lateral;
    private final double[] axial;
    private final double[] elevation;
    private final double[] relative;
    private final float[] normals;
    private IntList near = new IntList();

    SonatedSurface(int index, Surface surface) {
        this.index = index;
        this.surface = surface;
        tissue = Tissue.of(surface);
        portal = PORTAL.matcher(surface.name()).matches();
        boolean solid = surface.kind() != StructureKind.PLEURA && MeshMeasure.hasInside(surface.rest());
        orientation = solid ? (int) Math.signum(MeshMeasure.signedVolume(surface.rest())) : 0;
        rank = rank(surface.kind());
        int n = surface.rest().vertexCount();
        world = new double[3 * n];
        lateral = new double[n];
        axial = new double[n];
        elevation = new double[n];
        relative = new double[n];
        normals = new float[3 * n];
    }

    /** Where surfaces overlap, that of the highest rank says which tissue is there. */
    private static int rank(StructureKind kind) {
        return switch (kind) {
            case SKIN, PLEURA -> 0;
            case MUSCLE, DIAPHRAGM -> 1;
            case LUNG -> 2;
            case LIVER -> 3;
            case ORGAN, OTHER -> 4;
            case VESSEL, LESION -> 5;
            case RIB, COSTAL_CARTILAGE, STERNUM, VERTEBRA, DISC, BONE -> 6;
        };
    }

    /** Whether the surface is seen: one that has an inside, or the open sheet of the diaphragm. */
    boolean isSeen() {
        return orientation != 0 || surface.kind() == StructureKind.DIAPHRAGM;
    }

    /** Writes the vertex positions in a frame, LPS, mm. */
    void locate(Frame frame, double[] out) {
        frame.writePositions(surface, index, out);
    }

    /** Index of the surface that the tissue inside moves with. */
    int carrier() {
        return index;
    }

    /** Current vertex positions, LPS, mm. */
    double[] world() {
        return world;
    }

    /** Moves the surface to a frame, and says where the probe meets it. */
    void update(Frame frame, ProbePose pose, SectorGrid grid) {
        locate(frame, world);
        double[] e = pose.elevation();
        double[] l = pose.lateral();
        double[] a = pose.axial();
        double[] face = pose.face();
        double radius = grid.probe.radiusMm();
        double reach = REACH * grid.probe.elevationWidthMm(grid.depthMm) + REACH * grid.probe.elevationWidthMm(0);
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        for (int v = 0; v < lateral.length; v++) {
            double x = world[3 * v] - face[0];
            double y = world[3 * v + 1] - face[1];
            double z = world[3 * v + 2] - face[2];
            lateral[v] = x * l[0] + y * l[1] + z * l[2];
            axial[v] = radius + x * a[0] + y * a[1] + z * a[2];
            elevation[v] = x * e[0] + y * e[1] + z * e[2];
            least = Math.min(least, elevation[v]);
            greatest = Math.max(greatest, elevation[v]);
        }
        boolean meets = least <= reach && greatest >= -reach;
        near = new IntList();
        if (meets) {
            for (int v = 0; v < lateral.length; v++) {
                double depth = Math.sqrt(lateral[v] * lateral[v] + axial[v] * axial[v]) - radius;
                relative[v] = elevation[v] / grid.probe.elevationWidthMm(depth);
            }
            collectTriangles(reach + NORMAL_MARGIN_MM);
        }
    }

    private void collectTriangles(double margin) {
        int[] t = surface.rest().triangles();
        java.util.Arrays.fill(normals, 0);
        for (int k = 0; k < t.length; k += 3) {
            int a = t[k];
            int b = t[k + 1];
            int c = t[k + 2];
            double low = Math.min(elevation[a], Math.min(elevation[b], elevation[c]));
            double high = Math.max(elevation[a], Math.max(elevation[b], elevation[c]));
            if (low <= margin && high >= -margin) {
                addNormal(a, b, c);
                double from = Math.min(relative[a], Math.min(relative[b], relative[c]));
                double to = Math.max(relative[a], Math.max(relative[b], relative[c]));
                if (from <= REACH && to >= -REACH) {
                    near.add(k);
                }
            }
        }
    }

    /** Adds the normal of a triangle, weighted by its area, to its corners. */
    private void addNormal(int a, int b, int c) {
        double x1 = lateral[b] - lateral[a];
        double y1 = axial[b] - axial[a];
        double z1 = elevation[b] - elevation[a];
        double x2 = lateral[c] - lateral[a];
        double y2 = axial[c] - axial[a];
        double z2 = elevation[c] - elevation[a];
        float nx = (float) (y1 * z2 - z1 * y2);
        float ny = (float) (z1 * x2 - x1 * z2);
        float nz = (float) (x1 * y2 - y1 * x2);
        for (int v : new int[] {a, b, c}) {
            normals[3 * v] += nx;
            normals[3 * v + 1] += ny;
            normals[3 * v + 2] += nz;
        }
    }

    /**
     * Adds the crossings of the scan lines with the surface at a level of the elevation.
     *
     * @param level elevation in units of the beam's width
     */
    void crossings(SectorGrid grid, double level, LineCrossings out) {
        int[] t = surface.rest().triangles();
        Cut in = new Cut();
        Cut end = new Cut();
        for (int i = 0; i < near.size(); i++) {
            int k = near.get(i);
            boolean found = false;
            for (int corner = 0; corner < 3; corner++) {
                int a = t[k + corner];
                int b = t[k + (corner + 1) % 3];
                if (relative[a] < level && relative[b] >= level) {
                    in.set(a, b, level);
                    found = true;
                } else if (relative[a] >= level && relative[b] < level) {
                    end.set(a, b, level);
                }
            }
            if (found) {
                cross(grid, in, end, out);
            }
        }
    }

    /** Where an edge reaches the level; the same from both of its triangles. */
    private final class Cut {
        private double x;
        private double z;
        private double nx;
        private double nz;
        private double ny;

        void set(int one, int other, double level) {
            int a = Math.min(one, other);
            int b = Math.max(one, other);
            double share = (level - relative[a]) / (relative[b] - relative[a]);
            x = lateral[a] + share * (lateral[b] - lateral[a]);
            z = axial[a] + share * (axial[b] - axial[a]);
            double scaleA = (1 - share) / length(a);
            double scaleB = share / length(b);
            nx = scaleA * normals[3 * a] + scaleB * normals[3 * b];
            nz = scaleA * normals[3 * a + 1] + scaleB * normals[3 * b + 1];
            ny = scaleA * normals[3 * a + 2] + scaleB * normals[3 * b + 2];
        }

        private double length(int v) {
            double sum = normals[3 * v] * normals[3 * v]
                    + normals[3 * v + 1] * normals[3 * v + 1]
                    + normals[3 * v + 2] * normals[3 * v + 2];
            return sum > 0 ? Math.sqrt(sum) : 1;
        }
    }

    /** Adds the lines that pass between two points of a curve. */
    private void cross(SectorGrid grid, Cut p, Cut q, LineCrossings out) {
        boolean front = p.z > 1 && q.z > 1;
        int from = front ? grid.firstLine(p.x, p.z, q.x, q.z) : 0;
        int to = front ? grid.endLine(p.x, p.z, q.x, q.z) : SectorGrid.LINES;
        for (int line = from; line < to; line++) {
            double sp = grid.side(line, p.x, p.z);
            double sq = grid.side(line, q.x, q.z);
            if (sp < 0 == sq < 0) {
                continue;
            }
            double share = sp / (sp - sq);
            double x = p.x + share * (q.x - p.x);
            double z = p.z + share * (q.z - p.z);
            double range = x * grid.sin[line] + z * grid.cos[line];
            if (range <= 0) {
                continue;
            }
            double nx = p.nx + share * (q.nx - p.nx);
            double nz = p.nz + share * (q.nz - p.nz);
            double ny = p.ny + share * (q.ny - p.ny);
            double length = Math.sqrt(nx * nx + nz * nz + ny * ny);
            double along = nx * grid.sin[line] + nz * grid.cos[line];
            double cosine = length > 0 ? Math.min(1, Math.abs(along) / length) : 0;
            double slope = Math.abs(along) > 0 ? Math.abs(ny / along) : 1e3;
            // The curve runs from rising to falling elevation, so the inside lies on a fixed side of it.
            int turn = sq > sp ? 1 : -1;
            out.add(line, range - grid.probe.radiusMm(), turn * orientation * (index + 1), cosine, slope);
        }
    }
}
