package org.phrenic.patient.numbering;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.phrenic.anatomy.Side;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.segmentation.LungPieces.LungVoxels;
import org.phrenic.patient.segmentation.NearVoxels;
import org.phrenic.patient.segmentation.Segmentation;
import org.phrenic.patient.segmentation.VoxelRuns;

/**
 * Separates ribs, sternum and spine where all bones share a label. The spine is followed up and down from the middle of
 * the lungs ({@link SpineAxis}). Of the other bones, connected parts that begin beside it, as long and as large as
 * ribs, are the ribs, counted from the first, whose vertebral end is as high as the apex of the lung and which is short
 * beside the second; parts in front of the lungs in the middle are the sternum. In a scan that cuts the upper ribs off,
 * so are the anterior parts that end at its top, and {@link RibNumbering} counts them from the last. The rest keeps the
 * common label. Both lungs have labels of their own.
 */
final class SkeletonSplitter {
    private static final String STERNUM = "sternum";

    /** Greatest distance of a rib's vertebral end from the axis of the spine, mm. */
    private static final double BESIDE_MM = 50;

    private static final double LEAST_LENGTH_MM = 50;
    private static final double LEAST_ML = 1.2;
    private static final double MOST_ML = 60;
    /** Ribs' centres lie between so far below and above the lungs, mm. */
    private static final double BELOW_MM = 110;

    private static final double ABOVE_MM = 30;
    /** The sternum lies within this distance of the median plane, mm, and is at least so high. */
    private static final double STERNUM_MM = 40;

    private static final double STERNUM_HEIGHT_MM = 60;
    /** Half the width of the strip that is cut from bones that touch the sternum, mm. */
    private static final double STRIP_MM = 30;

    private static final String NEAR_LUNGS = "bone_near_lungs";
    private static final String IN_FRONT = "bone_in_front";
    /** Least height of the first rib's vertebral end above the apex of the lung, mm. */
    private static final double FIRST_ABOVE_APEX_MM = -12;

    /**
     * Length of the first rib over that of the second from end to end, 0.49 to 0.69 in five bodies; that of the second
     * over the third is 0.78 to 0.84.
     */
    private static final double FIRST_SHORT = 0.735;

    /** Least length of what a scan leaves of a rib, mm, and least height of what it leaves of a sternum. */
    private static final double LEAST_CUT_MM = 20;
    /** Least length beside the spine of the last rib of a scan that cuts others off, mm. */
    private static final double LEAST_LAST_MM = 35;
    /** Least number of ribs of a side in a scan that cuts others off, and of those shown with their vertebral ends. */
    private static final int LEAST_SHOWN = 4;

    private static final int LEAST_WHOLE = 2;
    /** Least depth of the spine below the last rib in a scan that shows it, mm. */
    private static final double BELOW_LAST_MM = 20;

    private static final int LEAST_RIBS = 8;
    private static final int MOST_RIBS = 12;
    /** Greatest distance of two neighbouring vertebral ends over the median distance. */
    private static final double REGULAR = 1.7;

    private final Segmentation s;
    private final SpineAxis spine;
    private final Map<Side, LungVoxels> lungs;

    /**
     * A connected part of the bones beside the spine.
     *
     * @param foremost least y, mm
     * @param ends ends of the volume that it reaches, as {@link Segmentation#ends}
     */
    private record Part(
            IntList voxels, double[] centre, double[] extent, double foremost, double besideMm, double endZ, int ends) {
        double length() {
            return StrictMath.hypot(StrictMath.hypot(extent[0], extent[1]), extent[2]);
        }
    }

    private SkeletonSplitter(Segmentation s, SpineAxis spine, Map<Side, LungVoxels> lungs) {
        this.s = s;
        this.spine = spine;
        this.lungs = lungs;
    }

    /**
     * Separates the bones.
     *
     * @return a note; empty if no bones share a label or ribs have labels of their own
     */
    static Optional<String> split(Segmentation s) {
        int all = s.find(LabelTable.ALL_BONES);
        boolean hasRibs = s.names().stream().anyMatch(name -> name.startsWith("rib"));
        if (all == 0 || hasRibs) {
            return Optional.empty();
        }
        Map<Side, LungVoxels> lungs = new EnumMap<>(Side.class);
        LungVoxels.of(s, "lung_R").ifPresent(lung -> lungs.put(Side.RIGHT, lung));
        LungVoxels.of(s, "lung_L").ifPresent(lung -> lungs.put(Side.LEFT, lung));
        Optional<SpineAxis> axis = lungs.size() == 2
                ? SpineAxis.of(
                        s,
                        all,
                        lungs.get(Side.RIGHT).centre(),
                        lungs.get(Side.LEFT).centre())
                : Optional.empty();
        return Optional.of(axis.flatMap(spine -> new SkeletonSplitter(s, spine, lungs).split(all))
                .orElse("bones under one label: ribs are not told apart; they are an obstacle and do not shape the"
                        + " cage"));
    }

