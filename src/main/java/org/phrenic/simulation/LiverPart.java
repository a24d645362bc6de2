package org.phrenic.simulation;

import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Structure;
import org.phrenic.geometry.RigidMotion;
import org.phrenic.geometry.TriangleMesh;

/**
 * The liver, hung from the underside of the diaphragm by its ligaments: it follows the rigid motion that best fits the part of the abdominal face it lies against, wholly at its top and less toward its lower
 * edge (the lower right lobe moves 0.6 to 0.7 times as far as the dome; physiology D1). It is carried, not stepped.
 */
final class LiverPart {
    /** The bare area and the ligaments: what lies this near to the diaphragm at rest hangs from it. */
    private static final double ATTACHED_MM = 10;

    private static final double LOWEST_SHARE = 0.65;
    private static final int FEWEST = 12;

    final Structure structure;
    private final DiaphragmPart diaphragm;
    private final int[] attached;
    private final double[] share;


    LiverPart(Structure liver, DiaphragmPart part) {
        structure = liver;
        diaphragm = part;
        TriangleMesh mesh = liver.mesh();
        Diaphragm d = part.diaphragm;
        TriangleMesh sheet = d.sheet();
        NearestVertex surface = new NearestVertex(mesh, i -> true);
        double[] distance = new double[sheet.vertexCount()];
        for (int i = 0; i < distance.length; i++) {
            surface.find(sheet.x(i), sheet.y(i), sheet.z(i));
            distance[i] = surface.distance();
        }
        int[] near = abdominal(d, distance, ATTACHED_MM);
        attached = near.length >= FEWEST ? near : abdominal(d, distance, 3 * ATTACHED_MM);
        double[] box = mesh.bounds();
        share = new double[mesh.vertexCount()];
        for (int i = 0; i < share.length; i++) {
            double height = (mesh.z(i) - box[2]) / (box[5] - box[2]);
            share[i] = LOWEST_SHARE + (1 - LOWEST_SHARE) * height * height * (3 - 2 * height);
        }
    }

    private static int[] abdominal(Diaphragm d, double[] distance, double reach) {
        return IntStream.range(0, distance.length)
                .filter(i -> !d.isThoracic(i) && !d.isInserted(i) && distance[i] < reach)
                .toArray();
    }

    /** Nodes of the diaphragm that the liver hangs from. */
    int attachedCount() {
        return attached.length;
    }

    /**
     * Where the liver's vertices are.
     *
     * @param rest positions of the whole scene at rest, caller's order
     * @param now positions of the whole scene now
     */
    double[] positions(double[] rest, double[] now) {
        double[] p = structure.mesh().positions().clone();
        if (attached.length < FEWEST) {
            return p;
        }
        double[] from = new double[3 * attached.length];
        double[] to = new double[3 * attached.length];
        for (int i = 0; i < attached.length; i++) {
            System.arraycopy(rest, 3 * (diaphragm.first + attached[i]), from, 3 * i, 3);
            System.arraycopy(now, 3 * (diaphragm.first + attached[i]), to, 3 * i, 3);
        }
        double[] moved = p.clone();
        RigidMotion.fit(from, to).apply(moved);
        for (int i = 0; i < p.length; i++) {
            p[i] += share[i / 3] * (moved[i] - p[i]);
        }
        return p;
    }
}
