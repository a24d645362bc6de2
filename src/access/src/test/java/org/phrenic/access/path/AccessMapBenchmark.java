package org.phrenic.access.path;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;

/**
 * What an access map costs: {@code AccessMapBenchmark [THREADS [NEEDLE_MM]]}, the first exercise's target in the
 * virtual man at medium resolution, 20 moments. The first map is made before the code is compiled. "cpu" is what all
 * threads of the process used together, which other programs on the machine disturb less than the wall's time.
 */
final class AccessMapBenchmark {
    private static final int MAPS = 8;
    private static final double POINTS = 2000;
    private static final double NANOS = 1e-9;

    private AccessMapBenchmark() {}

    public static void main(String[] arguments) {
        int threads = arguments.length > 0 ? Integer.parseInt(arguments[0]) : 2;
        double length = arguments.length > 1 ? Double.parseDouble(arguments[1]) : 210;
        RehearsalPlan plan = RehearsalPlan.exercises()
                .get(0)
                .with(List.of("lungs=embedded", "sternum=kinematic", "threads=" + threads));
        Scenario scenario = plan.scenario();
        OperatingSystemMXBean system = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
        try (Simulation simulation = Simulation.of(scenario, SimulationRun.loadThorax(scenario));
                Workers workers = Workers.of(threads)) {
            SceneSurfaces surfaces = new SceneSurfaces(simulation);
            MovingAnatomy scene = new MovingAnatomy(surfaces.surfaces());
            scene.update(surfaces.newFrame());
            TargetLesion target = plan.target(scene);
            List<BreathMoment> cycle = BreathCycle.record(simulation, surfaces, plan.moments());
            Needle needle = new Needle(plan.needle().gauge(), length);
            for (int i = 0; i < MAPS; i++) {
                long wallFrom = System.nanoTime();
                long cpuFrom = system.getProcessCpuTime();
                AccessMap map = AccessMap.of(scene, cycle, target, needle, plan.avoided(), workers);
                double cpu = NANOS * (system.getProcessCpuTime() - cpuFrom);
                double wall = NANOS * (System.nanoTime() - wallFrom);
                int reached = map.counts().inReach();
                System.out.printf(
                        "%d points, %d in reach, %d moments, %d threads: wall %.2f s, cpu %.2f s; for 2,000 in"
                                + " reach %.2f s of cpu%n",
                        map.size(), reached, cycle.size(), threads, wall, cpu, cpu * POINTS / reached);
            }
        }
    }
}
