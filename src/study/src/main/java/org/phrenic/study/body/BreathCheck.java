package org.phrenic.study.body;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.phrenic.anatomy.Thorax;
import org.phrenic.document.ShippedFileException;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.patient.diaphragm.SheetQuality;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.Surface;

/** Simulates a quiet and a deep breath of a body, each from rest, and measures them. */
final class BreathCheck {
    /** Sampling interval, s. */
    private static final double SAMPLE_S = 0.05;

    private final String body;
    private final Simulation simulation;
    private final SceneSurfaces surfaces;
    private final SheetCrossing crossing;
    private final BodyStudy.Witness witness;

    private BreathCheck(String body, Simulation simulation, BodyStudy.Witness witness) {
        this.body = body;
        this.simulation = simulation;
        this.witness = witness;
        surfaces = new SceneSurfaces(simulation);
        crossing = new SheetCrossing(simulation.scene().diaphragm().diaphragm);
    }

    /** Checks a body; a body that cannot be made or assembled gives a refusal. */
    static BodyResult of(BodyCase body, Scenario scenario, BodyStudy.Witness witness) {
        List<BreathResult> breaths = new ArrayList<>();
        Optional<SheetQuality> sheet = Optional.empty();
        Optional<RibComparison> ribs = Optional.empty();
        List<SurfaceMiss> misses = List.of();
        String notInScan = "";
        try {
            Thorax thorax = body.thorax().get();
            notInScan = thorax.notInScanSummary();
            sheet = SheetQuality.of(thorax);
            ribs = body.original().flatMap(original -> RibComparison.of(original.get(), thorax));
            misses = body.original()
                    .map(original -> SurfaceMiss.of(original.get(), thorax))
                    .orElse(misses);
            Scenario quiet = scenario.with("preset=" + BreathDepth.QUIET.preset());
            try (Simulation simulation = Simulation.of(quiet, thorax)) {
                BreathCheck check = new BreathCheck(body.name(), simulation, witness);
                for (BreathDepth depth : BreathDepth.values()) {
                    simulation.change(Assignment.read("breath", "preset", depth.preset()));
                    if (!simulation.restart()) {
                        throw new IllegalStateException("the breath cannot start again from rest");
                    }
                    breaths.add(check.breathe(depth));
                }
            }
            return new BodyResult(body, notInScan, "", sheet, ribs, misses, breaths);
        } catch (ShippedFileException e) {
            throw e;
        } catch (RuntimeException e) {
            // Whatever a body brings about is a result of the check, and the other bodies are checked all the same.
            String why = e.getMessage() == null ? e.toString() : e.getMessage();
            return new BodyResult(body, notInScan, why, sheet, ribs, misses, breaths);
        }
    }

    /** One breath from rest. */
    private BreathResult breathe(BreathDepth depth) {
        Frame lowest = surfaces.newFrame();
        double[] rest = lowest.values().clone();
        List<TriangleMesh> atRest = meshes(surfaces.surfaces(), lowest);
        OrganCrossing restCrossing = crossing.measure(surfaces.surfaces(), atRest);
        if (depth == BreathDepth.QUIET) {
            witness.seen(body, "rest", surfaces.surfaces(), atRest);
        }
        double[] end;
        try {
            end = breathe(simulation, surfaces, now -> {
                if (domes(now) < domes(lowest.values())) {
                    surfaces.write(lowest);
                }
                return true;
            });
        } catch (DivergenceException e) {
            return BreathResult.failed(depth, e.getMessage(), restCrossing);
        }
        List<TriangleMesh> inspired = meshes(surfaces.surfaces(), lowest);
        witness.seen(body, depth.preset(), surfaces.surfaces(), inspired);
        return new BreathResult(
                depth,
                "",
                new BreathResult.Motion(
                        value("dome_right_mm", rest) - value("dome_right_mm", lowest.values()),
                        value("dome_left_mm", rest) - value("dome_left_mm", lowest.values()),
                        value("lung_volume_change_ml", lowest.values()) - value("lung_volume_change_ml", rest),
                        value("from_rest_rms_mm", end)),
                restCrossing,
                Optional.of(crossing.measure(surfaces.surfaces(), inspired)));
    }

    /**
     * Simulates a period of the breath, or as much of it as is asked for.
     *
     * @param seen receives the observables of each sample, of which {@code surfaces} then writes a frame; the breath
     *     goes on while it returns true
     * @return observables of the last sample
     */
    static double[] breathe(Simulation simulation, SceneSurfaces surfaces, Predicate<double[]> seen) {
        double end = simulation.breathPeriodS();
        long chunk = Math.max(1, Math.round(SAMPLE_S / simulation.stepper().dt()));
        double[] now = surfaces.observe();
        boolean asked = true;
        while (asked && simulation.time() < end - 0.5 * simulation.stepper().dt()) {
            for (long i = 0; i < chunk; i++) {
                simulation.step();
            }
            now = surfaces.observe();
            surfaces.read(now);
            asked = seen.test(now);
        }
        return now;
    }

    /** The surfaces of a scene in a frame of it. */
    static List<TriangleMesh> meshes(List<Surface> surfaces, Frame frame) {
        List<TriangleMesh> meshes = new ArrayList<>();
        for (int i = 0; i < surfaces.size(); i++) {
            Surface surface = surfaces.get(i);
            double[] p = new double[surface.rest().positions().length];
            frame.writePositions(surface, i, p);
            meshes.add(surface.rest().withPositions(p));
        }
        return meshes;
    }

    /** Sum of the heights of the domes, mm. */
    static double domes(double[] values) {
        return value("dome_right_mm", values) + value("dome_left_mm", values);
    }

    private static double value(String column, double[] values) {
        return values[Observation.COLUMNS.indexOf(column)];
    }
}
