package org.phrenic.study.body;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.mesh.voxel.MeshVoxelizer;
import org.phrenic.simulation.observe.Surface;

/**
 * How far two organs lie in one another.
 *
 * @param overlapPercent common volume, counted on a grid of {@value #GRID_MM} mm, in per cent of the smaller organ
 * @param depthMm greatest distance of a vertex of either, inside the other, from the other's surface, mm; 0 if none is
 *     inside
 */
public record OrganContact(String first, String second, double overlapPercent, double depthMm) {
    private static final double GRID_MM = 2;
    /** A direction in which no edges of a mesh run. */
    private static final double[] RAY = {0.36, 0.48, 0.8};

    /** Most of the smaller organ that may lie in the other, per cent. */
    static final double MOST_PERCENT = 2;

    /** Whether the two are as far apart as is wanted: {@link #MOST_PERCENT}, {@link BodyLimits#THROUGH_MM}. */
    boolean isWithin() {
        return overlapPercent <= MOST_PERCENT && depthMm <= BodyLimits.THROUGH_MM;
    }

    String pair() {
        return first + ", " + second;
    }

    /** Whether a surface is an organ, a lung, the liver or a large vessel. */
    static boolean isOrgan(StructureKind kind) {
        return switch (kind) {
            case ORGAN, LUNG, LIVER, VESSEL -> true;
            default -> false;
        };
    }

    /** Vessels join one another and run through the liver. */
    private static boolean mayMeet(StructureKind a, StructureKind b) {
        boolean vessel = a == StructureKind.VESSEL || b == StructureKind.VESSEL;
        return vessel && (a == b || a == StructureKind.LIVER || b == StructureKind.LIVER);
    }

    /**
     * Measures all pairs of organs but those of two vessels, or of a vessel and the liver.
     *
     * @param surfaces of a scene
     * @param meshes their positions
     */
    static List<OrganContact> all(List<Surface> surfaces, List<TriangleMesh> meshes) {
        List<OrganContact> contacts = new ArrayList<>();
        TriangleTree[] trees = new TriangleTree[surfaces.size()];
        Arrays.setAll(trees, i -> isOrgan(surfaces.get(i).kind()) ? new TriangleTree(meshes.get(i)) : null);
        for (int i = 0; i < trees.length; i++) {
            for (int j = 0; j < i; j++) {
                if (trees[i] != null
                        && trees[j] != null
                        && !mayMeet(surfaces.get(i).kind(), surfaces.get(j).kind())) {
                    TriangleMesh a = meshes.get(j);
                    TriangleMesh b = meshes.get(i);
                    contacts.add(new OrganContact(
                            surfaces.get(j).name(),
                            surfaces.get(i).name(),
                            overlapPercent(a, b),
                            Math.max(depthMm(a, b, trees[i]), depthMm(b, a, trees[j]))));
                }
            }
        }
        return contacts;
    }

    /** Low and high corner of what the boxes of two meshes have in common. */
    private static double[] common(TriangleMesh a, TriangleMesh b) {
        double[] box = a.bounds();
        double[] other = b.bounds();
        for (int axis = 0; axis < 3; axis++) {
            box[axis] = Math.max(box[axis], other[axis]);
            box[3 + axis] = Math.min(box[3 + axis], other[3 + axis]);
        }
        return box;
    }

    private static double overlapPercent(TriangleMesh a, TriangleMesh b) {
        double[] box = common(a, b);
        int[] size = new int[3];
        Arrays.setAll(size, axis -> (int) Math.ceil((box[3 + axis] - box[axis]) / GRID_MM));
        if (size[0] <= 0 || size[1] <= 0 || size[2] <= 0) {
            return 0;
        }
        byte[] inA = inside(a, box, size);
        byte[] inB = inside(b, box, size);
        int both = 0;
        for (int i = 0; i < inA.length; i++) {
            both += inA[i] & inB[i];
        }
        double smaller = Math.min(MeshMeasure.signedVolume(a), MeshMeasure.signedVolume(b));
        return 100 * both * GRID_MM * GRID_MM * GRID_MM / smaller;
    }

    private static byte[] inside(TriangleMesh mesh, double[] box, int[] size) {
        double[] toVoxel = new double[12];
        for (int axis = 0; axis < 3; axis++) {
            toVoxel[5 * axis] = 1 / GRID_MM;
            toVoxel[4 * axis + 3] = -box[axis] / GRID_MM - 0.5;
        }
        byte[] labels = new byte[size[0] * size[1] * size[2]];
        new MeshVoxelizer(size[0], size[1], size[2], toVoxel, labels).fill(mesh, 1);
        return labels;
    }

    private static double depthMm(TriangleMesh of, TriangleMesh in, TriangleTree tree) {
        double[] box = common(of, in);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        double deepest = 0;
        for (int v = 0; v < of.vertexCount(); v++) {
            double x = of.x(v);
            double y = of.y(v);
            double z = of.z(v);
            if (BoundingBoxes.squaredDistance(box, 0, x, y, z) == 0
                    && tree.closest(x, y, z, hit)
                    && hit.distanceSquared > deepest * deepest) {
                double mm = Math.sqrt(hit.distanceSquared);
                deepest = isInside(tree, x, y, z, hit) ? mm : deepest;
            }
        }
        return deepest;
    }

    /**
     * Whether a point is inside, by the winding number, which folds of a surface do not mislead. It is computed only
     * where a ray passes the surface an odd number of times.
     */
    private static boolean isInside(TriangleTree tree, double x, double y, double z, TriangleTree.Hit working) {
        return tree.countAlongRay(x, y, z, RAY[0], RAY[1], RAY[2], working) % 2 == 1 && tree.isInside(x, y, z);
    }
}
