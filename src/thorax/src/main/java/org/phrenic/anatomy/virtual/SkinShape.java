package org.phrenic.anatomy.virtual;

import java.util.List;
import org.phrenic.anatomy.virtual.shape.Polyline;
import org.phrenic.anatomy.virtual.shape.ProfileCurve;
import org.phrenic.anatomy.virtual.shape.Tube;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/** The skin of the trunk from the loins to the neck, without arms: a closed surface of superelliptic sections. */
final class SkinShape {
    private static final int AROUND = 72;
    private static final int ALONG = 62;
    private static final double CAP_MM = 8;

    private final VirtualThoraxParameters.Skin measures;

    SkinShape(VirtualThoraxParameters.Skin measures) {
        this.measures = measures;
    }

    TriangleMesh mesh() {
        List<ImmutableDoubleArray> rows = measures.sections();
        double[] z = rows.stream().mapToDouble(row -> row.at(0)).toArray();
        ProfileCurve breadth =
                new ProfileCurve(z, rows.stream().mapToDouble(row -> row.at(1)).toArray());
        ProfileCurve front =
                new ProfileCurve(z, rows.stream().mapToDouble(row -> row.at(2)).toArray());
        ProfileCurve back =
                new ProfileCurve(z, rows.stream().mapToDouble(row -> row.at(3)).toArray());
        double bottom = z[0];
        double top = z[z.length - 1];
        double[][] middle = new double[60][];
        for (int i = 0; i < middle.length; i++) {
            double height = bottom + (top - bottom) * i / (middle.length - 1);
            middle[i] = Vectors.of(0, (front.at(height) + back.at(height)) / 2, height);
        }
        Tube tube = new Tube(AROUND, ALONG, measures.exponent(), CAP_MM);
        return tube.mesh(
                new Polyline(List.of(middle)),
                t -> {
                    double height = bottom + (top - bottom) * t;
                    return new Tube.Section(breadth.at(height), (back.at(height) - front.at(height)) / 2);
                },
                p -> Vectors.of(0, -1, 0));
    }
}
