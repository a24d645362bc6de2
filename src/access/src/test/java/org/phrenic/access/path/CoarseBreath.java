package org.phrenic.access.path;

import java.util.List;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.BreathMoment;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Surface;

/** A deep breath of the coarse virtual adult male that is taken fast, simulated once for the tests of access maps. */
final class CoarseBreath {
    /** Evenly spaced moments that are recorded. */
    static final int MOMENTS = 10;

    /** The surfaces of the body. */
    static final List<Surface> SURFACES;

    /** The body at each moment. */
    static final List<BreathMoment> CYCLE;

    static {
        Scenario deep = Scenario.defaults()
                .with("preset=deep", "rate_per_min=20", "mesh_vertices=5000", "lungs=embedded", "sternum=kinematic");
        try (Simulation simulation = Simulation.of(deep, VirtualThorax.ofPreset("adult-male", new MeshBudget(5000)))) {
            SceneSurfaces surfaces = SceneSurfaces.withOrgans(simulation);
            CYCLE = BreathCycle.record(simulation, surfaces, MOMENTS);
            SURFACES = surfaces.surfaces();
        }
    }

    private CoarseBreath() {}
}
