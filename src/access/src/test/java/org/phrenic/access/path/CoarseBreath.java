package org.phrenic.access.path;

import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.simulation.observe.TestFrames;

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

    /** The body at the first moment, with those of its surfaces that are wanted. */
    static MovingAnatomy with(Predicate<Surface> wanted) {
        List<Surface> kept = SURFACES.stream().filter(wanted).toList();
        Frame first = CYCLE.get(0).frame();
        double[][] places = new double[kept.size()][];
        Arrays.setAll(places, i -> place(first, kept.get(i).motion(), SURFACES.indexOf(kept.get(i))));
        MovingAnatomy body = new MovingAnatomy(kept);
        body.update(TestFrames.of(kept, first.timeS(), 0, 0, places));
        return body;
    }

    private static double[] place(Frame frame, Surface.Motion motion, int surface) {
        float[] from =
                switch (motion) {
                    case STILL -> new float[0];
                    case RIGID -> frame.pose(surface);
                    case DEFORMING -> frame.positions(surface);
                };
        double[] to = new double[from.length];
        Arrays.setAll(to, i -> from[i]);
        return to;
    }
}
