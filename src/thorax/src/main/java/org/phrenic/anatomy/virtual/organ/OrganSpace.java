package org.phrenic.anatomy.virtual.organ;

import org.phrenic.anatomy.virtual.shape.ImplicitSurface;

/** The space of the trunk that an organ is cut to. */
public enum OrganSpace {
    /** Below the diaphragm, inside the wall and outside the liver. */
    ABDOMEN,
    /** Below the diaphragm and inside the wall: vessels that enter the liver. */
    LIVER,
    /** Above the diaphragm, between the lungs. */
    THORAX,
    /** Inside the wall and between the lungs: vessels that pass through the diaphragm. */
    TRUNK;

    /**
     * The boundaries of the cavities.
     *
     * @param abdomen inside the wall and below the diaphragm
     * @param liver the liver, which ends at the border of {@code abdomen}
     * @param mediastinum inside the wall and between the lungs
     * @param aboveDiaphragm above the diaphragm
     */
    public record Cavities(
            ImplicitSurface abdomen,
            ImplicitSurface liver,
            ImplicitSurface mediastinum,
            ImplicitSurface aboveDiaphragm) {}

    /** The space as a region, {@code gapMm} away from its boundaries. */
    ImplicitSurface within(Cavities c, double gapMm) {
        return switch (this) {
            case ABDOMEN ->
                (x, y, z) ->
                        gapMm + Math.max(c.abdomen().at(x, y, z), -c.liver().at(x, y, z));
            case LIVER -> (x, y, z) -> gapMm + c.abdomen().at(x, y, z);
            case THORAX ->
                (x, y, z) -> gapMm
                        + Math.max(
                                c.mediastinum().at(x, y, z), c.aboveDiaphragm().at(x, y, z));
            case TRUNK -> (x, y, z) -> gapMm + c.mediastinum().at(x, y, z);
        };
    }
}
