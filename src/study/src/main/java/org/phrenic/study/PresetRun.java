package org.phrenic.study;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.phrenic.anatomy.Thorax;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.organ.LiverPart;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.UnknownObservables;
import org.phrenic.study.measure.SceneObservables;

/**
 * Simulates a preset from rest and records its observables: one breath, or up to the end of its hold. What is measured
 * on a structure that the body lacks is NaN.
 */
public final class PresetRun {
    /** Sampling interval of a validation, s. */
    public static final double SAMPLE_S = 0.05;

    /** Observables of the liver's surface, which a scene without a liver that moves has too. */
    private static final List<String> OF_LIVER = List.of("liver_top_mm", "liver_edge_mm");

    private PresetRun() {}

    /**
     * Runs the simulation.
     *
     * @param sampleS sampling interval, s
     * @param wanted names of additional observables of {@link SceneObservables}
     */
    public static BreathSeries of(Scenario scenario, Thorax thorax, double sampleS, Collection<String> wanted) {
        try (Simulation simulation = Simulation.of(scenario, thorax)) {
            return of(simulation, sampleS, wanted);
        }
    }

    /** Runs a simulation that is at rest, which the caller closes. */
    public static BreathSeries of(Simulation simulation, double sampleS, Collection<String> wanted) {
        SceneSurfaces surfaces = new SceneSurfaces(simulation);
        Frame frame = surfaces.newFrame();
        SceneObservables measures =
                new SceneObservables(surfaces, simulation.scene().diaphragm().diaphragm, frame, wanted);
        List<String> columns = new ArrayList<>(Observation.COLUMNS);
        columns.addAll(measures.columns());
        List<double[]> rows = new ArrayList<>();
        List<RespiratoryPhase> labels = new ArrayList<>();
        boolean periodic =
                !Double.isInfinite(simulation.settings().breathing().pattern().periodS());
        int breath = Observation.COLUMNS.indexOf("breath");
        double endS = simulation.durationS();
        boolean over = false;
        boolean held = false;
        while (true) {
            rows.add(row(frame, measures, columns.size()));
            RespiratoryPhase label = simulation.breathLabel();
            // The closed glottis of a cough is no hold that a breath ends with.
            boolean isHold = label == RespiratoryPhase.HOLD
                    && (!periodic || simulation.settings().get(Breathing.HOLD));
            held |= isHold;
            labels.add(label == RespiratoryPhase.HOLD && !isHold ? RespiratoryPhase.EXPIRATION : label);
            if (over) {
                return new BreathSeries(columns, rows, labels).withUnknown(unknown(simulation.scene()));
            }
            long steps = Math.max(1, Math.round(sampleS / simulation.stepper().dt()));
            for (long i = 0; i < steps; i++) {
                simulation.step();
            }
            surfaces.capture(frame);
            boolean released = held && simulation.breathLabel() != RespiratoryPhase.HOLD;
            boolean whole = periodic && frame.values()[breath] > rows.get(0)[breath];
            over = released || whole || simulation.time() >= endS;
        }
    }

    /** Further observables that a scene does not have. */
    private static List<String> unknown(Scene scene) {
        List<String> unknown = new ArrayList<>();
        if (scene.liver().filter(LiverPart::isCarried).isEmpty()) {
            unknown.addAll(OF_LIVER);
        }
        if (UnknownObservables.of(scene).contains("sternum_ventral_mm")) {
            unknown.add("sternum_pitch_deg");
        }
        return unknown;
    }

    private static double[] row(Frame frame, SceneObservables measures, int length) {
        double[] row = new double[length];
        double[] seen = frame.values();
        System.arraycopy(seen, 0, row, 0, seen.length);
        double[] measured = measures.measure(frame);
        System.arraycopy(measured, 0, row, seen.length, measured.length);
        return row;
    }
}
