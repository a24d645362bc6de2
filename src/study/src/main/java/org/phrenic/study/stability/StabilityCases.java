package org.phrenic.study.stability;

import static org.phrenic.study.stability.StabilityMeasure.KINETIC_FACTOR;
import static org.phrenic.study.stability.StabilityMeasure.REACH_MM;
import static org.phrenic.study.stability.StabilityMeasure.SHAPE;
import static org.phrenic.study.stability.StabilityMeasure.SPEED_MM_S;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Resolution;

/**
 * The stability cases: synthetic domes that test the engine alone, and thoraxes ({@link ThoraxCases}) that test the
 * whole program.
 */
final class StabilityCases {
    private static final double DOME_REFERENCE_S = 40;
    /** Vertices of a thorax of the short version, a third of those at low resolution. */
    private static final MeshBudget QUICK_BUDGET = new MeshBudget(4000);

    static final double UNBOUNDED = Double.POSITIVE_INFINITY;

    static final StabilityBounds NEAR_REFERENCE =
            StabilityBounds.BODY.with(KINETIC_FACTOR, 2).with(SHAPE, 0.1);
    static final StabilityBounds FAST = NEAR_REFERENCE.with(SPEED_MM_S, 10_000);
    static final StabilityBounds JUMPING = NEAR_REFERENCE.with(SHAPE, 0.25);

    private final DomeMesh mesh;
    private final int rings;
    private final List<StabilityCase> cases = new ArrayList<>();

    private StabilityCases(int rings) {
        this.rings = rings;
        mesh = DomeMesh.regular(rings);
    }

    /**
     * @param quick whether to use the short version: coarser domes and thoraxes
     * @param scan folder of a scanned body; without it the cases of that body are left out
     */
    static List<StabilityCase> all(boolean quick, Optional<String> scan) {
        StabilityCases domes = new StabilityCases(quick ? 5 : 10);
        domes.addDomes();
        List<StabilityCase> all = new ArrayList<>(domes.cases);
        all.addAll(new ThoraxCases(quick ? QUICK_BUDGET : Resolution.MEDIUM.budget(), scan).all());
        return List.copyOf(all);
    }

    private void addDomes() {
        StabilityBounds near = NEAR_REFERENCE;
        dome("published", "the paper's parameters", 200, 8, near, d -> {});
        dome("stiffness-100", "springs 100 times as stiff", 20, 4, near, d -> d.stiffness *= 100);
        dome("stiffness-10000", "springs 10,000 times as stiff", 20, 4, near, d -> d.stiffness *= 10_000);
        dome("dt-2", "time step twice as long", 40, 8, near, d -> d.dtS *= 2);
        dome("dt-5", "time step 5 times as long", 40, 8, near, d -> d.dtS *= 5);
        dome("dt-20", "time step 20 times as long", 40, 8, near, d -> d.dtS *= 20);
        StabilityBounds lively = StabilityBounds.BODY.with(KINETIC_FACTOR, 4);
        dome("damping-0", "no damping", 200, 8, lively, d -> d.viscosity = 0);
        dome("damping-1000", "damping 1,000 times as strong", 40, 4, near, d -> d.viscosity *= 1000);
        dome("mass-ratio", "masses that differ by a factor of a million", 20, 4, FAST, d -> d.massRatio = 1e6);
        dome("valence", "nodes of valence 3 to 24", 40, 4, near, new DomeParameters(DomeMesh.uneven(rings, 24)));
        DomeParameters slivers = new DomeParameters(DomeMesh.slivers(rings, false));
        dome("slivers", "slivers and triangles without area", 40, 4, near, slivers);
        DomeParameters coincident = new DomeParameters(DomeMesh.slivers(rings, true));
        dome("coincident", "triangles that have an edge without length", 40, 4, near, coincident);
        DomeParameters inverted = new DomeParameters(DomeMesh.inverted(rings));
        dome("inverted", "every seventh triangle turned over", 40, 4, near, inverted);
        DomeParameters apart = new DomeParameters(DomeMesh.disconnected(rings));
        dome("disconnected", "a sheet of two pieces", 40, 4, near, apart);
        DomeParameters fins = new DomeParameters(DomeMesh.nonManifold(rings));
        dome("non-manifold", "edges of four triangles", 40, 4, near, fins);
        String contradiction = "three rigid links a pair that contradict each other";
        dome("links-conflict", contradiction, 20, 2, near.ofImpossible(), d -> d.conflictingLinks = true);
        String jump = "the rim thrown through its whole range in one step, and back";
        dome("rim-thrown", jump, 40, 8, JUMPING, d -> d.rimJumps = true);
        StabilityBounds far = FAST.with(REACH_MM, UNBOUNDED);
        dome("force-50", "muscle force 50 times as strong", 40, 8, far, d -> d.force = 50);
        // Reference solutions at 1/8, 1/16 and 1/32 of the step agree to 0.001 mm for 10 s and differ by 3 mm 10 s
        // later. The buckling of a slack sheet is sensitive to errors smaller than any step resolves.
        String slack = "a sheet that nothing pulls and nothing brings back";
        dome("limp", slack, 60, 4, near.withShapeUntil(10), d -> {
            d.force = 0;
            d.homeSprings = false;
        });
    }

    private void dome(
            String key,
            String title,
            double durationS,
            double quickS,
            StabilityBounds bounds,
            Consumer<DomeParameters> change) {
        DomeParameters parameters = new DomeParameters(mesh);
        change.accept(parameters);
        dome(key, title, durationS, quickS, bounds, parameters);
    }

    private void dome(
            String key,
            String title,
            double durationS,
            double quickS,
            StabilityBounds bounds,
            DomeParameters parameters) {
        StabilityCase.Factory factory =
                (integrator, refinement, duration) -> new DomeScene(parameters, integrator, refinement);
        cases.add(new StabilityCase(
                key, title, bounds, factory, durationS, quickS, DomeDrive.PERIOD_S, DOME_REFERENCE_S));
    }
}
