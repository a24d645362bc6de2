package org.phrenic.study.stability;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;
import org.phrenic.anatomy.Thorax;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

/** The hard cases: domes for the engine alone, thoraxes for the whole program. */
final class StabilityCases {
    /** Everything of the whole thorax that is not the diaphragm moves little and costs half of the time. */
    private static final String[] DIAPHRAGM = {"resolution=low", "lungs=off", "sternum=off", "liver=false", "threads=1"
    };

    private static final double BREATH_S = 4;
    /** The time step of a thorax is already half of its limit: its trusted run is refined by half as much. */
    private static final double THORAX_REFINEMENT_DIVISOR = 2;

    private static final double DOME_REFERENCE_S = 40;
    private static final double THORAX_REFERENCE_S = 8;
    private static final double UNBOUNDED = Double.POSITIVE_INFINITY;

    private final DomeMesh mesh;
    private final int rings;
    private Thorax thorax;
    private final List<StabilityCase> cases = new ArrayList<>();

    private StabilityCases(int rings) {
        this.rings = rings;
        mesh = DomeMesh.regular(rings);
    }

    /**
     * All cases.
     *
     * @param quick for the short version, on coarser domes
     */
    static List<StabilityCase> all(boolean quick) {
        StabilityCases made = new StabilityCases(quick ? 5 : 10);
        made.domes();
        made.thoraxes();
        return List.copyOf(made.cases);
    }

    private void domes() {
        DomeParameters published = DomeParameters.published(mesh);
        StabilityBounds close = StabilityBounds.body().kinetic(2).shape(0.1);
        dome("published", "the paper's parameters", published, close, 200, 8);
        dome("stiffness-100", "springs 100 times as stiff", published.stiffer(100), close, 20, 4);
        dome("stiffness-10000", "springs 10,000 times as stiff", published.stiffer(10_000), close, 20, 4);
        dome("dt-2", "time step twice as long", published.slower(2), close, 40, 8);
        dome("dt-5", "time step 5 times as long", published.slower(5), close, 40, 8);
        dome("dt-20", "time step 20 times as long", published.slower(20), close, 40, 8);
        dome(
                "damping-0",
                "no damping",
                published.damped(0),
                StabilityBounds.body().kinetic(4),
                200,
                8);
        dome("damping-1000", "damping 1,000 times as strong", published.damped(1000), close, 40, 4);
        dome(
                "mass-ratio",
                "masses that differ by a factor of a million",
                published.uneven(1e6),
                close.speed(10_000),
                20,
                4);
        dome("valence", "nodes of valence 3 to 24", DomeParameters.published(DomeMesh.uneven(rings, 24)), close, 40, 4);
        dome(
                "slivers",
                "slivers and triangles without area",
                DomeParameters.published(DomeMesh.slivers(rings, false)),
                close,
                40,
                4);
        dome(
                "coincident",
                "triangles that have an edge without length",
                DomeParameters.published(DomeMesh.slivers(rings, true)),
                close,
                40,
                4);
        dome(
                "links-conflict",
                "three rigid links a pair that contradict each other",
                published.inConflict(),
                close,
                20,
                2);
        dome(
                "rim-thrown",
                "the rim thrown through its whole range in one step, and back",
                published.withRimThrown(),
                StabilityBounds.body().kinetic(2).shape(0.25),
                40,
                8);
        dome(
                "force-50",
                "muscle force 50 times as strong",
                published.pulled(50),
                close.reach(UNBOUNDED).speed(10_000),
                40,
                8);
        // Trusted runs in 8, 16 and 32 parts agree to 0.001 mm for 10 s and part by 3 mm in the next 10: how a slack
        // sheet crumples is decided by less than any step resolves.
        dome(
                "limp",
                "a sheet that nothing pulls and nothing brings back",
                published.limp(),
                close.shapeUntil(10),
                60,
                4);
    }

    private void dome(
            String key, String title, DomeParameters recipe, StabilityBounds bounds, double durationS, double quickS) {
        cases.add(new StabilityCase(
                key,
                title,
                bounds,
                (kind, refinement, duration) -> new DomeScene(recipe, kind, refinement),
                durationS,
                quickS,
                DomeDrive.PERIOD_S,
                DOME_REFERENCE_S));
    }

