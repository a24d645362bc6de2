package org.phrenic.simulation.observe;

import org.phrenic.mesh.TriangleMesh;

/** The surface of a soft organ that is dented by the diaphragm: {@link SheetContact} and {@link YieldSpread}. */
public final class YieldingOrgan {
    private final SheetContact.Organ contact;
    private final YieldSpread spread;
    private final double[] positions;

    /**
     * @param sheet updated before each call of {@link #dented}
     * @param mesh the organ at rest
     * @param above whether it lies above the thoracic face; else below the abdominal face
     */
    public YieldingOrgan(SheetContact sheet, TriangleMesh mesh, boolean above) {
        positions = mesh.positions().clone();
        contact = sheet.organ(positions, above);
        spread = new YieldSpread(mesh);
    }

    /**
     * Returns the vertices of the dented organ, in an array that is used again.
     *
     * @param free vertices where the organ would be without the diaphragm
     */
    public double[] dented(double[] free) {
        System.arraycopy(free, 0, positions, 0, positions.length);
        contact.pushBack(positions);
        if (spread.spread(free, positions)) {
            contact.pushBack(positions);
        }
        return positions;
    }
}
