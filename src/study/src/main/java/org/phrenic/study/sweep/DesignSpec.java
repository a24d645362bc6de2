package org.phrenic.study.sweep;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.phrenic.document.CsvTable;
import org.phrenic.document.Key;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.study.sweep.design.FactorLevels;
import org.phrenic.study.sweep.design.FullGrid;
import org.phrenic.study.sweep.design.LatinHypercube;
import org.phrenic.study.sweep.design.MorrisDesign;
import org.phrenic.study.sweep.design.SaltelliDesign;
import org.phrenic.study.sweep.design.SweepDesign;

/**
 * The design of a study file.
 *
 * @param kind of design
 * @param samples points of a Latin hypercube, rows of matrix A of Saltelli's sampling, trajectories of Morris
 * @param seed of all random numbers
 * @param levels of a factor that is not listed, on Morris trajectories
 * @param file CSV file of a list, one column a factor
 * @param columns factors of {@code points}
 * @param points of a list, in place of a file
 */
public record DesignSpec(
        Kind kind,
        @Key(absent = "64", min = 1, max = 1_000_000) int samples,
        @Key(absent = "1") long seed,
        @Key(absent = "4", min = 2, max = 1000) int levels,
        Optional<String> file,
        @Key(absent = "") List<String> columns,
        @Key(absent = "") List<List<String>> points) {
    /** Number up to which the points of a grid are counted. */
    static final long MOST_COUNTED = 1L << 40;

    /** Kinds of designs. */
    public enum Kind {
        /** All combinations of levels. */
        GRID,
        /** Latin hypercube. */
        LATIN_HYPERCUBE("samples", "seed"),
        /** Sobol' sequence with Saltelli's sampling. */
        SOBOL("samples", "seed"),
        /** Morris trajectories. */
        MORRIS("samples", "seed", "levels"),
        /** A table of points. */
        LIST;

        private final Set<String> numbers;

        Kind(String... numbers) {
            this.numbers = Set.of(numbers);
        }

        /** Name in files. */
        public String label() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /**
     * @throws IllegalArgumentException with one sentence, if a list lacks its points or states them twice, or another
     *     design has some
     */
    public DesignSpec {
        columns = List.copyOf(columns);
        points = List.copyOf(points);
        boolean given = file.isPresent() || !points.isEmpty();
        if (given != (kind == Kind.LIST)) {
            throw new IllegalArgumentException("found " + (given ? "points" : "neither file nor points")
                    + " in a design of kind " + kind.label() + ", expected points in a list and only there");
        }
        if (!columns.isEmpty() && (kind != Kind.LIST || file.isPresent())) {
            throw new IllegalArgumentException("found columns "
                    + (file.isPresent() ? "besides a file" : "in a design of kind " + kind.label())
                    + ", expected them in a list without a file");
        }
        if (file.isPresent() && !points.isEmpty()) {
            throw new IllegalArgumentException("found points besides a file, expected one of them");
        }
        for (List<String> point : points) {
            if (point.size() != columns.size()) {
                throw new IllegalArgumentException("found a point of " + point.size() + " values, expected "
                        + columns.size() + ", as many as columns");
            }
        }
        if (kind == Kind.MORRIS && levels % 2 != 0) {
            throw new IllegalArgumentException("found " + levels + " levels, expected an even number");
        }
    }

    /** @throws BadInputException with one sentence, if a design states a number that its kind does not read */
    static void requireRead(YamlMap design, Kind kind) {
        for (String key : List.of("samples", "seed", "levels")) {
            if (design.has(key) && !kind.numbers.contains(key)) {
                boolean ofFactor = kind == Kind.GRID && key.equals("levels");
                throw design.bad(
                        key,
                        "found it in a design of kind " + kind.label() + ", expected it "
                                + (ofFactor ? "at the factors" : "in designs of other kinds"));
            }
        }
    }

    /** What a value means whose relative path is taken from a folder. */
    interface ValueReader {
        String read(String key, String value, Path folder);
    }

    /** The design with points in place of a file of them, whose relative paths are taken from where they are stated. */
    DesignSpec withPoints(Path folder, ValueReader values) {
        if (file.isEmpty()) {
            return read(columns, points, folder, values);
        }
        Path csv = folder.resolve(file.get());
        CsvTable table = CsvTable.read(csv);
        if (table.rowCount() == 0) {
            throw new BadInputException(csv + ": found no row, expected a point a line");
        }
        List<String> names = List.copyOf(table.columnNames());
        List<List<String>> cells = names.stream().map(table::texts).toList();
        List<List<String>> rows = new ArrayList<>();
        for (int r = 0; r < table.rowCount(); r++) {
            int row = r;
            rows.add(cells.stream().map(column -> column.get(row)).toList());
        }
        return read(names, rows, csv.toAbsolutePath().getParent(), values);
    }

    private DesignSpec read(List<String> names, List<List<String>> rows, Path folder, ValueReader values) {
        List<List<String>> read = new ArrayList<>();
        for (List<String> row : rows) {
            List<String> cells = new ArrayList<>();
            for (int c = 0; c < row.size(); c++) {
                cells.add(values.read(names.get(c), row.get(c), folder));
            }
            read.add(cells);
        }
        return new DesignSpec(kind, samples, seed, levels, Optional.empty(), names, read);
    }

    /** Factors of a list: its columns with their values. */
    List<Factor> listedFactors() {
        List<Factor> factors = new ArrayList<>();
        for (int c = 0; c < columns.size(); c++) {
            int column = c;
            factors.add(Factor.listed(
                    columns.get(c),
                    points.stream().map(point -> point.get(column)).distinct().toList()));
        }
        return factors;
    }

    /** Number of points, without making them; those of a grid are counted up to {@link #MOST_COUNTED}. */
    long size(List<Factor> factors) {
        return switch (kind) {
            case LIST -> points.size();
            case LATIN_HYPERCUBE -> samples;
            case SOBOL -> (long) samples * SaltelliDesign.blockSize(factors.size());
            case MORRIS -> (long) samples * MorrisDesign.blockSize(factors.size());
            case GRID ->
                factors.stream().mapToLong(DesignSpec::gridLevels).reduce(1, (a, b) -> Math.min(a * b, MOST_COUNTED));
        };
    }

    private static int gridLevels(Factor factor) {
        return levels(factor, factor.levels()).count();
    }

    /** The levels of a factor; with listed values these. */
    private static FactorLevels levels(Factor factor, int ofRange) {
        if (factor.isListed()) {
            return new FactorLevels(factor.values().size(), FactorLevels.Spacing.LISTED);
        }
        return new FactorLevels(
                ofRange, factor.normal().isPresent() ? FactorLevels.Spacing.MIDDLES : FactorLevels.Spacing.ENDS);
    }

    /** The design in the unit cube; empty for a list. */
    Optional<SweepDesign> design(List<Factor> factors) {
        int k = factors.size();
        return switch (kind) {
            case LIST -> Optional.empty();
            case LATIN_HYPERCUBE -> Optional.of(new LatinHypercube(k, samples, seed));
            case SOBOL -> Optional.of(new SaltelliDesign(k, samples, seed));
            case MORRIS ->
                Optional.of(new MorrisDesign(
                        factors.stream().map(f -> levels(f, levels)).toList(), samples, seed));
            case GRID ->
                Optional.of(new FullGrid(
                        factors.stream().map(f -> levels(f, f.levels())).toList()));
        };
    }

    /** The design as in a study file. */
    Map<String, Object> toMap() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("kind", kind.label());
        if (kind == Kind.LIST) {
            map.put("columns", columns);
            map.put("points", points);
            return map;
        }
        if (kind != Kind.GRID) {
            map.put("samples", samples);
            map.put("seed", seed);
        }
        if (kind == Kind.MORRIS) {
            map.put("levels", levels);
        }
        return map;
    }
}
