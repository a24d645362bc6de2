package org.phrenic.patient.numbering;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.TreeMap;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.mesh.IntList;
import org.phrenic.patient.segmentation.Segmentation;
import org.phrenic.patient.segmentation.Specks;

/**
 * How far the vertebral ends of the ribs of a volume lie from the vertebrae of their numbers, in parts of the distance
 * of vertebrae.
 */
final class RibDeviations {
    /** First rib that is looked at, but for those above a fault within the spine. */
    static final int FIRST = 7;

    static final int FIRST_ABOVE = 2;
    /**
     * Height of the vertebra above the vertebral end of ribs 7 to 12, in distances of vertebrae: means of two trunks,
     * the scanned man and the virtual woman, each within 0.25 of it.
     */
    private static final double[] USUAL = {-0.47, -0.42, -0.33, -0.25, 0.05, 0.5};

    /** The same of ribs 2 to 6 in these and a trunk at inspiration, each within 0.55. */
    private static final double USUAL_ABOVE = -0.5;

    /**
     * Distance from the median plane to which ends of ribs are continued, mm: about that of the transverse processes.
     * In these trunks ribs 7 to 11 end 12 to 27 mm from it, ribs 12 at 35 mm, and are nearly level up to there.
     */
    private static final double USUAL_END_MM = 30;
    /**
     * Fall of ribs 7 to 12 beyond that distance, mm for each mm away from the median plane. Between 30 and 60 mm it is
     * 0.55 in the virtual woman and 0.74 in the scanned man; ribs of other bodies are flatter, with 0.47 (the virtual
     * man), 0.46 (a scanned trunk), 0.1 and 0.2 (two people at inspiration). With 0.5, no right numbers are taken for
     * wrong in 60 scans of the four with a spine, in which ribs end up to 20 mm beside it and which lean by up to 11
     * degrees; with 0.6 one is, with 0 eleven are.
     */
    private static final double FALL = 0.5;

    private static final int LEAST_RIBS = 4;
    /** Numbers are one off if the median of the ribs deviates by so much, and most ribs are near to it. */
    private static final double LEAST_DEVIATION = 0.65;

    private static final double MOST_DEVIATION = 1.35;
    /** The same beside vertebrae whose heights show a fault. */
    private static final double LEAST_BESIDE_FAULT = 0.55;

    private static final double MOST_BESIDE_FAULT = 1.45;
    private static final double SCATTER = 0.5;
    private static final double MOST = 0.75;

    private final Segmentation s;
    /** Name of each segment. */
    private final StructureName[] names;
    /** Voxels of each rib, by segment. */
    private final TreeMap<Integer, IntList> ribs = new TreeMap<>();
    /** The ends of the scan that each rib reaches, as {@link Segmentation#ends}. */
    private final TreeMap<Integer, Integer> ends = new TreeMap<>();
    /** Least number of voxels of a rib that is no speck. */
    private final double leastVoxels;
    /** x of the spine, mm; NaN if there is no vertebra. */
    private final double middle;

    /** @param specks voxels that are left out */
    RibDeviations(Segmentation s, Specks specks) {
        this.s = s;
        names = VertebraNumbering.names(s);
        double sumX = 0;
        int vertebral = 0;
        for (int v = 0; v < s.voxels().length; v++) {
            int segment = s.segmentAt(v);
            if (segment == 0 || specks.contain(v)) {
                continue;
            }
            if (names[segment].kind() == StructureKind.VERTEBRA) {
                sumX += s.coordinate(v, 0);
                vertebral++;
            } else if (names[segment].kind() == StructureKind.RIB) {
                ribs.computeIfAbsent(segment, rib -> new IntList()).add(v);
                ends.merge(segment, s.ends(v), (a, b) -> a | b);
            }
        }
        middle = sumX / vertebral;
        int[] sizes = ribs.values().stream().mapToInt(IntList::size).sorted().toArray();
        leastVoxels = ribs.isEmpty() ? 0 : Specks.SHARE_OF_RIB * sizes[sizes.length / 2];
    }

    /** Whether the volume shows vertebrae and ribs. */
    boolean areKnown() {
        return !Double.isNaN(middle) && !ribs.isEmpty();
    }

