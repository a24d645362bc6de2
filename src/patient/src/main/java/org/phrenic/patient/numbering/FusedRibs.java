package org.phrenic.patient.numbering;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.LayerParting;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.segmentation.Segmentation;
import org.phrenic.patient.segmentation.VoxelRuns;

/**
 * Ribs that hang together: under their label, as where it holds the cartilages of the costal margin or where a bridge
 * of bone joins two; or where each has a label of its own and they touch.
 */
final class FusedRibs {
    /** Least share of the shorter one's directions that two ribs which touch have in common. */
    private static final double BESIDE = 0.5;
    /** Least difference in height of two ribs that touch, mm: more than the thickness of one. */
    private static final double APART_MM = 8;

    /** Voxels of a piece to which distances are taken. */
    private static final int SAMPLES = 300;

    private final Segmentation s;
    /** x and y of an axis in front of the vertebral ends of the ribs and behind their front ends, mm. */
    private final double[] axis;

    private FusedRibs(Segmentation s, double[] axis) {
        this.s = s;
        this.axis = axis;
    }

    /**
     * Parts ribs that hang together.
     *
     * @param ribs connected parts of ribs; one that holds several is replaced by these
     * @param middle x of the median plane, mm
     * @return a clause to end a sentence with that says which were parted; empty if none were
     * @throws BadInputException with a message without the file's name, if some cannot be parted
     */
    static String part(Segmentation s, List<RibComponents.Rib> ribs, double middle) {
        DoubleSummaryStatistics y = ribs.stream()
                .flatMapToDouble(rib ->
                        IntStream.range(0, rib.voxels.size()).mapToDouble(i -> s.coordinate(rib.voxels.get(i), 1)))
                .summaryStatistics();
        FusedRibs fused = new FusedRibs(s, new double[] {middle, 0.5 * (y.getMin() + y.getMax())});
        List<String> parted = new ArrayList<>();
        List<RibComponents.Rib> apart =
                ribs.stream().flatMap(rib -> fused.apart(rib, parted)).toList();
        ribs.clear();
        ribs.addAll(apart);
        return parted.isEmpty() ? "" : "; ribs that hang together are parted: " + String.join(", ", parted);
    }

    /**
     * Parts ribs that touch by their labels: of a connected part that holds nearly all of several labels, each nearly
     * all in one piece, the pieces that lie one above another are ribs. Others, as the front and the back of one rib
     * under two labels, stay together.
     *
     * @param ribs connected parts of ribs; one that holds several is replaced by these
     * @param middle x and y of the axis about which the ribs curve, mm
     */
    static void partByLabels(Segmentation s, List<RibComponents.Rib> ribs, double[] middle) {
        Map<Integer, Integer> totals = RibComponents.totals(ribs);
        FusedRibs fused = new FusedRibs(s, middle);
        List<RibComponents.Rib> apart = ribs.stream()
                .flatMap(rib -> fused.byLabels(
                        rib,
                        rib.segments.keySet().stream()
                                .filter(segment -> !LabelTable.isRibs(s.names().get(segment - 1)))
                                .filter(segment -> rib.segments.get(segment) >= RibComponents.MIN_VOXELS)
                                .filter(segment -> isMost(rib.segments.get(segment), totals.get(segment)))
                                .toList()))
                .toList();
        ribs.clear();
        ribs.addAll(apart);
    }

    private static boolean isMost(int part, int all) {
        return part > (1 - RibComponents.SUBSTANTIAL) * all;
    }

    private Stream<RibComponents.Rib> byLabels(RibComponents.Rib rib, List<Integer> labels) {
        if (labels.size() < 2) {
            return Stream.of(rib);
        }
        byte[] groups = new byte[LabelGrid.MAX_BYTE_LABEL + 1];
        labels.forEach(label -> groups[label] = (byte) (int) label);
        Map<Integer, RibComponents.Rib> pieces = new TreeMap<>();
        for (IntList voxels : new VoxelRuns(s, groups, true).voxels(run -> true).values()) {
            int label = s.segmentAt(voxels.get(0));
            if (isMost(voxels.size(), rib.segments.get(label))) {
                RibComponents.Rib piece = new RibComponents.Rib(s, voxels);
                piece.findAngles(s, axis);
                pieces.put(label, piece);
            }
        }
        List<List<Integer>> ribs = new ArrayList<>();
        for (int label : pieces.keySet()) {
            List<List<Integer>> same = ribs.stream()
                    .filter(other -> other.stream().anyMatch(o -> !areTwo(pieces.get(o), pieces.get(label))))
                    .toList();
            ribs.removeAll(same);
            ribs.add(Stream.concat(same.stream().flatMap(List::stream), Stream.of(label))
                    .toList());
        }
        return ribs.size() < 2 ? Stream.of(rib) : shared(rib, pieces, ribs);
    }

