package org.phrenic.motion;

import java.util.List;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.VoxelBox;
import org.phrenic.simulation.observe.Surface;

/**
 * Fields and images of a {@link BodyMotion} at the voxels of a box. Each voxel takes the field of the region that its
 * centre is in: at rest for what goes forward, now for what comes back. No value is a mean over two regions, so faces
 * that slide stay sharp. Slices are computed in parallel, with the same bits on any number of threads.
 */
public final class MotionSampler {
    /** Step of the differences of which the Jacobian is made, mm. */
    private static final double STEP_MM = 3;
    /** Distance of the nodes from which the inverse begins, mm. */
    private static final double INVERSE_EDGE_MM = 4;

    private final BodyMotion motion;
    private final VoxelBox box;
    private final byte[] restLabels;
    private final RestTissue tissue;
    private final RegionField[] inverse = new RegionField[256];
    private byte[] nowLabels;

    public MotionSampler(BodyMotion motion, VoxelBox box) {
        this.motion = motion;
        this.box = box;
        restLabels = motion.regions().label(box, motion.rest());
        tissue = new RestTissue(box, restLabels);
        nowLabels = restLabels;
    }

    VoxelBox box() {
        return box;
    }

    /** Values of a voxel, written to an array at an index. */
    private interface Voxel {
        void at(int region, double[] place, double[] working, int voxel);
    }

    private void each(byte[] labels, Voxel voxel) {
        int slice = box.columns() * box.rows();
        motion.workers().run(box.slices(), k -> {
            double[] place = new double[3];
            double[] working = new double[9];
            for (int v = 0; v < slice; v++) {
                int row = v / box.columns();
                box.voxelToMm(v % box.columns(), row, k, place);
                int at = k * slice + v;
                voxel.at(Byte.toUnsignedInt(labels[at]), place, working, at);
            }
        });
    }

    /** Takes the present state of the body. */
    public void update() {
        nowLabels = motion.regions().label(box, motion.now());
        boolean[] present = new boolean[inverse.length];
        for (byte label : nowLabels) {
            present[Byte.toUnsignedInt(label)] = true;
        }
        present[BodyRegions.WALL] |= present[BodyRegions.OUTSIDE];
        for (int region = BodyRegions.WALL; region < inverse.length; region++) {
            inverse[region] = present[region] ? inverse(region) : null;
        }
        inverse[BodyRegions.OUTSIDE] = inverse[BodyRegions.WALL];
    }

    private RegionField inverse(int region) {
        RegionField field = motion.field(region);
        if (field instanceof RigidField rigid) {
            return rigid.inverse();
        }
        double[] bounds = region < BodyRegions.FIRST
                ? bounds()
                : motion.surfaces()
                        .get(region - BodyRegions.FIRST)
                        .rest()
                        .withPositions(motion.now().get(region - BodyRegions.FIRST))
                        .bounds();
        InverseField found = new InverseField(field, bounds, INVERSE_EDGE_MM);
        motion.workers().run(found.planes(), found::solvePlane);
        return found;
    }

    /** Box of the voxels within reach of the body. */
    private double[] bounds() {
        double[] out = {1e9, 1e9, 1e9, -1e9, -1e9, -1e9};
        double[] place = new double[3];
        for (int corner = 0; corner < 8; corner++) {
            box.voxelToMm(
                    (corner & 1) * (box.columns() - 1),
                    (corner >> 1 & 1) * (box.rows() - 1),
                    (corner >> 2) * (box.slices() - 1),
                    place);
            for (int axis = 0; axis < 3; axis++) {
                out[axis] = Math.min(out[axis], place[axis]);
                out[3 + axis] = Math.max(out[3 + axis], place[axis]);
            }
        }
        double[] body = motion.bounds();
        for (int axis = 0; axis < 3; axis++) {
            out[axis] = Math.max(out[axis], body[axis] - BodyMotion.OUTSIDE_MM);
            out[3 + axis] = Math.max(out[axis], Math.min(out[3 + axis], body[3 + axis] + BodyMotion.OUTSIDE_MM));
        }
        return out;
    }

    /** Displacement from rest to now of what is at each voxel at rest, LPS, mm; three numbers a voxel. */
    public float[] forward() {
        float[] out = new float[3 * box.voxels()];
        each(restLabels, (region, p, u, voxel) -> {
            motion.field(region).at(p[0], p[1], p[2], u);
            put(u, out, voxel);
        });
        return out;
    }

    /** Displacement from now to rest of what is at each voxel now, LPS, mm; three numbers a voxel. */
    public float[] backward() {
        float[] out = new float[3 * box.voxels()];
        each(nowLabels, (region, p, u, voxel) -> {
            inverse[region].at(p[0], p[1], p[2], u);
            put(u, out, voxel);
        });
        return out;
    }

    private static void put(double[] vector, float[] out, int voxel) {
        for (int axis = 0; axis < 3; axis++) {
            out[3 * voxel + axis] = (float) vector[axis];
        }
    }

