package org.phrenic.anatomy;

import java.util.List;
import org.phrenic.engine.force.FallOff;
import org.phrenic.geometry.TriangleMesh;
import org.phrenic.geometry.TriangleTree;

/**
 * Where the crura come from: the front of the first three lumbar vertebrae and the discs between them, by tendons that blend with the ligament there. What of the sheet lies there does not slide, and the less of it is muscle the nearer it is.
 */
public final class CruralOrigin {
    /** The right crus comes from L1 to L3, the left from L1 and L2 (physiology C1). */
    private static final int LAST_LEVEL = StructureName.FIRST_LUMBAR + 2;
    /** The sheet's middle is 3 to 8 mm off the bone: its half thickness, ligament and what smoothing does to both surfaces. With 14 mm it creased at the border of what is held. */
    private static final double REACH_MM = 15;

    private CruralOrigin() {}

    /**
     * How much of each vertex of the sheet belongs to the origin.
     *
     * @return of each vertex 1 on the bone, falling smoothly to 0 at {@value #REACH_MM} mm from it; all 0 where the body has none of these vertebrae
     */
    public static double[] of(Thorax thorax, Diaphragm diaphragm) {
        TriangleMesh sheet = diaphragm.sheet();
        double[] share = new double[sheet.vertexCount()];
        List<Structure> spine = thorax.structures().stream()
                .filter(s -> s.level() >= StructureName.FIRST_LUMBAR - 1)
                .filter(s -> (s.kind() == StructureKind.VERTEBRA && s.level() <= LAST_LEVEL)
                        || (s.kind() == StructureKind.DISC && s.level() < LAST_LEVEL))
                .toList();
        TriangleTree.Hit hit = new TriangleTree.Hit();
        for (Structure part : spine) {
            TriangleTree tree = new TriangleTree(part.mesh());
            for (int i = 0; i < share.length; i++) {
                if (tree.closest(sheet.x(i), sheet.y(i), sheet.z(i), REACH_MM, hit)) {
                    share[i] = Math.max(share[i], FallOff.at(Math.sqrt(hit.distanceSquared), REACH_MM));
                }
            }
        }
        return share;
    }
}