    private Optional<String> split(int all) {
        byte[] before = s.voxels().clone();
        int ofSpine = s.segment(LabelTable.SPINE);
        double lowest = Double.POSITIVE_INFINITY;
        for (int v = 0; v < s.voxels().length; v++) {
            if (s.segmentAt(v) == all && spine.contains(s, v)) {
                s.voxels()[v] = (byte) ofSpine;
                lowest = Math.min(lowest, s.coordinate(v, 2));
            }
        }
        List<Part> parts = new ArrayList<>(parts(all));
        parts.addAll(dividedParts(parts, all));
        List<Part> right = wholeRibs(parts, Side.RIGHT);
        List<Part> left = wholeRibs(parts, Side.LEFT);
        boolean whole =
                isCage(right, Side.RIGHT) && isCage(left, Side.LEFT) && Math.abs(right.size() - left.size()) <= 1;
        if (whole) {
            name(right, Side.RIGHT);
            name(left, Side.LEFT);
        } else {
            right = cutRibs(parts, Side.RIGHT);
            left = cutRibs(parts, Side.LEFT);
            if (!isLowerCage(right, lowest) || !isLowerCage(left, lowest) || Math.abs(right.size() - left.size()) > 2) {
                System.arraycopy(before, 0, s.voxels(), 0, before.length);
                return Optional.empty();
            }
            int ribs = s.segment(LabelTable.RIBS);
            Stream.concat(right.stream(), left.stream()).forEach(part -> s.write(part.voxels(), ribs));
            s.inheritFrom(LabelTable.RIBS, LabelTable.ALL_BONES);
        }
        s.inheritFrom(LabelTable.SPINE, LabelTable.ALL_BONES);
        boolean sternum = false;
        for (Part part : parts) {
            if (isSternum(part)) {
                s.write(part.voxels(), s.segment(STERNUM));
                s.inheritFrom(STERNUM, LabelTable.ALL_BONES);
                sternum = true;
            }
        }
        return Optional.of("bones under one label: " + (right.size() + left.size()) + " ribs are "
                + (whole ? "counted from the first" : "told apart")
                + (sternum ? ", sternum and spine are" : ", the spine is") + " separated");
    }

    /** The ribs of a side in a scan that cuts the upper ones off. */
    private List<Part> cutRibs(List<Part> parts, Side side) {
        return ribs(
                parts,
                side,
                part -> isCutAbove(part)
                        ? part.length() > LEAST_CUT_MM && isInFront(part.foremost()) && !isSternum(part)
                        : part.besideMm() < BESIDE_MM && part.length() > LEAST_LAST_MM);
    }

    private boolean isCutAbove(Part part) {
        return (part.ends() & s.endsToward(true)) != 0;
    }

    /**
     * Whether these are the last ribs of a side, none missing between those with a vertebral end.
     *
     * @param lowest height of the lower end of the spine, mm
     */
    private boolean isLowerCage(List<Part> ribs, double lowest) {
        List<Part> whole = ribs.stream().filter(part -> !isCutAbove(part)).toList();
        boolean cutBelow = ribs.stream().anyMatch(part -> (part.ends() & s.endsToward(false)) != 0);
        if (cutBelow
                || whole.size() < LEAST_WHOLE
                || whole.size() == ribs.size()
                || ribs.size() < LEAST_SHOWN
                || ribs.size() > MOST_RIBS) {
            return false;
        }
        return isRegular(whole) && whole.get(whole.size() - 1).endZ() > lowest + BELOW_LAST_MM;
    }

