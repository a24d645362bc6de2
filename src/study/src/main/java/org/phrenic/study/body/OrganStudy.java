package org.phrenic.study.body;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.BreathMoment;
import org.phrenic.anatomy.Thorax;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;

/** The organs of bodies at rest and at the full inspirations of a quiet and of a deep breath. */
public final class OrganStudy {
    /** Moments of a breath of which the one with the lowest domes is full inspiration. */
    private static final int PHASES = 60;

    private OrganStudy() {}

    /**
     * Simulates the breaths of each body and measures its organs.
     *
     * @param bodies values of {@code anatomy}
     */
    public static OrganReport of(Scenario scenario, List<String> bodies, SimulationRun.Progress progress) {
        List<OrganMoment> moments = new ArrayList<>();
        for (String body : bodies) {
            Scenario on = scenario.with(
                    List.of(Assignment.read(body, "anatomy", body), Assignment.read("breath", "preset", quiet())));
            moments.addAll(of(body, on));
            progress.note(body + " is measured.");
        }
        return new OrganReport(scenario, moments);
    }

    private static String quiet() {
        return BreathDepth.QUIET.preset();
    }

    private static List<OrganMoment> of(String body, Scenario scenario) {
        Thorax thorax = SimulationRun.loadThorax(scenario);
        List<OrganMoment> moments = new ArrayList<>();
        try (Simulation simulation = Simulation.of(scenario, thorax)) {
            SceneSurfaces surfaces = SceneSurfaces.withOrgans(simulation);
            moments.add(OrganMoment.of(body, OrganMoment.REST, surfaces.surfaces(), surfaces.meshes()));
            for (BreathDepth depth : BreathDepth.values()) {
                simulation.change(Assignment.read("breath", "preset", depth.preset()));
                if (!simulation.restart()) {
                    throw new IllegalStateException("the breath cannot start again from rest");
                }
                Frame inspired = BreathCycle.record(simulation, surfaces, PHASES).stream()
                        .map(BreathMoment::frame)
                        .min(Comparator.comparingDouble(frame -> BreathCheck.domes(frame.values())))
                        .orElseThrow();
                moments.add(OrganMoment.of(
                        body, depth.preset(), surfaces.surfaces(), BreathCheck.meshes(surfaces.surfaces(), inspired)));
            }
        }
        return moments;
    }
}
