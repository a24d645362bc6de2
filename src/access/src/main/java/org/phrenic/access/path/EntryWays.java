package org.phrenic.access.path;

import java.util.Optional;
import org.phrenic.access.Midline;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.MovingStructure;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Names the ways of paths in the current frame. A path passes the rib cage where it comes nearest to a rib or
 * cartilage; with neighbouring ribs above and below that place the way is intercostal, with none below it is subcostal,
 * or subxiphoid within {@value #MIDLINE_MM} mm of the {@link Midline}. Not thread-safe.
 */
final class EntryWays {
    private static final double MIDLINE_MM = 30;
    /** Entries farther below the tip of the xiphoid process are subcostal. */
    private static final double BELOW_TIP_MM = 100;

    private final MovingAnatomy anatomy;
    private final TriangleTree.Hit hit = new TriangleTree.Hit();

    EntryWays(MovingAnatomy anatomy) {
        this.anatomy = anatomy;
    }

    /** @param wallDepth depth of the path's nearest point to a rib or cartilage, mm; NaN if none is in range */
    EntryWay of(double[] entry, double[] end, double wallDepth) {
        double depth = Double.isNaN(wallDepth) ? 0 : wallDepth;
        double[] at = Vectors.addScaled(entry, Vectors.normalize(Vectors.subtract(end, entry)), depth);
        int above = 0;
        int below = Integer.MAX_VALUE;
        Side side = Side.MIDLINE;
        double nearest = PathAnalyzer.MAX_DISTANCE_MM;
        for (MovingStructure s : anatomy.hazards()) {
            double[] local = s.toLocal(at);
            if (!PathAnalyzer.isCage(s)
                    || !s.tree().closest(local[0], local[1], local[2], PathAnalyzer.MAX_DISTANCE_MM, hit)) {
                continue;
            }
            double[] point = s.toWorld(new double[] {hit.x, hit.y, hit.z});
            if (point[2] > at[2]) {
                above = Math.max(above, s.surface().level());
            } else {
                below = Math.min(below, s.surface().level());
            }
            if (hit.distanceSquared < nearest * nearest) {
                nearest = Math.sqrt(hit.distanceSquared);
                side = s.surface().side();
            }
        }
        if (above > 0 && below == above + 1) {
            return new EntryWay(EntryWay.Kind.INTERCOSTAL, side, Optional.of(new IntercostalSpace(above, side)));
        }
        return below < Integer.MAX_VALUE ? EntryWay.of(EntryWay.Kind.AT_RIB, side) : belowTheMargin(entry);
    }

    private EntryWay belowTheMargin(double[] entry) {
        double lowest = Double.POSITIVE_INFINITY;
        for (MovingStructure s : anatomy.structures()) {
            if (s.surface().kind() == StructureKind.STERNUM) {
                lowest = Math.min(lowest, s.box()[2]);
            }
        }
        double across = entry[0] - Midline.x(anatomy.structures(), MovingStructure::surface, MovingStructure::box);
        if (Math.abs(across) < MIDLINE_MM && entry[2] > lowest - BELOW_TIP_MM) {
            return EntryWay.of(EntryWay.Kind.SUBXIPHOID, Side.MIDLINE);
        }
        return EntryWay.of(EntryWay.Kind.SUBCOSTAL, across < 0 ? Side.RIGHT : Side.LEFT);
    }
}