    private void thoraxes() {
        StabilityBounds close = StabilityBounds.body().kinetic(2).shape(0.1);
        StabilityBounds apart = StabilityBounds.body().speed(10_000);
        thorax("thorax-published", "the paper's parameters, quiet breaths", close, 200, 2, BREATH_S, "material=paper");
        thorax("thorax-dt-20", "time step 20 times as long", close, 20, 2, BREATH_S, "time_step_s=0.02");
        thorax("thorax-limp", "neither muscle nor pressure", close, 20, 2, BREATH_S, "muscle=false", "pressure=false");
        thorax(
                "thorax-stiff",
                "muscle as stiff as the slider goes, no damping",
                close,
                20,
                2,
                BREATH_S,
                "muscle_stiffness_n_per_m=3000",
                "tendon_stiffness_ratio=50",
                "damping_rate_per_s=0");
        // Verlet at an eighth and at a twelfth of the step: 0.4 mm apart, 3 % of the way, up to 1.2 s; then the sheet
        // snaps through, at a moment that any step decides, single nodes at 1,400 mm/s however finely it is stepped.
        thorax(
                "thorax-deep",
                "breaths as deep as the sliders go",
                close.speed(10_000).shapeUntil(1.2),
                20,
                2,
                8,
                "preset=deep",
                "depth=2",
                "muscle_activation=0.8",
                "rib_rotation=1.5");
        ribs();
        sliders("sliders", "all sliders thrown from end to end at random", 600, apart.returns(1));
        sliders(
                "sliders-paper",
                "the same with the paper's material",
                600,
                apart.reach(UNBOUNDED).returns(1),
                "material=paper");
        thorax("hour", "an hour of quiet breathing", close.repeats(0.1), 3600, 1, BREATH_S);
        // With its own damping the paper's sheet swings on from breath to breath and never twice alike
        // (docs/stability.md):
        // its rest shape is seen when the breath is stopped.
        thorax(
                "hour-paper",
                "the same with the paper's material",
                close.drift(0.1),
                3600,
                2,
                BREATH_S,
                "material=paper");
    }

    /**
     * Ribs go from exhaled to beyond inhaled and back within two steps of a tenth of a second, as fast as a slider can
     * be thrown.
     */
    private void ribs() {
        Scenario scenario = scenario("preset=hold-inspiration", "time_step_s=0.1", "rib_rotation=0");
        simulated(
                "thorax-ribs-thrown",
                "ribs thrown through their whole range",
                StabilityBounds.body().kinetic(2).shape(0.25),
                new double[] {20, 1},
                0,
                scenario,
                duration -> new RibRotationSteps());
    }

    private void sliders(String key, String title, double durationS, StabilityBounds bounds, String... settings) {
        Scenario scenario = scenario(settings);
        simulated(
                key,
                title,
                bounds,
                new double[] {durationS, BreathStop.SETTLING_S + 2},
                0,
                scenario,
                duration -> new RandomSliders(scenario, duration - BreathStop.SETTLING_S));
    }

    private void thorax(
            String key,
            String title,
            StabilityBounds bounds,
            double durationS,
            double quickS,
            double periodS,
            String... settings) {
        simulated(
                key,
                title,
                bounds,
                new double[] {durationS, quickS},
                periodS,
                scenario(settings),
                duration -> simulation -> {});
    }

    private void simulated(
            String key,
            String title,
            StabilityBounds bounds,
            double[] durationsS,
            double periodS,
            Scenario scenario,
            DoubleFunction<ThoraxScene.Intervention> doing) {
        StabilityCase.Factory maker = (kind, refinement, duration) -> {
            double usual = scenario("material=" + scenario.material().label()).timeStepS();
            double dt = refinement == 1
                    ? scenario.timeStepS()
                    : Math.min(usual, scenario.timeStepS()) * THORAX_REFINEMENT_DIVISOR / refinement;
            Scenario on = scenario.with("integrator=" + kind.label(), "time_step_s=" + dt);
            return new ThoraxScene(on, body(), doing.apply(duration));
        };
        cases.add(new StabilityCase(
                key, title, bounds, maker, durationsS[0], durationsS[1], periodS, THORAX_REFERENCE_S));
    }

    private static Scenario scenario(String... settings) {
        return Scenario.defaults().with(DIAPHRAGM).with(settings);
    }

    private synchronized Thorax body() {
        if (thorax == null) {
            thorax = SimulationRun.loadThorax(scenario());
        }
        return thorax;
    }
}
