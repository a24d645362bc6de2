package org.phrenic.access.path;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.phrenic.access.Midline;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.MovingStructure;
import org.phrenic.access.Needle;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Names the ways of paths in the current frame. A path passes the rib cage where it comes nearest to a rib with its
 * cartilage. Where that place lies between this rib and a neighbour of it the way is intercostal; between it and
 * another rib, or where the needle touches it, the way is over a rib or the costal margin, as is any other way that
 * enters above the tip of the xiphoid process within {@value #MIDLINE_MM} mm of the {@link Midline}. Every other way
 * passes below the costal margin: it is subxiphoid within this distance of the midline, and subcostal beside it. Not
 * thread-safe.
 */
final class EntryWays {
    private static final double MIDLINE_MM = 30;
    /** Entries farther below the tip of the xiphoid process are subcostal. */
    private static final double BELOW_TIP_MM = 100;
    /**
     * A place that sees the nearest points of two ribs at more than this angle lies between them: in the ball that has
     * the line from one point to the other as its diameter. On both virtual bodies and a scanned one at rest, 99 % of
     * the paths that cross the sheet between two neighbouring ribs see them at more than 100 degrees, and most paths
     * below the costal margin at less than 65 degrees.
     */
    private static final double BETWEEN_DEG = 90;

    private final MovingAnatomy anatomy;
    private final double needleRadiusMm;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();

    EntryWays(MovingAnatomy anatomy, Needle needle) {
        this.anatomy = anatomy;
        needleRadiusMm = needle.radiusMm();
    }

    /** The point of a rib with its cartilage that is nearest to a place. */
    private record NearRib(Side side, int level, double distanceMm, double[] point) {
        private boolean isSameRib(NearRib other) {
            return side == other.side && level == other.level;
        }

        private boolean isNeighbourOf(NearRib other) {
            return side == other.side && Math.abs(level - other.level) == 1;
        }

        /** Angle at which a place sees the nearest points of this rib and another, degrees. */
        private double angleDeg(double[] at, NearRib other) {
            return Vectors.angleDeg(Vectors.subtract(point, at), Vectors.subtract(other.point, at));
        }
    }

    /** @param wallDepth depth of the path's nearest point to a rib or cartilage, mm; NaN if none is in range */
    EntryWay of(double[] entry, double[] end, double wallDepth) {
        if (Double.isNaN(wallDepth)) {
            return belowTheMargin(entry, Side.MIDLINE);
        }
        double[] at = Vectors.addScaled(entry, Vectors.normalize(Vectors.subtract(end, entry)), wallDepth);
        List<NearRib> ribs = ribsNear(at);
        if (ribs.isEmpty()) {
            return belowTheMargin(entry, Side.MIDLINE);
        }
        NearRib nearest = Collections.min(ribs, Comparator.comparingDouble(NearRib::distanceMm));
        if (nearest.distanceMm < needleRadiusMm) {
            return EntryWay.of(EntryWay.Kind.AT_RIB, nearest.side);
        }
        List<NearRib> opposite = ribs.stream()
                .filter(rib -> rib.side == nearest.side && rib.level != nearest.level)
                .filter(rib -> nearest.angleDeg(at, rib) > BETWEEN_DEG)
                .toList();
        Optional<NearRib> neighbour = opposite.stream()
                .filter(nearest::isNeighbourOf)
                .max(Comparator.comparingDouble(rib -> nearest.angleDeg(at, rib)));
        if (neighbour.isPresent()) {
            int space = Math.min(nearest.level, neighbour.get().level);
            return new EntryWay(
                    EntryWay.Kind.INTERCOSTAL, nearest.side, Optional.of(new IntercostalSpace(space, nearest.side)));
        }
        return opposite.isEmpty()
                ? belowTheMargin(entry, nearest.side)
                : EntryWay.of(EntryWay.Kind.AT_RIB, nearest.side);
    }

    /** The nearest points of all ribs in range of a place, one for each rib. */
    private List<NearRib> ribsNear(double[] at) {
        List<NearRib> ribs = new ArrayList<>();
        for (MovingStructure s : anatomy.hazards()) {
            double[] local = s.toLocal(at);
            if (!PathAnalyzer.isCage(s)
                    || !s.tree().closest(local[0], local[1], local[2], PathAnalyzer.MAX_DISTANCE_MM, hit)) {
                continue;
            }
            NearRib found = new NearRib(
                    s.surface().side(), s.surface().level(), Math.sqrt(hit.distanceSquared), s.toWorld(new double[] {
                        hit.x, hit.y, hit.z
                    }));
            if (ribs.stream().noneMatch(rib -> rib.isSameRib(found) && rib.distanceMm <= found.distanceMm)) {
                ribs.removeIf(found::isSameRib);
                ribs.add(found);
            }
        }
        return ribs;
    }

    /** @param side the side of the nearest rib */
    private EntryWay belowTheMargin(double[] entry, Side side) {
        double lowest = Double.POSITIVE_INFINITY;
        for (MovingStructure s : anatomy.structures()) {
            if (s.surface().kind() == StructureKind.STERNUM) {
                lowest = Math.min(lowest, s.box()[2]);
            }
        }
        double across = entry[0] - Midline.x(anatomy.structures(), MovingStructure::surface, MovingStructure::box);
        if (Math.abs(across) < MIDLINE_MM && entry[2] > lowest - BELOW_TIP_MM) {
            return entry[2] > lowest
                    ? EntryWay.of(EntryWay.Kind.AT_RIB, side)
                    : EntryWay.of(EntryWay.Kind.SUBXIPHOID, Side.MIDLINE);
        }
        return EntryWay.of(EntryWay.Kind.SUBCOSTAL, across < 0 ? Side.RIGHT : Side.LEFT);
    }
}
