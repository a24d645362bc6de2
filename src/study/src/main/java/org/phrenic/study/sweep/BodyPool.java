package org.phrenic.study.sweep;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import org.phrenic.anatomy.Thorax;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.study.body.BodyVariation;

/** The bodies of a study. A body that several runs need is loaded or generated once; the latest are kept. */
final class BodyPool {
    /** Bodies that are kept. */
    private static final int KEPT = 8;

    private final Map<String, FutureTask<Thorax>> bodies = new LinkedHashMap<>(KEPT, 0.75f, true);

    /** The body that a scenario names, in another size and shape if one is given. */
    Thorax body(Scenario scenario, Optional<BodyVariation> variation) {
        String key = scenario.anatomy() + " " + OrganSettings.budget(scenario).vertices();
        if (variation.isEmpty()) {
            return get(key, () -> SimulationRun.loadThorax(scenario));
        }
        BodyVariation varied = variation.get();
        return get(key + " " + varied, () -> {
            Thorax base = body(scenario, Optional.empty());
            return varied.of(base, base.name() + " " + varied.description());
        });
    }

    /** A body that could not be made is not kept: whoever wants it next tries again. */
    Thorax get(String key, Callable<Thorax> make) {
        FutureTask<Thorax> task;
        synchronized (bodies) {
            task = bodies.computeIfAbsent(key, any -> new FutureTask<>(make));
            Iterator<String> eldest = bodies.keySet().iterator();
            while (bodies.size() > KEPT) {
                eldest.next();
                eldest.remove();
            }
        }
        task.run(); // does nothing if another thread has begun
        try {
            return task.get();
        } catch (ExecutionException failure) {
            synchronized (bodies) {
                bodies.remove(key, task);
            }
            if (failure.getCause() instanceof RuntimeException told) {
                throw told;
            }
            if (failure.getCause() instanceof Error error) {
                throw error; // such as memory that is used up, which is no property of the run
            }
            throw new IllegalStateException(failure.getCause());
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("the study was interrupted", stopped);
        }
    }
}