    /** Segment of a rib; 0 if it is not there or no more than a speck. */
    int rib(int number, Side side) {
        return ribs.keySet().stream()
                .filter(segment -> names[segment].level() == number && names[segment].side() == side)
                .filter(segment -> ribs.get(segment).size() >= leastVoxels)
                .findFirst()
                .orElse(0);
    }

    IntList voxels(int rib) {
        return ribs.get(rib);
    }

    /** The ends of the scan that a rib reaches, as {@link Segmentation#ends}. */
    int ends(int rib) {
        return ends.get(rib);
    }

    /** Whether the scan cuts off a rib above. */
    boolean areCutAbove() {
        return ends.values().stream().anyMatch(at -> (at & s.endsToward(true)) != 0);
    }

    /** By how many numbers the ribs of these numbers are off; 0 for less than two. */
    long off(VertebraHeights height, int from, int to) {
        double[] deviations = of(height, from, to);
        return deviations.length < 2 ? 0 : Math.round(median(deviations));
    }

    private static double median(double[] sorted) {
        return sorted[sorted.length / 2];
    }

    /**
     * How far the ribs of these numbers deviate from the vertebrae of theirs, in distances of vertebrae, in ascending
     * order.
     */
    private double[] of(VertebraHeights height, int from, int to) {
        double spacing = (height.at(FIRST) - height.at(RibNumbering.RIBS)) / (RibNumbering.RIBS - FIRST);
        return ribs.entrySet().stream()
                .filter(rib -> names[rib.getKey()].level() >= from && names[rib.getKey()].level() <= to)
                .flatMapToDouble(rib -> {
                    int number = names[rib.getKey()].level();
                    OptionalDouble end = vertebralEnd(rib.getValue());
                    return end.stream().map(z -> (height.at(number) - z) / spacing - usual(number));
                })
                .sorted()
                .toArray();
    }

    /** Usual height of the vertebra of a number above the vertebral end of the rib, in distances of vertebrae. */
    static double usual(int number) {
        return number < FIRST ? USUAL_ABOVE : USUAL[number - FIRST];
    }

    /** 1 if the vertebrae lie one above the ribs of their numbers, -1 if one below, otherwise 0. */
    int slip(VertebraHeights height) {
        double[] deviation = of(height, FIRST, RibNumbering.RIBS);
        return deviation.length < LEAST_RIBS ? 0 : slip(deviation, LEAST_DEVIATION, MOST_DEVIATION);
    }

    /** By how many numbers the ribs of these numbers are off, which deviate alike; empty for less than two. */
    OptionalInt slip(VertebraHeights height, int from, int to) {
        double[] deviation = of(height, from, to);
        return deviation.length < 2
                ? OptionalInt.empty()
                : OptionalInt.of(slip(deviation, LEAST_BESIDE_FAULT, MOST_BESIDE_FAULT));
    }

    private static int slip(double[] deviation, double least, double most) {
        double median = median(deviation);
        long near = Arrays.stream(deviation)
                .filter(d -> Math.abs(d - median) < SCATTER)
                .count();
        boolean off = Math.abs(median) > least && Math.abs(median) < most;
        return off && near >= MOST * deviation.length ? (int) Math.signum(median) : 0;
    }

    /**
     * Height of the end of a rib toward the spine, mm, continued to the usual distance from the median plane; empty if
     * it is far from it or the scan ends there.
     */
    OptionalDouble vertebralEnd(IntList voxels) {
        return vertebralEnd(voxels, middle, 0);
    }

    /**
     * The same beside a vertebra that is tilted to a side.
     *
     * @param middle x of the vertebra, mm
     * @param rise of the vertebra toward the side of the rib, mm for each mm, by which the end is lowered
     */
    OptionalDouble vertebralEnd(IntList voxels, double middle, double rise) {
        double y = 0;
        for (int i = 0; i < voxels.size(); i++) {
            y += s.coordinate(voxels.get(i), 1) / voxels.size();
        }
        List<double[]> posterior = VertebraHeights.posterior(s, voxels, y, middle);
        posterior.forEach(p -> p[1] += FALL * Math.max(0, p[0] - USUAL_END_MM) - rise * p[0]);
        return VertebraHeights.isFarFromSpine(posterior) || VertebraHeights.isEndCut(posterior, voxels.size())
                ? OptionalDouble.empty()
                : VertebraHeights.endHeight(posterior, voxels.size());
    }
}
