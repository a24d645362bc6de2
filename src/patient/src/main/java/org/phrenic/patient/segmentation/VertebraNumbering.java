package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;

/**
 * Numbers of vertebrae that are one off those of the ribs, a frequent error of segmentations. It is seen in the lower
 * ribs: how far the vertebral end of a rib lies from the vertebra of its number, in parts of the distance of vertebrae.
 * The ribs are right if all twelve of a side are there, or if the scan cuts off the first ones and the twelfth is as
 * short as a last rib ({@link CutRibCount}). Then the vertebrae are numbered anew, else the ribs.
 */
final class VertebraNumbering {
    /** First rib that is looked at. */
    private static final int FIRST = 7;
    /**
     * Height of the vertebra above the vertebral end of ribs 7 to 12, in distances of vertebrae: means of two trunks,
     * the scanned man and the virtual woman, each within 0.25 of it.
     */
    private static final double[] USUAL = {-0.47, -0.42, -0.33, -0.25, 0.05, 0.5};

    private static final int LEAST_RIBS = 4;
    /** Numbers are one off if the median of the ribs deviates by so much, and most ribs are near to it. */
    private static final double LEAST_DEVIATION = 0.65;

    private static final double MOST_DEVIATION = 1.35;
    private static final double SCATTER = 0.5;
    private static final double MOST = 0.75;
    private static final List<String> SPINE = IntStream.range(0, 24)
            .mapToObj(i -> String.format(
                    Locale.ROOT,
                    i < 7 ? "vertebra_C%d" : i < 19 ? "vertebra_T%02d" : "vertebra_L%02d",
                    i < 7 ? i + 1 : i < 19 ? i - 6 : i - 18))
            .toList();

    private final Segmentation s;
    /** Voxels of each rib, by segment. */
    private final TreeMap<Integer, List<double[]>> ribs = new TreeMap<>();

    /** The ends of the scan that each rib reaches, as {@link Segmentation#ends}. */
    private final TreeMap<Integer, Integer> ends = new TreeMap<>();

    private final boolean[][] isThere = new boolean[2][RibNumbering.RIBS + 1];

    private VertebraNumbering(Segmentation s) {
        this.s = s;
    }

    /**
     * Numbers the vertebrae or the ribs anew if they are one off each other.
     *
     * @return a note if they were
     */
    static Optional<String> check(Segmentation s) {
        boolean known = s.names().stream()
                .flatMap(name -> StructureName.parse(name).stream())
                .anyMatch(name -> name.kind() == StructureKind.VERTEBRA && name.level() <= RibNumbering.RIBS);
        return known ? new VertebraNumbering(s).check() : Optional.empty();
    }

    private Optional<String> check() {
        StructureName[] names = s.names().stream()
                .map(name -> StructureName.parse(name).orElse(new StructureName(StructureKind.OTHER, 0, Side.MIDLINE)))
                .toArray(StructureName[]::new);
        double sumX = 0;
        int vertebral = 0;
        for (int v = 0; v < s.voxels.length; v++) {
            int segment = s.segmentAt(v);
            if (segment == 0) {
                continue;
            }
            StructureName name = names[segment - 1];
            if (name.kind() == StructureKind.VERTEBRA) {
                sumX += s.coordinate(v, 0);
                vertebral++;
            } else if (name.kind() == StructureKind.RIB) {
                enter(v, segment, name);
            }
        }
        int slip = vertebral == 0 ? 0 : slip(names, sumX / vertebral);
        if (slip == 0) {
            return Optional.empty();
        }
        String where = slip > 0 ? "above" : "below";
        if (!ribsAreRight(names)) {
            return Optional.of(RibNumbering.renumber(s, "ribs, whose vertebrae lie one " + where + " their numbers"));
        }
        shift(-slip);
        return Optional.of("the vertebrae lie one " + where + " the ribs of their numbers: they are numbered anew, "
                + (slip > 0 ? "vertebra_L01 is vertebra_T12" : "vertebra_T12 is vertebra_L01") + " now");
    }

    private void enter(int voxel, int segment, StructureName name) {
        isThere[name.side() == Side.RIGHT ? 0 : 1][name.level()] = true;
        ends.merge(segment, s.ends(voxel), (a, b) -> a | b);
        if (name.level() >= FIRST) {
            ribs.computeIfAbsent(segment, number -> new ArrayList<>()).add(s.point(voxel));
        }
    }

