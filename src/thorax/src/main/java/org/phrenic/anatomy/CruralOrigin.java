package org.phrenic.anatomy;

import java.util.List;
import org.phrenic.engine.force.FallOff;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The origin of the crura: by tendons from the vertebrae L1 to L3 and the discs between them, blended with the anterior
 * longitudinal ligament, and above them from the front of T12, where the median arcuate ligament joins the crura. The
 * sheet does not slide there, and its muscle fraction decreases toward the bone.
 */
public final class CruralOrigin {
    /** T12 and the disc below it. */
    private static final int LIGAMENT_LEVEL = StructureName.FIRST_LUMBAR - 1;
    /** The right crus originates from L1 to L3, the left from L1 and L2 (physiology C1). */
    private static final int LAST_LEVEL = StructureName.FIRST_LUMBAR + 2;
    /**
     * Attachment distance, mm. The middle of the sheet is 3 to 8 mm from the bone: half its thickness, the ligament and
     * the effect of smoothing both surfaces. A larger value reduces dome descent. At 14 mm, or on a stiffer bed, the
     * sheet creases at the border of the attached part.
     */
    private static final double REACH_MM = 15;

    /** Sine of 30 degrees. */
    private static final double MAX_BEHIND_SINE = 0.5;

    private CruralOrigin() {}

    /**
     * Attachment of each vertex of the sheet to the crural origin.
     *
     * @return for each vertex 1 on the bone, falling smoothly to 0 at {@value #REACH_MM} mm from it; all 0 if the
     *     thorax has none of these vertebrae
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
     * Weight of a point beside or in front of the bone: 1, falling smoothly to 0 where the direction from the bone
     * points 30 degrees backward.
     */
    private static double inFront(double forward, double distance) {
        double behind = distance == 0 ? 0 : Math.max(0, -forward / distance);
        return FallOff.at(behind, MAX_BEHIND_SINE);
    }
}
