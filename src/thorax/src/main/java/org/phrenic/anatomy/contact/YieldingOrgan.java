package org.phrenic.anatomy.contact;

import java.util.Arrays;
import org.phrenic.mesh.TriangleMesh;

/** The surface of a soft organ that is dented by the diaphragm: {@link SheetContact} and {@link YieldSpread}. */
public final class YieldingOrgan {
    private final SheetContact.Organ contact;
    private final TriangleMesh mesh;
    private final double[] positions;
    /** Made when the organ first yields, which many never do; null before. */
    private YieldSpread spread;

    /**
     * @param sheet updated before each call of {@link #dented}
     * @param mesh the organ at rest
     * @param above whether it lies above the thoracic face; else below the abdominal face
     */
    public YieldingOrgan(SheetContact sheet, TriangleMesh mesh, boolean above) {
        this.mesh = mesh;
        positions = mesh.positions().clone();
        contact = sheet.organ(positions, above);
    }

    /**
     * Returns the vertices of the dented organ, in an array that is used again.
     *
     * @param free vertices where the organ would be without the diaphragm
     */
    public double[] dented(double[] free) {
        System.arraycopy(free, 0, positions, 0, positions.length);
        contact.pushBack(positions);
        if (!Arrays.equals(free, positions) && spread().spread(free, positions)) {
            contact.pushBackAgain(positions);
        }
        return positions;
    }

    private YieldSpread spread() {
        if (spread == null) {
            spread = new YieldSpread(mesh);
        }
        return spread;
    }
}
