package org.phrenic.anatomy.virtual.organ;

import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.virtual.shape.ImmutableDoubleArray;
import org.phrenic.document.Key;

/**
 * Measures of one organ: ellipsoids and a tube, united with fillets, less hollows. The union is widened or narrowed by
 * one distance everywhere so that what remains within the organ's space has its volume.
 *
 * @param name name of the structure, such as {@code kidney_R}
 * @param in the space that the organ is cut to
 * @param volumeMl volume; without it the shape is kept as stated
 * @param gridMm edge length of the grid on which the surface is triangulated
 * @param filletMm radius with which the parts are joined and cut edges are rounded
 * @param ellipsoids rows of x, y, z of the centre, half-axes along x, y and z, and rotations about x, y and z in
 *     degrees
 * @param tube points of the middle line in order along it: x, y, z and radius
 * @param hollows ellipsoids that are cut away
 */
public record OrganParameters(
        String name,
        OrganSpace in,
        @Key(above = 0) Optional<Double> volumeMl,
        @Key(above = 0.5, max = 20) double gridMm,
        @Key(absent = "4", above = 0) double filletMm,
        @Key(absent = "", count = 9) List<ImmutableDoubleArray> ellipsoids,
        @Key(absent = "", count = 4) List<ImmutableDoubleArray> tube,
        @Key(absent = "", count = 9) List<ImmutableDoubleArray> hollows) {
    public OrganParameters {
        if (ellipsoids.isEmpty() && tube.isEmpty()) {
            throw new IllegalArgumentException("found neither ellipsoids nor a tube for '" + name + "', expected one");
        }
        if (tube.size() == 1) {
            throw new IllegalArgumentException("tube: found 1 point for '" + name + "', expected at least two");
        }
        for (ImmutableDoubleArray row : tube) {
            if (!(row.at(3) > 0)) {
                throw new IllegalArgumentException(
                        "tube: found radius " + row.at(3) + " for '" + name + "', expected more than 0");
            }
        }
        requireAxes(name, "ellipsoids", ellipsoids);
        requireAxes(name, "hollows", hollows);
    }

    private static void requireAxes(String name, String key, List<ImmutableDoubleArray> rows) {
        for (ImmutableDoubleArray row : rows) {
            if (!(Math.min(row.at(3), Math.min(row.at(4), row.at(5))) > 0)) {
                throw new IllegalArgumentException(key + ": found half-axes " + row.at(3) + ", " + row.at(4) + ", "
                        + row.at(5) + " for '" + name + "', expected more than 0");
            }
        }
    }
}