    /** 1 if the vertebrae lie one above the ribs of their numbers, -1 if one below, otherwise 0. */
    private int slip(StructureName[] names, double middle) {
        double[] height = VertebraHeights.of(s);
        double[] deviation = ribs.entrySet().stream()
                .filter(rib -> ends.get(rib.getKey()) == 0)
                .flatMapToDouble(rib -> {
                    int number = names[rib.getKey() - 1].level();
                    double spacing = (height[FIRST] - height[RibNumbering.RIBS]) / (RibNumbering.RIBS - FIRST);
                    OptionalDouble end = vertebralEnd(rib.getValue(), middle);
                    return end.stream().map(z -> (height[number] - z) / spacing - USUAL[number - FIRST]);
                })
                .sorted()
                .toArray();
        if (deviation.length < LEAST_RIBS) {
            return 0;
        }
        double median = deviation[deviation.length / 2];
        long near = Arrays.stream(deviation)
                .filter(d -> Math.abs(d - median) < SCATTER)
                .count();
        boolean off = Math.abs(median) > LEAST_DEVIATION && Math.abs(median) < MOST_DEVIATION;
        return off && near >= MOST * deviation.length ? (int) Math.signum(median) : 0;
    }

    /** Height of the end of a rib toward the spine, mm; empty if it is far from it. */
    private static OptionalDouble vertebralEnd(List<double[]> voxels, double middle) {
        double y = voxels.stream().mapToDouble(p -> p[1]).average().orElseThrow();
        List<double[]> posterior = voxels.stream()
                .filter(p -> p[1] >= y)
                .map(p -> new double[] {Math.abs(p[0] - middle), p[2]})
                .toList();
        boolean isShown = posterior.stream().anyMatch(p -> p[0] < RibNumbering.HEAD_MM);
        return isShown ? RibNumbering.endHeight(posterior, voxels.size()) : OptionalDouble.empty();
    }

    private boolean ribsAreRight(StructureName[] names) {
        for (boolean[] side : isThere) {
            if (IntStream.rangeClosed(1, RibNumbering.RIBS).allMatch(number -> side[number])) {
                return true;
            }
        }
        boolean cutAbove = ends.values().stream().anyMatch(at -> (at & s.endsToward(true)) != 0);
        return cutAbove && lastIsShort(names);
    }

    /** Whether a rib with the number twelve is as short beside the eleventh as the twelfth is. */
    private boolean lastIsShort(StructureName[] names) {
        double[][] length = new double[2][RibNumbering.RIBS + 1];
        ribs.forEach((segment, voxels) -> {
            StructureName name = names[segment - 1];
            boolean cut = (ends.get(segment) & s.endsToward(false)) != 0;
            length[name.side() == Side.RIGHT ? 0 : 1][name.level()] = cut ? 0 : diagonal(voxels);
        });
        return Arrays.stream(length)
                .anyMatch(side -> side[RibNumbering.RIBS] > 0
                        && side[RibNumbering.RIBS] < CutRibCount.SHORT * side[RibNumbering.RIBS - 1]);
    }

    /** Diagonal of the box of some points, mm. */
    private static double diagonal(List<double[]> points) {
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            int along = axis;
            DoubleSummaryStatistics range =
                    points.stream().mapToDouble(p -> p[along]).summaryStatistics();
            square += (range.getMax() - range.getMin()) * (range.getMax() - range.getMin());
        }
        return Math.sqrt(square);
    }

    /** Gives each vertebra the name of the one so many below it; what is beyond the fifth lumbar one is sacral. */
    private void shift(int down) {
        byte[] segment = new byte[s.names().size() + 1];
        TreeMap<String, List<Integer>> labels = new TreeMap<>();
        for (int i = 1; i < segment.length; i++) {
            segment[i] = (byte) i;
        }
        for (String name : List.copyOf(s.names())) {
            int at = SPINE.indexOf(name);
            if (at >= 0) {
                int to = Math.max(0, at + down);
                String now = to < SPINE.size() ? SPINE.get(to) : "vertebra_S1";
                labels.computeIfAbsent(now, n -> new ArrayList<>()).addAll(s.labels(name));
                segment[s.find(name)] = (byte) s.segment(now);
            }
        }
        for (int v = 0; v < s.voxels.length; v++) {
            s.voxels[v] = segment[s.segmentAt(v)];
        }
        labels.forEach(s::setLabels);
    }
}
