package org.phrenic.patient.segmentation;

import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureName;

/**
 * Sides of connected ribs. The side is that of the label, or the other one if the rib lies among the ribs of that side,
 * as where a segmentation confuses right and left in some of them.
 */
final class RibSides {
    /** A rib is of the other side if that side's median is nearer than this share of the distance to its own. */
    private static final double NEARER = 0.5;

    private final Segmentation s;
    private final List<RibComponents.Rib> ribs;
    private final double medianRight;
    private final double medianLeft;

    RibSides(Segmentation s, List<RibComponents.Rib> ribs) {
        this.s = s;
        this.ribs = ribs;
        medianRight = median(Side.RIGHT);
        medianLeft = median(Side.LEFT);
    }

    /** Median x of the centres of the ribs whose label names a side, mm; NaN if there is none. */
    private double median(Side side) {
        double[] x = ribs.stream()
                .filter(rib -> labelled(rib).filter(side::equals).isPresent())
                .mapToDouble(rib -> rib.centre[0])
                .sorted()
                .toArray();
        return x.length == 0 ? Double.NaN : x[x.length / 2];
    }

    private Optional<Side> labelled(RibComponents.Rib rib) {
        return StructureName.parse(s.names().get(rib.dominantSegment() - 1))
                .map(StructureName::side)
                .filter(side -> side == Side.RIGHT || side == Side.LEFT);
    }

    /** The side of a rib; empty if its label names none. */
    Optional<Side> of(RibComponents.Rib rib) {
        return labelled(rib).map(side -> isMisplaced(rib, side) ? other(side) : side);
    }

    private static Side other(Side side) {
        return side == Side.RIGHT ? Side.LEFT : Side.RIGHT;
    }

    /** Whether a rib lies among those of the other side. NaN compares false. */
    private boolean isMisplaced(RibComponents.Rib rib, Side side) {
        double toRight = Math.abs(rib.centre[0] - medianRight);
        double toLeft = Math.abs(rib.centre[0] - medianLeft);
        return side == Side.RIGHT ? toLeft < NEARER * toRight : toRight < NEARER * toLeft;
    }

    /** The segment of a rib that lies among those of the other side, if there is one. */
    Optional<Integer> misplaced() {
        return ribs.stream()
                .filter(rib ->
                        labelled(rib).filter(side -> isMisplaced(rib, side)).isPresent())
                .map(RibComponents.Rib::dominantSegment)
                .findFirst();
    }
}
