package org.phrenic.study.sweep;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The completed runs of a plan, in its order. */
public final class SweepResults {
    private final SweepPlan plan;
    private final RunRow[] rows;

    /**
     * @param done completed runs in any order; of two with the same index the first counts
     * @throws IllegalArgumentException with one sentence, if a run is none of the plan
     */
    public SweepResults(SweepPlan plan, Collection<RunRow> done) {
        this.plan = plan;
        rows = new RunRow[plan.size()];
        for (RunRow row : done) {
            if (row.index() >= rows.length) {
                throw new IllegalArgumentException(
                        "found a run " + row.index() + ", expected " + rows.length + " runs, counted from 0");
            }
            if (rows[row.index()] == null) {
                rows[row.index()] = row;
            }
        }
    }

    public SweepPlan plan() {
        return plan;
    }

    private Stream<RunRow> stream() {
        return Arrays.stream(rows).filter(Objects::nonNull);
    }

    /** The completed runs, in the order of the design. */
    public List<RunRow> rows() {
        return stream().toList();
    }

    public boolean has(int index) {
        return rows[index] != null;
    }

    public int done() {
        return (int) stream().count();
    }

    public int failed() {
        return (int) stream().filter(RunRow::isFailed).count();
    }

    public boolean isComplete() {
        return done() == rows.length;
    }

    /** A response at every point; NaN for a run that failed or is missing. */
    public double[] response(int number) {
        return Arrays.stream(rows)
                .mapToDouble(row -> row == null ? Double.NaN : row.outcome().responses()[number])
                .toArray();
    }

    /** Sum of the wall times of all runs, s. */
    public double wallS() {
        return stream().mapToDouble(RunRow::wallS).sum();
    }

    /** The builds of the program that computed the runs, in alphabetical order. */
    public SortedSet<String> programs() {
        return stream().map(row -> RunMachine.program(row.machine())).collect(Collectors.toCollection(TreeSet::new));
    }

    /** A sentence on the builds of the program that computed the runs; empty if it is one. */
    public Optional<String> builds() {
        Set<String> all = programs();
        return all.size() < 2
                ? Optional.empty()
                : Optional.of("The runs are of different builds of the program, whose results may differ: "
                        + String.join("; ", all) + ".");
    }

    /** Machines that computed the runs, with their numbers of runs. */
    public Map<String, Long> machines() {
        Map<String, Long> machines = new TreeMap<>();
        stream().forEach(row -> machines.merge(row.machine(), 1L, Long::sum));
        return machines;
    }
}
