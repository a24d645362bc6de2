package org.phrenic.study.error;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.StepPolicy;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;

/**
 * Runs the same breath of one scene with different solver settings. All runs start from the state at rest that the
 * scenario's own settings give, so differences arise during the breath alone.
 */
final class BreathRunner implements AutoCloseable {
    /** Sampling interval, s; every measured time step divides it. */
    static final double SAMPLE_S = 0.1;

    private final Scenario scenario;
    private final double durationS;
    private final Simulation simulation;
    private final double[] start;

    /**
     * Assembles the scene.
     *
     * @param untilS simulated time of a run, s
     */
    BreathRunner(Scenario scenario, Thorax thorax, double untilS) {
        this.scenario = scenario;
        this.durationS = Math.max(1, Math.round(untilS / SAMPLE_S)) * SAMPLE_S;
        simulation = Simulation.of(scenario, thorax);
        start = simulation.system().positions().clone();
    }

    Simulation simulation() {
        return simulation;
    }

    /** The diaphragm at rest. */
    TriangleMesh diaphragmAtRest() {
        return new SceneSurfaces(simulation)
                .surfaces().stream()
                        .filter(s -> s.kind() == StructureKind.DIAPHRAGM)
                        .findFirst()
                        .orElseThrow()
                        .rest();
    }

    /** Marks the nodes of the diaphragm in the caller's order, in which they come first. */
    boolean[] diaphragmNodes() {
        int vertices = diaphragmAtRest().vertexCount();
        boolean[] which = new boolean[nodes()];
        for (int i = 0; i < which.length; i++) {
            which[i] = simulation.system().layout().caller(i) < vertices;
        }
        return which;
    }

    /** Initial positions of all nodes, mm; read only. */
    double[] start() {
        return start;
    }

    /** Reorders node coordinates (three per node) from the solver's order to the caller's. */
    double[] toCallerOrder(double[] internal) {
        double[] out = new double[internal.length];
        simulation.system().layout().toCaller(internal, out);
        return out;
    }

    int nodes() {
        return start.length / 3;
    }

    double durationS() {
        return durationS;
    }

    /**
     * Number of substeps per time step that the stability limit requires; Integer.MAX_VALUE if unstable at any step.
     */
    int substeps(SolverSettings settings) {
        try {
            return simulation.stepper().limit().substeps(settings.integrator(), settings.timeStepS(), Stepper.SAFETY);
        } catch (IllegalArgumentException never) {
            return Integer.MAX_VALUE;
        }
    }

    /**
     * Simulates one breath from the start.
     *
     * @throws org.phrenic.engine.integrator.DivergenceException if the simulation diverges
     */
    Trajectory run(SolverSettings settings) {
        ParticleSystem system = simulation.system();
        system.setProjectionSweeps(settings.sweeps());
        system.setRefreshInterval(settings.refreshS());
        System.arraycopy(start, 0, system.positions(), 0, start.length);
        Arrays.fill(system.velocities(), 0);
        system.invalidate();
        Stepper stepper = new Stepper(
                settings.integrator().create(system),
                settings.timeStepS(),
                StepPolicy.SUBSTEP,
                simulation.stepper().limit());
        int samples = (int) Math.round(durationS / SAMPLE_S);
        long perSample = Math.round(SAMPLE_S / settings.timeStepS());
        double[][] positions = new double[samples][];
        long wall = 0;
        long cpu = 0;
        for (int s = 0; s < samples; s++) {
            long wallFrom = System.nanoTime();
            long cpuFrom = cpuNanos();
            for (long i = 0; i < perSample; i++) {
                stepper.step();
            }
            cpu += cpuNanos() - cpuFrom;
            wall += System.nanoTime() - wallFrom;
            positions[s] = system.positions().clone();
        }
        return new Trajectory(positions, stepper.substeps(), cpu * 1e-9, wall * 1e-9);
    }

    /** Greatest displacement of the domes from rest in a trajectory, mean of both sides, mm; a descent in a breath. */
    double excursionMm(Trajectory trajectory) {
        SceneSurfaces surfaces = new SceneSurfaces(simulation);
        Frame frame = surfaces.newFrame();
        double rest = meanDomeHeight(start, surfaces, frame);
        return Arrays.stream(trajectory.positions())
                .mapToDouble(p -> Math.abs(rest - meanDomeHeight(p, surfaces, frame)))
                .max()
                .orElse(0);
    }

    private double meanDomeHeight(double[] positions, SceneSurfaces surfaces, Frame frame) {
        System.arraycopy(positions, 0, simulation.system().positions(), 0, positions.length);
        surfaces.capture(frame);
        return 0.5
                * (frame.values()[Observation.COLUMNS.indexOf("dome_right_mm")]
                        + frame.values()[Observation.COLUMNS.indexOf("dome_left_mm")]);
    }

    /** CPU time, ns: of this thread for a single-threaded scenario, otherwise of the process. */
    private long cpuNanos() {
        if (scenario.threads() == 1) {
            return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        }
        return ManagementFactory.getOperatingSystemMXBean() instanceof com.sun.management.OperatingSystemMXBean process
                ? process.getProcessCpuTime()
                : 0;
    }

    @Override
    public void close() {
        simulation.close();
    }
}
