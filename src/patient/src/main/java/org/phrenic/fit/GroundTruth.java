package org.phrenic.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.Decimator;
import org.phrenic.mesh.query.SurfaceComparison;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.Surface;

/**
 * The known second breath level of a synthetic patient, as it would appear in a scan. It is simulated with a model that
 * differs from the fitted one: another mesh, a central tendon above a plane, two rigid links per node, a kinematic
 * sternum, and a breath of normal duration. The surfaces are decimated to half their vertices and displaced along their
 * normals by noise.
 *
 * @param targets the visible parts
 * @param domeRightMm displacement of the right dome from end-expiration, mm
 * @param domeLeftMm displacement of the left dome from end-expiration, mm
 * @param floorMm mean symmetric distance between the targets and the exact surfaces, mm; a fit is not expected to get
 *     below it
 */
public record GroundTruth(List<FitTarget> targets, double domeRightMm, double domeLeftMm, double floorMm) {
    private static final double STEP_S = 1e-3;
    private static final long STOP_STEP = 2150;
    private static final long STEPS = 3200;

    /**
     * Simulates the breath. Both lungs are visible.
     *
     * @param resolution resolution of the ground truth
     * @param noiseMm standard deviation of the noise, mm
     * @param seed random seed of the noise
     */
    public static GroundTruth of(SyntheticPatient patient, Resolution resolution, double noiseMm, long seed) {
        List<FitPart> lungs = List.of(FitPart.LUNG_RIGHT, FitPart.LUNG_LEFT);
        return of(patient, patient.settings(resolution), lungs, noiseMm, seed);
    }

    /** Like {@link #of(SyntheticPatient, Resolution, double, long)}, with a choice of mesh and visible parts. */
    public static GroundTruth of(
            SyntheticPatient patient, List<String> settings, List<FitPart> parts, double noiseMm, long seed) {
        return of(patient.body(settings), settings, patient.hidden(), parts, noiseMm, seed);
    }

    /**
     * Simulates a breath of any body.
     *
     * @param of settings of a scenario that name body and resolution
     * @param hidden settings of the breath
     * @throws org.phrenic.engine.integrator.DivergenceException if the body does not bear that breath
     */
    public static GroundTruth of(
            Thorax body, List<String> of, List<String> hidden, List<FitPart> parts, double noiseMm, long seed) {
        List<String> settings = new ArrayList<>(List.of(
                "preset=deep",
                "time_step_s=" + STEP_S,
                "rate_per_min=12",
                "inspiratory_fraction=0.45",
                "tendon=plane",
                "links_per_node=2",
                "sternum=kinematic",
                "threads=1"));
        settings.addAll(of);
        settings.addAll(hidden);
        Scenario scenario = Scenario.defaults()
                .with(settings.toArray(String[]::new))
                .withChanges(List.of(ScheduledChange.parse(STOP_STEP + ":hold=true")));
        try (Simulation simulation = Simulation.of(scenario, body)) {
            SceneSurfaces surfaces = new SceneSurfaces(simulation);
            while (simulation.steps() < STEPS) {
                simulation.step();
            }
            return seen(surfaces, parts, noiseMm, new Random(seed));
        }
    }

    private static GroundTruth seen(SceneSurfaces surfaces, List<FitPart> parts, double noiseMm, Random random) {
        List<FitTarget> targets = new ArrayList<>();
        double floor = 0;
        for (FitPart part : parts) {
            List<Surface> all = surfaces.surfaces();
            for (int i = 0; i < all.size(); i++) {
                if (part.matches(all.get(i))) {
                    TriangleMesh exact = surfaces.mesh(i);
                    TriangleMesh seen =
                            noisy(Decimator.toVertexCount(exact, exact.vertexCount() / 2, noiseMm), noiseMm, random);
                    targets.add(FitTarget.of(part, seen));
                    floor += SurfaceComparison.of(exact, seen).byArea().mean() / parts.size();
                }
            }
        }
        double[] observed = surfaces.observe();
        return new GroundTruth(
                targets,
                observed[Observation.COLUMNS.indexOf("dome_right_mm")],
                observed[Observation.COLUMNS.indexOf("dome_left_mm")],
                floor);
    }

    private static TriangleMesh noisy(TriangleMesh mesh, double noiseMm, Random random) {
        double[] p = mesh.positions().clone();
        double[] normals = MeshMeasure.vertexNormals(mesh);
        for (int i = 0; i < p.length; i += 3) {
            double by = noiseMm * random.nextGaussian();
            for (int axis = 0; axis < 3; axis++) {
                p[i + axis] += by * normals[i + axis];
            }
        }
        return mesh.withPositions(p);
    }
}
