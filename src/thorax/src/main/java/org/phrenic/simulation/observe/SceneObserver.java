package org.phrenic.simulation.observe;

import java.util.Arrays;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.breathing.BreathState;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.organ.LiverPart;

/** Computes the observables of a scene, along the axes of the body's frame. */
public final class SceneObserver {
    /**
     * Positions in the plan view of the sheet ({@link SheetPatch}). The dome is measured at its posterior third, as in
     * M-mode ultrasound.
     */
    private static final double[][] PLACES = {
        {-0.5, 0.33},
        {0.5, 0.33},
        {0, -0.2},
        {-0.45, -0.45},
        {-0.45, 0.1},
        {-0.45, 0.5},
        {0.45, -0.45},
        {0.45, 0.1},
        {0.45, 0.5},
        {-0.65, 0.1},
        {-0.2, 0.1},
        {0.65, 0.1},
        {0.2, 0.1},
    };

    private final Scene scene;
    private final SheetPatch[] patches = new SheetPatch[PLACES.length];
    private final FibreShortening fibres;
    private final CageMeasure cage;
    private final LungMeasure lungs;
    /** Columns of what the scene lacks. */
    private final int[] unknown;

    private final double[] now;
    private final double[] liver = new double[3];
    private double[] sternum;
    private double transverseChange;
    private double lungVolumeChange;
    private double shortening;
    private double rmsFromRest;

    public SceneObserver(Scene scene) {
        this.scene = scene;
        Arrays.setAll(patches, i -> new SheetPatch(scene.diaphragm(), PLACES[i][0], PLACES[i][1]));
        fibres = new FibreShortening(scene.diaphragm(), scene.restPositions());
        scene.pose().update(0);
        cage = new CageMeasure(scene.thorax(), scene.pose());
        lungs = new LungMeasure(scene);
        unknown = UnknownObservables.of(scene).stream()
                .mapToInt(Observation.COLUMNS::indexOf)
                .toArray();
        now = new double[scene.restPositions().length];
    }

    public LungMeasure lungs() {
        return lungs;
    }

    /**
     * Observables of the current state; NaN for those of structures that the scene lacks.
     *
     * @param time of the state, s
     */
    public Observation observe(double time) {
        double[] rest = scene.restPositions();
        scene.system().layout().toCaller(scene.system().positions(), now);
        scene.pose().update(time);
        lungs.update(time, rest, now);
        BreathState breath = scene.drive().breathAt(time);
        // Two tasks of similar cost: the liver, and everything else.
        scene.system().workers().run(2, this::measureGroup);
        double[] row = new double[Observation.COLUMNS.size()];
        int c = 0;
        row[c++] = time;
        row[c++] = breath.breath;
        row[c++] = breath.phase;
        row[c++] = breath.activation;
        row[c++] = scene.drive().pressureAt(time);
        row[c++] = scene.pose().amplitude();
        for (SheetPatch patch : patches) {
            row[c++] = patch.displacement(rest, now, 2);
        }
        row[c++] = shortening;
        row[c++] = lungVolumeChange;
        row[c++] = -sternum[1];
        row[c++] = transverseChange;
        row[c++] = sternum[2];
        row[c++] = -sternum[1];
        row[c++] = liver[2];
        row[c++] = liver[1];
        row[c++] = liver[0];
        row[c++] = rmsFromRest;
        row[c] = scene.activeLinks().map(l -> l.error(scene.system())).orElse(0.0);
        for (int column : unknown) {
            row[column] = Double.NaN;
        }
        return new Observation(row);
    }

    /** Computes one of the two groups of observables that run in parallel. */
    private void measureGroup(int which) {
        double[] rest = scene.restPositions();
        if (which == 0) {
            scene.liver().ifPresent(part -> measureLiver(part, rest));
        } else {
            shortening = fibres.shorteningPercent(now);
            rmsFromRest = rms(rest);
            lungVolumeChange = lungs.volumeChange();
            sternum = cage.sternumMotion();
            transverseChange = cage.transverseChange();
        }
    }

    /** Mean displacement of the liver's surface: left, posterior, superior, mm. */
    private void measureLiver(LiverPart part, double[] rest) {
        double[] start = part.structure.mesh().positions();
        double[] moved = part.positions(rest, now);
        double[] mean = new double[3];
        for (int i = 0; i < start.length; i++) {
            mean[i % 3] += 3 * (moved[i] - start[i]) / start.length;
        }
        double[] axes = scene.diaphragm().diaphragm.frame().axes();
        for (int axis = 0; axis < 3; axis++) {
            liver[axis] = MedianFrame.along(axes, axis, mean[0], mean[1], mean[2]);
        }
    }

    private double rms(double[] rest) {
        double sum = 0;
        for (int i = 0; i < rest.length; i++) {
            sum += (now[i] - rest[i]) * (now[i] - rest[i]);
        }
        return Math.sqrt(3 * sum / rest.length);
    }
}
