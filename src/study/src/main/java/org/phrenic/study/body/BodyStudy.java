package org.phrenic.study.body;

import java.util.List;
import org.phrenic.engine.parallel.BatchRunner;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Surface;

/**
 * Checks whether bodies breathe: a quiet and a deep breath of each, with the default numbers of the scenario.
 *
 * @param scenario settings of all runs
 * @param bodies results in the order of the cases
 */
public record BodyStudy(Scenario scenario, List<BodyResult> bodies) {
    /** Receives the surfaces of a body at rest and at full inspiration of each breath. May be called concurrently. */
    public interface Witness {
        /** Ignores everything. */
        Witness NONE = (body, when, surfaces, meshes) -> {};

        /**
         * @param when {@code rest}, {@code quiet} or {@code deep}
         * @param meshes positions of the surfaces, in their order
         */
        void seen(String body, String when, List<Surface> surfaces, List<TriangleMesh> meshes);
    }

    public BodyStudy {
        bodies = List.copyOf(bodies);
    }

    /**
     * Checks the bodies. The results do not depend on the number of threads.
     *
     * @param scenario settings of all runs; the preset is replaced
     * @param threads number of bodies at a time
     */
    public static BodyStudy of(
            Scenario scenario, List<BodyCase> cases, int threads, Witness witness, ProgressListener progress) {
        Scenario single = scenario.with("threads=1");
        List<BatchRunner.Job<BodyResult>> jobs = cases.stream()
                .map(body -> new BatchRunner.Job<>(body.name(), () -> {
                    BodyResult result = BreathCheck.of(body, single, witness);
                    synchronized (progress) {
                        result.faults().forEach(fault -> progress.note(body.name() + ": " + fault));
                    }
                    return result;
                }))
                .toList();
        return new BodyStudy(single, BatchRunner.run(jobs, threads, progress));
    }

    /** Whether all bodies breathe within the limits. */
    public boolean passes() {
        return bodies.stream().allMatch(BodyResult::passes);
    }
}
