package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.anatomy.Side;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;

/**
 * Separates ribs, sternum and spine where all bones share a label. The spine is followed up and down from the middle of
 * the lungs ({@link SpineAxis}). Of the other bones, connected parts that begin beside it, as long and as large as
 * ribs, are the ribs, counted from the first, whose vertebral end is as high as the apex of the lung; parts in front of
 * the lungs in the middle are the sternum. The rest keeps the common label. Both lungs have labels of their own.
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

    private static final int LEAST_RIBS = 8;
    private static final int MOST_RIBS = 12;
    /** Greatest distance of two neighbouring vertebral ends over the median distance. */
    private static final double REGULAR = 1.7;

    private final Segmentation s;
    private final SpineAxis spine;
    private final Map<Side, double[]> lungs;

    /** A connected part of the bones beside the spine. */
    private record Part(IntList voxels, double[] centre, double[] extent, double besideMm, double endZ) {
        double length() {
            return StrictMath.hypot(StrictMath.hypot(extent[0], extent[1]), extent[2]);
        }
    }

    private SkeletonSplitter(Segmentation s, SpineAxis spine, Map<Side, double[]> lungs) {
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
        Map<Side, double[]> lungs = new EnumMap<>(Side.class);
        lung(s, "lung_R").ifPresent(lung -> lungs.put(Side.RIGHT, lung));
        lung(s, "lung_L").ifPresent(lung -> lungs.put(Side.LEFT, lung));
        Optional<SpineAxis> axis = lungs.size() == 2
                ? SpineAxis.of(s, all, lungs.get(Side.RIGHT), lungs.get(Side.LEFT))
                : Optional.empty();
        return Optional.of(axis.flatMap(spine -> new SkeletonSplitter(s, spine, lungs).split(all))
                .orElse("bones under one label: ribs are not told apart; they are an obstacle and do not shape the"
                        + " cage"));
    }

    /** Mean of the voxels of a lung, then its lowest and greatest height, mm. */
    private static Optional<double[]> lung(Segmentation s, String name) {
        int segment = s.find(name);
        double[] lung = {0, 0, 0, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
        int count = 0;
        for (int v = 0; segment > 0 && v < s.voxels.length; v++) {
            if (s.segmentAt(v) == segment) {
                count++;
                for (int axis = 0; axis < 3; axis++) {
                    lung[axis] += (s.coordinate(v, axis) - lung[axis]) / count;
                }
                lung[3] = Math.min(lung[3], s.coordinate(v, 2));
                lung[4] = Math.max(lung[4], s.coordinate(v, 2));
            }
        }
        return count == 0 ? Optional.empty() : Optional.of(lung);
    }

    private Optional<String> split(int all) {
        byte[] before = s.voxels.clone();
        int ofSpine = s.segment(LabelTable.SPINE);
        for (int v = 0; v < s.voxels.length; v++) {
            if (s.segmentAt(v) == all && spine.contains(s, v)) {
                s.voxels[v] = (byte) ofSpine;
            }
        }
        List<Part> parts = new ArrayList<>(parts(all));
        parts.addAll(dividedParts(parts, all));
        List<Part> right = ribs(parts, Side.RIGHT);
        List<Part> left = ribs(parts, Side.LEFT);
        if (!isCage(right, Side.RIGHT) || !isCage(left, Side.LEFT) || Math.abs(right.size() - left.size()) > 1) {
            System.arraycopy(before, 0, s.voxels, 0, before.length);
            return Optional.empty();
        }
        name(right, Side.RIGHT);
        name(left, Side.LEFT);
        s.inheritFrom(LabelTable.SPINE, LabelTable.ALL_BONES);
        boolean sternum = false;
        for (Part part : parts) {
            if (isSternum(part)) {
                s.write(part.voxels(), s.segment(STERNUM));
                s.inheritFrom(STERNUM, LabelTable.ALL_BONES);
                sternum = true;
            }
        }
        return Optional.of("bones under one label: " + (right.size() + left.size()) + " ribs are counted from the first"
                + (sternum ? ", sternum and spine are" : ", the spine is") + " separated");
    }

    /** Parts of those that are larger than a rib: near the lungs, and in the middle in front of them. */
    private List<Part> dividedParts(List<Part> parts, int all) {
        NearVoxels near = new NearVoxels(s, List.of(s.find("lung_R"), s.find("lung_L")));
        int nearLungs = s.segment(NEAR_LUNGS);
        int inFront = s.segment(IN_FRONT);
        for (Part part : parts) {
            if (part.voxels().size() < most() || part.centre()[2] < lungs.get(Side.RIGHT)[3] - BELOW_MM) {
                continue;
            }
            for (int i = 0; i < part.voxels().size(); i++) {
                int v = part.voxels().get(i);
                double[] p = s.point(v);
                boolean middle = spine.beside(p) < STRIP_MM && isInFront(p);
                if (middle || near.isNear(p)) {
                    s.voxels[v] = (byte) (middle ? inFront : nearLungs);
                }
            }
        }
        List<Part> divided = new ArrayList<>(parts(nearLungs));
        divided.addAll(parts(inFront));
        for (int v = 0; v < s.voxels.length; v++) {
            int segment = s.segmentAt(v);
            s.voxels[v] = (byte) (segment == nearLungs || segment == inFront ? all : segment);
        }
        return divided;
    }

    private double most() {
        return MOST_ML * 1000 / s.grid().voxelVolume();
    }

    private boolean isInFront(double[] p) {
        return p[1] < 0.5 * (lungs.get(Side.RIGHT)[1] + lungs.get(Side.LEFT)[1]);
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
        List<double[]> posterior = new ArrayList<>();
        for (int i = 0; i < n; i++) {
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
        double endZ = RibNumbering.endHeight(posterior, n).orElse(Double.NaN);
        double beside = posterior.stream().mapToDouble(p -> p[0]).min().orElse(Double.POSITIVE_INFINITY);
        double[] extent = {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
        return new Part(voxels, centre, extent, beside, endZ);
    }

    /** The ribs of a side from top to bottom. */
    private List<Part> ribs(List<Part> parts, Side side) {
        double bottom = Math.min(lungs.get(Side.RIGHT)[3], lungs.get(Side.LEFT)[3]) - BELOW_MM;
        double top = Math.max(lungs.get(Side.RIGHT)[4], lungs.get(Side.LEFT)[4]) + ABOVE_MM;
        return parts.stream()
                .filter(part -> part.besideMm() < BESIDE_MM && part.length() > LEAST_LENGTH_MM)
                .filter(part -> part.voxels().size() < most() && part.centre()[2] > bottom && part.centre()[2] < top)
                .filter(part -> spine.isRight(part.centre()) == (side == Side.RIGHT))
                .sorted(Comparator.comparingDouble((Part part) -> -part.endZ()))
                .toList();
    }

    /**
     * Whether these are all ribs from the first on: it is as high as the apex of the lung, and none is missing between.
     */
    private boolean isCage(List<Part> ribs, Side side) {
        if (ribs.size() < LEAST_RIBS || ribs.size() > MOST_RIBS) {
            return false;
        }
        double[] steps = new double[ribs.size() - 1];
        for (int i = 0; i < steps.length; i++) {
            steps[i] = ribs.get(i).endZ() - ribs.get(i + 1).endZ();
        }
        double[] sorted = steps.clone();
        Arrays.sort(sorted);
        boolean regular = sorted[sorted.length - 1] < REGULAR * sorted[sorted.length / 2];
        return regular && ribs.get(0).endZ() > lungs.get(side)[4] + FIRST_ABOVE_APEX_MM;
    }

    private boolean isSternum(Part part) {
        return isInFront(part.centre())
                && Math.abs(part.centre()[0] - spine.x(part.centre()[2])) < STERNUM_MM
                && part.extent()[0] < 3 * STERNUM_MM
                && part.extent()[2] > STERNUM_HEIGHT_MM;
    }
}
