package org.phrenic.study.bare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.data.Percentage.withPercentage;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.mesh.TriangleMesh;

class BareWorkloadTest {
    private static final double PERCENT = 1e-6;
    private static final Path SHARED = Path.of("../shared/bench");

    /**
     * Expected numbers: README.md of the workload, on which six other programs (C++, numba, Taichi, JAX, Warp, SOFA)
     * agree.
     */
    @ParameterizedTest
    @CsvSource({
        "20909, false, -0.00751568349",
        "6633, false, -0.00505206753",
        "20909, true, -0.00750832941",
        "6633, true, -0.00501653054"
    })
    void movesTheDomeAsOtherProgramsDo(int nodes, boolean links, double meanDz) {
        String name = "dome_" + nodes;
        assumeTrue(Files.exists(SHARED.resolve(name + ".obj")), "needs " + SHARED + "/" + name + ".obj");
        BareScene scene = BareScene.read(
                SHARED.resolve(name + ".obj"),
                SHARED.resolve(name + ".fixed.txt"),
                SHARED.resolve(name + ".loaded.txt"),
                links ? SHARED.resolve(name + ".links.txt") : null);
        try (BareWorkload work = new BareWorkload(scene, BareSettings.DEFAULT)) {
            work.advance(BareWorkload.CHECKED_STEPS);
            assertThat(work.meanDz()).isCloseTo(meanDz, withPercentage(PERCENT));
        }
    }

    @ParameterizedTest
    @CsvSource({"symplectic-euler, false", "symplectic-euler, true", "verlet, true", "rk4, false"})
    void sameBitsOnAnyNumberOfThreads(String integrator, boolean links) {
        BareScene scene = Domes.scene(40, links);
        String[] hash = new String[3];
        for (int threads = 1; threads <= 3; threads++) {
            BareSettings settings = BareSettings.DEFAULT
                    .withIntegrator(IntegratorKind.of(integrator))
                    .withThreads(threads);
            try (BareWorkload work = new BareWorkload(scene, settings)) {
                work.advance(50);
                hash[threads - 1] = work.stateSha256();
            }
        }
        assertThat(hash[1]).isEqualTo(hash[0]);
        assertThat(hash[2]).isEqualTo(hash[0]);
    }

    @Test
    void oneSpringUnderLoadFallsAsItsEquationSays() {
        // Node 1 hangs on node 0, a mm apart along z; node 2 is held too, at a right angle, so its spring adds nothing
        // to first order. v += h a, x += h v by hand for two steps.
        BareScene scene = new BareScene(
                new TriangleMesh(new double[] {0, 0, 0, 0, 0, -1, 1e6, 0, -1}, new int[] {0, 1, 2}),
                new int[] {0, 2},
                new int[] {1},
                new int[0]);
        BareSettings s = BareSettings.DEFAULT;
        try (BareWorkload work = new BareWorkload(scene, s)) {
            work.advance(1);
            double v = s.step() * s.load() / s.mass();
            double z = s.step() * v;
            assertThat(work.meanDz()).isCloseTo(z, withPercentage(PERCENT));
            work.advance(1);
            v += s.step() * (s.load() - s.stiffness() * z - s.damping() * v) / s.mass();
            z += s.step() * v;
            assertThat(work.meanDz()).isCloseTo(z, withPercentage(PERCENT));
        }
    }

    @Test
    void aResultSaysWhatRan() {
        BareScene scene = Domes.scene(8, true);
        BareResult result = BareWorkload.run(scene, BareSettings.DEFAULT.withSteps(5));
        assertThat(result.nodes()).isEqualTo(2 * 64);
        // Euler's formula for a closed surface without holes: E = 3 V - 6.
        assertThat(result.edges()).isEqualTo(3 * 2 * 64 - 6);
        assertThat(result.links()).isEqualTo(13);
        assertThat(result.integrator()).isEqualTo("symplectic-euler");
        assertThat(result.stepsPerSecond()).isBetween(result.min(), result.max());
        assertThat(result.stateSha256()).matches("[0-9a-f]{64}");
        assertThat(BareWorkload.run(scene, BareSettings.DEFAULT.withSteps(3)).stateSha256())
                .as("the hash is taken after 200 steps, however many are timed")
                .isEqualTo(result.stateSha256());
    }

    @Test
    void refusesNoThreads() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> BareSettings.DEFAULT.withThreads(0))
                .withMessage("threads: found 0, expected 1 or more");
    }
}
