package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.voxel.LayerParting;
import org.phrenic.patient.label.LabelTable;

/**
 * Ribs that hang together under their label, as where it holds the cartilages of the costal margin, or where a bridge
 * of bone joins two.
 */
final class FusedRibs {
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
