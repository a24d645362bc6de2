package org.phrenic.study;

import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.parallel.BatchRunner;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.BadInputException;
import org.phrenic.fit.search.ForeignJournalException;

/**
 * Cases of a study. A case that cannot be computed is kept with its reason, and the others go on. What concerns the
 * study as a whole, such as a full disk or journals of another study, is thrown.
 *
 * @param <T> result of a case
 */
public final class Attempts<T> {
    private final List<T> results = new ArrayList<>();
    private final Map<String, T> named = new HashMap<>();
    private final List<String> failures = new ArrayList<>();
    private RuntimeException first;

    /**
     * Computes cases at the same time, which are kept in their order, and notes those that fail. If all do, nothing is
     * lost with them, and the first reason is thrown.
     *
     * @param jobs with different names
     * @param threads number of concurrent cases
     */
    public static <T> Attempts<T> of(List<BatchRunner.Job<T>> jobs, int threads, ProgressListener progress) {
        List<BatchRunner.Job<Attempts<T>>> each = new ArrayList<>();
        for (BatchRunner.Job<T> job : jobs) {
            each.add(new BatchRunner.Job<>(job.name(), () -> {
                Attempts<T> one = new Attempts<>();
                one.add(job.name(), job.work());
                return one;
            }));
        }
        Attempts<T> all = new Attempts<>();
        for (Attempts<T> one : BatchRunner.run(each, threads, progress)) {
            all.results.addAll(one.results);
            all.named.putAll(one.named);
            all.failures.addAll(one.failures);
            all.first = all.first == null ? one.first : all.first;
        }
        if (all.results.isEmpty() && all.first != null) {
            throw all.first;
        }
        all.failures.forEach(progress::note);
        return all;
    }

    /** Computes a case. */
    public void add(String name, Supplier<T> work) {
        try {
            T result = work.get();
            results.add(result);
            named.put(name, result);
        } catch (ForeignJournalException ofAll) {
            throw ofAll;
        } catch (BadInputException | DivergenceException | IllegalArgumentException | UncheckedIOException failure) {
            failures.add(name + ": " + failure.getMessage());
            first = first == null ? failure : first;
        }
    }

    /** Adds a section with the cases that failed to a page, if there are any. */
    public static void addFailures(ReportDocument page, String heading, List<String> failures) {
        if (!failures.isEmpty()) {
            page.section(heading);
            page.points(failures.stream().map(failure -> failure + ".").toArray(String[]::new));
        }
    }

    /** Results of the cases that were computed, in their order. */
    public List<T> results() {
        return List.copyOf(results);
    }

    /** Result of a case; empty if it was not computed. */
    public Optional<T> result(String name) {
        return Optional.ofNullable(named.get(name));
    }

    /** Name and reason of each case that was not, as a sentence without a full stop. */
    public List<String> failures() {
        return List.copyOf(failures);
    }
}
