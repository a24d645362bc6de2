package org.phrenic.patient.numbering;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.engine.math.OrderStatistic;
import org.phrenic.mesh.IntList;
import org.phrenic.patient.segmentation.Segmentation;
import org.phrenic.patient.segmentation.Specks;

/** Where the vertebrae of a volume lie, how they tilt to a side, and which of them each rib meets. */
final class VertebraVoxels {
    /** Length of the end of a rib, across the body, that is held against the vertebrae, mm. */
    private static final double END_MM = 30;
    /** Greatest distance of an end from the middle of its vertebra that tells which one it meets, mm. */
    private static final double NEAR_MM = 40;
    /** Greatest number of voxels of an end that are looked at. */
    private static final int SAMPLES = 60;
    /** Vertebrae above and below that of a rib's number that it may meet. */
    private static final int REACH = 2;
    /** Last rib that is looked at: the twelfth ends lower than its vertebra. */
    private static final int LAST = RibNumbering.RIBS - 1;
    /** Least share of some ribs that meet the vertebrae they should. */
    private static final double MOST = 0.75;

    private final Segmentation s;
    private final RibDeviations ribs;
    /** Voxels of each vertebra by level. */
    private final TreeMap<Integer, IntList> vertebrae = new TreeMap<>();

    private final TreeMap<Integer, Double> rises = new TreeMap<>();
    private final TreeMap<Integer, Double> middles = new TreeMap<>();
    /** Level of the vertebra that each rib meets, by segment. */
    private final TreeMap<Integer, OptionalInt> met = new TreeMap<>();

    /** @param specks voxels that are left out */
    VertebraVoxels(Segmentation s, RibDeviations ribs, Specks specks) {
        this.s = s;
        this.ribs = ribs;
        int[] levels = new int[s.names().size() + 1];
        for (String name : s.names()) {
            StructureName.parse(name)
                    .filter(n -> n.kind() == StructureKind.VERTEBRA)
                    .ifPresent(n -> levels[s.find(name)] = n.level());
        }
        for (int v = 0; v < s.voxels().length; v++) {
            int level = levels[s.segmentAt(v)];
            if (level > 0 && !specks.contain(v)) {
                vertebrae.computeIfAbsent(level, n -> new IntList()).add(v);
            }
        }
    }

    boolean show(int level) {
        return vertebrae.containsKey(level);
    }

    /** Mean x of a vertebra, mm. */
    double middle(int level) {
        return middles.computeIfAbsent(level, of -> mean(vertebrae.get(of), 0));
    }

    private double mean(IntList voxels, int axis) {
        return Arrays.stream(voxels.toArray())
                .mapToDouble(v -> s.coordinate(v, axis))
                .average()
                .orElseThrow();
    }

    /** How far a vertebra and its neighbours rise to the left, mm for each mm: the median of the three. */
    double tilt(int level) {
        return OrderStatistic.median(IntStream.rangeClosed(level - 1, level + 1)
                .filter(this::show)
                .mapToDouble(n -> rises.computeIfAbsent(n, of -> rise(vertebrae.get(of))))
                .toArray());
    }

    /** Coefficient of x in the regression of the heights of the anterior half of a vertebra on x and y. */
    private double rise(IntList vertebra) {
        double middle = mean(vertebra, 1);
        IntList voxels = new IntList();
        Arrays.stream(vertebra.toArray())
                .filter(v -> s.coordinate(v, 1) <= middle)
                .forEach(voxels::add);
        double[] sum = new double[3];
        double[][] products = new double[3][3];
        double[] origin = s.point(voxels.get(0));
        for (int i = 0; i < voxels.size(); i++) {
            double[] p = s.point(voxels.get(i));
            for (int a = 0; a < 3; a++) {
                sum[a] += p[a] - origin[a];
                for (int b = 0; b < 3; b++) {
                    products[a][b] += (p[a] - origin[a]) * (p[b] - origin[b]);
                }
            }
        }
        for (int a = 0; a < 3; a++) {
            for (int b = 0; b < 3; b++) {
                products[a][b] -= sum[a] * sum[b] / voxels.size();
            }
        }
        double determinant = products[0][0] * products[1][1] - products[0][1] * products[0][1];
        double rise = products[0][2] * products[1][1] - products[1][2] * products[0][1];
        return determinant > 0 ? rise / determinant : 0;
    }

