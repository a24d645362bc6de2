package org.phrenic.scene.gl;

import com.jogamp.opengl.GL3;
import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.SceneFixture;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;

/**
 * What a picture costs, pass by pass: {@code DrawingBenchmark [WIDTH HEIGHT [SAMPLES [ANATOMY]]]}. Each pass is waited
 * for, and each picture is of a new frame. "wall" is the least and the median of the pictures; "cpu" is the mean of
 * what all threads of the process used together, which other programs on the machine disturb less.
 */
final class DrawingBenchmark {
    private static final int WARM_UP = 10;
    private static final int PICTURES = 40;
    private static final double NANOS_PER_MS = 1e6;
    private static final OperatingSystemMXBean SYSTEM =
            ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

    private final Map<String, double[]> wall = new LinkedHashMap<>();
    private final Map<String, double[]> cpu = new LinkedHashMap<>();
    private int picture;
    private long lastWall;
    private long lastCpu;

    private DrawingBenchmark() {}

    public static void main(String[] arguments) throws NoGraphicsException {
        int width = arguments.length > 0 ? Integer.parseInt(arguments[0]) : 1280;
        int height = arguments.length > 1 ? Integer.parseInt(arguments[1]) : 800;
        int samples = arguments.length > 2 ? Integer.parseInt(arguments[2]) : 0;
        String anatomy = arguments.length > 3 ? arguments[3] : "virtual/adult-male";
        Scenario scenario = Scenario.defaults().with(List.of(Assignment.read("benchmark", "anatomy", anatomy)));
        try (Simulation simulation = Simulation.of(scenario, SimulationRun.loadThorax(scenario));
                OffscreenContext offscreen = OffscreenContext.open()) {
            new DrawingBenchmark().run(simulation, offscreen, width, height, samples);
        }
    }

    private void run(Simulation simulation, OffscreenContext offscreen, int width, int height, int samples) {
        SceneSurfaces scene = new SceneSurfaces(simulation);
        Frame frame = scene.newFrame();
        Renderer renderer = new Renderer(scene.surfaces(), scene.overlays());
        SceneStyle style = SceneStyle.atlas(scene.surfaces()).withSamples(samples);
        Camera camera =
                Camera.of(AnatomicalView.ANTERIOR, SceneFixture.bounds(scene.surfaces()), (double) width / height);
        renderer.setPassListener(this::passed);
        for (int i = -WARM_UP; i < PICTURES; i++) {
            simulation.step();
            scene.capture(frame);
            picture = i;
            offscreen.run(gl -> {
                gl.glFinish();
                begin();
                renderer.draw(gl, frame, camera, style, width, height);
            });
        }
        print(offscreen.info(), renderer.statistics(), width, height, samples);
        offscreen.release(renderer);
    }

    private void begin() {
        lastWall = System.nanoTime();
        lastCpu = SYSTEM.getProcessCpuTime();
    }

    private void passed(GL3 gl, String pass) {
        gl.glFinish();
        long nowWall = System.nanoTime();
        long nowCpu = SYSTEM.getProcessCpuTime();
        if (picture >= 0) {
            wall.computeIfAbsent(pass, p -> new double[PICTURES])[picture] = (nowWall - lastWall) / NANOS_PER_MS;
            cpu.computeIfAbsent(pass, p -> new double[PICTURES])[picture] = (nowCpu - lastCpu) / NANOS_PER_MS;
        }
        begin();
    }

    private void print(GraphicsInfo info, FrameStatistics cost, int width, int height, int samples) {
        System.out.printf(Locale.ROOT, "%s, %d x %d, %d samples%n", info.renderer(), width, height, samples);
        double[] whole = new double[PICTURES];
        double[] wholeCpu = new double[PICTURES];
        wall.forEach((pass, ms) -> {
            row(pass, ms, cpu.get(pass));
            for (int i = 0; i < PICTURES; i++) {
                whole[i] += ms[i];
                wholeCpu[i] += cpu.get(pass)[i];
            }
        });
        row("picture", whole, wholeCpu);
        System.out.printf(
                Locale.ROOT,
                "%d bytes uploaded, %d draw calls, %d triangles%n",
                cost.bytesUploaded(),
                cost.drawCalls(),
                cost.triangles());
    }

    private static void row(String name, double[] ms, double[] cpuMs) {
        Arrays.sort(ms);
        System.out.printf(
                Locale.ROOT,
                "%-12s wall %6.1f least %6.1f median   cpu %6.1f ms%n",
                name,
                ms[0],
                ms[ms.length / 2],
                Arrays.stream(cpuMs).average().orElseThrow());
    }
}