    /** Whether the vertebral ends of ribs follow each other at nearly equal distances. */
    private static boolean isRegular(List<Part> ribs) {
        double[] steps = new double[ribs.size() - 1];
        for (int i = 0; i < steps.length; i++) {
            steps[i] = ribs.get(i).endZ() - ribs.get(i + 1).endZ();
        }
        double[] sorted = steps.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length - 1] < REGULAR * sorted[sorted.length / 2];
    }

    /** Parts of those that are larger than a rib: near the lungs, and in the middle in front of them. */
    private List<Part> dividedParts(List<Part> parts, int all) {
        NearVoxels near = new NearVoxels(s, List.of(s.find("lung_R"), s.find("lung_L")));
        int nearLungs = s.segment(NEAR_LUNGS);
        int inFront = s.segment(IN_FRONT);
        for (Part part : parts) {
            if (part.voxels().size() < most()
                    || part.centre()[2] < lungs.get(Side.RIGHT).lowest() - BELOW_MM) {
                continue;
            }
            for (int i = 0; i < part.voxels().size(); i++) {
                int v = part.voxels().get(i);
                double[] p = s.point(v);
                boolean middle = spine.beside(p) < STRIP_MM && isInFront(p[1]);
                if (middle || near.isNear(p)) {
                    s.voxels()[v] = (byte) (middle ? inFront : nearLungs);
                }
            }
        }
        List<Part> divided = new ArrayList<>(parts(nearLungs));
        divided.addAll(parts(inFront));
        for (int v = 0; v < s.voxels().length; v++) {
            int segment = s.segmentAt(v);
            s.voxels()[v] = (byte) (segment == nearLungs || segment == inFront ? all : segment);
        }
        return divided;
    }

    private double most() {
        return MOST_ML * 1000 / s.grid().voxelVolume();
    }

    private boolean isInFront(double y) {
        return y
                < 0.5
                        * (lungs.get(Side.RIGHT).centre()[1]
                                + lungs.get(Side.LEFT).centre()[1]);
    }

    private void name(List<Part> ribs, Side side) {
        for (int i = 0; i < ribs.size(); i++) {
            String name = RibNumbering.name(i + 1, side);
            s.write(ribs.get(i).voxels(), s.segment(name));
            s.inheritFrom(name, LabelTable.ALL_BONES);
        }
    }

    private List<Part> parts(int all) {
        byte[] group = new byte[LabelGrid.MAX_BYTE_LABEL + 1];
        group[all] = 1;
        VoxelRuns runs = new VoxelRuns(s, group, false);
        double least = LEAST_ML * 1000 / s.grid().voxelVolume();
        return runs.voxels(run -> runs.size(runs.component(run)) >= least).values().stream()
                .map(this::part)
                .toList();
    }

    private Part part(IntList voxels) {
        int n = voxels.size();
        double[] centre = new double[3];
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        int ends = 0;
        List<double[]> posterior = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            ends |= s.ends(voxels.get(i));
            double[] p = s.point(voxels.get(i));
            for (int axis = 0; axis < 3; axis++) {
                centre[axis] += p[axis] / n;
                low[axis] = Math.min(low[axis], p[axis]);
                high[axis] = Math.max(high[axis], p[axis]);
            }
            if (spine.isBehindFront(p)) {
                posterior.add(new double[] {spine.beside(p), p[2]});
            }
        }
        double endZ = VertebraHeights.endHeight(posterior, n).orElse(Double.NaN);
        double beside = posterior.stream().mapToDouble(p -> p[0]).min().orElse(Double.POSITIVE_INFINITY);
        double[] extent = {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
        return new Part(voxels, centre, extent, low[1], beside, endZ, ends);
    }

    /** The ribs of a side in a scan that shows them all. */
    private List<Part> wholeRibs(List<Part> parts, Side side) {
        double top =
                Math.max(lungs.get(Side.RIGHT).highest(), lungs.get(Side.LEFT).highest()) + ABOVE_MM;
        return ribs(
                parts,
                side,
                part -> part.besideMm() < BESIDE_MM && part.length() > LEAST_LENGTH_MM && part.centre()[2] < top);
    }

    /** The parts of a side that are no larger than ribs and as high as these, from top to bottom of their ends. */
    private List<Part> ribs(List<Part> parts, Side side, Predicate<Part> isRib) {
        double bottom =
                Math.min(lungs.get(Side.RIGHT).lowest(), lungs.get(Side.LEFT).lowest()) - BELOW_MM;
        return parts.stream()
                .filter(part -> part.voxels().size() < most() && part.centre()[2] > bottom)
                .filter(isRib)
                .filter(part -> spine.isRight(part.centre()) == (side == Side.RIGHT))
                .sorted(Comparator.comparingDouble((Part part) -> -part.endZ()))
                .toList();
    }

    /**
     * Whether these are all ribs from the first on: it is as high as the apex of the lung and short beside the second,
     * and none is missing between.
     */
    private boolean isCage(List<Part> ribs, Side side) {
        if (ribs.size() < LEAST_RIBS || ribs.size() > MOST_RIBS) {
            return false;
        }
        Part first = ribs.get(0);
        return isRegular(ribs) && isFirst(first.length(), ribs.get(1).length(), first.endZ(), lungs.get(side));
    }

    /**
     * Whether a rib is the first one: as short beside the next, and as high as the apex of a lung that the scan shows.
     *
     * @param lengthMm its length
     * @param nextMm length of the next one
     * @param endZ height of its vertebral end, mm
     */
    static boolean isFirst(double lengthMm, double nextMm, double endZ, LungVoxels lung) {
        return !lung.isCutAbove() && lengthMm < FIRST_SHORT * nextMm && endZ > lung.highest() + FIRST_ABOVE_APEX_MM;
    }

    private boolean isSternum(Part part) {
        return isInFront(part.centre()[1])
                && Math.abs(part.centre()[0] - spine.x(part.centre()[2])) < STERNUM_MM
                && part.extent()[0] < 3 * STERNUM_MM
                && part.extent()[2] > (isCutAbove(part) ? LEAST_CUT_MM : STERNUM_HEIGHT_MM);
    }
}
