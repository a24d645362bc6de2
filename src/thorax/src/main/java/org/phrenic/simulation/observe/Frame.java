package org.phrenic.simulation.observe;

import java.util.Arrays;
import java.util.List;
import org.phrenic.simulation.SceneSurfaces;

/**
 * Snapshot of a scene at one step: positions of its surfaces and nodes, and observables. {@link SceneSurfaces#capture}
 * writes it into preallocated arrays, so that frames pass between the simulation thread and other threads without
 * allocation.
 */
public final class Frame {
    /** Length of a pose: a 3 × 3 rotation and a translation in mm, row by row, x' = R x + t. */
    public static final int POSE_LENGTH = 12;

    private final float[][] positions;
    private final float[][] poses;
    private final float[] nodes;
    private final double[] values = new double[Observation.COLUMNS.size()];
    /** Identity of the scene. Frames of different scenes are not interchangeable. */
    private final Object scene;

    private long serial;
    private long step;
    private double time;

    /**
     * @param scene the same object for all frames of a scene
     * @param positionLengths number of coordinates of each surface; 0 for a surface that does not deform
     * @param rigid whether each surface moves as a rigid body
     * @param nodeCoordinates three times the number of nodes
     */
    public Frame(Object scene, int[] positionLengths, boolean[] rigid, int nodeCoordinates) {
        this.scene = scene;
        positions = new float[positionLengths.length][];
        poses = new float[positionLengths.length][];
        for (int i = 0; i < positionLengths.length; i++) {
            positions[i] = new float[positionLengths[i]];
            poses[i] = rigid[i] ? new float[POSE_LENGTH] : new float[0];
        }
        nodes = new float[nodeCoordinates];
    }

    /** Frame of a static scene without simulation. */
    public static Frame still(List<Surface> surfaces) {
        int n = surfaces.size();
        return new Frame(new Object(), new int[n], new boolean[n], 0);
    }

    public void setState(long count, long atStep, double atTime, double[] observed) {
        serial = count;
        step = atStep;
        time = atTime;
        System.arraycopy(observed, 0, values, 0, values.length);
    }

    /** Sequence number of the capture, increasing within a scene; 0 before the first capture. */
    public long serial() {
        return serial;
    }

    /** Whether both frames belong to the same scene. */
    public boolean isOfSceneOf(Frame other) {
        return scene == other.scene;
    }

    /** Copy with the same content and serial number 0. */
    public Frame copy() {
        int[] lengths = Arrays.stream(positions).mapToInt(p -> p.length).toArray();
        boolean[] rigid = new boolean[poses.length];
        for (int i = 0; i < rigid.length; i++) {
            rigid[i] = poses[i].length > 0;
        }
        Frame twin = new Frame(scene, lengths, rigid, nodes.length);
        twin.copyFrom(this);
        twin.serial = 0;
        return twin;
    }

    /**
     * Writes the vertex positions of a surface, mm.
     *
     * @param surface of this frame's scene
     * @param index of the surface in its scene
     * @param out three numbers per vertex
     */
    public void writePositions(Surface surface, int index, double[] out) {
        double[] rest = surface.rest().positions();
        switch (surface.motion()) {
            case STILL -> System.arraycopy(rest, 0, out, 0, rest.length);
            case RIGID -> transform(poses[index], rest, out);
            case DEFORMING -> {
                float[] now = positions[index];
                for (int i = 0; i < now.length; i++) {
                    out[i] = now[i];
                }
            }
        }
    }

    /** Transforms points by a pose, x' = R x + t. */
    public static void transform(float[] pose, double[] from, double[] to) {
        for (int k = 0; k < from.length; k += 3) {
            for (int row = 0; row < 3; row++) {
                int r = 4 * row;
                to[k + row] = pose[r] * from[k] + pose[r + 1] * from[k + 1] + pose[r + 2] * from[k + 2] + pose[r + 3];
            }
        }
    }

    /** Number of steps since the start. */
    public long step() {
        return step;
    }

    /** Simulated time, s. */
    public double timeS() {
        return time;
    }

    /** Vertex positions of a deforming surface, mm. Readers must not modify the array. */
    public float[] positions(int surface) {
        return positions[surface];
    }

    /** Pose of a rigid surface. */
    public float[] pose(int surface) {
        return poses[surface];
    }

    /** Positions of all nodes in the caller's order, mm. Overlays of springs, links and fibres use them. */
    public float[] nodes() {
        return nodes;
    }

    /** Observables, in the order of {@link Observation#COLUMNS}. */
    public double[] values() {
        return values;
    }

    /** Copies the content of another frame of the same scene. */
    public void copyFrom(Frame other) {
        for (int i = 0; i < positions.length; i++) {
            System.arraycopy(other.positions[i], 0, positions[i], 0, positions[i].length);
            System.arraycopy(other.poses[i], 0, poses[i], 0, poses[i].length);
        }
        System.arraycopy(other.nodes, 0, nodes, 0, nodes.length);
        setState(other.serial, other.step, other.time, other.values);
    }

    /** Memory of the arrays, bytes. */
    public long bytes() {
        long floats = nodes.length;
        for (int i = 0; i < positions.length; i++) {
            floats += positions[i].length + poses[i].length;
        }
        return Float.BYTES * floats + (long) Double.BYTES * values.length;
    }

    /** Whether all values to be drawn are finite. */
    public boolean isFinite() {
        return Arrays.stream(positions).allMatch(Frame::finite)
                && Arrays.stream(poses).allMatch(Frame::finite)
                && finite(nodes);
    }

    private static boolean finite(float[] numbers) {
        float sum = 0;
        for (float number : numbers) {
            sum += 0 * number;
        }
        return sum == 0;
    }
}
