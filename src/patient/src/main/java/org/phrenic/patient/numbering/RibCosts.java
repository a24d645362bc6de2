package org.phrenic.patient.numbering;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Side;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.numbering.VertebraHeights.VertebralEnd;
import org.phrenic.patient.segmentation.Segmentation;

/** Numbers of least cost for the ribs of a side, as {@link RibNumbering} says. */
final class RibCosts {
    private static final int RIBS = RibNumbering.RIBS;
    /** Weight of the labels' numbers where vertebrae are known. */
    private static final double VOTE = 0.5;
    /** Cost of a number without a rib between two ribs. */
    private static final double GAP = 0.3;
    /** Weight of the height above what is left of a rib whose vertebral end is cut off. */
    private static final double ABOVE_CUT = 0.2;

    /** Cost of leaving out a stray part: more than a rib costs that carries another number half way to the next. */
    private static final double LEFT_OUT = 2;

    /** The same where parts are left out of more than twelve alone. */
    private static final double NEVER = 1000;
    /** A part is as likely the stray one of a label as another that holds more than this share of its voxels. */
    private static final double LIKE = 1 / 3.0;
    /** Mean gain of ribs that go back to a number, of vertebrae (in their distances) and of votes. */
    private static final double CLEARLY = 0.5;

    private final Segmentation s;
    private final boolean isCommon;
    private final RibComponents components;
    private final VertebraHeights vertebrae;

    RibCosts(Segmentation s, RibComponents components, VertebraHeights vertebrae) {
        this.s = s;
        isCommon = s.names().stream().anyMatch(LabelTable::isRibs);
        this.components = components;
        this.vertebrae = vertebrae;
    }

    /**
     * Increasing numbers for ribs from top to bottom; 0 for a part that is left out. Of more than twelve as few as
     * possible are; of others, where the scan cuts off ribs of the side above or below, only those without which ribs
     * go back to the numbers of both labels and vertebrae. A side of which nothing is cut off keeps all.
     */
    int[] numbers(List<Integer> ribs, VertebralEnd[] ends, Side side) {
        int[] most = leastCost(ribs, ends, side, NEVER);
        if (!vertebrae.showThorax() || ribs.stream().noneMatch(this::isCut)) {
            return most;
        }
        int[] fewer = leastCost(ribs, ends, side, LEFT_OUT);
        int[] changed = IntStream.range(0, most.length)
                .filter(i -> fewer[i] > 0 && most[i] > 0 && fewer[i] != most[i])
                .toArray();
        double nearer = Arrays.stream(changed)
                .mapToDouble(i -> away(ends[ribs.get(i)], most[i]) - away(ends[ribs.get(i)], fewer[i]))
                .average()
                .orElse(0);
        double votes = Arrays.stream(changed)
                .mapToDouble(i -> vote(ribs.get(i), most[i], side) - vote(ribs.get(i), fewer[i], side))
                .average()
                .orElse(0);
        return Math.min(nearer, votes) > CLEARLY ? fewer : most;
    }

    /**
     * Increasing numbers of least total cost for ribs from top to bottom; 0 for a stray part that is left out.
     *
     * @param leftOut cost of leaving out a part, to which its size over that of the largest rib is added
     */
    private int[] leastCost(List<Integer> ribs, VertebralEnd[] ends, Side side, double leftOut) {
        int n = ribs.size();
        List<RibComponents.Rib> all = components.ribs();
        double largest =
                ribs.stream().mapToInt(i -> all.get(i).voxels.size()).max().orElse(1);
        // Of the ribs before the i-th, the last of which has a number, or 0 if none has.
        double[][] least = new double[n + 1][RIBS + 1];
        int[][] before = new int[n + 1][RIBS + 1];
        Arrays.fill(least[0], 1, RIBS + 1, Double.POSITIVE_INFINITY);
        for (int i = 0; i < n; i++) {
            RibComponents.Rib rib = all.get(ribs.get(i));
            boolean stray = components.isStray(rib, vertebrae.showThorax() ? LIKE : 1);
            double without = stray ? leftOut + rib.voxels.size() / largest : Double.POSITIVE_INFINITY;
            for (int number = 0; number <= RIBS; number++) {
                least[i + 1][number] = least[i][number] + without;
                before[i + 1][number] = number;
                double cost = number == 0 ? 0 : cost(ribs.get(i), ends, number, side);
                for (int above = 0; above < number; above++) {
                    double sum = least[i][above] + (above == 0 ? 0 : GAP * (number - above - 1)) + cost;
                    if (sum < least[i + 1][number]) {
                        least[i + 1][number] = sum;
                        before[i + 1][number] = above;
                    }
                }
            }
        }
        int[] numbers = new int[n];
        int number = lowest(least[n]);
        for (int i = n - 1; i >= 0; i--) {
            int above = before[i + 1][number];
            numbers[i] = above == number ? 0 : number;
            number = above;
        }
        return numbers;
    }

    /**
     * The number of the highest of ribs that follow each other, from the lowest one whose vertebral end the scan shows:
     * how far vertebrae lie from each other above the twelfth is then unknown.
     */
    int byLowest(List<Integer> ribs, VertebralEnd[] ends, Side side) {
        int n = ribs.size();
        int lowest = IntStream.iterate(n - 1, i -> i >= 0, i -> i - 1)
                .filter(i -> !ends[ribs.get(i)].isCut())
                .findFirst()
                .orElse(n - 1);
        return IntStream.rangeClosed(1, RIBS - n + 1)
                .boxed()
                .min(Comparator.comparingDouble(first -> cost(ribs.get(lowest), ends, first + lowest, side)))
                .orElseThrow();
    }

    private boolean isCut(int rib) {
        return (components.ribs().get(rib).ends & (s.endsToward(true) | s.endsToward(false))) != 0;
    }

    /** The number of least cost of the lowest rib; 0 if there are none. */
    private static int lowest(double[] least) {
        return IntStream.rangeClosed(0, RIBS)
                .boxed()
                .min(Comparator.comparingDouble(number -> least[number]))
                .orElseThrow();
    }

    private double cost(int rib, VertebralEnd[] ends, int number, Side side) {
        double vote = vote(rib, number, side);
        return !vertebrae.showThorax() && !(isCommon && vertebrae.areShown())
                ? vote
                : away(ends[rib], number) + VOTE * vote;
    }

    /** Share of a rib's voxels that carry another number. */
    private double vote(int rib, int number, Side side) {
        int segment = s.find(RibNumbering.name(number, side));
        return 1 - (segment > 0 ? components.ribs().get(rib).share(segment) : 0);
    }

    /** Distance of a vertebral end from the vertebra of a number, in vertebrae. */
    private double away(VertebralEnd end, int number) {
        double above = (vertebrae.at(number) - end.z()) / RibNumbering.VERTEBRA_MM;
        return Math.abs(above) * (end.isCut() && above > 0 ? ABOVE_CUT : 1);
    }
}
