package org.phrenic.anatomy.virtual;

import java.util.List;
import java.util.function.DoubleFunction;
import org.phrenic.anatomy.virtual.shape.ImmutableDoubleArray;
import org.phrenic.anatomy.virtual.shape.ProfileCurve;
import org.phrenic.anatomy.virtual.shape.Tube;
import org.phrenic.mesh.Polyline;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/**
 * The skin of the trunk from the loins to the neck, without arms: a closed surface of superelliptic sections, each at
 * one height.
 */
record SkinShape(VirtualThoraxParameters.Skin measures) {
    private static final int AROUND = 72;
    private static final int ALONG = 62;
    private static final double CAP_MM = 8;

    TriangleMesh mesh() {
        List<ImmutableDoubleArray> rows = measures.sections();
        double[] z = ChestWallShape.column(rows, 0);
        ProfileCurve breadth = new ProfileCurve(z, ChestWallShape.column(rows, 1));
        ProfileCurve front = new ProfileCurve(z, ChestWallShape.column(rows, 2));
        ProfileCurve back = new ProfileCurve(z, ChestWallShape.column(rows, 3));
        double bottom = z[0];
        double top = z[z.length - 1];
        DoubleFunction<Tube.Section> section =
                height -> new Tube.Section(breadth.at(height), (back.at(height) - front.at(height)) / 2);
        Tube tube = new Tube(AROUND, ALONG, measures.exponent(), CAP_MM);
        TriangleMesh straight = tube.mesh(
                new Polyline(List.of(Vectors.of(0, 0, bottom), Vectors.of(0, 0, top))),
                t -> section.apply(bottom + (top - bottom) * t),
                p -> Vectors.of(0, -1, 0));
        double[] positions = straight.positions().clone();
        for (int k = 0; k < positions.length; k += 3) {
            double height = positions[k + 2];
            positions[k + 1] += (front.at(height) + back.at(height)) / 2;
        }
        return straight.withPositions(positions);
    }
}
