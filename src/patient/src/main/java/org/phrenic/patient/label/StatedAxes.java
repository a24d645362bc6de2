package org.phrenic.patient.label;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Axes that a file states and that its structures contradict: right and left, front and back or up and down are
 * exchanged. Structures are compared by their places ({@link LabelPlaces}), whole lungs by their shape as well
 * ({@link LungMoments}).
 *
 * @param stated sides of the body to which columns, rows and slices run by the file, such as LPS
 * @param seen sides to which they run if structures lie as in people; the stated ones if names of right and left
 *     structures are exchanged while others lie as in people
 * @param sidesAlone whether right and left alone differ, as they do if labels are exchanged
 */
public record StatedAxes(String stated, String seen, boolean sidesAlone) {
    /**
     * Least number of comparisons whose mean cosines tell axes, as one of two organs may lie in any direction, and that
     * tell axes of labels whose structures are not certain.
     */
    private static final int ENOUGH = 12;

    /** Difference of the mean cosines from which axes are worse than others. */
    private static final double MISALIGNED = 0.2;

    /** Greatest difference of people's lungs from the usual ones. */
    private static final double SIMILAR = 0.8;
    /** Gain from which axes count as better than the stated ones. */
    private static final double CLEAR = 0.1;

    /**
     * Added to the difference of a mirror image, and where structures tell right from left for each axis that changes:
     * it decides where shapes hardly do.
     */
    private static final double UNLIKELY = 0.03;

    private static final Set<String> BOTH_LUNGS = Set.of("lung_R", "lung_L");

    /**
     * Judges the axes of a volume.
     *
     * @param table structures of its labels
     * @param usual moments of people's lungs in LPS; without them the shape of lungs tells nothing
     * @return the axes if the structures contradict those that the file states
     */
    public static Optional<StatedAxes> contradicted(LabelVolume volume, LabelTable table, Optional<LungMoments> usual) {
        LabelGrid grid = volume.grid();
        LabelPlaces places = new LabelPlaces(grid, table.structures());
        List<BodyAxes> fitting = fitting(places);
        if (fitting.isEmpty() && places.haveSidesExchanged()) {
            String stated = BodyAxes.STATED.letters(grid);
            return Optional.of(new StatedAxes(stated, stated, true));
        }
        boolean fits = fitting.contains(BodyAxes.STATED);
        Optional<LungMoments> lungs = usual.flatMap(u -> lungs(grid, table.structures()));
        if (lungs.isPresent()) {
            ToDoubleFunction<BodyAxes> unlikely =
                    places.compares(0) ? axes -> 3 - axes.unchanged() : axes -> axes.mirrors() ? 1 : 0;
            ToDoubleFunction<BodyAxes> difference =
                    axes -> usual.orElseThrow().distance(lungs.get(), axes) + UNLIKELY * unlikely.applyAsDouble(axes);
            return fitting.stream()
                    .min(Comparator.comparingDouble(difference))
                    .filter(best -> !fits || isClear(difference, best))
                    .map(best -> of(grid, best));
        }
        return fits
                ? Optional.empty()
                : fitting.stream()
                        .max(Comparator.comparingInt(BodyAxes::unchanged))
                        .map(best -> of(grid, best));
    }

    /** Axes in which structures lie as in people, and nearly as much along the coordinates as in any others. */
    private static List<BodyAxes> fitting(LabelPlaces places) {
        List<BodyAxes> all = BodyAxes.all().stream().filter(places::fit).toList();
        if (places.compared() < ENOUGH) {
            return all;
        }
        double best = all.stream().mapToDouble(places::alignment).max().orElse(0);
        return all.stream()
                .filter(axes -> places.alignment(axes) > best - MISALIGNED)
                .toList();
    }

    /** Axes in which labels would lie as the structures of a tool's numbers do, if they lie so in no stated ones. */
    static Optional<BodyAxes> ofNumbers(LabelPlaces places) {
        if (places.compared() < ENOUGH || places.fit(BodyAxes.STATED)) {
            return Optional.empty();
        }
        return BodyAxes.all().stream()
                .filter(axes -> places.fit(axes) && places.areBones(axes))
                .max(Comparator.comparingDouble(places::alignment));
    }

    private static StatedAxes of(LabelGrid grid, BodyAxes axes) {
        return new StatedAxes(BodyAxes.STATED.letters(grid), axes.letters(grid), axes == BodyAxes.MIRRORED);
    }

    /** The sides to which columns, rows and slices of a volume run by its file, such as LPS. */
    public static String letters(LabelVolume volume) {
        return BodyAxes.STATED.letters(volume.grid());
    }

    /** Whether the shape of lungs tells these axes from the stated ones. It hardly tells right from left. */
    private static boolean isClear(ToDoubleFunction<BodyAxes> difference, BodyAxes best) {
        double stated =
                Math.min(difference.applyAsDouble(BodyAxes.STATED), difference.applyAsDouble(BodyAxes.MIRRORED));
        double least = difference.applyAsDouble(best);
        return least < SIMILAR && stated - least > CLEAR;
    }

    /** Moments of both lungs if the volume shows them whole. */
    private static Optional<LungMoments> lungs(LabelGrid grid, Map<Integer, String> structures) {
        boolean[] isLung = new boolean[LabelGrid.MAX_LABEL + 1];
        structures.forEach((label, s) -> isLung[label] = s.equals(LabelTable.LUNGS) || BOTH_LUNGS.contains(s));
        boolean both = structures.containsValue(LabelTable.LUNGS)
                || structures.values().containsAll(BOTH_LUNGS);
        int[] box = grid.box(label -> isLung[label]);
        boolean whole = both
                && box[0] > 0
                && box[1] > 0
                && box[2] > 0
                && box[3] < grid.columns() - 1
                && box[4] < grid.rows() - 1
                && box[5] < grid.slices() - 1
                && box[5] >= 0;
        return whole ? Optional.of(LungMoments.of(grid, label -> isLung[label])) : Optional.empty();
    }

    /** Whether names of right and left structures are exchanged, whatever the axes. */
    private boolean isOfNames() {
        return seen.equals(stated);
    }

    /** What is expected instead, after the sentence. */
    public String expected() {
        return isOfNames()
                ? "expected each label under the name of its own side, or --axes " + stated + " to keep them"
                : "expected --axes " + seen + ", or --axes " + stated + " to keep them";
    }

    /** One sentence without a full stop: what is found, and the axes that are expected. */
    public String sentence() {
        return isOfNames()
                ? "structures that are named right lie to the left of those that are named left, while liver, spleen or"
                        + " stomach lie as in people: names of right and left are exchanged"
                : "structures lie as in people if columns, rows and slices run to " + seen + ", where the file states "
                        + stated + (sidesAlone ? " (or labels of right and left are exchanged)" : "");
    }
}
