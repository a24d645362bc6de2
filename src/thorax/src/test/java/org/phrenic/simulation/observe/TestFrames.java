package org.phrenic.simulation.observe;

import java.util.List;

/** Frames of scenes that no simulation made: where every surface is, is said by the test. */
public final class TestFrames {
    private static final Object SCENE = new Object();

    private TestFrames() {}

    /**
     * A frame.
     *
     * @param places for each surface its vertices, or its pose, or nothing where it stands still
     */
    public static Frame of(List<Surface> surfaces, double timeS, double breath, double phase, double[]... places) {
        int n = surfaces.size();
        int[] lengths = new int[n];
        boolean[] rigid = new boolean[n];
        for (int i = 0; i < n; i++) {
            lengths[i] = surfaces.get(i).motion() == Surface.Motion.DEFORMING ? places[i].length : 0;
            rigid[i] = surfaces.get(i).motion() == Surface.Motion.RIGID;
        }
        Frame frame = new Frame(SCENE, lengths, rigid, 0);
        for (int i = 0; i < n; i++) {
            float[] to = rigid[i] ? frame.pose(i) : frame.positions(i);
            for (int k = 0; k < to.length; k++) {
                to[k] = (float) places[i][k];
            }
        }
        double[] values = new double[Observation.COLUMNS.size()];
        values[Observation.COLUMNS.indexOf("breath")] = breath;
        values[Observation.COLUMNS.indexOf("phase")] = phase;
        frame.setState(1, Math.round(1000 * timeS), timeS, values);
        return frame;
    }
}
