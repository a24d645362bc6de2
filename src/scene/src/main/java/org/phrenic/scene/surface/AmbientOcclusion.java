package org.phrenic.scene.surface;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;

/**
 * Ambient occlusion of the body at rest: the fraction of ambient light that reaches a vertex, 1 if nothing occludes it.
 * Bone, cartilage and liver are voxelized and the grid is downsampled repeatedly. Along the vertex normal, coarser
 * grids are sampled at larger distances, as in voxel cone tracing (Crassin and others 2011, doi
 * 10.1111/j.1467-8659.2011.02063.x, with a grid instead of an octree). Computed once for all pictures.
 */
public final class AmbientOcclusion {
    private static final double CELL_MM = 4;
    private static final int LEVELS = 4;

    /** Fraction of light that an occupied cell blocks at each level, from near to far. */
    private static final double[] LEVEL_WEIGHT = {0.55, 0.60, 0.55, 0.40};

    private static final double MIN_VISIBILITY = 0.30;

    /** What a body has in every scene of it. */
    private static final Set<StructureKind> OCCLUDERS = EnumSet.of(
            StructureKind.RIB,
            StructureKind.COSTAL_CARTILAGE,
            StructureKind.STERNUM,
            StructureKind.VERTEBRA,
            StructureKind.DISC,
            StructureKind.BONE,
            StructureKind.LIVER);

    private final double[] origin = new double[3];
    private final int[] size = new int[3];
    private final float[][] levels = new float[LEVELS][];

    public AmbientOcclusion(List<Surface> surfaces) {
        List<Surface> occluders =
                surfaces.stream().filter(s -> OCCLUDERS.contains(s.kind())).toList();
        double[] box = Surface.bounds(occluders);
        int even = 1 << LEVELS;
        for (int i = 0; i < 3; i++) {
            origin[i] = box[i] - 2 * CELL_MM;
            int cells = (int) Math.ceil((box[3 + i] - box[i]) / CELL_MM) + 4;
            size[i] = Math.max(even, (cells + even - 1) / even * even);
        }
        levels[0] = new float[size[0] * size[1] * size[2]];
        occluders.forEach(s -> voxelize(s.rest()));
        for (int level = 1; level < LEVELS; level++) {
            levels[level] = downsampled(levels[level - 1], level - 1);
        }
    }

    /** Marks the cells that a surface passes through as occupied. */
    private void voxelize(TriangleMesh mesh) {
        int[] t = mesh.triangles();
        double[] p = mesh.positions();
        for (int i = 0; i < t.length; i += 3) {
            double ab = MeshMeasure.distance(mesh, t[i], t[i + 1]);
            double bc = MeshMeasure.distance(mesh, t[i + 1], t[i + 2]);
            double longest = Math.max(ab, Math.max(bc, MeshMeasure.distance(mesh, t[i + 2], t[i])));
            int parts = Math.max(1, (int) Math.ceil(longest / (CELL_MM / 2)));
            for (int u = 0; u <= parts; u++) {
                for (int v = 0; v <= parts - u; v++) {
                    double wb = (double) u / parts;
                    double wc = (double) v / parts;
                    int cell = 0;
                    for (int k = 2; k >= 0; k--) {
                        double a = p[3 * t[i] + k];
                        double x = a + wb * (p[3 * t[i + 1] + k] - a) + wc * (p[3 * t[i + 2] + k] - a);
                        int at = (int) Math.floor((x - origin[k]) / CELL_MM);
                        cell = cell * size[k] + Math.max(0, Math.min(size[k] - 1, at));
                    }
                    levels[0][cell] = 1;
                }
            }
        }
    }

    private float[] downsampled(float[] fine, int level) {
        int nx = size[0] >> level;
        int ny = size[1] >> level;
        int nz = size[2] >> level;
        float[] coarse = new float[nx / 2 * (ny / 2) * (nz / 2)];
        for (int z = 0; z < nz; z++) {
            for (int y = 0; y < ny; y++) {
                for (int x = 0; x < nx; x++) {
                    coarse[(z / 2 * (ny / 2) + y / 2) * (nx / 2) + x / 2] += fine[(z * ny + y) * nx + x] / 8;
                }
            }
        }
        return coarse;
    }

    /** Fraction of ambient light at each vertex, 0 to 1, sampled along the normals of the mesh at rest. */
    public float[] visibility(TriangleMesh mesh, VertexNormals normals) {
        float[] visibility = new float[mesh.vertexCount()];
        double[] n = new double[3];
        for (int i = 0; i < visibility.length; i++) {
            normals.normal(i, n);
            double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            double light = 1;
            for (int level = 0; level < LEVELS && length > 0; level++) {
                double away = CELL_MM * (1 << level) * 1.6 / length;
                double full =
                        occupancy(level, mesh.x(i) + away * n[0], mesh.y(i) + away * n[1], mesh.z(i) + away * n[2]);
                light *= 1 - LEVEL_WEIGHT[level] * full;
            }
            visibility[i] = (float) Math.max(MIN_VISIBILITY, light);
        }
        return visibility;
    }

    /** Trilinearly interpolated occupancy of a grid, 0 to 1; 0 outside. */
    private double occupancy(int level, double x, double y, double z) {
        double cell = CELL_MM * (1 << level);
        double[] at = {(x - origin[0]) / cell - 0.5, (y - origin[1]) / cell - 0.5, (z - origin[2]) / cell - 0.5};
        int[] low = new int[3];
        for (int k = 0; k < 3; k++) {
            low[k] = (int) Math.floor(at[k]);
            at[k] -= low[k];
        }
        double sum = 0;
        for (int corner = 0; corner < 8; corner++) {
            double weight = 1;
            int index = 0;
            boolean inside = true;
            for (int k = 2; k >= 0; k--) {
                int far = corner >> k & 1;
                int i = low[k] + far;
                int n = size[k] >> level;
                inside &= i >= 0 && i < n;
                index = index * n + i;
                weight *= far == 1 ? at[k] : 1 - at[k];
            }
            if (inside) {
                sum += weight * levels[level][index];
            }
        }
        // Compensates that a surface fills a smaller fraction of a coarser cell.
        return Math.min(1, sum * (1 + 0.5 * level));
    }
}
