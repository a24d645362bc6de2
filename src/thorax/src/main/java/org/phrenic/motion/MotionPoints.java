package org.phrenic.motion;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.phrenic.document.CsvTable;
import org.phrenic.document.CsvWriter;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.query.DistanceSummary;

/**
 * Points at rest and their trajectories. A CSV file has the columns {@code x_mm}, {@code y_mm}, {@code z_mm} (LPS) and,
 * if wanted, {@code name} and {@code structure}. A point without a structure belongs to the closed surface that it is
 * in, else to the soft tissue. With the columns {@code to_x_mm}, {@code to_y_mm}, {@code to_z_mm} it has a place where
 * it was seen at another breath level, in the same axes, and its distance from there is told.
 */
final class MotionPoints {
    private static final List<String> HEADER = List.of("name", "structure", "time_s", "x_mm", "y_mm", "z_mm");
    private static final String DISTANCE = "distance_mm";
    private static final List<String> SEEN = List.of("to_x_mm", "to_y_mm", "to_z_mm");

    private final BodyMotion motion;
    private final List<String> names = new ArrayList<>();
    private final List<double[]> places = new ArrayList<>();
    private final List<Optional<Integer>> structures = new ArrayList<>();
    private final List<String> regions = new ArrayList<>();
    /** Coordinates at the other breath level, by axis; empty if they are not known. */
    private final List<double[]> seen;

    private final List<List<Object>> rows = new ArrayList<>();

    /** @throws BadInputException if the file cannot be read, has no points or names a structure that is not there */
    MotionPoints(Path file, BodyMotion motion) {
        this.motion = motion;
        CsvTable table = CsvTable.read(file);
        double[] x = table.numbers("x_mm");
        double[] y = table.numbers("y_mm");
        double[] z = table.numbers("z_mm");
        if (x.length == 0) {
            throw new BadInputException(file + ": found no row, expected points");
        }
        seen = SEEN.stream().anyMatch(table::has)
                ? SEEN.stream().map(table::numbers).toList()
                : List.of();
        List<String> named = texts(table, "name");
        List<String> stated = texts(table, "structure");
        for (int i = 0; i < x.length; i++) {
            String name = named.get(i);
            String structure = stated.get(i);
            names.add(name.isEmpty() ? Integer.toString(i + 1) : name);
            places.add(new double[] {x[i], y[i], z[i]});
            try {
                structures.add(
                        structure.isEmpty()
                                ? motion.structureAt(x[i], y[i], z[i])
                                : Optional.of(motion.structure(structure)));
            } catch (BadInputException unknown) {
                throw table.badCell(i, "structure", unknown.getMessage());
            }
            regions.add(structures
                    .get(i)
                    .map(s -> motion.surfaces().get(s).name())
                    .orElseGet(() -> motion.softTissueAt(places.get(places.size() - 1))));
        }
    }

    /** The cells of a column; empty ones without it. */
    private static List<String> texts(CsvTable table, String column) {
        return table.has(column) ? table.texts(column) : Collections.nCopies(table.rowCount(), "");
    }

    /** Adds where the points are now; returns their distances from where they were seen, if that is known. */
    Optional<DistanceSummary> add(double timeS) {
        double[] distances = new double[places.size()];
        for (int i = 0; i < places.size(); i++) {
            double[] place = places.get(i);
            double[] now = structures.get(i).isPresent()
                    ? motion.moved(structures.get(i).get(), place)
                    : motion.moved(place);
            List<Object> row = new ArrayList<>(List.of(names.get(i), regions.get(i), timeS, now[0], now[1], now[2]));
            if (!seen.isEmpty()) {
                double square = 0;
                for (int axis = 0; axis < 3; axis++) {
                    double off = now[axis] - seen.get(axis)[i];
                    square += off * off;
                }
                distances[i] = Math.sqrt(square);
                row.add(distances[i]);
            }
            rows.add(row);
        }
        double[] weights = new double[distances.length];
        Arrays.fill(weights, 1);
        return seen.isEmpty() ? Optional.empty() : Optional.of(DistanceSummary.of(distances, weights));
    }

    /** Writes the trajectories: a row for each point and time. */
    void write(Path file) {
        List<String> header = new ArrayList<>(HEADER);
        if (!seen.isEmpty()) {
            header.add(DISTANCE);
        }
        CsvWriter.write(file, header, rows);
    }
}
