package org.phrenic.access.ultrasound;

import java.util.List;
import java.util.Locale;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** A place on the skin where a probe is held. It moves with the skin, and the probe keeps its angles to it. */
public final class ProbeOnSkin {
    /** How deep the middle of the face is pressed in, mm, so that most of the face of a curvilinear probe touches. */
    public static final double PRESS_MM = 6;

    private static final double TOLERANCE_MM = 5;
    /** The normal is that of the skin within this distance, about the size of the face, mm. */
    private static final double FOOTPRINT_MM = 20;

    private final Surface skin;
    private final int index;
    private final int triangle;
    private final double[] weights;
    private final int[] footprint;
    private final double outward;
    private final double[] positions;

    /**
     * @param surfaces surfaces of a scene, in the order of its frames
     * @param restMm place on the skin at end-expiration, LPS, mm
     * @throws BadInputException if the body has no skin, or the place is more than {@value #TOLERANCE_MM} mm from it
     */
    public ProbeOnSkin(List<Surface> surfaces, double[] restMm) {
        index = indexOfSkin(surfaces);
        skin = surfaces.get(index);
        TriangleTree tree = new TriangleTree(skin.rest());
        TriangleTree.Hit hit = new TriangleTree.Hit();
        tree.closest(restMm[0], restMm[1], restMm[2], hit);
        double distance = Math.sqrt(hit.distanceSquared);
        if (distance > TOLERANCE_MM) {
            throw new BadInputException(String.format(
                    Locale.ROOT,
                    "probe: found (%.1f, %.1f, %.1f), %.1f mm %s, expected a place on the skin; the nearest is"
                            + " %.1f,%.1f,%.1f",
                    restMm[0],
                    restMm[1],
                    restMm[2],
                    distance,
                    tree.isInside(restMm[0], restMm[1], restMm[2]) ? "inside the body" : "off the skin",
                    hit.x,
                    hit.y,
                    hit.z));
        }
        triangle = hit.triangle;
        weights = new double[] {hit.weightA, hit.weightB, hit.weightC};
        footprint = footprint(skin.rest(), new double[] {hit.x, hit.y, hit.z});
        outward = Math.signum(MeshMeasure.signedVolume(skin.rest()));
        positions = new double[skin.rest().positions().length];
    }

    static int indexOfSkin(List<Surface> surfaces) {
        for (int i = 0; i < surfaces.size(); i++) {
            if (surfaces.get(i).kind() == StructureKind.SKIN) {
                return i;
            }
        }
        throw new BadInputException("the body: found no skin, expected one to put a probe on");
    }

    private int[] footprint(TriangleMesh mesh, double[] at) {
        IntList near = new IntList();
        for (int t = 0; t < mesh.triangleCount(); t++) {
            double[] middle = new double[3];
            for (int k = 0; k < 3; k++) {
                int v = mesh.triangles()[3 * t + k];
                middle = Vectors.addScaled(middle, Vectors.of(mesh.x(v), mesh.y(v), mesh.z(v)), 1 / 3.0);
            }
            if (t == triangle || Vectors.distance(middle, at) < FOOTPRINT_MM) {
                near.add(t);
            }
        }
        return near.toArray();
    }

    /** The pose of the probe in a frame. */
    public ProbePose pose(Frame frame, ProbePose.Angles angles) {
        frame.writePositions(skin, index, positions);
        int[] t = skin.rest().triangles();
        double[] at = new double[3];
        for (int k = 0; k < 3; k++) {
            at = Vectors.addScaled(at, corner(t[3 * triangle + k]), weights[k]);
        }
        double[] normal = new double[3];
        for (int f : footprint) {
            double[] a = corner(t[3 * f]);
            double[] ab = Vectors.subtract(corner(t[3 * f + 1]), a);
            double[] ac = Vectors.subtract(corner(t[3 * f + 2]), a);
            normal = Vectors.addScaled(normal, Vectors.cross(ab, ac), outward);
        }
        return ProbePose.onSkin(at, normal, angles, PRESS_MM);
    }

    private double[] corner(int vertex) {
        return new double[] {positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]};
    }
}
