package org.phrenic.model.material;

import java.util.List;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StepPolicy;
import org.phrenic.parameter.ChoiceSetting;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.NumberSetting;
import org.phrenic.parameter.WholeSetting;

/** Numerical settings: time step, integrator, constraint sweeps, threads. */
public final class Numerics {
    /** Largest number of threads that can be requested. */
    public static final int MAX_THREADS = 256;

    private static final int MAX_DEFAULT_THREADS = 2;
    private static final double MAX_STEP_S = 0.1;
    private static final double MAX_STATED_REFRESH_S = 1;
    private static final double MAX_SCALED_STEP_S = 0.01;
    private static final double SCALED_STEP_S = 0.00125;
    private static final int MAX_SWEEPS = 100;
    private static final double REFRESH_S = 0.02;
    private static final double REFRESH_STEPS = 4;
    /** Upper limit of the refresh interval. At 0.08 s the wall is off by 10 % of a breath's excursion. */
    private static final double MAX_REFRESH_S = 0.04;

    public static final NumberSetting TIME_STEP = new NumberSetting(
            "time_step_s",
            "Time step",
            Effect.SCENE,
            new NumberSetting.Range("s", 1e-5, MAX_STEP_S),
            values -> values.get(Materials.MATERIAL).timeStepS(),
            "Step of the clock; one beyond the stability limit is split into substeps.");
    public static final ChoiceSetting<IntegratorKind> INTEGRATOR = new ChoiceSetting<>(
            "integrator",
            "Integrator",
            Effect.INTEGRATION,
            List.of(IntegratorKind.values()),
            IntegratorKind::label,
            values -> values.get(Materials.MATERIAL).integrator(),
            "Scheme that carries positions and velocities over a step.");
    public static final ChoiceSetting<StepPolicy> STEP_POLICY = ChoiceSetting.of(
            "step_policy",
            "Step policy",
            Effect.ASSEMBLY,
            StepPolicy.SUBSTEP,
            "What to do with a step beyond the stability limit.");
    public static final WholeSetting PROJECTION_SWEEPS = new WholeSetting(
            "projection_sweeps",
            "Projection sweeps",
            Effect.ASSEMBLY,
            MAX_SWEEPS,
            values -> values.get(Materials.MATERIAL).projectionSweeps(),
            "How many times a step goes through links, faces in order and contact, each of which breaks a little of"
                    + " what the others put right.");
    public static final NumberSetting REFRESH = new NumberSetting(
            "refresh_s",
            "Refresh",
            Effect.ASSEMBLY,
            new NumberSetting.Range("s", 1e-5, MAX_STATED_REFRESH_S),
            values -> Math.min(MAX_REFRESH_S, Math.max(REFRESH_S, REFRESH_STEPS * values.get(TIME_STEP))),
            "Anchors on bone and the planes of the chest wall are taken anew after so much simulated time; in between"
                    + " they go on at their velocity.");
    public static final NumberSetting MASS_SCALING = new NumberSetting(
            "mass_scaling_s",
            "Mass scaling",
            Effect.ASSEMBLY,
            new NumberSetting.Range("s", 1e-6, MAX_SCALED_STEP_S),
            values -> SCALED_STEP_S,
            "Physical material: the lightest nodes are made heavier until velocity Verlet bears this step; the less,"
                    + " the less mass is added.");
    public static final WholeSetting THREADS = new WholeSetting(
            "threads",
            "Threads",
            Effect.ASSEMBLY,
            MAX_THREADS,
            values -> Math.min(MAX_DEFAULT_THREADS, Runtime.getRuntime().availableProcessors()),
            "Threads to compute on; the numbers do not depend on it.");

    private Numerics() {}
}
