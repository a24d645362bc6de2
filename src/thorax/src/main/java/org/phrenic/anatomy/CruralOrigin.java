package org.phrenic.anatomy;

import java.util.List;
import org.phrenic.engine.force.FallOff;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The origin of the crura: the first three lumbar vertebrae and the discs between them, by tendons that blend with the
 * ligament there; and above them the front of the last thoracic one, where the median arcuate ligament joins the two.
 * What of the sheet lies there does not slide, and the less of it is muscle the nearer it is.
 */
public final class CruralOrigin {
    /** T12, and the disc below it. */
    private static final int LIGAMENT_LEVEL = StructureName.FIRST_LUMBAR - 1;
    /** The right crus comes from L1 to L3, the left from L1 and L2 (physiology C1). */
    private static final int LAST_LEVEL = StructureName.FIRST_LUMBAR + 2;
    /**
     * The sheet's middle is 3 to 8 mm off the bone: its half thickness, ligament and what smoothing does to both
     * surfaces. A larger reach lets the domes descend less; at 14 mm, or on a firmer bed, the sheet creases at the
     * border of the held part.
     */
    private static final double REACH_MM = 15;

    /** Sine of 30 degrees. */
    private static final double MAX_BEHIND_SINE = 0.5;

    private CruralOrigin() {}

    /**
     * How much of each vertex of the sheet belongs to the origin.
     *
     * @return of each vertex 1 on the bone, falling smoothly to 0 at {@value #REACH_MM} mm from it; all 0 where the
     *     body has none of these vertebrae
     */
    public static double[] attachmentShares(Thorax thorax, Diaphragm diaphragm) {
        TriangleMesh sheet = diaphragm.sheet();
        double[] share = new double[sheet.vertexCount()];
        List<Structure> spine = thorax.structures().stream()
                .filter(s -> s.level() >= LIGAMENT_LEVEL)
                .filter(s -> (s.kind() == StructureKind.VERTEBRA && s.level() <= LAST_LEVEL)
                        || (s.kind() == StructureKind.DISC && s.level() < LAST_LEVEL))
                .toList();
        TriangleTree.Hit hit = new TriangleTree.Hit();
        for (Structure part : spine) {
            TriangleTree tree = new TriangleTree(part.mesh());
            for (int i = 0; i < share.length; i++) {
                if (tree.closest(sheet.x(i), sheet.y(i), sheet.z(i), REACH_MM, hit)) {
                    double distance = Math.sqrt(hit.distanceSquared);
                    double ahead = part.level() == LIGAMENT_LEVEL ? inFront(hit.y - sheet.y(i), distance) : 1;
                    share[i] = Math.max(share[i], ahead * FallOff.at(distance, REACH_MM));
                }
            }
        }
        return share;
    }

    /**
     * 1 beside the bone and before it, falling smoothly to 0 where the way from the bone leads back by a third of a
     * right angle.
     */
    private static double inFront(double forward, double distance) {
        double behind = distance == 0 ? 0 : Math.max(0, -forward / distance);
        return FallOff.at(behind, MAX_BEHIND_SINE);
    }
}