    /** Whether most ribs of these numbers, of one side or both, meet the vertebra so many numbers lower. */
    boolean meet(List<Side> sides, int from, int to, int off) {
        int[] found = sides.stream()
                .flatMapToInt(side -> IntStream.rangeClosed(from, Math.min(LAST, to))
                        .flatMap(number -> vertebra(number, side).stream().map(level -> level - number)))
                .toArray();
        long alike = Arrays.stream(found).filter(n -> n == off).count();
        return found.length > 0 && alike >= MOST * found.length;
    }

    /** Greatest number of ribs of a side that meet one of two vertebrae. */
    long mostAt(int level, int other) {
        return Stream.of(Side.RIGHT, Side.LEFT)
                .mapToLong(side -> IntStream.rangeClosed(1, LAST)
                        .flatMap(number -> vertebra(number, side).stream())
                        .filter(met -> met == level || met == other)
                        .count())
                .max()
                .orElse(0);
    }

    /**
     * Height of the vertebral end of a rib across its vertebra, mm, from the height at its middle on where that is
     * tilted to a side; empty if the rib does not end beside it, or the volume lacks one of the two.
     */
    OptionalDouble end(int number, Side side) {
        int rib = ribs.rib(number, side);
        if (rib == 0 || !show(number) || nearest(ribs.voxels(rib), middle(number)) > NEAR_MM) {
            return OptionalDouble.empty();
        }
        // The x axis points to the patient's left.
        return ribs.vertebralEnd(ribs.voxels(rib), middle(number), tilt(number) * (side == Side.LEFT ? 1 : -1));
    }

    /**
     * Level of the vertebra that the end of a rib lies nearest to; empty if the rib does not end beside the spine, or
     * the volume lacks the vertebra of its number.
     */
    private OptionalInt vertebra(int number, Side side) {
        return met.computeIfAbsent(
                ribs.rib(number, side),
                rib -> end(number, side).isPresent()
                        ? OptionalInt.of(nearest(points(ribs.voxels(rib), middle(number)), number))
                        : OptionalInt.empty());
    }

    /** Least distance of the posterior half of a rib from a sagittal plane, mm. */
    private double nearest(IntList rib, double middle) {
        return posterior(rib)
                .mapToDouble(v -> Math.abs(s.coordinate(v, 0) - middle))
                .min()
                .orElse(Double.MAX_VALUE);
    }

    private IntStream posterior(IntList rib) {
        double centre = mean(rib, 1);
        return Arrays.stream(rib.toArray()).filter(v -> s.coordinate(v, 1) >= centre);
    }

    /** Points of the end of a rib. */
    private List<double[]> points(IntList rib, double middle) {
        double reach = nearest(rib, middle) + END_MM;
        int[] end = posterior(rib)
                .filter(v -> Math.abs(s.coordinate(v, 0) - middle) <= reach)
                .toArray();
        int samples = Math.min(SAMPLES, end.length);
        return IntStream.range(0, samples)
                .mapToObj(i -> s.point(end[(int) ((long) i * end.length / samples)]))
                .toList();
    }

    private int nearest(List<double[]> end, int number) {
        int best = number;
        double least = Double.POSITIVE_INFINITY;
        for (int level = Math.max(1, number - REACH); level <= number + REACH; level++) {
            double sum = show(level) ? distances(end, vertebrae.get(level)) : Double.POSITIVE_INFINITY;
            if (sum < least) {
                least = sum;
                best = level;
            }
        }
        return best;
    }

    private double distances(List<double[]> points, IntList voxels) {
        double[] squares = new double[points.size()];
        Arrays.fill(squares, Double.POSITIVE_INFINITY);
        for (int i = 0; i < voxels.size(); i++) {
            double[] q = s.point(voxels.get(i));
            for (int n = 0; n < squares.length; n++) {
                double[] p = points.get(n);
                double x = p[0] - q[0];
                double y = p[1] - q[1];
                double z = p[2] - q[2];
                squares[n] = Math.min(squares[n], x * x + y * y + z * z);
            }
        }
        return Arrays.stream(squares).map(Math::sqrt).sum();
    }
}