    /**
     * Volume now over volume at rest of what is at each voxel at rest: the determinant of the gradient of its place
     * now, by central differences of {@value #STEP_MM} mm within its region. 1 outside the body.
     */
    public float[] jacobian() {
        float[] out = new float[box.voxels()];
        each(
                restLabels,
                (region, p, g, voxel) -> out[voxel] =
                        region == BodyRegions.OUTSIDE ? 1 : (float) determinant(motion.field(region), p, g));
        return out;
    }

    private static double determinant(RegionField field, double[] p, double[] g) {
        double[] far = new double[3];
        double[] near = new double[3];
        double h = STEP_MM / 2;
        for (int axis = 0; axis < 3; axis++) {
            double x = axis == 0 ? h : 0;
            double y = axis == 1 ? h : 0;
            double z = axis == 2 ? h : 0;
            field.at(p[0] + x, p[1] + y, p[2] + z, far);
            field.at(p[0] - x, p[1] - y, p[2] - z, near);
            for (int row = 0; row < 3; row++) {
                g[3 * row + axis] = (far[row] - near[row]) / STEP_MM + (row == axis ? 1 : 0);
            }
        }
        return g[0] * (g[4] * g[8] - g[5] * g[7])
                - g[1] * (g[3] * g[8] - g[5] * g[6])
                + g[2] * (g[3] * g[7] - g[4] * g[6]);
    }

    /**
     * Specific ventilation of the lungs since rest, ml of air for each ml of lung at rest: the Jacobian less 1 in
     * lungs, 0 elsewhere (Reinhardt et al. 2008, doi 10.1016/j.media.2008.03.007).
     *
     * @param jacobian of {@link #jacobian}
     */
    public float[] ventilation(float[] jacobian) {
        boolean[] lung = new boolean[inverse.length];
        List<Surface> surfaces = motion.surfaces();
        for (int i = 0; i < surfaces.size(); i++) {
            lung[BodyRegions.FIRST + i] = surfaces.get(i).kind() == StructureKind.LUNG;
        }
        float[] out = new float[jacobian.length];
        for (int v = 0; v < out.length; v++) {
            out[v] = lung[Byte.toUnsignedInt(restLabels[v])] ? jacobian[v] - 1 : 0;
        }
        return out;
    }

    /** An image as it is now: each voxel shows what has come there, interpolated linearly. */
    public float[] warpLinear(float[] values, float beyond) {
        float[] out = new float[values.length];
        double[] toVoxel = box.toVoxel();
        each(nowLabels, (region, p, u, voxel) -> {
            source(region, p, u, toVoxel);
            out[voxel] = tissue.value(values, region, u[3], u[4], u[5], beyond);
        });
        return out;
    }

    /** A label volume as it is now: each voxel shows the label of what has come there, nearest; 0 beyond the volume. */
    public float[] warpNearest(float[] values) {
        float[] out = new float[values.length];
        double[] toVoxel = box.toVoxel();
        each(nowLabels, (region, p, u, voxel) -> {
            source(region, p, u, toVoxel);
            out[voxel] = tissue.label(values, region, u[3], u[4], u[5]);
        });
        return out;
    }

    /** Writes where a place was at rest, in voxels, to the numbers 3 to 5. */
    private void source(int region, double[] p, double[] u, double[] toVoxel) {
        inverse[region].at(p[0], p[1], p[2], u);
        double x = p[0] + u[0];
        double y = p[1] + u[1];
        double z = p[2] + u[2];
        for (int row = 0; row < 3; row++) {
            int m = 4 * row;
            u[3 + row] = toVoxel[m] * x + toVoxel[m + 1] * y + toVoxel[m + 2] * z + toVoxel[m + 3];
        }
    }

    /** The region of each voxel now, as a number of {@link BodyMotion#regionNames}. */
    public float[] regions() {
        return values(nowLabels);
    }

    /** Regions of voxels as real values, which {@link #warpNearest} takes. */
    static float[] values(byte[] labels) {
        float[] out = new float[labels.length];
        for (int v = 0; v < out.length; v++) {
            out[v] = Byte.toUnsignedInt(labels[v]);
        }
        return out;
    }

    /** Displacement back to rest of a place that is in a region now. */
    void back(int region, double[] place, double[] out) {
        inverse[region].at(place[0], place[1], place[2], out);
    }

    /** The region of each voxel at rest, or now. */
    byte[] labels(boolean now) {
        return now ? nowLabels : restLabels;
    }

    /** Number of voxels in the body at rest. */
    public int voxelsInBody() {
        int count = 0;
        for (byte label : restLabels) {
            count += label == BodyRegions.OUTSIDE ? 0 : 1;
        }
        return count;
    }

    /** Labels of a box as real values, which {@link #warpNearest} takes. */
    public static float[] values(LabelGrid grid) {
        float[] values = new float[grid.voxelCount()];
        for (int v = 0; v < values.length; v++) {
            values[v] = grid.label(v);
        }
        return values;
    }
}
