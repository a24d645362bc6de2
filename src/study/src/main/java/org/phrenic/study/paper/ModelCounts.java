package org.phrenic.study.paper;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.study.PaperScenarios;

/**
 * Size of a model and attachments of its diaphragm.
 *
 * @param vertices number of vertices moved by springs
 * @param springs number of springs
 * @param diaphragmVertices number of vertices of the closed sheet
 * @param diaphragmTriangles number of triangles of the closed sheet
 * @param eulerCharacteristic Euler characteristic of the sheet: vertices - edges + triangles
 * @param tendonVertices number of tendon vertices of the sheet
 * @param rigidLinks number of rigid links across the tendon
 * @param attachedByPlace number of sheet vertices attached to bone, by the nearest part of the skeleton
 * @param rk2LimitS largest stable step of midpoint Runge-Kutta, s; without sternum and cartilages, where these step
 *     apart
 * @param rk2SternumLimitS that of sternum and cartilages, s
 * @param rk2Substeps number of midpoint Runge-Kutta substeps needed for the paper's time step
 * @param rk2SternumSubsteps that of sternum and cartilages
 */
public record ModelCounts(
        int vertices,
        int springs,
        int diaphragmVertices,
        int diaphragmTriangles,
        int eulerCharacteristic,
        int tendonVertices,
        int rigidLinks,
        Map<String, Integer> attachedByPlace,
        double rk2LimitS,
        double rk2SternumLimitS,
        int rk2Substeps,
        int rk2SternumSubsteps) {
    private static final int FIRST_FLOATING = 11;
    private static final int FIRST_OF_MARGIN = 7;

    /** The four attachment sites named in the paper, then all others. */
    static final List<String> PLACES = List.of(
            "sternum (xiphoid)",
            "costal margin (ribs and cartilages 7 to 10)",
            "ribs 11 and 12",
            "vertebrae",
            "higher ribs and cartilages");

    static ModelCounts of(Scenario scenario, Thorax thorax) {
        try (Simulation simulation = Simulation.of(scenario, thorax)) {
            SceneSurfaces scene = new SceneSurfaces(simulation);
            Surface sheet = scene.surfaces().stream()
                    .filter(s -> s.kind() == StructureKind.DIAPHRAGM)
                    .findFirst()
                    .orElseThrow();
            StabilityLimit limit = simulation.stepper().limit();
            StabilityLimit ofSternum = limit.apart().orElse(limit);
            int substeps = limit.substeps(IntegratorKind.RK2, PaperScenarios.STEP_S, Stepper.SAFETY);
            double substepS = PaperScenarios.STEP_S / substeps;
            int tendon = (int) IntStream.range(0, sheet.tendon().length)
                    .filter(i -> sheet.tendon()[i])
                    .count();
            return new ModelCounts(
                    simulation.system().nodeCount(),
                    simulation.scene().springCount(),
                    sheet.rest().vertexCount(),
                    sheet.rest().triangleCount(),
                    new MeshTopology(sheet.rest()).eulerCharacteristic(),
                    tendon,
                    overlay(scene, Overlay.Kind.RIGID_LINKS)
                            .map(o -> o.nodePairs().length / 2)
                            .orElse(0),
                    attachedByPlace(scene, sheet),
                    limit.largestStep(IntegratorKind.RK2),
                    ofSternum.largestStep(IntegratorKind.RK2),
                    substeps,
                    substeps * limit.stepsApart(IntegratorKind.RK2, substepS, Stepper.SAFETY));
        }
    }

    private static Optional<Overlay> overlay(SceneSurfaces scene, Overlay.Kind kind) {
        return scene.overlays().stream().filter(o -> o.kind() == kind).findFirst();
    }

    private static Map<String, Integer> attachedByPlace(SceneSurfaces scene, Surface sheet) {
        List<Surface> bones =
                scene.surfaces().stream().filter(s -> place(s) != null).toList();
        List<TriangleTree> trees = new ArrayList<>();
        bones.forEach(bone -> trees.add(new TriangleTree(bone.rest())));
        Map<String, Integer> count = new LinkedHashMap<>();
        PLACES.forEach(place -> count.put(place, 0));
        TriangleTree.Hit hit = new TriangleTree.Hit();
        // The sheet's nodes come first; each point of the overlay repeats its node twice.
        int[] nodes =
                overlay(scene, Overlay.Kind.ATTACHMENTS).map(Overlay::nodePairs).orElse(new int[0]);
        for (int node : Arrays.stream(nodes)
                .distinct()
                .filter(n -> n < sheet.rest().vertexCount())
                .toArray()) {
            TriangleMesh rest = sheet.rest();
            double distance = Double.POSITIVE_INFINITY;
            int nearest = 0;
            for (int b = 0; b < trees.size(); b++) {
                if (trees.get(b).closest(rest.x(node), rest.y(node), rest.z(node), distance, hit)) {
                    distance = Math.sqrt(hit.distanceSquared);
                    nearest = b;
                }
            }
            count.merge(place(bones.get(nearest)), 1, Integer::sum);
        }
        return count;
    }

    private static String place(Surface s) {
        return switch (s.kind()) {
            case STERNUM -> PLACES.get(0);
            case RIB, COSTAL_CARTILAGE ->
                PLACES.get(s.level() >= FIRST_FLOATING ? 2 : s.level() >= FIRST_OF_MARGIN ? 1 : 4);
            case VERTEBRA, DISC -> PLACES.get(3);
            default -> null;
        };
    }

    /** Number of attached vertices of the sheet. */
    int attachedCount() {
        return attachedByPlace.values().stream().mapToInt(Integer::intValue).sum();
    }
}