    /** Whether two pieces of one connected part lie on the two sides, or one above the other. */
    private boolean areTwo(RibComponents.Rib a, RibComponents.Rib b) {
        boolean sides = a.centre[0] < axis[0] != b.centre[0] < axis[0];
        return sides || (RibComponents.commonAngle(a, b) > BESIDE && Math.abs(a.heightAbove(b)) > APART_MM);
    }

    /** Ribs of some labels each, with the voxels that belong to none of their pieces in the nearest one. */
    private Stream<RibComponents.Rib> shared(
            RibComponents.Rib whole, Map<Integer, RibComponents.Rib> pieces, List<List<Integer>> ribs) {
        List<IntList> parts = new ArrayList<>();
        List<IntList> samples = new ArrayList<>();
        BitSet shared = new BitSet();
        for (List<Integer> rib : ribs) {
            IntList part = new IntList();
            IntList sample = new IntList();
            for (int label : rib) {
                int[] voxels = pieces.get(label).voxels.toArray();
                for (int i = 0; i < voxels.length; i++) {
                    part.add(voxels[i]);
                    shared.set(voxels[i]);
                    if (i % Math.max(1, voxels.length / SAMPLES) == 0) {
                        sample.add(voxels[i]);
                    }
                }
            }
            parts.add(part);
            samples.add(sample);
        }
        List<VoxelBlocks> blocks =
                samples.stream().map(sample -> new VoxelBlocks(s, sample)).toList();
        for (int voxel : whole.voxels.toArray()) {
            if (!shared.get(voxel)) {
                parts.get(nearest(voxel, blocks)).add(voxel);
            }
        }
        return parts.stream().map(part -> new RibComponents.Rib(s, part));
    }

    private int nearest(int voxel, List<VoxelBlocks> parts) {
        double[] distances = parts.stream()
                .mapToDouble(part -> part.distance(s.point(voxel)))
                .toArray();
        return IntStream.range(0, distances.length)
                .reduce((a, b) -> distances[b] < distances[a] ? b : a)
                .orElseThrow();
    }

    private Stream<RibComponents.Rib> apart(RibComponents.Rib rib, List<String> parted) {
        if (hasLabelsOfItsOwn(rib)) {
            return Stream.of(rib);
        }
        Optional<LayerParting.Layers> layers = LayerParting.part(s.grid(), rib.voxels, axis);
        if (layers.isEmpty()) {
            return Stream.of(rib);
        }
        List<IntList> pieces = layers.get().pieces();
        double[] joint = layers.get().joint();
        String side = rib.centre[0] < axis[0] ? "right" : "left";
        if (pieces.size() == 1) {
            throw new BadInputException(String.format(
                    Locale.ROOT,
                    "%s: found %d ribs on the %s that hang together %s about (%.0f, %.0f, %.0f) mm and cannot be"
                            + " parted, expected gaps between ribs, with cartilages under a label of their own, or a"
                            + " label for each rib",
                    s.names().get(rib.dominantSegment() - 1),
                    layers.get().count(),
                    side,
                    place(joint),
                    joint[0],
                    joint[1],
                    joint[2]));
        }
        parted.add(pieces.size() + " on the " + side + " " + place(joint));
        return pieces.stream().map(piece -> new RibComponents.Rib(s, piece));
    }

    /** Whether labels of single ribs tell several apart, which only touch. */
    private boolean hasLabelsOfItsOwn(RibComponents.Rib rib) {
        return rib.segments.keySet().stream()
                        .filter(segment -> !LabelTable.isRibs(s.names().get(segment - 1)))
                        .filter(segment -> rib.share(segment) > RibComponents.SUBSTANTIAL)
                        .count()
                > 1;
    }

    private String place(double[] joint) {
        double forward = axis[1] - joint[1];
        boolean beside = Math.abs(forward) < Math.abs(joint[0] - axis[0]);
        return beside ? "at the side" : forward > 0 ? "in front" : "at the back";
    }
}
