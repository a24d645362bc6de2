package org.phrenic.simulation;

import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Structure;
import org.phrenic.geometry.MeshMeasure;
import org.phrenic.geometry.TriangleMesh;

/**
 * The liver, hung from the underside of the diaphragm by its ligaments: it follows the mean motion of the roof of the dome it lies under (the viscera beneath keep it from turning with the roof), wholly at its top and less toward its lower
 * edge (the lower right lobe moves 0.6 to 0.7 times as far as the dome; physiology D1). It is carried, not stepped.
 */
final class LiverPart {
    /** The bare area and the coronary ligament lie behind: what of the back half of the roof is this near to the liver at rest carries it. */
    private static final double ATTACHED_MM = 10;

    /** The abdominal face of the roof looks down. */
    private static final double ROOF = -0.5;

    private static final double LOWEST_SHARE = 0.65;
    private static final int FEWEST = 12;

    final Structure structure;
    private final DiaphragmPart diaphragm;
    private final int[] attached;
    private final double[] share;
    private final double[] moved;

    LiverPart(Structure liver, DiaphragmPart part) {
        structure = liver;
        diaphragm = part;
        TriangleMesh mesh = liver.mesh();
        Diaphragm d = part.diaphragm;
        TriangleMesh sheet = d.sheet();
        NearestVertex surface = new NearestVertex(mesh, i -> true);
        double[] distance = new double[sheet.vertexCount()];
        for (int i = 0; i < distance.length; i++) {
            surface.find(sheet.x(i), sheet.y(i), sheet.z(i), 3 * ATTACHED_MM);
            distance[i] = surface.distance();
        }
        double[] normals = MeshMeasure.vertexNormals(sheet);
        double[] liverBox = mesh.bounds();
        double middle = 0.5 * (liverBox[1] + liverBox[4]);
        int[] near = roof(d, normals, distance, middle, ATTACHED_MM);
        attached = near.length >= FEWEST ? near : roof(d, normals, distance, middle, 3 * ATTACHED_MM);
        share = new double[mesh.vertexCount()];
        moved = mesh.positions().clone();
        for (int i = 0; i < share.length; i++) {
            double height = (mesh.z(i) - liverBox[2]) / (liverBox[5] - liverBox[2]);
            share[i] = LOWEST_SHARE + (1 - LOWEST_SHARE) * height * height * (3 - 2 * height);
        }
    }

    private static int[] roof(Diaphragm d, double[] normals, double[] distance, double middle, double reach) {
        return IntStream.range(0, distance.length)
                .filter(i -> !d.isThoracic(i)
                        && !d.isInserted(i)
                        && d.sheet().y(i) > middle
                        && normals[3 * i + 2] < ROOF
                        && distance[i] < reach)
                .toArray();
    }

    /**
     * Where the liver's vertices are; valid until the next call.
     *
     * @param rest positions of the whole scene at rest, caller's order
     * @param now positions of the whole scene now
     */
    double[] positions(double[] rest, double[] now) {
        double[] p = moved;
        double[] start = structure.mesh().positions();
        if (attached.length < FEWEST) {
            return p;
        }
        double[] mean = new double[3];
        for (int node : attached) {
            int at = 3 * (diaphragm.first + node);
            for (int axis = 0; axis < 3; axis++) {
                mean[axis] += (now[at + axis] - rest[at + axis]) / attached.length;
            }
        }
        for (int i = 0; i < p.length; i++) {
            p[i] = start[i] + share[i / 3] * mean[i % 3];
        }
        return p;
    }
}
