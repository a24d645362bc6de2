package org.phrenic.study.body;

/**
 * Vertices of the organs of one group that lie on the wrong side of the diaphragm.
 *
 * @param lungVertices vertices of the lungs below the thoracic face, deeper than {@link BodyLimits#THROUGH_MM}
 * @param liverVertices vertices of the liver above the abdominal face, deeper than that
 * @param otherVertices vertices of other organs on the wrong side, deeper than that
 * @param deepestMm greatest depth of any organ vertex on the wrong side, mm; 0 if there is none
 * @param deepest name of the organ with that vertex; empty if there is none
 */
public record OrganCrossing(int lungVertices, int liverVertices, int otherVertices, double deepestMm, String deepest) {
    /** No vertex on the wrong side. */
    public static final OrganCrossing NONE = new OrganCrossing(0, 0, 0, 0, "");

    /** All vertices that are too deep. */
    public int vertices() {
        return lungVertices + liverVertices + otherVertices;
    }
}
