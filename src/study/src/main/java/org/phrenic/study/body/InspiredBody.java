package org.phrenic.study.body;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** A body at inspiration, from its own deep breath at low resolution. */
final class InspiredBody {
    private InspiredBody() {}

    /**
     * The body when its domes have gone down by a share of their descent to full inspiration. Structures of which the
     * scene has no surface are left out.
     *
     * @param share of the descent, more than 0 to 1
     */
    static Thorax of(Thorax body, double share) {
        try (Simulation simulation = Simulation.of(
                Scenario.defaults().with("resolution=low", "preset=" + BreathDepth.DEEP.preset()), body)) {
            SceneSurfaces surfaces = new SceneSurfaces(simulation);
            Frame frame = at(share, simulation, surfaces);
            List<TriangleMesh> meshes = BreathCheck.meshes(surfaces.surfaces(), frame);
            Map<String, TriangleMesh> moved = new HashMap<>();
            List<Surface> all = surfaces.surfaces();
            for (int i = 0; i < all.size(); i++) {
                moved.put(all.get(i).name(), meshes.get(i));
            }
            List<Structure> structures = body.structures().stream()
                    .filter(s -> moved.containsKey(s.name()))
                    .map(s -> s.withMesh(moved.get(s.name())))
                    .toList();
            return new Thorax(body.name(), structures, body.notes());
        }
    }

    /** The first frame in which the domes stand that low. */
    private static Frame at(double share, Simulation simulation, SceneSurfaces surfaces) {
        Frame now = surfaces.newFrame();
        double rest = BreathCheck.domes(now.values());
        List<Frame> frames = new ArrayList<>(List.of(now.copy()));
        BreathCheck.breathe(simulation, surfaces, now, () -> {
            if (BreathCheck.domes(now.values()) < lowest(frames)) {
                frames.add(now.copy());
            }
        });
        double wanted = rest + share * (lowest(frames) - rest);
        return frames.stream()
                .skip(1)
                .filter(frame -> BreathCheck.domes(frame.values()) <= wanted)
                .findFirst()
                .orElseThrow(() -> new IllegalStateException("the domes do not descend in a deep breath"));
    }

    /** Height of the domes in the last of frames that stand ever lower, mm. */
    private static double lowest(List<Frame> frames) {
        return BreathCheck.domes(frames.get(frames.size() - 1).values());
    }
}
