package org.phrenic.model.material;

import java.util.List;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StepPolicy;
import org.phrenic.parameter.ChoiceSetting;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.NumberSetting;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.WholeSetting;

/** Numerical settings: time step, integrator, constraint sweeps, threads. */
public final class Numerics {
    /** Largest number of threads that can be requested. */
    public static final int MAX_THREADS = 256;

    private static final int MAX_DEFAULT_THREADS = 4;
    /** With less, a breath takes millions of steps. */
    private static final double MIN_STEP_S = 1e-5;

    private static final double MAX_STEP_S = 0.1;
    private static final double MAX_STATED_REFRESH_S = 1;
    private static final double MAX_SCALED_STEP_S = 0.01;
    private static final double SCALED_STEP_S = 0.0015;
    private static final double MAX_LIGHTNESS = 100;
    private static final double LIGHTNESS = 20;
    private static final double MAX_DAMPING_TIME_S = 10;
    private static final double DAMPING_TIME_S = 0.1;
    private static final int MAX_SWEEPS = 100;
    private static final double REFRESH_S = 0.02;
    private static final double REFRESH_STEPS = 4;
    /** Upper limit of the refresh interval. At 0.08 s the wall is off by 10 % of a breath's excursion. */
    private static final double MAX_REFRESH_S = 0.04;

    public static final NumberSetting TIME_STEP = Setting.named("time_step_s", "Time step", Effect.SCENE)
            .describedAs("Step of the clock; one beyond the stability limit is split into substeps.")
            .numberFrom("s", MIN_STEP_S, MAX_STEP_S, values -> values.get(Materials.MATERIAL)
                    .timeStepS());
    public static final ChoiceSetting<IntegratorKind> INTEGRATOR = Setting.named(
                    "integrator", "Integrator", Effect.INTEGRATION)
            .describedAs("Scheme that carries positions and velocities over a step.")
            .choice(List.of(IntegratorKind.values()), IntegratorKind::label, values -> values.get(Materials.MATERIAL)
                    .integrator());
    public static final ChoiceSetting<StepPolicy> STEP_POLICY = Setting.named(
                    "step_policy", "Step policy", Effect.ASSEMBLY)
            .describedAs("What to do with a step beyond the stability limit.")
            .choice(StepPolicy.SUBSTEP);
    public static final WholeSetting PROJECTION_SWEEPS = Setting.named(
                    "projection_sweeps", "Projection sweeps", Effect.ASSEMBLY)
            .describedAs("How many times a step goes through links, faces in order and contact, each of which"
                    + " breaks a little of what the others put right.")
            .whole(MAX_SWEEPS, values -> values.get(Materials.MATERIAL).projectionSweeps());
    public static final NumberSetting REFRESH = Setting.named("refresh_s", "Refresh", Effect.ASSEMBLY)
            .describedAs("Anchors on bone and the planes of the chest wall are taken anew after so much simulated"
                    + " time; in between they go on at their velocity.")
            .number(
                    "s",
                    1e-5,
                    MAX_STATED_REFRESH_S,
                    values -> Math.min(MAX_REFRESH_S, Math.max(REFRESH_S, REFRESH_STEPS * values.get(TIME_STEP))));
    public static final NumberSetting MASS_SCALING = Setting.named("mass_scaling_s", "Mass scaling", Effect.ASSEMBLY)
            .describedAs("Physical material: the lightest nodes are made heavier until velocity Verlet bears this"
                    + " step; the less, the less mass is added.")
            .number("s", 1e-6, MAX_SCALED_STEP_S, values -> SCALED_STEP_S);
    public static final NumberSetting TENDON_LIGHTNESS = Setting.named(
                    "tendon_lightness", "Tendon lightness", Effect.ASSEMBLY)
            .describedAs("Physical material: the tendon moves as a whole as if its nodes were so many times lighter;"
                    + " their masses, which its stiffness asks for, oppose its deformation alone.")
            .numberFrom("times", 1, MAX_LIGHTNESS, values -> LIGHTNESS);
    public static final NumberSetting DAMPING_TIME = Setting.named("damping_time_s", "Damping time", Effect.ASSEMBLY)
            .describedAs("Physical material: damping acts on a node's velocity relative to its mean over this time, so"
                    + " that slow motion is not held back; 0: on all of it.")
            .number("s", 0, MAX_DAMPING_TIME_S, values -> DAMPING_TIME_S);
    public static final WholeSetting THREADS = Setting.named("threads", "Threads", Effect.ASSEMBLY)
            .describedAs("Threads to compute on; the numbers do not depend on it.")
            .whole(MAX_THREADS, values -> defaultThreads(Runtime.getRuntime().availableProcessors()));

    private Numerics() {}

    /** All of one or two processors, half of up to eight: more threads wait for each other more than they compute. */
    static int defaultThreads(int processors) {
        return Math.min(processors, Math.max(2, Math.min(MAX_DEFAULT_THREADS, processors / 2)));
    }
}
