package org.phrenic.patient.diaphragm;

import java.util.Arrays;
import java.util.List;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.contact.SheetContact;
import org.phrenic.anatomy.contact.YieldingOrgan;
import org.phrenic.mesh.TriangleMesh;

/**
 * The contact of the organs of a body with the diaphragm that is built for it, by the rule of a scene
 * ({@link YieldingOrgan}): vertices beyond the face of their own side move to it, and the vertices about them follow.
 */
final class YieldToSheet {
    private final MedianFrame frame;
    private final List<Structure> above;
    private final List<Structure> below;
    private final SheetContact contact;

    /**
     * @param body the body without its diaphragm, LPS, mm
     * @param sheet the diaphragm in the frame of the median plane
     */
    YieldToSheet(Thorax body, MedianFrame frame, TriangleMesh sheet) {
        this.frame = frame;
        above = ContactingOrgans.thoracic(body);
        below = ContactingOrgans.abdominal(body);
        contact = new SheetContact(Diaphragm.withTrefoilTendon(sheet), 0);
    }

    /** The organ with the vertices that yield where they lie then; the others keep their places to the bit. */
    Structure yielded(Structure organ) {
        boolean isAbove = above.contains(organ);
        if (!isAbove && !below.contains(organ)) {
            return organ;
        }
        TriangleMesh rest = frame.toFrame(organ.mesh());
        double[] free = rest.positions();
        double[] dented = new YieldingOrgan(contact, rest, isAbove).dented(free);
        if (Arrays.equals(free, dented)) {
            return organ;
        }
        double[] now = frame.toScan(rest.withPositions(dented)).positions();
        double[] places = organ.mesh().positions().clone();
        for (int i = 0; i < places.length; i += 3) {
            if (!Arrays.equals(free, i, i + 3, dented, i, i + 3)) {
                System.arraycopy(now, i, places, i, 3);
            }
        }
        return organ.withMesh(organ.mesh().withPositions(places));
    }
}
