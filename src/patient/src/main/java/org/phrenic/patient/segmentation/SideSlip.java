package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import org.phrenic.anatomy.Side;
import org.phrenic.engine.math.OrderStatistic;

/**
 * Ribs of one side whose numbers are one off, all of them or some that follow each other, while those of the other side
 * fit the vertebrae. It is seen in the heights of the vertebral ends of both ribs of a number.
 */
final class SideSlip {
    /** Fewest ribs of a side that follow each other and are one off. */
    private static final int LEAST_RIBS = 3;
    /** Two ribs of a number are one or none off each other to this share of a distance of vertebrae. */
    private static final double SCATTER = 0.4;
    /** The same of the ribs of a side and their vertebrae. */
    private static final double FIT = 0.5;
    /** Least share of the ribs of both sides that are one or none off each other. */
    private static final double MOST = 0.75;

    private final Segmentation s;
    private final RibDeviations ribs;
    private final VertebraHeights height;
    private final Side side;
    /** By number, in distances of vertebrae. */
    private final TreeMap<Integer, Double> deviations;

    private final TreeMap<Integer, Double> ofOther;

    private SideSlip(Segmentation s, RibDeviations ribs, Side side) {
        this.s = s;
        this.ribs = ribs;
        this.side = side;
        height = new VertebraHeights(s);
        deviations = deviations(side);
        ofOther = deviations(side == Side.RIGHT ? Side.LEFT : Side.RIGHT);
        deviations.keySet().retainAll(ofOther.keySet());
        ofOther.keySet().retainAll(deviations.keySet());
    }

    /**
     * Numbers anew the ribs of a side that are one off.
     *
     * @return a note if there are some
     */
    static Optional<String> mend(Segmentation s, RibDeviations ribs) {
        SideSlip right = new SideSlip(s, ribs, Side.RIGHT);
        SideSlip left = new SideSlip(s, ribs, Side.LEFT);
        return right.mend(-1).or(() -> right.mend(1)).or(() -> left.mend(-1)).or(() -> left.mend(1));
    }

    private TreeMap<Integer, Double> deviations(Side of) {
        TreeMap<Integer, Double> all = new TreeMap<>();
        for (int number = 1; number <= RibNumbering.RIBS; number++) {
            int level = number;
            int rib = ribs.rib(number, of);
            if (rib > 0) {
                ribs.vertebralEnd(ribs.voxels(rib))
                        .ifPresent(z -> all.put(level, (height.ribEnd(level) - z) / height.spacing(level)));
            }
        }
        return all;
    }

    /** @param off by how many numbers the ribs may be too low */
    private Optional<String> mend(int off) {
        TreeSet<Integer> run = alike(off);
        TreeSet<Integer> right = alike(0);
        boolean between =
                !run.isEmpty() && !right.subSet(run.first(), run.last()).isEmpty();
        if (run.size() < LEAST_RIBS
                || between
                || run.size() + right.size() < MOST * deviations.size()
                || Math.abs(median(deviations, run) - off) > FIT
                || Math.abs(median(ofOther, run)) > FIT) {
            return Optional.empty();
        }
        List<Integer> moved = new ArrayList<>();
        TreeSet<Integer> numbers = new TreeSet<>();
        int all = 0;
        for (int number = 1; number <= RibNumbering.RIBS; number++) {
            if (ribs.rib(number, side) > 0) {
                all++;
                boolean moves = distance(run, number) < distance(right, number);
                numbers.add(moves ? number + off : number);
                if (moves) {
                    moved.add(number);
                }
            }
        }
        boolean fits = numbers.size() == all && numbers.first() > 0 && numbers.last() <= RibNumbering.RIBS;
        return fits ? Optional.of(move(moved, off)) : Optional.empty();
    }

    /** The numbers whose ribs of this side are so many lower than those of the other one. */
    private TreeSet<Integer> alike(int off) {
        TreeSet<Integer> alike = new TreeSet<>(deviations.keySet());
        alike.removeIf(number -> Math.abs(deviations.get(number) - ofOther.get(number) - off) > SCATTER);
        return alike;
    }

    private static double median(TreeMap<Integer, Double> of, TreeSet<Integer> numbers) {
        return OrderStatistic.median(numbers.stream().mapToDouble(of::get).toArray());
    }

    private static int distance(TreeSet<Integer> numbers, int number) {
        return numbers.stream().mapToInt(n -> Math.abs(n - number)).min().orElse(Integer.MAX_VALUE);
    }

    private String move(List<Integer> moved, int off) {
        byte[] segment = new byte[s.names().size() + 1];
        for (int i = 0; i < segment.length; i++) {
            segment[i] = (byte) i;
        }
        TreeMap<String, List<Integer>> labels = new TreeMap<>();
        for (int number : moved) {
            String name = RibNumbering.name(number, side);
            String now = RibNumbering.name(number + off, side);
            labels.put(now, s.labels(name));
            segment[s.find(name)] = (byte) s.segment(now);
        }
        for (int v = 0; v < s.voxels.length; v++) {
            s.voxels[v] = segment[s.segmentAt(v)];
        }
        labels.forEach(s::setLabels);
        int first = moved.get(0);
        int last = moved.get(moved.size() - 1);
        String here = side.name().toLowerCase(Locale.ROOT);
        String there = (side == Side.RIGHT ? Side.LEFT : Side.RIGHT).name().toLowerCase(Locale.ROOT);
        return here + " ribs " + first + " to " + last + " begin at the vertebrae one " + (off < 0 ? "above" : "below")
                + " their numbers, " + there + " ones at theirs: they are numbered " + (first + off) + " to "
                + (last + off);
    }
}
