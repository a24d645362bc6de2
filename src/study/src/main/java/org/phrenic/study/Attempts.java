package org.phrenic.study;

import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.file.BadInputException;

/**
 * Cases of a study that are computed one after another. A case that cannot be computed is kept with its reason, and the
 * next one goes on. What concerns the study as a whole, such as a full disk, is thrown.
 *
 * @param <T> result of a case
 */
public final class Attempts<T> {
    private final List<T> results = new ArrayList<>();
    private final List<String> failures = new ArrayList<>();

    /** Computes a case. */
    public void add(String name, Supplier<T> work) {
        try {
            results.add(work.get());
        } catch (BadInputException | DivergenceException | IllegalArgumentException | UncheckedIOException failure) {
            failures.add(name + ": " + failure.getMessage());
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

    /** Name and reason of each case that was not, as a sentence without a full stop. */
    public List<String> failures() {
        return List.copyOf(failures);
    }
}
