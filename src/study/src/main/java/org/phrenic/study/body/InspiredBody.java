package org.phrenic.study.body;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * A body at shares of its inspiration, all from one deep breath, which is simulated when the first of them is asked
 * for. Structures of which the scene has no surface are left out. Thread-safe.
 */
final class InspiredBody {
    /** A breath takes both domes together down by more than this, mm. */
    private static final double DESCENT_MM = 10;

    private final Supplier<Thorax> body;
    private final MeshBudget budget;
    private final Set<Double> shares;
    private final Map<Double, Thorax> known = new HashMap<>();

    /**
     * @param body loads the body at end-expiration
     * @param budget number of vertices with which it breathes
     * @param shares shares of the descent of the domes to full inspiration that may be asked for, more than 0 to 1
     */
    InspiredBody(Supplier<Thorax> body, MeshBudget budget, Set<Double> shares) {
        this.body = body;
        this.budget = budget;
        this.shares = Set.copyOf(shares);
    }

    /** The body when its domes have gone down by one of the shares of their descent. */
    synchronized Thorax at(double share) {
        if (known.isEmpty()) {
            known.putAll(breathe());
        }
        return Optional.ofNullable(known.get(share))
                .orElseThrow(
                        () -> new IllegalArgumentException("found share " + share + ", expected one of " + shares));
    }

    private Map<Double, Thorax> breathe() {
        Thorax resting = body.get();
        Scenario deep =
                Scenario.defaults().with("mesh_vertices=" + budget.vertices(), "preset=" + BreathDepth.DEEP.preset());
        try (Simulation simulation = Simulation.of(deep, resting)) {
            SceneSurfaces surfaces = SceneSurfaces.withOrgans(simulation);
            List<Frame> descent = descent(simulation, surfaces);
            return shares.stream()
                    .collect(Collectors.toMap(share -> share, share -> body(resting, surfaces, at(share, descent))));
        }
    }

    private static Thorax body(Thorax resting, SceneSurfaces surfaces, Frame frame) {
        List<TriangleMesh> meshes = BreathCheck.meshes(surfaces.surfaces(), frame);
        Map<String, TriangleMesh> moved = new HashMap<>();
        List<Surface> all = surfaces.surfaces();
        for (int i = 0; i < all.size(); i++) {
            moved.put(all.get(i).name(), meshes.get(i));
        }
        List<Structure> structures = resting.structuresAndOrgans().stream()
                .filter(s -> moved.containsKey(s.name()))
                .map(s -> s.withMesh(moved.get(s.name())))
                .toList();
        return new Thorax(resting.name(), structures, resting.notes());
    }

    /** The frame at rest and those in which the domes stand lower than ever before. */
    private static List<Frame> descent(Simulation simulation, SceneSurfaces surfaces) {
        Frame now = surfaces.newFrame();
        List<Frame> frames = new ArrayList<>(List.of(now.copy()));
        BreathCheck.breathe(simulation, surfaces, values -> {
            if (BreathCheck.domes(values) < lowest(frames)) {
                surfaces.write(now);
                frames.add(now.copy());
            }
            return !haveRisen(values, frames);
        });
        return frames;
    }

    /** Whether the domes, after a descent, stand less than half as low as they stood. */
    private static boolean haveRisen(double[] values, List<Frame> descent) {
        double rest = BreathCheck.domes(descent.get(0).values());
        double lowest = lowest(descent);
        return rest - lowest > DESCENT_MM && BreathCheck.domes(values) > 0.5 * (rest + lowest);
    }

    /** The first frame in which the domes stand that low. */
    private static Frame at(double share, List<Frame> descent) {
        double rest = BreathCheck.domes(descent.get(0).values());
        double wanted = rest + share * (lowest(descent) - rest);
        return descent.stream()
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
