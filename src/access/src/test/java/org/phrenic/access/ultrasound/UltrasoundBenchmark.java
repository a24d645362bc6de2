package org.phrenic.access.ultrasound;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.Optional;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;

/**
 * What an ultrasound image costs: {@code UltrasoundBenchmark [THREADS [ANATOMY [RESOLUTION]]]}, the right intercostal
 * window at 150 mm. "cpu" is what all threads of the process used together, which other programs on the machine disturb
 * less than the wall's time.
 */
final class UltrasoundBenchmark {
    private static final int ROUNDS = 6;
    private static final int IMAGES = 40;
    private static final double MILLIS = 1e-6;

    private UltrasoundBenchmark() {}

    public static void main(String[] arguments) {
        int threads = arguments.length > 0 ? Integer.parseInt(arguments[0]) : 2;
        String anatomy = arguments.length > 1 ? arguments[1] : "virtual/adult-male";
        String resolution = arguments.length > 2 ? arguments[2] : "medium";
        Scenario scenario = Scenario.defaults().with("anatomy=" + anatomy).with("resolution=" + resolution);
        OperatingSystemMXBean system = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
        try (Simulation simulation = Simulation.of(scenario, SimulationRun.loadThorax(scenario))) {
            SceneSurfaces scene = new SceneSurfaces(simulation);
            Frame frame = scene.newFrame();
            Ultrasound ultrasound = new Ultrasound(scene.surfaces(), CurvilinearProbe.abdominal(), threads);
            ProbeOnSkin place =
                    new ProbeOnSkin(scene.surfaces(), LiverWindow.RIGHT_INTERCOSTAL.placeOn(scene.surfaces()));
            for (int round = 0; round < ROUNDS; round++) {
                long wallFrom = System.nanoTime();
                long cpuFrom = system.getProcessCpuTime();
                for (int i = 0; i < IMAGES; i++) {
                    ProbePose pose = place.pose(frame, new ProbePose.Angles(i, 0, 0));
                    ultrasound.take(frame, pose, UltrasoundSettings.DEFAULT, Optional.empty());
                }
                double cpu = MILLIS * (system.getProcessCpuTime() - cpuFrom) / IMAGES;
                double wall = MILLIS * (System.nanoTime() - wallFrom) / IMAGES;
                System.out.printf("%d threads: wall %.1f ms, cpu %.1f ms an image%n", threads, wall, cpu);
            }
        }
    }
}
