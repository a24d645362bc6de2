package org.phrenic.patient.numbering;

import java.util.List;
import java.util.Locale;
import java.util.NavigableMap;
import java.util.NavigableSet;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.phrenic.anatomy.Side;
import org.phrenic.engine.math.OrderStatistic;

/**
 * Ribs of one side that lie one vertebra off those of the other side, all of them or some that follow each other, while
 * those of the other side fit the vertebrae. It is seen in the heights of the vertebral ends of both ribs of a number.
 */
final class SideSlip {
    private static final int LEAST_RIBS = 5;
    /** Two ribs of a number are one or none off each other to this share of a distance of vertebrae. */
    private static final double SCATTER = 0.3;
    /** The same of the ribs of a side and their vertebrae. */
    private static final double FIT = 0.5;
    /** Least share of the ribs of both sides that are one or none off each other. */
    private static final double MOST = 0.75;
    /** Least step in the deviations from the last right rib to the first that is off, and greatest one opposite. */
    private static final double STEP = 0.65;

    private static final double LEVEL = 0.4;

    private final VertebraVoxels vertebrae;
    private final Side side;
    private final Side opposite;
    /** By number, in distances of vertebrae. */
    private final NavigableMap<Integer, Double> deviations;

    private final NavigableMap<Integer, Double> ofOther;

    private SideSlip(
            VertebraVoxels vertebrae,
            Side side,
            NavigableMap<Integer, Double> deviations,
            NavigableMap<Integer, Double> ofOther) {
        this.vertebrae = vertebrae;
        this.side = side;
        this.deviations = deviations;
        this.ofOther = ofOther;
        opposite = side == Side.RIGHT ? Side.LEFT : Side.RIGHT;
    }

    /** Returns a note on ribs of a side that are one off, if there are some. */
    static Optional<String> find(VertebraHeights height, VertebraVoxels vertebrae) {
        NavigableMap<Integer, Double> ofRight = deviations(height, vertebrae, Side.RIGHT);
        NavigableMap<Integer, Double> ofLeft = deviations(height, vertebrae, Side.LEFT);
        ofRight.keySet().retainAll(ofLeft.keySet());
        ofLeft.keySet().retainAll(ofRight.keySet());
        SideSlip right = new SideSlip(vertebrae, Side.RIGHT, ofRight, ofLeft);
        SideSlip left = new SideSlip(vertebrae, Side.LEFT, ofLeft, ofRight);
        return right.note(-1).or(() -> right.note(1)).or(() -> left.note(-1)).or(() -> left.note(1));
    }

    /** How far ribs lie from the vertebrae of their numbers, across these where they are tilted. */
    private static NavigableMap<Integer, Double> deviations(VertebraHeights height, VertebraVoxels vertebrae, Side of) {
        NavigableMap<Integer, Double> all = new TreeMap<>();
        for (int number = 1; number <= RibNumbering.RIBS; number++) {
            OptionalDouble end = height.showsSpacing(number) ? vertebrae.end(number, of) : OptionalDouble.empty();
            if (end.isPresent()) {
                all.put(number, (height.ribEnd(number) - end.getAsDouble()) / height.spacing(number));
            }
        }
        return all;
    }

    /** @param off by how many numbers the ribs may be too low */
    private Optional<String> note(int off) {
        NavigableSet<Integer> run = alike(off);
        NavigableSet<Integer> right = alike(0);
        if (run.size() < LEAST_RIBS
                || !right.subSet(run.first(), run.last()).isEmpty()
                || run.size() + right.size() < MOST * deviations.size()
                || Math.abs(median(deviations, run) - off) > FIT
                || Math.abs(median(ofOther, run)) > FIT
                || !isStep(right.lower(run.first()), run.first(), off)
                || !isStep(right.higher(run.last()), run.last(), off)
                || !vertebrae.meet(List.of(side), run.first(), run.last(), off)
                || !vertebrae.meet(List.of(opposite), run.first(), run.last(), 0)) {
            return Optional.empty();
        }
        String example = run.stream()
                .filter(number -> run.contains(number + off))
                .findFirst()
                .map(number ->
                        RibNumbering.name(number, side) + " beside " + RibNumbering.name(number + off, opposite) + "; ")
                .orElse("");
        return Optional.of(name(side) + " ribs " + run.first() + " to " + run.last() + " lie one vertebra "
                + (off < 0 ? "above" : "below") + " those of the " + name(opposite) + " side, which fit the vertebrae: "
                + example + "check the numbers of the " + name(side) + " ribs");
    }

    private static String name(Side side) {
        return side.name().toLowerCase(Locale.ROOT);
    }

    /**
     * Whether the ends of a right rib and the next one that is off are a vertebra nearer or farther than opposite.
     *
     * @param right number of the right rib; null if all are off there
     */
    private boolean isStep(Integer right, int off, int by) {
        return right == null
                || ((deviations.get(off) - deviations.get(right)) * by > STEP
                        && Math.abs(ofOther.get(off) - ofOther.get(right)) < LEVEL);
    }

    /** The numbers whose ribs of this side are so many lower than those of the other one. */
    private NavigableSet<Integer> alike(int off) {
        NavigableSet<Integer> alike = new TreeSet<>(deviations.keySet());
        alike.removeIf(number -> !(Math.abs(deviations.get(number) - ofOther.get(number) - off) <= SCATTER));
        return alike;
    }

    private static double median(NavigableMap<Integer, Double> of, Set<Integer> numbers) {
        return OrderStatistic.median(numbers.stream().mapToDouble(of::get).toArray());
    }
}
