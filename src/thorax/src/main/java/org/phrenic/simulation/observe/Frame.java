package org.phrenic.simulation.observe;

import java.util.Arrays;
import java.util.List;
import org.phrenic.simulation.SceneSurfaces;

/**
 * What a scene looks like at one step: places of its surfaces, nodes and observables. Written by
 * {@link SceneSurfaces#capture} into arrays that are made once, so that frames can be handed from the simulation's
 * thread to another and back without allocation.
 */
public final class Frame {
    /** Numbers of a pose: three rows of a rotation and a translation in mm, x' = R x + t, row by row. */
    public static final int POSE_LENGTH = 12;

    private final float[][] positions;
    private final float[][] poses;
    private final float[] nodes;
    private final double[] values = new double[Observation.COLUMNS.size()];
    /** One object a scene: frames of another never fit. */
    private final Object scene;

    private long serial;
    private long step;
    private double time;

    /**
     * @param scene the same object for all frames of a scene
     * @param positionLengths coordinates of each surface; 0 for one that does not deform
     * @param rigid whether each surface moves as a rigid body
     * @param nodeCoordinates three times the count of nodes
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

    /** The frame of a scene in which nothing moves and nothing is simulated. */
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

    /** Of two frames of a scene the one with the greater number was captured later; 0 before the first capture. */
    public long serial() {
        return serial;
    }

    /** Whether this and another are frames of one scene. */
    public boolean isOfSceneOf(Frame other) {
        return scene == other.scene;
    }

    /** Another frame of the same scene with the same content, as if captured before all others. */
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
     * Writes where the vertices of a surface are, mm.
     *
     * @param surface of this frame's scene
     * @param index of the surface in its scene
     * @param out three numbers a vertex
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

    /** Moves points by a pose, x' = R x + t. */
    public static void transform(float[] pose, double[] from, double[] to) {
        for (int k = 0; k < from.length; k += 3) {
            for (int row = 0; row < 3; row++) {
                int r = 4 * row;
                to[k + row] = pose[r] * from[k] + pose[r + 1] * from[k + 1] + pose[r + 2] * from[k + 2] + pose[r + 3];
            }
        }
    }

    /** Steps since the start. */
    public long step() {
        return step;
    }

    /** Simulated time, s. */
    public double timeS() {
        return time;
    }

    /** Vertices of a deforming surface, mm; not to be written by readers. */
    public float[] positions(int surface) {
        return positions[surface];
    }

    /** Pose of a rigid surface. */
    public float[] pose(int surface) {
        return poses[surface];
    }

    /** All nodes in the caller's order, mm: what overlays of springs, links and fibres are drawn between. */
    public float[] nodes() {
        return nodes;
    }

    /** Observables, in the order of {@link Observation#COLUMNS}. */
    public double[] values() {
        return values;
    }

    /** Takes over another frame of the same scene. */
    public void copyFrom(Frame other) {
        for (int i = 0; i < positions.length; i++) {
            System.arraycopy(other.positions[i], 0, positions[i], 0, positions[i].length);
            System.arraycopy(other.poses[i], 0, poses[i], 0, poses[i].length);
        }
        System.arraycopy(other.nodes, 0, nodes, 0, nodes.length);
        setState(other.serial, other.step, other.time, other.values);
    }

    /** Size of the arrays, bytes. */
    public long bytes() {
        long floats = nodes.length;
        for (int i = 0; i < positions.length; i++) {
            floats += positions[i].length + poses[i].length;
        }
        return Float.BYTES * floats + (long) Double.BYTES * values.length;
    }

    /** Whether every number that would be drawn is finite. */
    public boolean isFinite() {
        return Arrays.stream(positions).allMatch(Frame::finite) && finite(nodes);
    }

    private static boolean finite(float[] numbers) {
        float sum = 0;
        for (float number : numbers) {
            sum += 0 * number;
        }
        return sum == 0;
    }
}
